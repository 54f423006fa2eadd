// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/box_tree.h>

#include <deal.II/base/quadrature.h>

#include <functional>
#include <vector>

namespace Signorini {
/** A square in the unit square, and how often this was halved in both directions. */
struct SquarePart {
  Point<2> corner;
  double width = 1.;
  unsigned int halvings = 0;

  Point<2> operator()(const Point<2> &xi) const {
    return corner + width * (xi - Point<2>());
  }
  /** Returns a rule of at most n x n points; half the size needs one point less. */
  Quadrature<2> rule(unsigned int n) const;
};

/** Returns quarters of the unit square, sixteenths and so on, until the image of each is in four
 * boxes of data that is smooth in all of them.
 * @param image a smooth map of the unit square to the body. */
std::vector<SquarePart> smooth_parts(const BoxTree &boxes,
                                     const std::function<Point<2>(const Point<2> &)> &image);
} // namespace Signorini
