// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/arc_mapping.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <optional>

namespace Signorini {
/** A 2-D stress (s11, s22, s12) or strain (e11, e22, 2 e12): s * e is their scalar product. */
using Components = Tensor<1, 3>;
using Triangle = std::array<Point<2>, 3>;

/** Returns the components of a strain. */
inline Components components_of(const SymmetricTensor<2, 2> &strain) {
  return Components({strain[0][0], strain[1][1], 2. * strain[0][1]});
}

/** Returns a1 b2 - a2 b1. */
inline double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return a[0] * b[1] - a[1] * b[0];
}

inline double twice_area(const Triangle &x) {
  return cross(x[1] - x[0], x[2] - x[0]);
}

/** Returns the image of a point of the unit triangle. */
inline Point<2> point_of(const Triangle &x, const Point<2> &at) {
  return x[0] + at[0] * (x[1] - x[0]) + at[1] * (x[2] - x[0]);
}

/** The bilinear functions of the corners at a point of [0,1]², as values and gradients. */
struct CellFunctions {
  explicit CellFunctions(const Point<2> &at);

  std::array<double, 4> values;
  std::array<Tensor<1, 2>, 4> gradients;
};

/** The numbers of the faces of a cell, counter-clockwise: face k begins at corner k. */
constexpr std::array<unsigned int, 4> face_in_circle = {{2, 1, 3, 0}};

/** Returns the corners of a cell, counter-clockwise. */
inline std::array<Point<2>, 4> corners_of(const Triangulation<2>::cell_iterator &cell) {
  return {{cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)}};
}

struct CellShape;

/** Returns the shape of a cell with its arcs. */
CellShape shape_of(const Triangulation<2>::cell_iterator &cell, const std::vector<Side<2>> &sides);

/** The corners and diagonals of a convex quadrilateral, and its maps from [0,1]². Its edges may be
 * arcs; then areas and maps are those of the quadrilateral of its corners. */
struct CellShape {
  /** @param centres of edge k, from corner k on. */
  explicit CellShape(const std::array<Point<2>, 4> &corners, const ArcCentres &centres = {});

  std::array<Point<2>, 4> corners;
  ArcCentres centres;
  /** The directions of contact on edges that are arcs, where they are not the normals: components
   * of tractions there are those of TractionEdge. */
  std::array<std::optional<Tensor<1, 2>>, 4> directions;
  /** Whether the cell is a parallelogram. */
  bool affine;
  /** The point in which the diagonals meet. */
  Point<2> crossing;
  /** The areas of the four triangles. */
  std::array<double, 4> areas;

  double area() const {
    return areas[0] + areas[1] + areas[2] + areas[3];
  }
  bool has_arcs() const {
    return Signorini::has_arcs(centres);
  }
  /** Returns edge k, counter-clockwise. */
  Curve edge(const unsigned int k) const {
    return Curve::between(corners[k], corners[(k + 1) % 4], centres[k]);
  }
  /** Returns the same cell with x(z) instead of points z. */
  template <typename Map>
  CellShape image(const Map &x) const {
    CellShape shape(*this);
    for (unsigned int k = 0; k < 4; ++k) {
      shape.corners[k] = x(corners[k]);
      if (centres[k])
        shape.centres[k] = x(*centres[k]);
    }
    CellShape result(shape.corners, shape.centres);
    result.directions = directions;
    return result;
  }
  /** Returns the cell with the crossing at the origin. */
  CellShape seen_from_crossing() const {
    return image([this](const Point<2> &z) { return Point<2>(z - crossing); });
  }
  /** Returns the matrix F of the half-diagonals to corners 0 and 1. */
  Tensor<2, 2> half_diagonals() const;
  /** Returns the longest diagonal or edge. */
  double diameter() const;
  /** Returns the triangle (x_k, x_{k+1}, z) with the crossing z. */
  Triangle triangle(const unsigned int k) const {
    return {{corners[k], corners[(k + 1) % 4], crossing}};
  }
  /** Returns the centre of mass of triangle k. */
  Point<2> centre(const unsigned int k) const {
    return crossing + ((corners[k] - crossing) + (corners[(k + 1) % 4] - crossing)) / 3.;
  }
  /** Returns the centre of mass of the cell. */
  Point<2> centre() const;
  /** Returns the vector from corner 0 to the bilinear image of a point in [0,1]². */
  Tensor<1, 2> offset(const CellFunctions &functions) const;
  /** Returns the bilinear image. */
  Point<2> point(const CellFunctions &functions) const {
    return corners[0] + offset(functions);
  }
  /** Returns the Jacobian of the same map. */
  Tensor<2, 2> jacobian(const CellFunctions &functions) const;
  /** Returns the point in [0,1]² whose bilinear image has the given offset. */
  Point<2> reference(const Tensor<1, 2> &offset) const;
};

} // namespace Signorini
