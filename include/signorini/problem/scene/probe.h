// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** Points for which a user wants the largest stresses and displacements: those of some sides, of a
 * region, of a disc (in space a ball), of a box, a point or a line. */
template <int dim>
struct Probe {
  /** The text that describes it, and the entry for messages. */
  std::string name, where;
  std::vector<unsigned int> sides;
  std::optional<unsigned int> region;
  /** The centre and the radius of a disc (length); without a disc the radius is negative. */
  Point<dim> centre;
  double radius = -1.;
  std::optional<BoundingBox<dim>> box;
  /** The arc lengths between which points of the side count. */
  std::optional<std::array<double, 2>> stretch;
  /** The point, or points at equal distances along the line; else empty. */
  std::vector<Point<dim>> points;
  /** Whether means over it are wanted, with guaranteed bounds of their errors. */
  bool is_guaranteed = false;

  /** Returns whether a point lies in the disc or in the box. */
  bool contains(const Point<dim> &x) const {
    return box ? box->point_inside(x) : x.distance(centre) <= radius;
  }
};
} // namespace Signorini
