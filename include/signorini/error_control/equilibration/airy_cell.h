// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/law.h>
#include <signorini/error_control/equilibration/traction_space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini {
/** A point in a cell of unit size. */
struct AiryPoint {
  /** The coordinates in [0,1]², and along the half-diagonals (AiryCell). */
  Point<2> reference, on_diagonals;
  double weight;
  /** w^{1/2} Gᵀ and w^{1/2} G⁻¹ with the weight w and Hooke's law C = G Gᵀ: squares of the weighted
   * strain and of the weighted stress are energies. */
  Tensor<2, 3> of_strain, of_stress;
  /** w (C' - C), where C' is as stiff as any law in an unresolved box and C as soft. */
  Tensor<2, 3> unresolved;
  /** Law::min_eigenvalue. */
  double min_eigenvalue;
};

/** A polynomial body force f = F Σ f_l Λ_i(X) Λ_j(Y) over i + j < q, in the order of i, then j,
 * with F = (a_1 a_2) the half-diagonals to corners 0 and 1, and Legendre's polynomials Λ between
 * opposite corners. */
using PolynomialLoad = std::vector<Tensor<1, 2>>;

/**
 * Stresses of degree q on a quadrilateral that is cut by its diagonals: symmetric, polynomials on
 * each of the four triangles, with continuous tractions.
 *
 * In the coordinates (X, Y) along the half-diagonals the corners are (1,0), (0,1), (-p,0), (0,-r).
 * Stresses without loads are τ = F s Fᵀ, s = (φ_YY, φ_XX, -φ_XY), of functions φ that are C¹ and on
 * every triangle polynomials of degree q + 2: products f_i(X) f_j(Y), i + j ≤ q + 2, with f_0 = 1,
 * f_1 = X, and f_i = X² L_{i-2} on one of the two half-axes and zero on the other one, i ≥ 2. (Such
 * spaces: M.-J. Lai, L. L. Schumaker, Spline Functions on Triangulations, 2007, chapter 6.) Their
 * traces are all tractions of degree q that are in balance: the rank of N is 8 (q + 1) - 3.
 *
 * In the triangle of an edge that is an arc φ goes on, and stresses are τ - L(τ n) + L(λ): the
 * ArcLift L replaces the traction of τ by λ, polynomials of the angle along n and t, or along the
 * direction of contact and its tangent, which are 2 (q + 1) further functions and the traces on
 * this edge. The conditions of the lift on λ - τ n are five further traces, which are zero.
 *
 * With the Gram matrix G of these stresses in the norm ‖.‖_{E⁻¹}, the traces y in balance cost the
 * energy yᵀ S y, S = (N G⁻¹ Nᵀ)⁺. G = RᵀR is not formed: lifts of one more degree are nearly
 * polynomials, so that behind arcs the condition of G is 7e16 at degree 9. That of R, a factor of
 * the stresses at the points, is its root. All of that is for the cell at unit size: stresses do
 * not depend on it, energies are multiplied by its square.
 */
class AiryCell {
public:
  using Vector = dealii::Vector<double>;

  /** Tabulates the stresses. @param points those of the four triangles; behind arcs those of the
   * ArcLift. @throws ComputationError if the cell is so flat that rounding hides the rank. */
  AiryCell(const CellShape &unit_shape, unsigned int degree,
           std::array<std::vector<AiryPoint>, 4> points);

  const std::array<std::vector<AiryPoint>, 4> &points() const {
    return points_;
  }
  std::size_t n_points() const {
    return points_[0].size() + points_[1].size() + points_[2].size() + points_[3].size();
  }
  unsigned int degree() const {
    return degree_;
  }
  unsigned int n_traces() const {
    return traces_.n();
  }
  /**
   * Returns the part of a body force that stresses balance, of the degree q - 1: the projection of
   * a force with the given values at points with weights, those of the cell at unit size.
   * @param rest_square receives the square of the norm of the rest.
   */
  PolynomialLoad project(const std::vector<Point<2>> &on_diagonals,
                         const std::vector<double> &weights, const std::vector<Tensor<1, 2>> &force,
                         double &rest_square) const;
  Tensor<1, 2> value(const PolynomialLoad &load, const Point<2> &on_diagonals) const;
  /** Subtracts the weighted values of stresses δ with div δ = -f from those at the points, three
   * for each, and returns the traces of δ. */
  Vector subtract_load(const PolynomialLoad &load, Vector &values) const;
  /** Subtracts the weighted values of the stress that lifts a given traction on edge k, an arc,
   * from those at the points. @param r at the nodes of lift(). @return its traces. */
  Vector subtract_traction(unsigned int k, const std::vector<Tensor<1, 2>> &r,
                           Vector &values) const;
  const std::optional<ArcLift> &lift(const unsigned int k) const {
    return lifts_[k];
  }
  /**
   * Projects weighted values onto the stresses without loads.
   * @param values receives the rest. @return the traces of the projection.
   */
  Vector project(Vector &values) const;
  /** Releases the points, most of the memory; S remains. */
  void forget_points();
  /** Returns S y, for y in balance. */
  Vector multiply(const Vector &y) const;
  /** Returns the mean of the diagonal of S. */
  double mean_energy() const {
    return energy_.trace() / energy_.m();
  }
  /** Returns S + weight BᵀB. */
  FullMatrix<double> penalised_energy(double weight) const;
  /** Returns B, the rows of balance. */
  const FullMatrix<double> &balance() const {
    return balance_;
  }
  /** Returns the coordinates along the half-diagonals of a vector from the crossing. */
  Point<2> on_diagonals(const Tensor<1, 2> &from_crossing) const {
    return Point<2>(inverse_ * from_crossing);
  }

private:
  /** Returns the stresses without loads at a point of triangle k. */
  std::vector<Components> stresses(unsigned int k, const Point<2> &at) const;
  Components stress(const PolynomialLoad &load, const Point<2> &at) const;
  /** Returns Λ_i at X or Y. */
  std::array<double, max_legendre> load_values(unsigned int d, double at) const;
  /** Returns the integrals of Λ_i from zero to X or Y. */
  std::array<double, max_legendre> load_integrals(unsigned int d, double at) const;
  /** A point of a rule on an edge: each trace with the factors that stresses have in it. */
  struct TracePoint {
    Point<2> on_diagonals;
    std::vector<std::pair<unsigned int, Components>> factors;
  };
  std::vector<TracePoint> trace_points(unsigned int k) const;
  /** Returns the number of the first condition on edge k among the traces. */
  unsigned int first_condition(unsigned int k) const;
  /** Subtracts the weighted values of L(r) from the columns of values on triangle k. @param r by
   * component at the nodes (rows). @return the conditions on r (rows). */
  LAPACKFullMatrix<double> subtract_lift(unsigned int k, const LAPACKFullMatrix<double> &r,
                                         LAPACKFullMatrix<double> &values) const;
  /** Tabulates the functions of triangle k, and adds their traces. */
  void tabulate(unsigned int k);
  /** Adds weight BᵀB. */
  void add_balance(double weight, FullMatrix<double> &matrix) const;
  void number_functions();
  void factorise();
  void factorise_loads();

  CellShape shape_;
  unsigned int degree_;
  std::array<std::vector<AiryPoint>, 4> points_;
  /** Those on the edges of the triangles. */
  std::array<std::vector<TracePoint>, 4> trace_points_;
  std::array<std::optional<ArcLift>, 4> lifts_;
  /** The matrix F, its inverse, and s -> F s Fᵀ by components. */
  Tensor<2, 2> F_, inverse_;
  Tensor<2, 3> push_forward_;
  /** The half-axes +X, +Y, -X, -Y. */
  std::array<double, 4> half_axes_;
  /** The pairs (i, j), and the number of the function on every triangle; then those of λ. */
  std::vector<std::array<unsigned int, 2>> pairs_;
  std::array<std::vector<unsigned int>, 4> numbers_;
  unsigned int n_functions_ = 0;
  /** The weighted values on each triangle. */
  std::array<LAPACKFullMatrix<double>, 4> values_;
  /** R with G = RᵀR, and R⁻ᵀ Nᵀ. */
  LAPACKFullMatrix<double> factor_, traces_;
  /** The same factor of the Gram matrix of the body forces. */
  LAPACKFullMatrix<double> load_factor_;
  FullMatrix<double> energy_, balance_;
};
} // namespace Signorini
