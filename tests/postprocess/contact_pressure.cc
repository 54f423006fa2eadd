// SPDX-License-Identifier: LGPL-2.1-or-later
// Resultants, recovery and transfer of piecewise constant pressures, on hand-made patches.

#include <signorini/postprocess/contact_pressure.h>
#include <signorini/scene_input/make_scene.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;

namespace
{
constexpr unsigned int left = 0, bottom = 2;

/** Patches between the given positions of a side. */
std::vector<Patch> patches_between(const unsigned int side, const std::vector<double> &positions)
{
  std::vector<Patch> patches;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    patches.push_back({side, positions[i], positions[i + 1]});
  return patches;
}

std::vector<Patch> both(std::vector<Patch> first, const std::vector<Patch> &second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

MultiplierSpace<2> make_space(const Scene<2> &scene, const std::vector<Patch> &patches)
{
  ContactPartition partition;
  partition.patches = patches;
  return MultiplierSpace<2>(scene, {}, partition);
}

Vector vector(const std::vector<double> &values)
{
  return Vector(values.begin(), values.end());
}

void summary(Checks &checks, const Scene<2> &scene)
{
  const auto space = make_space(scene, patches_between(bottom, {0., 0.1, 0.4, 0.5, 1.}));
  const ContactSummary found = summarise_contact(space, vector({-2., 0., -0.5, 0.}));
  checks.that("two patches press", found.active == 2);
  checks.near("contact length", found.length, 0.2, 1e-15);
  checks.near("normal force", found.normal_force, 0.25, 1e-15);
  checks.near("largest pressure", found.max_pressure, 2., 0.);
  const ContactSummary rounded = summarise_contact(space, vector({-2., -1e-16, -0.5, -1e-11}));
  checks.that("rounding does not press, a small pressure does", rounded.active == 3);
  const ContactSummary nothing = summarise_contact(space, Vector(4));
  checks.that("nothing presses",
              nothing.active == 0 && nothing.length == 0. && nothing.normal_force == 0. &&
                nothing.max_pressure == 0.);
}

/** Linear pressures on both sides, also where the patches have different lengths. */
void recovery(Checks &checks, const Scene<2> &scene)
{
  const std::vector<Patch> patches = both(patches_between(left, {0., 0.3, 0.4, 1.}),
                                          patches_between(bottom, {0., 0.1, 0.4, 0.5, 1.}));
  const auto space = make_space(scene, patches);
  const auto exact = [](const unsigned int side, const double s) {
    return side == left ? -1. - 2. * s : -3. + 2.5 * s;
  };
  Vector P(patches.size());
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    P[tau] = exact(patches[tau].side, patches[tau].middle());
  const RecoveredPressure<2> recovered(space, P);
  double largest = 0.;
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    for (unsigned int k = 0; k <= 10; ++k)
    {
      const double s = patches[tau].start + 0.1 * k * patches[tau].length();
      largest = std::max(largest, std::abs(recovered(tau, s) - exact(patches[tau].side, s)));
    }
  checks.near("linear pressures are recovered", largest, 0., 1e-14);

  const auto bottom_space = make_space(scene, patches_between(bottom, {0., 0.1, 0.4, 0.5, 1.}));
  const Vector bumpy = vector({-0.1, -5., 0., -0.2});
  const RecoveredPressure<2> clipped(bottom_space, bumpy);
  double highest = -1., jump = 0.;
  for (unsigned int tau = 0; tau < 4; ++tau)
  {
    const Patch &patch = bottom_space.partition().patches[tau];
    for (unsigned int k = 0; k <= 20; ++k)
      highest = std::max(highest, clipped(tau, patch.start + 0.05 * k * patch.length()));
    if (tau > 0)
      jump = std::max(jump, std::abs(clipped(tau, patch.start) - clipped(tau - 1, patch.start)));
  }
  checks.near("recovered pressure is nowhere positive", highest, 0., 0.);
  checks.near("recovered pressure is continuous", jump, 0., 1e-15);

  const auto single = make_space(
    scene, both(patches_between(left, {0., 1.}), patches_between(bottom, {0., 0.5, 1.})));
  const Vector given = vector({-3., -1., -2.});
  const RecoveredPressure<2> by_side(single, given);
  checks.near("a single patch keeps its value", by_side(0, 0.9), -3., 0.);
  checks.near("sides do not mix", by_side(1, 0.), -0.5, 1e-15);
}

/** Around a circle the last patch is next to the first. */
void closed_side(Checks &checks)
{
  const Scene<2> ring = make_scene(parse_parameters("", "test", {"Scene/Name=E1"}));
  const unsigned int outer = ring.geometry.find_side("outer");
  const double length = ring.geometry.sides[outer].length();
  const unsigned int m = 12;
  std::vector<Patch> patches;
  Vector P(m);
  for (unsigned int tau = 0; tau < m; ++tau)
  {
    patches.push_back({outer, tau * length / m, (tau + 1) * length / m});
    P[tau] = -2. - std::cos(2. * dealii::numbers::PI * tau / m);
  }
  const auto space = make_space(ring, patches);
  const RecoveredPressure<2> recovered(space, P);
  checks.near(
    "closed side: no jump at the seam", recovered(0, 0.), recovered(m - 1, length), 1e-14);
  checks.near(
    "closed side: mean of the neighbours", recovered(0, 0.), 0.5 * (P[0] + P[m - 1]), 1e-14);
}

double force(const std::vector<Patch> &patches, const Vector &P, const unsigned int side)
{
  double sum = 0.;
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    if (patches[tau].side == side)
      sum += patches[tau].length() * P[tau];
  return sum;
}

void transfer(Checks &checks)
{
  const auto equal = [](const unsigned int n) {
    std::vector<double> positions;
    for (unsigned int i = 0; i <= n; ++i)
      positions.push_back(static_cast<double>(i) / n);
    return both(patches_between(left, positions), patches_between(bottom, positions));
  };
  RandomNumbers random(4);
  const Vector P = random.vector(14);
  checks.near(
    "equal partitions: identity", distance(transfer_pressure(equal(7), P, equal(7)), P), 0., 0.);
  const Vector halved = transfer_pressure(equal(7), P, equal(14));
  double largest = 0.;
  for (unsigned int tau = 0; tau < 28; ++tau)
    largest = std::max(largest, std::abs(halved[tau] - P[tau / 2]));
  checks.near("halved patches inherit", largest, 0., 1e-14);
  checks.near(
    "back from the halves", distance(transfer_pressure(equal(14), halved, equal(7)), P), 0., 1e-14);
  const Vector coarse = transfer_pressure(equal(2), vector({-1., -3., -2., -6.}), equal(1));
  checks.near("means", distance(coarse, vector({-2., -4.})), 0., 1e-15);
  const Vector uneven = transfer_pressure(patches_between(bottom, {0., 0.2, 1.}),
                                          vector({-1., -2.}),
                                          patches_between(bottom, {0., 0.5, 1.}));
  checks.near("weighted mean", uneven[0], -(0.2 * 1. + 0.3 * 2.) / 0.5, 1e-15);
  for (const unsigned int n : {1U, 3U, 5U, 9U, 100U})
    for (const unsigned int side : {left, bottom})
      checks.near("force on side " + std::to_string(side) + " from 7 to " + std::to_string(n) +
                    " patches",
                  force(equal(n), transfer_pressure(equal(7), P, equal(n)), side),
                  force(equal(7), P, side),
                  1e-14);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  const Scene<2> scene = make_scene(parse_parameters(
    "subsection Boundary\nset Clamped = top\nset Contact = left bottom\nend\n", "test"));
  summary(checks, scene);
  recovery(checks, scene);
  closed_side(checks);
  transfer(checks);
  return checks.exit_code();
}
