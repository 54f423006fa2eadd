// SPDX-License-Identifier: LGPL-2.1-or-later
// C^ on sides that are grids of equal patches.

#include <signorini/boundary_model/cosine_model.h>

namespace Signorini
{
namespace
{
using Vector = ComplianceOperator::Vector;

Vector gather_block(const std::vector<unsigned int> &numbers, const Vector &P)
{
  Vector part(numbers.size());
  for (unsigned int a = 0; a < numbers.size(); ++a)
    part[a] = P[numbers[a]];
  return part;
}

void scatter_block(const std::vector<unsigned int> &numbers, const Vector &part, Vector &P)
{
  for (unsigned int a = 0; a < numbers.size(); ++a)
    P[numbers[a]] = part[a];
}
} // namespace

CosineModel::CosineModel(std::vector<GridBlock> blocks,
                         Vector scaling,
                         const unsigned int largest_factorised)
  : BoundaryModel(largest_factorised)
  , blocks_(std::move(blocks))
  , scaling_(std::move(scaling))
  , places_(scaling_.size())
{
  for (unsigned int b = 0; b < blocks_.size(); ++b)
    for (unsigned int a = 0; a < blocks_[b].multipliers.size(); ++a)
      places_[blocks_[b].multipliers[a]] = {b, a};
}

unsigned int CosineModel::size() const
{
  return scaling_.size();
}

Vector CosineModel::apply(const Vector &P) const
{
  Vector scaled(P), product(P.size());
  scaled.scale(scaling_);
  for (const GridBlock &block : blocks_)
    scatter_block(
      block.multipliers, block.grid.apply(gather_block(block.multipliers, scaled)), product);
  product.scale(scaling_);
  return product;
}

Vector CosineModel::apply_inverse(const Vector &P) const
{
  Vector scaled(P), product(P.size());
  for (unsigned int k = 0; k < P.size(); ++k)
    scaled[k] /= scaling_[k];
  for (const GridBlock &block : blocks_)
    scatter_block(block.multipliers,
                  block.grid.apply_inverse(gather_block(block.multipliers, scaled)),
                  product);
  for (unsigned int k = 0; k < P.size(); ++k)
    product[k] /= scaling_[k];
  return product;
}

double CosineModel::entry(const unsigned int i, const unsigned int j) const
{
  if (places_[i].first != places_[j].first)
    return 0.;
  return scaling_[i] * scaling_[j] *
         blocks_[places_[i].first].grid.entry(places_[i].second, places_[j].second);
}
} // namespace Signorini
