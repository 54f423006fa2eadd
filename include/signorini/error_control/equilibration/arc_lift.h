// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini {
struct CellShape;

/**
 * A stress τ_L without loads in the curved triangle T = {z + t p(a)} between a point z and an arc
 * γ, p = γ - z, 0 ≤ a, t ≤ 1, a by the angle: it has any traction r on the arc that has neither
 * force nor moment and fits the corners, and no traction on the two straight sides.
 *
 * With g' = (-r_2, r_1) |γ'|, g(0) = 0, A' = g.γ', A(0) = 0 and B = g.p it is that of Airy's
 * function
 *
 *     φ = A(a) χ_0(t) + B(a) χ_1(t),   χ_0 = t^k (1 + k (1 - t)),   χ_1 = -t^k (1 - t).
 *
 * On the arc φ = A and ∂_t φ = B, so that grad φ = g and the traction is r. On the sides a = 0 and
 * a = 1 φ and its derivatives vanish if A = B = A' = B' = 0 there: that is g = 0 at both ends (r
 * has no force), A = 0 (no moment), and r.p^⊥ = 0 at both ends: a corner that no load on the
 * straight side holds has a symmetric stress. Continued by zero, φ is C¹ in the cell. So these are
 * five conditions on r; k exceeds the degree of all polynomials from which r may come, or τ - τ_L
 * would vanish for some of them.
 *
 * Condition: (γ - z) x γ' > 0, with a margin: the arc is seen from z. Functions of a are
 * interpolated at Gauss' points, which for arcs of less than 60 degrees is exact up to rounding.
 */
class ArcLift {
public:
  static constexpr unsigned int n_conditions = 5;

  /** @param arc relative to z, counter-clockwise around it. @param degree of the stresses whose
   * tractions are lifted. @throws ComputationError if the arc is not seen. */
  ArcLift(const Curve &arc, unsigned int degree);

  /** Returns whether an arc is seen from the origin, with distances of its tangents that differ by
   * less than a factor of five, and turns by less than 60 degrees. */
  static bool is_seen(const Curve &arc);
  /** Returns whether all arcs of a cell are seen from the point in which its diagonals meet. */
  static bool sees_arcs(const CellShape &cell);

  /** A point of the arc: a, γ - z, the outward normal and tangent, and ds. */
  struct Node {
    double position;
    Point<2> x;
    Tensor<1, 2> normal, tangent;
    double weight;
  };
  const std::vector<Node> &nodes() const {
    return nodes_;
  }
  /** Returns the points of a rule on T relative to z, and their weights. */
  const std::vector<std::pair<Point<2>, double>> &points() const {
    return points_;
  }
  /** Returns τ_L at the points (three rows each) by r at the nodes (two columns each). */
  const LAPACKFullMatrix<double> &stresses() const {
    return stresses_;
  }
  /** Returns the force, the moment about z and r.p^⊥ at both ends (rows) by r at the nodes. */
  const LAPACKFullMatrix<double> &conditions() const {
    return conditions_;
  }

private:
  std::vector<Node> nodes_;
  std::vector<std::pair<Point<2>, double>> points_;
  LAPACKFullMatrix<double> stresses_, conditions_;
};
} // namespace Signorini
