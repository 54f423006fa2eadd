// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/edge_mesh.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace Signorini {
/** A 2-D stress (s11, s22, s12) or strain (e11, e22, 2 e12): s * e is their scalar product. */
using Components = Tensor<1, 3>;
using Triangle = std::array<Point<2>, 3>;

/** Returns a1 b2 - a2 b1. */
inline double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return a[0] * b[1] - a[1] * b[0];
}

inline double twice_area(const Triangle &x) {
  return cross(x[1] - x[0], x[2] - x[0]);
}

/** Returns the barycentric coordinates of a point. */
inline std::array<double, 3> barycentric(const Triangle &x, const Point<2> &point) {
  std::array<double, 3> lambda;
  for (unsigned int v = 0; v < 3; ++v)
    lambda[v] = twice_area({{point, x[(v + 1) % 3], x[(v + 2) % 3]}}) / twice_area(x);
  return lambda;
}

/**
 * The nine hierarchical functions of degree two at a point of [0,1]², as values and gradients: the
 * bilinear functions of the corners; 4 s (1 - s) (1 - d) for every edge, with the position s along
 * it and the depth d behind it; and the bubble of the cell. Corners and edges are in the order of
 * EdgeCell.
 */
struct CellFunctions {
  explicit CellFunctions(const Point<2> &at);

  static constexpr unsigned int n_corners = 4, n_functions = 9;
  std::array<double, n_functions> values;
  std::array<Tensor<1, 2>, n_functions> gradients;
};

/** The corners and diagonals of a convex quadrilateral, and its maps from [0,1]². */
struct CellShape {
  explicit CellShape(const std::array<Point<2>, 4> &corners, const Bulges &bulges = {});
  explicit CellShape(const EdgeCell &cell)
    : CellShape(cell.corners, cell.bulges) {}

  std::array<Point<2>, 4> corners;
  Bulges bulges;
  /** Whether there are bulges; whether the cell is a parallelogram without any. */
  bool is_curved, affine;
  /** The point in which the diagonals meet. */
  Point<2> crossing;
  /** The areas of the four triangles. */
  std::array<double, 4> areas;

  double area() const {
    return areas[0] + areas[1] + areas[2] + areas[3];
  }
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
  /** Returns the matrix with the columns (x_1 - x_0)/2 and (x_3 - x_0)/2. */
  Tensor<2, 2> half_edges() const;
  /** Returns the vector from corner 0 to the image of a point in [0,1]²: bilinear, or with bulges.
   */
  Tensor<1, 2> offset(const CellFunctions &functions, bool with_bulges) const;
  /** Returns the Jacobian of the same map. */
  Tensor<2, 2> jacobian(const CellFunctions &functions, bool with_bulges) const;
  /** Returns the point in [0,1]² whose bilinear image has the given offset. */
  Point<2> reference(const Tensor<1, 2> &offset) const;
};

/** Returns the strain of Σ_i u_i φ_i from the gradients of φ_i. */
template <std::size_t n_values, std::size_t n_gradients>
Components strain_of(const std::array<Tensor<1, 2>, n_gradients> &gradients,
                     const std::array<Tensor<1, 2>, n_values> &u) {
  Components e;
  for (std::size_t i = 0; i < n_values; ++i)
    e += Components({gradients[i][0] * u[i][0], gradients[i][1] * u[i][1],
                     gradients[i][1] * u[i][0] + gradients[i][0] * u[i][1]});
  return e;
}

/**
 * The stresses of the composite quadrilateral of Johnson and Mercier (Numer. Math. 30 (1978)
 * 103-116): symmetric, linear on each of the four triangles into which the diagonals divide the
 * cell, with continuous tractions.
 *
 * Such a stress is determined by the moments of its tractions on the four edges and by the loads
 * d_k with div τ + d_k = 0 on triangle k, if they are in balance. It is stored as its components at
 * the corners of the triangles: entry 9 k + 3 m + i is component i on triangle k at its corner m.
 *
 * The equations are solved on the affine image of the cell whose crossing is the origin and whose
 * corners 0 and 1 are the unit points. With F the matrix of the map and τ = F τ' Fᵀ, moments
 * are det(F) F b' and loads F d'. So thin cells are as good as squares.
 */
class CompositeCell {
public:
  /** The degree of stresses and of tractions on edges. */
  static constexpr unsigned int degree = 1;
  static constexpr unsigned int n_stresses = 4 * 3 * (degree + 1) * (degree + 2) / 2;
  static constexpr unsigned int n_moments = 4 * 2 * (degree + 1);
  static constexpr unsigned int n_loads = 4 * degree * (degree + 1);
  static constexpr unsigned int n_data = n_moments + n_loads;

  explicit CompositeCell(const CellShape &shape);

  /** Returns the entry of a stress by the number of the moment or load that is one. Only sums of
   * columns whose moments and loads are in balance have a meaning. */
  double operator()(const unsigned int entry, const unsigned int data) const {
    return matrix_[entry][data];
  }

private:
  std::array<std::array<double, n_data>, n_stresses> matrix_;
};
} // namespace Signorini
