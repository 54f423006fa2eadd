// SPDX-License-Identifier: LGPL-2.1-or-later
// Peak pressure, contact zones and contact forces of pressures that are known in closed form.

#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/postprocessing/quantities/side_forces.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** The unit square with contact at the bottom, ratio 2, and so many cells along it. */
std::string square(const unsigned int cells, const std::string &contact = "bottom")
{
  return "subsection Boundary\nset Clamped = top\nset Contact = " + contact + "\nend\n" +
         entry("Geometry", "Cells", std::to_string(cells) + ", " + std::to_string(cells));
}

/** P with the means of a function with the given primitive. */
template <typename Primitive>
Pressure means(const MultiplierSpace<2> &space, const Primitive &primitive)
{
  const auto &patches = space.surface().patches();
  Pressure P(patches.size());
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    P[tau] =
      (primitive(patches[tau].upper[0]) - primitive(patches[tau].lower[0])) / patches[tau].measure;
  return P;
}

void peak(Checks &checks)
{
  // 11 faces: the last patch has three. -p = 1 - 4 (x - 0.37)².
  const OneLevel uneven(square(11), 0);
  const auto parabola = [](const double x) { return -x + 4. / 3. * std::pow(x - 0.37, 3); };
  const auto found = peak_pressure(uneven.multipliers(), means(uneven.multipliers(), parabola));
  checks.near("peak of a parabola", found->value, 1., 1e-13);
  checks.near("its place", found->place.point[0], 0.37, 1e-12);
  checks.that("its side", found->place.side == "bottom");
  const auto &patch = uneven.discretization.surface.patches()[2];
  checks.near("mean of its patch",
              found->mean,
              -(parabola(patch.upper[0]) - parabola(patch.lower[0])) / patch.measure,
              1e-14);
  // -p = 2 - x has its maximum at the end of the side.
  const auto at_end =
    peak_pressure(uneven.multipliers(),
                  means(uneven.multipliers(), [](double x) { return -2. * x + 0.5 * x * x; }));
  checks.near("peak at the end of a side", at_end->value, 2., 1e-13);
  checks.near("there", at_end->place.point[0], 0., 1e-15);
  checks.that("no pressure, no peak",
              !peak_pressure(uneven.multipliers(), Pressure(uneven.multipliers().n_multipliers())));
}

/** -p = (rho² - (x - m)²)^{1/2}: Hertz. */
void zones(Checks &checks)
{
  const double rho = 0.3;
  for (const double m : {0.5, 0.4871, 0.5203, 0.45})
  {
    const OneLevel level(square(64), 0);
    const auto primitive = [&](const double x) {
      const double t = std::min(1., std::max(-1., (x - m) / rho));
      return -0.5 * rho * rho * (t * std::sqrt(1. - t * t) + std::asin(t));
    };
    const Pressure P = means(level.multipliers(), primitive);
    const auto found = contact_zones(level.multipliers(), P);
    const std::string name = "Hertz at " + std::to_string(m) + ": ";
    checks.that(name + "one zone", found.size() == 1);
    const double H = 1. / 32.;
    checks.near(name + "start", found[0].start.place.arc_length, m - rho, 0.1 * H);
    checks.near(name + "end", found[0].end.place.arc_length, m + rho, 0.1 * H);
    checks.near(name + "length of a patch", found[0].start.uncertainty, H, 1e-15);
    checks.near(name + "length", found[0].length, 2. * rho, 0.2 * H);
  }
}

void zones_at_ends(Checks &checks)
{
  const OneLevel level(square(8, "bottom left"), 0);
  const auto &space = level.multipliers();
  // left: patches 0 to 3, from top to bottom or the other way; bottom: 4 to 7.
  Pressure P(8);
  checks.that("no zone", contact_zones(space, P).empty());
  P[0] = P[1] = P[2] = P[3] = -1.;
  auto found = contact_zones(space, P);
  checks.that("a whole side",
              found.size() == 1 && found[0].start.uncertainty == 0. &&
                found[0].end.uncertainty == 0. && std::abs(found[0].length - 1.) < 1e-14);
  P = Pressure(8);
  P[4] = P[6] = -1.;
  found = contact_zones(space, P);
  checks.that("two zones", found.size() == 2);
  checks.that("the first from the corner",
              found[0].start.place.arc_length == 0. && found[0].start.uncertainty == 0.);
  checks.near("a single patch ends where it ends", found[1].length, 0.25, 1e-14);
}

void zones_around(Checks &checks)
{
  const OneLevel ring(entry("Scene", "Name", "E1") + entry("Discretization", "Patches", "12"), 2);
  const double around = ring.scene.geometry.sides[1].length();
  Pressure P(12);
  for (const unsigned int tau : {11U, 0U, 1U})
    P[tau] = -1.;
  auto found = contact_zones(ring.multipliers(), P);
  checks.that("a zone across the seam is one", found.size() == 1);
  checks.near("its start", found[0].start.place.arc_length, around * 11. / 12., 1e-12 * around);
  checks.near("its end", found[0].end.place.arc_length, around / 6., 1e-12 * around);
  checks.near("its length", found[0].length, around / 4., 1e-12 * around);
  for (double &p : P)
    p = -1.;
  found = contact_zones(ring.multipliers(), P);
  checks.that("all around", found.size() == 1 && std::abs(found[0].length - around) < 1e-12);
}

/** -p = 1 + x at the bottom: the force 3/2 acts at x = (1/2 + 1/3)/(3/2) = 5/9. */
void forces(Checks &checks)
{
  const OneLevel level(square(64), 0);
  const Pressure P = means(level.multipliers(), [](const double x) { return -x - 0.5 * x * x; });
  const auto force_of = [&](const Pressure &pressure) {
    return contact_force(level.multipliers(), level.scene.contact_sides(), pressure);
  };
  const SideForce found = force_of(P);
  checks.that("its side", found.side == "bottom");
  const SideForce::Total &sum = found.resultant;
  checks.near("no horizontal force", sum.force[0], 0., 1e-14);
  // p n = p (0,-1) points upwards.
  checks.near("force", sum.force[1], 1.5, 1e-13);
  // Means over patches of length H lose H²/12 of the linear part's moment.
  const double H = 1. / 32.;
  checks.near("moment", sum.moment[0], 5. / 6. - H * H / 12., 1e-13);
  checks.near("line of action", (*found.through)[0], (5. / 6. - H * H / 12.) / 1.5, 1e-13);
  checks.near("on the side", (*found.through)[1], 0., 1e-13);
  checks.that("no force, no line", !force_of(Pressure(P.size())).through);
  Resultant<2> oblique;
  const dealii::Point<2> a(0.3, -0.7);
  oblique.add(dealii::Tensor<1, 2>({2., 1.}), a);
  const AnswerVector nearest = *side_force<2>("", oblique, {0.3 + 4., -0.7 + 2.}, 1.).through;
  checks.near("a point of the line stays", nearest.distance({4.3, 1.3}), 0., 1e-14);
  const AnswerVector foot = *side_force<2>("", oblique, {0.3 - 1., -0.7 + 2.}, 1.).through;
  checks.near("foot of the perpendicular", foot.distance(a), 0., 1e-14);
}

void trends(Checks &checks)
{
  using Kind = Trend::Kind;
  const auto kind = [](const std::vector<std::optional<double>> &values) {
    return trend_of(values).kind;
  };
  checks.that("one level", kind({1.}) == Kind::unknown);
  checks.that("nothing known", kind({{}, {}}) == Kind::unknown);
  checks.that("order one", kind({1.2, 1.1, 1.05}) == Kind::settled);
  checks.that("levels without contact are left out", kind({{}, 1.2, 1.1, 1.05}) == Kind::settled);
  checks.that("constant", kind({0., 0.}) == Kind::settled);
  checks.that("a punch: factor 2^{1/2}",
              kind({1., std::sqrt(2.), 2., 2. * std::sqrt(2.)}) == Kind::not_settled);
  checks.that("a facet: log h", kind({1., 1.1, 1.2, 1.3}) == Kind::not_settled);
  checks.that("a sharp corner: factor 2^{0.1}", kind({1., 1.072, 1.149}) == Kind::not_settled);
  checks.near("change", *trend_of({1., 0.8}).change, -0.25, 1e-15);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  peak(checks);
  zones(checks);
  zones_at_ends(checks);
  zones_around(checks);
  forces(checks);
  trends(checks);
  return checks.exit_code();
}
