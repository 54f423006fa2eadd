// SPDX-License-Identifier: LGPL-2.1-or-later
// Error norms of functions whose norms are known in closed form, kinks and square roots included.

#include <signorini/base/errors.h>
#include <signorini/verification/norms/errors.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
std::string scene(const std::string &geometry, const std::string &displacement,
                  const std::string &gradient, const std::string &discretization) {
  return "subsection Geometry\n" + geometry +
         "end\nsubsection Boundary\nset Displacement = top: " + displacement +
         "\nset Contact = bottom\nend\n"
         "Contact/Gap = 9\n"
         "subsection Exact solution\nset Displacement = " +
         displacement + "\nset Displacement gradient = " + gradient +
         "\nend\nsubsection Discretization\n" + discretization + "end\n";
}

DisplacementErrors errors(const OneLevel &level, const Displacement &U) {
  return compute_displacement_errors(level.body(U), 4);
}

Displacement nothing(const OneLevel &level) {
  return nodal_values(level.space(), [](const Point<2> &) { return Point<2>(); });
}

/** U = 0: the errors are the norms of u itself. */
void norms(Checks &checks, const std::string &name, const OneLevel &level, const double l2_squared,
           const double h1_seminorm_squared, const double tolerance) {
  checks.about(name);
  const DisplacementErrors found = errors(level, nothing(level));
  const double h1 = std::sqrt(l2_squared + h1_seminorm_squared);
  checks.near("L2", found.l2, std::sqrt(l2_squared), tolerance);
  checks.near("H1", found.h1, h1, tolerance);
  if (found.post_h1)
    checks.near("recovered", *found.post_h1, h1, tolerance);
}

void polynomials(Checks &checks) {
  // u = (x^2 y, x - y^3) on (0,1)^2: int u^2 = 1/15 + 1/3 - 1/4 + 1/7,
  // int grad^2 = 4/9 + 1/5 + 1 + 9/5.
  const double l2 = 1. / 15. + 1. / 3. - 1. / 4. + 1. / 7.,
               seminorm = 4. / 9. + 1. / 5. + 1. + 9. / 5.;
  const std::string u = "x^2*y; x - y^3", du = "2*x*y; x^2; 1; -3*y^2";
  norms(checks, "polynomial", OneLevel(scene("", u, du, ""), 1), l2, seminorm, 1e-14);
  norms(checks, "polynomial, distorted mesh",
        OneLevel(scene("set Distortion = 0.3\n", u, du, ""), 3), l2, seminorm, 1e-14);
  norms(checks, "polynomial, gradient by differences",
        OneLevel("subsection Boundary\nset Displacement = top: " + u +
                   "\nset Contact = bottom\nend\n"
                   "Contact/Gap = 9\n" +
                   entry("Exact solution", "Displacement", u),
                 2),
        l2, seminorm, 1e-10);
  const OneLevel coarsest(scene("", u, du, ""), 0);
  checks.that("no recovery on level 0", !errors(coarsest, nothing(coarsest)).post_h1);
}

/** u = ((x - c)_+, (y - d)_+): int u^2 = (1-c)^3/3 + (1-d)^3/3, int grad^2 = (1-c) + (1-d). */
void kinks(Checks &checks) {
  const double c = 0.3, d = 0.45;
  const double l2 = std::pow(1. - c, 3) / 3. + std::pow(1. - d, 3) / 3., seminorm = 2. - c - d;
  const std::string u = "max(x - 0.3, 0); max(y - 0.45, 0)",
                    du = "x > 0.3 ? 1 : 0; 0; 0; y > 0.45 ? 1 : 0",
                    at = "set Kinks at x = 0.3\nset Kinks at y = 0.45\n";
  norms(checks, "kinks", OneLevel(scene("", u, du, at), 0), l2, seminorm, 1e-14);
  norms(checks, "kinks, distorted mesh", OneLevel(scene("set Distortion = 0.3\n", u, du, at), 3),
        l2, seminorm, 1e-13);
}

/** Against the interpolant of u itself. */
void interpolants(Checks &checks) {
  const OneLevel a1("Scene/Name = A1\n", 2);
  const auto &exact = *a1.scene.exact_displacement;
  const Displacement Iu = nodal_values(
    a1.space(), [&](const Point<2> &x) { return Point<2>(exact.value(x, 0), exact.value(x, 1)); });
  const DisplacementErrors found = errors(a1, Iu);
  checks.near("A1, U = I^h u: superclose", found.superclose_h1, 0., 1e-14);
  Displacement shifted = Iu;
  shifted.add(0.5);
  checks.near("A1, U = I^h u + (1/2, 1/2): superclose", errors(a1, shifted).superclose_h1,
              std::sqrt(0.5), 1e-14);

  checks.throws<InputError>("no finite value", "no finite value", [] {
    const OneLevel level(scene("", "x; y", "1; 0; 0; abs(y-0.5206255924)<1e-6?0/0:1", ""), 4);
    errors(level, nothing(level));
  });
}

std::string pressed(const std::string &pressure, const std::string &discretization) {
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
         entry("Exact solution", "Pressure", pressure) + "subsection Discretization\n" +
         discretization + "end\n";
}

/** p = -1 - x against its means: H^2/12, squared, on the unit side. */
void linear_pressure(Checks &checks) {
  for (const unsigned int n : {3U, 4U, 7U}) {
    const OneLevel level(pressed("-1 - x", "set Patches = " + std::to_string(n) + "\n"), 3);
    Pressure P(n);
    for (unsigned int tau = 0; tau < n; ++tau)
      P[tau] = -1. - (tau + 0.5) / n;
    const PressureErrors found = compute_pressure_errors(level.multipliers(), P, 4);
    checks.about("linear pressure, patches " + std::to_string(n));
    checks.near("L2", found.l2, 1. / n / std::sqrt(12.), 1e-15);
    checks.near("recovered", found.post_l2, 0., 1e-14);
  }
}

/** p = -sqrt((c - x)_+): int p^2 = c^2/2, int_a^b p = -2/3 ((c-a)_+^{3/2} - (c-b)_+^{3/2}). */
void square_root(Checks &checks) {
  for (const char *position : {"0.3", "0.5", "0.7071067811865476"}) {
    const double c = std::stod(position);
    const std::string text = position;
    const OneLevel level(pressed("-sqrt(max(" + text + " - x, 0))",
                                 "set Kinks at x = " + text + "\nset Patches = 7\n"),
                         3);
    const Pressure P(RandomNumbers(9).vector(7));
    const auto integral = [&](const double x) {
      return 2. / 3. * std::pow(std::max(c - x, 0.), 1.5);
    };
    double squared = 0.5 * c * c;
    for (unsigned int tau = 0; tau < 7; ++tau) {
      const Patch<2> &patch = level.discretization.surface.patches()[tau];
      squared += P[tau] * P[tau] * patch.measure -
                 2. * P[tau] * (integral(patch.upper[0]) - integral(patch.lower[0]));
    }
    checks.near("square root up to " + text, compute_pressure_errors(level.multipliers(), P, 4).l2,
                std::sqrt(squared), 1e-8);
  }
}

/** The sums are the same digit by digit on any number of threads. */
void threads(Checks &checks) {
  const OneLevel level("subsection Boundary\n"
                       "set Displacement = top: sin(3*x)*y; max(x-0.3,0)^2*exp(y)\n"
                       "set Contact = bottom\nend\nsubsection Contact\nset Gap = 9\nend\n"
                       "subsection Exact solution\n"
                       "set Displacement = sin(3*x)*y; max(x-0.3,0)^2*exp(y)\nend\n"
                       "subsection Discretization\nset Kinks at x = 0.3\nend\n",
                       5);
  RandomNumbers random(11);
  const Displacement U = random_rows(level.space(), random);
  const auto numbers = [&](const unsigned int n_threads) {
    setenv("DEAL_II_NUM_THREADS", std::to_string(n_threads).c_str(), 1);
    const DisplacementErrors e = compute_displacement_errors(level.body(U), 4);
    const ErrorEstimate estimate = level.estimate(U);
    return std::vector<double>({e.h1, e.l2, e.superclose_h1, *e.post_h1, *e.post4_h1, e.energy,
                                estimate.h1.value(), estimate.energy, estimate.relative});
  };
  const auto one = numbers(1);
  checks.that("two threads = one thread", numbers(2) == one);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {polynomials, kinks, interpolants, linear_pressure, square_root, threads});
}
