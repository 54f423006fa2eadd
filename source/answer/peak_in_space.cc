// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure on rectangles.

#include <signorini/answer/peak_pressure.h>
#include <signorini/postprocess/contact_pressure.h>

#include <array>
#include <cmath>

#include "mean_parabola.h"

namespace Signorini
{
namespace
{
/** A pressure at a point of a side. */
struct PressureAt
{
  dealii::Point<2> s;
  double value;
};

/** Whether a material is its own mirror image in a plane at right angles to an axis: entries of
 * Hooke's tensor with an odd number of indices of this axis vanish. */
bool is_symmetric(const dealii::SymmetricTensor<4, 3> &E, const unsigned int axis)
{
  const double negligible = 1e-12 * E.norm();
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          if (((i == axis) + (j == axis) + (k == axis) + (l == axis)) % 2 == 1 &&
              std::abs(E[i][j][k][l]) > negligible)
            return false;
  return true;
}

/** Whether a roller meets the contact side at a point of its edge. Then the body with its mirror
 * image is a body of twice the size, and the pressure goes on symmetrically. */
bool is_mirror(const Scene<3> &scene, const dealii::Point<3> &x)
{
  const double rounding = 1e-9 * scene.geometry.diameter();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const Side<3> &side = scene.geometry.sides[i];
    const dealii::Tensor<1, 3> n = side.normal(dealii::Point<2>());
    if (scene.boundary[i].role != Role::roller ||
        std::abs((x - side.point(dealii::Point<2>())) * n) > rounding)
      continue;
    unsigned int axis = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(n[d]) > std::abs(n[axis]))
        axis = d;
    return is_symmetric(scene.material->relative_hooke(x), axis);
  }
  return false;
}

/** By direction: whether the edges before the first and behind the last patch are mirrors. */
using Mirrors = std::array<std::array<bool, 2>, 2>;

Mirrors mirrors_of(const PatchGrid &grid, const Scene<3> &scene)
{
  const Side<3> &side = scene.geometry.sides[grid.side];
  Mirrors mirrors;
  for (unsigned int d = 0; d < 2; ++d)
    for (unsigned int end = 0; end < 2; ++end)
    {
      dealii::Point<2> s(0.5 * (grid.ends[0].front() + grid.ends[0].back()),
                         0.5 * (grid.ends[1].front() + grid.ends[1].back()));
      s[d] = end == 0 ? grid.ends[d].front() : grid.ends[d].back();
      mirrors[d][end] = is_mirror(scene, side.point(s));
    }
  return mirrors;
}

/** The parabola along coordinate @p d over patch @p index with its own mean and those of its
 * neighbours, which a mirror may take the place of; none where a neighbour is missing or does not
 * press. */
std::optional<MeanParabola> parabola_along(const PatchGrid &grid,
                                           const Mirrors &mirrors,
                                           const dealii::Vector<double> &P,
                                           const unsigned int d,
                                           const std::array<unsigned int, 2> &index)
{
  const double threshold = pressing_threshold(P);
  const std::vector<double> &ends = grid.ends[d];
  const unsigned int i = index[d], n = grid.n(d);
  const auto mean = [&](const unsigned int k) {
    std::array<unsigned int, 2> other = index;
    other[d] = k;
    return P[grid.at(other[0], other[1])];
  };
  if ((i == 0 && !mirrors[d][0]) || (i + 1 == n && !mirrors[d][1]))
    return {};
  const double before = mean(i == 0 ? 0 : i - 1), after = mean(i + 1 == n ? i : i + 1);
  if (!(before < threshold) || !(after < threshold))
    return {};
  return MeanParabola({{i == 0 ? 2. * ends[0] - ends[1] : ends[i - 1],
                        ends[i],
                        ends[i + 1],
                        i + 1 == n ? 2. * ends[n] - ends[n - 1] : ends[i + 2]}},
                      {{-before, -mean(i), -after}});
}
/** The middle and the ends of an interval. A line that is continued to a mirror would have a kink
 * there: such an end is left out. */
std::vector<double> positions_on(const PatchGrid &grid,
                                 const Mirrors &mirrors,
                                 const unsigned int d,
                                 const unsigned int i)
{
  std::vector<double> positions = {grid.middle(d, i)};
  if (i > 0 || !mirrors[d][0])
    positions.push_back(grid.ends[d][i]);
  if (i + 1 < grid.n(d) || !mirrors[d][1])
    positions.push_back(grid.ends[d][i + 1]);
  return positions;
}
} // namespace

std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<3> &multipliers,
                                             const dealii::Vector<double> &P,
                                             const std::vector<SingularPlace<3>> &outside_of)
{
  const ContactSurface<3> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  const RecoveredPressure<3> recovered(multipliers, P);
  std::optional<PressureMaximum> peak;
  const auto compare = [&](const unsigned int tau, const PressureAt &candidate) {
    // Of equal peaks (a symmetric body may have two) the first, whatever rounding makes of them.
    constexpr double larger = 1. + 1e-9;
    const Patch<3> &patch = surface.patches()[tau];
    const Side<3> &side = surface.side(patch);
    const dealii::Point<3> x = side.point(candidate.s);
    if ((!peak || candidate.value > larger * peak->value) && !any_contains(outside_of, x))
      peak = {candidate.value, {side.name(), 0., x}, -P[tau], {}};
  };
  for (const PatchGrid &grid : patch_grids(surface.patches()))
  {
    const Mirrors mirrors = mirrors_of(grid, surface.scene());
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int i = 0; i < grid.n(0); ++i)
      {
        const unsigned int tau = grid.at(i, j);
        if (!(P[tau] < threshold))
          continue;
        const auto along_x = parabola_along(grid, mirrors, P, 0, {{i, j}});
        const auto along_y = parabola_along(grid, mirrors, P, 1, {{i, j}});
        if (along_x && along_y)
        {
          const MeanParabola::Value x = along_x->maximum_with_ends(),
                                    y = along_y->maximum_with_ends();
          compare(tau, {{x.s, y.s}, x.value + y.value + P[tau]});
        }
        else
          for (const double t : positions_on(grid, mirrors, 1, j))
            for (const double r : positions_on(grid, mirrors, 0, i))
              compare(tau, {{r, t}, -recovered(tau, {r, t})});
      }
  }
  return peak;
}
} // namespace Signorini
