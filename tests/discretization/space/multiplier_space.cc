// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over patches against closed forms: lengths, gaps with kinks, square roots.

#include <signorini/base/errors.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
std::string square(const std::string &gap, const std::string &discretization) {
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
         entry("Contact", "Gap", gap) + "subsection Discretization\n" + discretization + "end\n";
}

/** Compares G with F(end) - F(start) of an antiderivative along the bottom of the unit square. */
void check_gap(Checks &checks, const std::string &name, const OneLevel &level,
               const std::function<double(double)> &antiderivative,
               const double tolerance = 1e-15) {
  double largest = 0.;
  for (unsigned int tau = 0; tau < level.multipliers().n_multipliers(); ++tau) {
    const Patch<2> &patch = level.discretization.surface.patches()[tau];
    largest =
      std::max(largest, std::abs(level.discretization.G[tau] - antiderivative(patch.upper[0]) +
                                 antiderivative(patch.lower[0])));
  }
  checks.near(name, largest, 0., tolerance);
}

/** g = |x - c|^s, as u_n at an end of contact: 3/2 where the foundation is smooth. */
void fractional_powers(Checks &checks) {
  for (const char *c : {"0.3", "0.5", "0.7071067811865476"})
    for (const double s : {0.5, 1.25, 1.5})
      for (const unsigned int number : {3U, 6U}) {
        const double kink = std::stod(c);
        const std::string exponent = std::to_string(s);
        check_gap(
          checks, "gap |x - c|^" + exponent + ", c = " + c + ", level " + std::to_string(number),
          OneLevel(square("abs(x - " + std::string(c) + ")^" + exponent,
                          "set Kinks at x = " + std::string(c) + "\n"),
                   number),
          [&](const double x) {
            return std::copysign(std::pow(std::abs(x - kink), s + 1.), x - kink) / (s + 1.);
          },
          1e-10 * std::pow(0.5, (s + 1.) * number));
      }
}

void gaps(Checks &checks) {
  const auto positive = [](const double t) { return std::max(t, 0.); };
  for (const std::string partition : {"", "set Patches = 5\n", "set Patch ratio = 3\n"}) {
    const std::string with =
      partition.empty() ? "" : ", " + partition.substr(4, partition.size() - 5);
    check_gap(checks, "constant gap" + with, OneLevel(square("0.3", partition), 3),
              [](const double x) { return 0.3 * x; });
    check_gap(checks, "linear gap" + with, OneLevel(square("0.1 - x", partition), 3),
              [](const double x) { return 0.1 * x - 0.5 * x * x; });
    check_gap(checks, "gap of degree five" + with, OneLevel(square("x^5", partition), 3),
              [](const double x) { return std::pow(x, 6) / 6.; });
    check_gap(
      checks, "gap with two kinks" + with,
      OneLevel(
        square("max(x - 0.3, 0) + abs(x - 0.55)", "set Kinks at x = 0.3, 0.55\n" + partition), 3),
      [&](const double x) {
        const double d = x - 0.55;
        return 0.5 * std::pow(positive(x - 0.3), 2) + 0.5 * d * std::abs(d);
      });
  }
  checks.throws<InputError>("gap without a value", "Contact/Gap: found the value",
                            [] { OneLevel(square("sqrt(x - 0.02)", ""), 4); });
  checks.throws<InputError>(
    "gap of the catalogue without a value", "the gap has the value nan at (", [] {
      OneLevel level(square("0", ""), 2);
      for (auto &contact : level.scene.contacts)
        contact.gap = std::make_shared<dealii::Functions::ConstantFunction<2>>(std::nan(""), 1);
      assemble_gap(level.multipliers(), level.scene.contacts, 3);
    });
}

/** Weights sum to the pieces' lengths, points lie on the side at their arc length. */
void rules(Checks &checks) {
  const OneLevel level(
    "subsection Geometry\nset Shape = polygon\n"
    "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
    "subsection Boundary\nset Clamped = side0\nset Contact = side1 side2 side3\nend\n"
    "subsection Discretization\nset Patches = 5\nset Kinks at x = 0.7, 2.2\n"
    "set Kinks at y = 1.7\nend\n",
    2);
  const auto &space = level.multipliers();
  for (const Grading grading : {Grading::none, Grading::towards_kinks}) {
    dealii::Vector<double> sums(space.n_multipliers());
    double off_side = 0., off_arc = 0.;
    for (const Piece<2> &piece : space.surface().pieces()) {
      const Side<2> &side = space.surface().side(space.surface().patches()[piece.patch]);
      const auto rule = space.surface().rule(piece, 3, grading);
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        sums[piece.patch] += rule.weights[q];
        off_side = std::max(off_side, std::abs((rule.points[q] - side.start()) * side.normal(0.)));
        off_arc = std::max(off_arc, std::abs(side.arc_length(rule.points[q]) - rule.on_side[q][0]));
      }
    }
    const std::string name = grading == Grading::none ? "plain rule" : "graded rule";
    checks.near(name + ": weights sum to |tau|", distance(sums, space.integrals()), 0., 1e-14);
    checks.near(name + ": points on the side", off_side + off_arc, 0., 1e-14);
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {gaps, fractional_powers, rules});
}
