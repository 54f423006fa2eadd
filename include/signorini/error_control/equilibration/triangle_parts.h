// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/problem/geometry/kinks.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <vector>

namespace Signorini {
/** A part of one of the triangles of a cell. */
struct TrianglePart {
  Triangle corners;
  /** How often boxes halved it, see PolygonPart. */
  unsigned int halvings = 0;
  /** Whether data still varies faster on it than a few points show: there the integrals of the
   * bound are taken from above. */
  bool is_rough = false;
};

/** Returns the parts into which lines and boxes cut the triangles of a cell. */
std::array<std::vector<TrianglePart>, 4> triangle_parts(const CellShape &shape,
                                                        const Kinks<2> &kinks);

/** Returns a rule on the unit triangle that integrates polynomials of the degree exactly. */
Quadrature<2> triangle_rule(unsigned int degree);

/** Adds the points of a rule on the unit triangle to those of a rule on the reference cell, with
 * their weights. */
void add_points(const Quadrature<2> &rule, const Triangle &part, const CellShape &shape,
                std::vector<Point<2>> &points, std::vector<double> &weights);
} // namespace Signorini
