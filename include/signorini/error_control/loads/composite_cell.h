// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/edge_mesh.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace Signorini
{
/** A 2-D stress (s11, s22, s12) or strain (e11, e22, 2 e12): s:e is their scalar product. */
using Components = std::array<double, 3>;

/** Returns a1 b2 - a2 b1. */
inline double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** The corners and diagonals of a convex quadrilateral. */
struct CellShape
{
  explicit CellShape(const std::array<Point<2>, 4> &corners);
  /** Takes the corners of a cell, and the bulges if it is curved. */
  explicit CellShape(const EdgeCell &cell);

  std::array<Point<2>, 4> corners;
  Bulges bulges{};
  bool is_curved = false;
  /** The point z in which the diagonals meet: x_c = z + t (x_0 - z) for c = 2 with t = -p, and so
   * on. */
  Point<2> crossing;
  /** The ratios in x_2 = z - p (x_0 - z) and x_3 = z - q (x_1 - z). */
  double p, q;
  /** The areas of the triangles (x_k, x_{k+1}, z). */
  std::array<double, 4> areas;
  /** Whether the cell is a parallelogram. */
  bool affine;

  double area() const
  {
    return areas[0] + areas[1] + areas[2] + areas[3];
  }
  /** Returns the longest diagonal or edge. */
  double diameter() const;
  /** Returns the centre of mass of triangle k. */
  Point<2> centre(unsigned int k) const;
  /** Returns the centre of mass of the cell. */
  Point<2> centre() const;
};

/**
 * The stresses of the composite quadrilateral of Johnson and Mercier (Numer. Math. 30 (1978)
 * 103-116): symmetric, linear on each of the four triangles into which the diagonals divide the
 * cell, with continuous tractions.
 *
 * Such a stress is determined by the moments of its tractions on the four edges and by the loads
 * d_k with div τ + d_k = 0 on triangle k, if they are in balance. It is stored as the components
 * at the mid-points of the edges of the triangles: entry 9 k + 3 m + i is component i on triangle k
 * opposite vertex m of (x_k, x_{k+1}, z).
 *
 * The equations are solved on the affine image of the cell whose crossing is the origin and whose
 * corners 0 and 1 are the unit points. With F the matrix of the map and τ = F τ' Fᵀ, moments
 * are det(F) F b' and loads F d'. So thin cells are as good as squares, and all parallelograms have
 * the same equations.
 */
class CompositeCell
{
public:
  static constexpr unsigned int n_stresses = 36, n_moments = 16, n_loads = 8;
  using Stresses = std::array<double, n_stresses>;
  using Loads = std::array<double, n_loads>;

  explicit CompositeCell(const CellShape &shape);

  /** Returns the stress with the given moments of tractions and loads, which are in balance. */
  Stresses stress(const CellMoments &moments, const Loads &loads) const;
  /** Returns the stress with the given moments, without loads. */
  Stresses stress(const CellMoments &moments) const;
  /** Applies the transpose of stress(moments). */
  CellMoments transposed(const Stresses &values) const;

  /** Returns the stress with the moment @p j equal to one, moments first, then loads. Only sums of
   * columns whose moments and loads are in balance have a meaning. */
  const Stresses &column(const unsigned int j) const
  {
    return columns_[j];
  }

private:
  std::array<Stresses, n_moments + n_loads> columns_;
};

/** Returns ψ_m, m = 0, 1, 2, at a point with barycentric coordinates λ. ψ_m is the linear
 * function that is one at the mid-point opposite vertex m and zero at the others. */
inline std::array<double, 3> midpoint_functions(const std::array<double, 3> &lambda)
{
  return {{1. - 2. * lambda[0], 1. - 2. * lambda[1], 1. - 2. * lambda[2]}};
}

/** Returns the components of the stress on triangle k at a point with the values ψ. */
inline Components stress_at(const CompositeCell::Stresses &stresses,
                            const unsigned int k,
                            const std::array<double, 3> &psi)
{
  Components s;
  for (unsigned int i = 0; i < 3; ++i)
    s[i] = psi[0] * stresses[9 * k + i] + psi[1] * stresses[9 * k + 3 + i] +
           psi[2] * stresses[9 * k + 6 + i];
  return s;
}
} // namespace Signorini
