// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/contact_surface.h>

#include <array>
#include <vector>

namespace Signorini
{
/** The patches of one rectangular side in space, as a grid. */
struct PatchGrid
{
  /** Number of the side in the geometry. */
  unsigned int side = 0;
  /** In both coordinates of the side: where the patches begin, sorted, and the end of the last. */
  std::array<std::vector<double>, 2> ends;
  /** Numbers of the patches; that of column i and row j at i + n(0) j. */
  std::vector<unsigned int> patches;

  /** The number of patches along one coordinate. */
  unsigned int n(const unsigned int d) const
  {
    return ends[d].size() - 1;
  }
  unsigned int at(const unsigned int i, const unsigned int j) const
  {
    return patches[i + n(0) * j];
  }
  double length(const unsigned int d) const
  {
    return ends[d].back() - ends[d].front();
  }
  double middle(const unsigned int d, const unsigned int i) const
  {
    return 0.5 * (ends[d][i] + ends[d][i + 1]);
  }
};

/** One grid for each side, in the order of the patches; m log m operations for m patches. @throws
 * ComputationError where patches are no grid. */
std::vector<PatchGrid> patch_grids(const std::vector<Patch<3>> &patches);
} // namespace Signorini
