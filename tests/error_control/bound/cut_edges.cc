// SPDX-License-Identifier: LGPL-2.1-or-later
// What is left of the traction of a pair on edges of meshes that do not match, and the stress that
// balances it, by sums over many points.

#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/tractions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "error_control/hp/graded.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** The stress of F(x) ψ(y/d), F = x² (1 - x)², on rectangles of all depths. */
void stress_on_a_rectangle(Checks &checks) {
  const GradedLevel level("Boundary/Clamped = top\nBoundary/Contact = bottom\n",
                          uniform_plan(0, 2));
  const CellShape shape =
    shape_of(level.mesh().triangulation().begin_active(), level.scene.geometry.sides);
  constexpr unsigned int n = 200;
  double least = std::numeric_limits<double>::max();
  for (double d = 0.5; d < 1.; d += 0.01) {
    double sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j) {
        const double x = (i + 0.5) / n, s = (j + 0.5) / n, F = x * x * (1. - x) * (1. - x),
                     F_1 = 2. * x * (1. - x) * (1. - 2. * x), F_2 = 2. - 12. * x + 12. * x * x,
                     psi = (1. - s) * (1. - s) * (1. + 2. * s), psi_1 = -6. * s * (1. - s),
                     psi_2 = -6. + 12. * s;
        sum += std::pow(F * psi_2 / (d * d), 2) + std::pow(F_2 * psi, 2) +
               2. * std::pow(F_1 * psi_1 / d, 2);
      }
    least = std::min(least, std::sqrt(d * sum / (n * n)));
  }
  const TractionRest rest = {std::sqrt(4. / 5.), std::sqrt(2. / 105.), std::sqrt(1. / 630.)};
  const OscillationConstants constants(shape, 2);
  checks.near("the best rectangle", constants.normal(0, rest) / least, 1., 1e-3);
  const TractionRest unknown = TractionRest::of_norm(rest.norm, 1.);
  checks.that("any r of this norm has no larger F' and F",
              unknown.slope >= rest.slope && unknown.primitive >= rest.primitive);
}

/** Returns the value of Legendre polynomials on an edge. */
double value(const std::vector<double> &coefficients, const double s) {
  const std::vector<double> L = legendre_values(coefficients.size() - 1, s);
  return std::inner_product(L.begin(), L.end(), coefficients.begin(), 0.);
}

/** A traction that rises along each edge of a punch, which ends within a face of the other body. */
void rests_of_a_pair(Checks &checks) {
  const GradedLevel level(
    "Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, -1\n"
    "Geometry/Upper right = a: 0.5, 0.5 | b: 1.5, 0\nMaterial/Young's modulus = a: 1 | b: 10\n"
    "Boundary/Contact = a.bottom with b.top\nContact/Gap = -0.01\n"
    "Boundary/Rollers = a.left a.top b.left b.bottom\n",
    uniform_plan(1, 3));
  const LevelProblem<2> problem = {level.parameters, level.scene, level.solvers()};
  const LevelSolution<2> solution = solve_level(problem, level.discretization, ContactStart(),
                                                [](const std::string & /*stage*/) {});
  const BoundData data(solution.on(level.discretization), *solution.operators->inverse,
                       solution.energies, solution.scale);
  Tractions tractions(data, EquilibrationMesh(data));
  const TractionSpace &space = tractions.space;
  for (unsigned int e = 0; e < space.edges().size(); ++e)
    if (space.edges()[e].is_shared) {
      std::vector<double> q(space.edges()[e].degree + 1, 0.);
      q[0] = -1.;
      q[1] = 0.3;
      tractions.fix(e, 0, q);
    }
  tractions.project_shared();
  constexpr unsigned int n = 30000;
  unsigned int n_cut = 0;
  for (unsigned int e = 0; e < space.edges().size(); ++e) {
    const TractionEdge &edge = space.edges()[e];
    if (space.shared_parts(e).empty())
      continue;
    const std::vector<double> own = tractions.on_edge(e, 0);
    const double step = edge.length() / n;
    double slope = 0., primitive = 0., squares = 0., of_slope = 0., of_primitive = 0.;
    for (unsigned int i = 0; i < n; ++i) {
      const dealii::Point<2> x = edge.point((i + 0.5) / n);
      double r = -value(own, (i + 0.5) / n);
      for (unsigned int s = 0; s < space.edges().size(); ++s)
        if (const TractionEdge &shared = space.edges()[s]; shared.is_shared)
          if (const double at = shared.position_of(x); at > 0. && at < 1.)
            r += value(tractions.on_edge(s, 0), at);
      primitive += step * (slope + 0.5 * step * r);
      slope += step * r;
      squares += step * r * r;
      of_slope += step * slope * slope;
      of_primitive += step * primitive * primitive;
    }
    const TractionRest &rest = tractions.rests[0][e];
    checks.near("no force", slope, 0., 1e-6);
    checks.near("no moment", primitive, 0., 1e-6);
    checks.near("r", rest.norm, std::sqrt(squares), 1e-5);
    checks.near("F'", rest.slope, std::sqrt(of_slope), 1e-6);
    checks.near("F", rest.primitive, std::sqrt(of_primitive), 1e-7);
    n_cut += rest.norm > 0. ? 1 : 0;
  }
  checks.that("some edges are cut", n_cut > 0);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {stress_on_a_rectangle, rests_of_a_pair});
}
