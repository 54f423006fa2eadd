// SPDX-License-Identifier: LGPL-2.1-or-later
// Peak pressure, contact zones and contact forces of pressures that are known in closed form.

#include <signorini/discretization/space/resultant.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <algorithm>
#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** The unit square with contact at the bottom, ratio 2, and so many cells along it. */
std::string square(const unsigned int cells) {
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
         entry("Geometry", "Cells", std::to_string(cells) + ", " + std::to_string(cells));
}

/** P with the means of a function with the given primitive. */
template <typename Primitive>
Pressure means(const MultiplierSpace<2> &space, const Primitive &primitive) {
  const auto &patches = space.surface().patches();
  Pressure P(patches.size());
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    P[tau] =
      (primitive(patches[tau].upper[0]) - primitive(patches[tau].lower[0])) / patches[tau].measure;
  return P;
}

void peak(Checks &checks) {
  // 11 faces: the last patch has three. -p = 1 - 4 (x - 0.37)².
  const OneLevel uneven(square(11), 0);
  const auto parabola = [](const double x) { return -x + 4. / 3. * std::pow(x - 0.37, 3); };
  const auto found = peak_pressure(uneven.multipliers(), means(uneven.multipliers(), parabola));
  checks.near("peak of a parabola", found->value, 1., 1e-13);
  checks.near("its place", found->at.point[0], 0.37, 1e-12);
  checks.that("its side", found->at.side == "bottom");
  const auto &patch = uneven.discretization.surface.patches()[2];
  checks.near("mean of its patch", found->mean,
              -(parabola(patch.upper[0]) - parabola(patch.lower[0])) / patch.measure, 1e-14);
  // -p = 2 - x has its maximum at the end of the side.
  const auto at_end =
    peak_pressure(uneven.multipliers(),
                  means(uneven.multipliers(), [](double x) { return -2. * x + 0.5 * x * x; }));
  checks.near("peak at the end of a side", at_end->value, 2., 1e-13);
  checks.near("there", at_end->at.point[0], 0., 1e-15);
  checks.that("no pressure, no peak",
              !peak_pressure(uneven.multipliers(), Pressure(uneven.multipliers().n_multipliers())));
}

/** -p = (rho² - (x - m)²)^{1/2}: Hertz. */
void zones(Checks &checks) {
  const OneLevel level(square(64), 0);
  const double rho = 0.3, H = 1. / 32.;
  for (const double m : {0.5, 0.4871, 0.5203, 0.45}) {
    const auto found =
      contact_zones(level.multipliers(), means(level.multipliers(), [&](double x) {
                      const double t = std::clamp((x - m) / rho, -1., 1.);
                      return -0.5 * rho * rho * (t * std::sqrt(1. - t * t) + std::asin(t));
                    }));
    checks.that("Hertz: one zone", found.size() == 1);
    checks.near("Hertz: start", found[0].start.at.arc_length, m - rho, 0.1 * H);
    checks.near("Hertz: end", found[0].end.at.arc_length, m + rho, 0.1 * H);
    checks.near("Hertz: length of a patch", found[0].start.uncertainty, H, 1e-15);
    checks.near("Hertz: length", found[0].length, 2. * rho, 0.2 * H);
  }
}

/** -p = 1 + x at the bottom: the force 3/2 acts at x = (1/2 + 1/3)/(3/2) = 5/9. */
void forces(Checks &checks) {
  const OneLevel level(square(64), 0);
  const auto force_of = [&](const Pressure &pressure) {
    return contact_force(level.multipliers(), {0}, pressure);
  };
  const Pressure P = means(level.multipliers(), [](const double x) { return -x - 0.5 * x * x; });
  const SideForce found = force_of(P);
  // p n = p (0,-1) points upwards. Means over patches of length H lose H²/12 of the linear part's
  // moment.
  const double moment = 5. / 6. - 1. / 12. / 32. / 32.;
  checks.near("force, moment, line of action",
              {found.resultant.force[0], found.resultant.force[1], found.resultant.moment[0],
               (*found.through)[0], (*found.through)[1]},
              {0., 1.5, moment, moment / 1.5, 0.}, 1e-13);
  // Presses on both thirds at the ends: two zones, whose forces sum up to that of the side.
  const Pressure two = means(level.multipliers(), [](const double x) {
    return x < 0.25 ? -x : x < 0.75 ? -0.25 : -0.25 - 3. * (x - 0.75);
  });
  const auto found_zones = contact_zones(level.multipliers(), two);
  const auto of_zones = zone_forces(level.multipliers(), two, found_zones);
  checks.near("forces of two zones",
              {of_zones.at(0).resultant.force[1], of_zones.at(1).resultant.force[1]}, {0.25, 0.75},
              1e-13);
  checks.near("their lines of action", {(*of_zones[0].through)[0], (*of_zones[1].through)[0]},
              {0.125, 0.875}, 1e-13);
  checks.that("no force, no line", !force_of(Pressure(P.size())).through && found.side == "bottom");
  Resultant<2> oblique;
  const dealii::Point<2> a(0.3, -0.7);
  oblique.add(dealii::Tensor<1, 2>({2., 1.}), a);
  const AnswerVector nearest = *side_force<2>("", oblique, {0.3 + 4., -0.7 + 2.}, 1.).through;
  checks.near("a point of the line stays", nearest.distance({4.3, 1.3}), 0., 1e-14);
  const AnswerVector foot = *side_force<2>("", oblique, {0.3 - 1., -0.7 + 2.}, 1.).through;
  checks.near("foot of the perpendicular", foot.distance(a), 0., 1e-14);
}

void trends(Checks &checks) {
  using Kind = Trend::Kind;
  struct Row {
    std::vector<std::optional<double>> values;
    Kind kind;
  };
  // Nothing known; order one, also where levels without contact are left out; constant; a punch's
  // factor 2^{1/2}, a facet's log h, a sharp corner's 2^{0.1}; jumps.
  for (const Row &row :
       std::vector<Row>{{{1.}, Kind::unknown},
                        {{{}, {}}, Kind::unknown},
                        {{1.2, 1.1, 1.05}, Kind::settled},
                        {{{}, 1.2, 1.1, 1.05}, Kind::settled},
                        {{0., 0.}, Kind::settled},
                        {{1., 1.414, 2., 2.828}, Kind::not_settled},
                        {{1., 1.1, 1.2, 1.3}, Kind::not_settled},
                        {{1., 1.072, 1.149}, Kind::not_settled},
                        {{0.0744, 0.0778, 0.0776, 0.0565, 0.0607}, Kind::not_settled},
                        {{0.0776, 0.0565, 0.0607}, Kind::not_settled},
                        {{3., 1.2, 1.1, 1.05}, Kind::settled}})
    checks.that("trends", trend_of(row.values).kind == row.kind);
  checks.near("change", *trend_of({1., 0.8}).change, -0.25, 1e-15);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {peak, zones, forces, trends});
}
