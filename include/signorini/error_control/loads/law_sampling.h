// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/cell_rule.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Signorini
{
/**
 * Finds where Hooke's tensor varies inside of cells, and divides their triangles there.
 *
 * Every cell is sampled at m x m points, m = intervals(). Where the tensor varies by more than a
 * factor of 1.5 (a norm, that of the compliance, or a share in the norm), triangles are halved
 * until it does not, or until their longest edge is below 1/m of the cell's diameter. Parts in
 * which it still varies are marked: there the integrals of the bound are taken from above.
 *
 * Layers and inclusions that are wider than 1/m of the cell are seen; narrower ones may be missed.
 */
class LawSampling
{
public:
  /** The features of the tensor that are compared between points. */
  using Features = std::array<double, 8>;
  struct Sample
  {
    Point<2> x;
    Features features;
  };
  using Samples = std::vector<Sample>;

  LawSampling(const Material<2> &material, std::size_t n_cells);

  /** Returns m: about 500000 points for a mesh, between 6 and 96 per direction of a cell. */
  unsigned int intervals() const
  {
    return intervals_;
  }
  Samples scan(const std::array<Point<2>, 4> &corners) const;
  /** Returns whether the tensor varies by more than a factor of 1.5. */
  static bool varies(const Samples &samples);
  /**
   * Divides a triangle into parts.
   * @param least the length below which edges are not divided.
   */
  std::vector<RulePart> divide(const RulePart::Triangle &whole,
                               const Samples &samples,
                               double least) const;

private:
  Sample sample(const Point<2> &x) const;

  const Material<2> &material_;
  unsigned int intervals_;
};
} // namespace Signorini
