// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/cell_shape.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Signorini {
/** A part of one of the triangles of a cell. */
struct TrianglePart {
  Triangle corners;
  /** Whether data is smooth on it. */
  bool resolved = true;
};

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
class LawSampling {
public:
  /** A point with the features of the tensor that are compared: the norms of the tensor and of its
   * inverse, and the shares of its entries in the norm. */
  struct Sample {
    Point<2> x;
    std::array<double, 8> features;
  };
  using Samples = std::vector<Sample>;

  LawSampling(const Material<2> &material, std::size_t n_cells);

  static constexpr unsigned int min_intervals = 6;

  /** Returns m: about 500000 points for a mesh, between 6 and 96 per direction of a cell. */
  unsigned int intervals() const {
    return intervals_;
  }
  Samples scan(const std::array<Point<2>, 4> &corners) const;
  /** Returns whether the tensor varies by more than a factor of 1.5 in a cell. On meshes of so many
   * cells that a scan has m = min_intervals, only the given points are looked at. */
  bool varies_in(const std::array<Point<2>, 4> &corners, const std::vector<Point<2>> &points) const;
  /** Returns whether the tensor varies by more than a factor of 1.5. */
  static bool varies(const Samples &samples);
  /**
   * Appends the parts of a triangle to @p parts.
   * @param samples points in the triangle and outside of it.
   * @param least the length below which edges are not divided.
   */
  void divide(const Triangle &whole, const Samples &samples, double least,
              std::vector<TrianglePart> &parts) const;

private:
  Sample sample(const Point<2> &x) const;

  const Material<2> &material_;
  unsigned int intervals_;
};

/** Returns the parts into which lines and boxes cut the triangles of a cell, divided further where
 * Hooke's tensor varies. @param sampling null for a constant law. */
std::array<std::vector<TrianglePart>, 4> triangle_parts(const CellShape &shape,
                                                        const Kinks<2> &kinks,
                                                        const LawSampling *sampling);

/** Returns a rule on the unit triangle that integrates polynomials of the degree exactly. */
Quadrature<2> triangle_rule(unsigned int degree);
} // namespace Signorini
