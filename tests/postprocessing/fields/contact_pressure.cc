// SPDX-License-Identifier: LGPL-2.1-or-later
// Resultants, recovery and transfer of piecewise constant pressures, also on patches of different
// lengths.

#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>

#include <cmath>
#include <numeric>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
constexpr unsigned int left = 0, bottom = 2;

/** Patches between the given positions of a side. */
std::vector<Patch<2>> patches_between(const unsigned int side,
                                      const std::vector<double> &positions) {
  std::vector<Patch<2>> patches;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    patches.push_back({side, side, dealii::Point<1>(positions[i]),
                       dealii::Point<1>(positions[i + 1]), positions[i + 1] - positions[i]});
  return patches;
}

std::vector<Patch<2>> both(std::vector<Patch<2>> first, const std::vector<Patch<2>> &second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/** The unit square with contact on the left and at the bottom, and so many cells. */
std::string square(const std::string &contact, const std::string &cells, const std::string &ratio) {
  return "subsection Boundary\nset Clamped = top\nset Contact = " + contact + "\nend\n" +
         entry("Geometry", "Cells", cells) + entry("Discretization", "Patch ratio", ratio);
}

/** The point of a patch with the given position between its ends. */
dealii::Point<1> within(const Patch<2> &patch, const double position) {
  return patch.lower + position * (patch.upper - patch.lower);
}

Pressure pressure(const std::vector<double> &values) {
  return Pressure(dealii::Vector<double>(values.begin(), values.end()));
}

/** Nine faces: patches of the lengths 2/9, 2/9, 2/9, 3/9. */
void summary(Checks &checks) {
  const OneLevel level(square("bottom", "9, 9", "2"), 0);
  const auto of = [&](const std::vector<double> &P) {
    const ContactSummary found = summarise_contact(level.multipliers(), pressure(P));
    return std::vector<double>(
      {double(found.active), found.length, found.normal_force, found.max_pressure});
  };
  checks.near("two patches press", of({-2., 0., 0., -0.5}), {2., 5. / 9., 5.5 / 9., 2.}, 1e-15);
  checks.near("rounding does not press, a small pressure does", of({-2., -1e-16, -0.5, -1e-11})[0],
              3., 0.);
  checks.near("nothing presses", of({0., 0., 0., 0.}), {0., 0., 0., 0.}, 0.);
}

/** Linear pressures on both sides, also where the patches have different lengths. */
void recovery(Checks &checks) {
  // 11 faces and 14: patches of 3, 3 and 5 faces, and of 3, 3, 3 and 5.
  const OneLevel uneven(square("left bottom", "14, 11", "3"), 0);
  const std::vector<Patch<2>> &patches = uneven.discretization.surface.patches();
  checks.that("three patches and four", patches.size() == 7);
  const auto exact = [](const unsigned int side, const double s) {
    return side == left ? -1. - 2. * s : -3. + 2.5 * s;
  };
  Pressure P(patches.size());
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    P[tau] = exact(patches[tau].side, patches[tau].centre()[0]);
  const RecoveredPressure recovered(uneven.multipliers(), P);
  double largest = 0.;
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    for (unsigned int k = 0; k <= 10; ++k) {
      const dealii::Point<1> s = within(patches[tau], 0.1 * k);
      largest = std::max(largest, std::abs(recovered(tau, s) - exact(patches[tau].side, s[0])));
    }
  checks.near("linear pressures are recovered", largest, 0., 1e-14);

  const OneLevel below(square("bottom", "14, 11", "3"), 0);
  const Pressure bumpy = pressure({-0.1, -5., 0., -0.2});
  const RecoveredPressure clipped(below.multipliers(), bumpy);
  double highest = -1., jump = 0.;
  for (unsigned int tau = 0; tau < 4; ++tau) {
    const Patch<2> &patch = below.discretization.surface.patches()[tau];
    for (unsigned int k = 0; k <= 20; ++k)
      highest = std::max(highest, clipped(tau, within(patch, 0.05 * k)));
    if (tau > 0)
      jump = std::max(jump, std::abs(clipped(tau, patch.lower) - clipped(tau - 1, patch.lower)));
  }
  checks.near("recovered pressure is nowhere positive", highest, 0., 0.);
  checks.near("recovered pressure is continuous", jump, 0., 1e-15);

  // One patch on the left, two at the bottom.
  const OneLevel single(square("left bottom", "4, 2", "2"), 0);
  const RecoveredPressure by_side(single.multipliers(), pressure({-3., -1., -2.}));
  checks.near("a single patch keeps its value", by_side(0, dealii::Point<1>(0.9)), -3., 0.);
  checks.near("sides do not mix", by_side(1, dealii::Point<1>(0.)), -0.5, 1e-15);
}

/** Around a circle the last patch is next to the first. */
void closed_side(Checks &checks) {
  const OneLevel ring("Scene/Name = E1\n"
                      "Discretization/Patches = 12\n",
                      2);
  const dealii::Point<1> start(0.), end(ring.scene.geometry.sides[1].length());
  const unsigned int m = 12;
  checks.that("closed side: twelve patches around it",
              ring.scene.geometry.sides[1].name() == "outer" &&
                ring.multipliers().n_multipliers() == m);
  Pressure P(m);
  for (unsigned int tau = 0; tau < m; ++tau)
    P[tau] = -2. - std::cos(2. * dealii::numbers::PI * tau / m);
  const RecoveredPressure recovered(ring.multipliers(), P);
  checks.near("closed side: no jump at the seam", recovered(0, start), recovered(m - 1, end),
              1e-14);
  checks.near("closed side: mean of the neighbours", recovered(0, start), 0.5 * (P[0] + P[m - 1]),
              1e-14);
}

void transfer(Checks &checks) {
  const auto equal = [](const unsigned int n) {
    std::vector<double> positions;
    for (unsigned int i = 0; i <= n; ++i)
      positions.push_back(static_cast<double>(i) / n);
    return both(patches_between(left, positions), patches_between(bottom, positions));
  };
  RandomNumbers random(4);
  const Pressure P(random.vector(14));
  checks.near("equal partitions: identity", distance(transfer_pressure({equal(7), P}, equal(7)), P),
              0., 0.);
  const Pressure halved = transfer_pressure({equal(7), P}, equal(14));
  for (unsigned int tau = 0; tau < 28; ++tau)
    checks.near("halved patches inherit", halved[tau], P[tau / 2], 1e-14);
  const Pressure uneven =
    transfer_pressure({patches_between(bottom, {0., 0.2, 1.}), pressure({-1., -2.})},
                      patches_between(bottom, {0., 0.5, 1.}));
  checks.near("weighted mean", uneven[0], -(0.2 * 1. + 0.3 * 2.) / 0.5, 1e-15);
  // The means of all patches of a side are the same.
  for (const unsigned int n : {1U, 5U, 100U}) {
    const Pressure Q = transfer_pressure({equal(7), P}, equal(n));
    for (const unsigned int side : {0U, 1U})
      checks.near(
        "force", std::accumulate(Q.begin() + side * n, Q.begin() + (side + 1) * n, 0.) / n,
        std::accumulate(P.begin() + side * 7, P.begin() + (side + 1) * 7, 0.) / 7., 1e-14);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {summary, recovery, closed_side, transfer});
}
