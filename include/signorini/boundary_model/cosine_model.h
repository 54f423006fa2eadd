// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/boundary_model/boundary_model.h>
#include <signorini/boundary_model/cosine_grid.h>

#include <utility>
#include <vector>

namespace Signorini
{
/** The patches of one side as a grid. */
struct GridBlock
{
  CosineGrid grid;
  /** The multiplier of every patch of the grid. */
  std::vector<unsigned int> multipliers;
};

/** C^ = S B S, B block diagonal with a cosine series on each side, S a diagonal matrix. */
class CosineModel final : public BoundaryModel
{
public:
  /** @param scaling the diagonal of S. @param largest_factorised see BoundaryModel. */
  CosineModel(std::vector<GridBlock> blocks, Vector scaling, unsigned int largest_factorised);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector apply_inverse(const Vector &P) const override;
  double entry(unsigned int i, unsigned int j) const override;

private:
  std::vector<GridBlock> blocks_;
  Vector scaling_;
  /** By multiplier: block and number in its grid. */
  std::vector<std::pair<unsigned int, unsigned int>> places_;
};
} // namespace Signorini
