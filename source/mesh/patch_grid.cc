// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows and columns of the patches of a rectangle.

#include <signorini/base/exceptions.h>
#include <signorini/mesh/patch_grid.h>

#include <algorithm>

namespace Signorini
{
namespace
{
constexpr unsigned int no_patch = dealii::numbers::invalid_unsigned_int;

/** The ends of the intervals that the patches [first, last) cover in one coordinate. */
std::vector<double> ends_of(const std::vector<Patch<3>> &patches,
                            const std::size_t first,
                            const std::size_t last,
                            const unsigned int d)
{
  std::vector<double> starts;
  double end = patches[first].upper[d], shortest = end - patches[first].lower[d];
  for (std::size_t t = first; t < last; ++t)
  {
    starts.push_back(patches[t].lower[d]);
    end = std::max(end, patches[t].upper[d]);
    shortest = std::min(shortest, patches[t].upper[d] - patches[t].lower[d]);
  }
  std::sort(starts.begin(), starts.end());
  // Equal up to rounding.
  starts.erase(std::unique(starts.begin(),
                           starts.end(),
                           [&](const double a, const double b) { return b - a < 0.5 * shortest; }),
               starts.end());
  starts.push_back(end);
  return starts;
}

/** The interval that contains a point. */
unsigned int interval_of(const std::vector<double> &ends, const double s)
{
  const auto next = std::upper_bound(ends.begin() + 1, ends.end() - 1, s);
  return next - ends.begin() - 1;
}
} // namespace

std::vector<PatchGrid> patch_grids(const std::vector<Patch<3>> &patches)
{
  std::vector<PatchGrid> grids;
  for (std::size_t first = 0, last = 0; first < patches.size(); first = last)
  {
    while (last < patches.size() && patches[last].side == patches[first].side)
      ++last;
    PatchGrid grid;
    grid.side = patches[first].side;
    for (unsigned int d = 0; d < 2; ++d)
      grid.ends[d] = ends_of(patches, first, last, d);
    grid.patches.assign(static_cast<std::size_t>(grid.n(0)) * grid.n(1), no_patch);
    for (std::size_t t = first; t < last; ++t)
    {
      const dealii::Point<2> centre = patches[t].centre();
      grid.patches[interval_of(grid.ends[0], centre[0]) +
                   grid.n(0) * interval_of(grid.ends[1], centre[1])] = t;
    }
    if (grid.patches.size() != last - first ||
        std::find(grid.patches.begin(), grid.patches.end(), no_patch) != grid.patches.end())
      throw ComputationError("The contact patches of a side in space are not the cells of a grid.");
    grids.push_back(std::move(grid));
  }
  return grids;
}
} // namespace Signorini
