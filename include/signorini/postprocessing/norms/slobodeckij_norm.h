// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/**
 * The kernel of the cosine norm, as a function of the distance of two points on a line that is
 * repeated with the period P:
 *
 *     κ(x) = (1/P) Σ_k (1 + (k ω)²)^{-1/2} e^{i k ω x}
 *          = (1/π) Σ_m K_0(|x + m P|),   ω = 2 π/P, all integers k and m.
 *
 * The second line is the first one by Poisson's summation. For short periods, where it needs many
 * terms, ln sin takes its singularity:
 *
 *     κ(x) = 1/P - (1/π) ln(2 |sin(ω x/2)|)
 *            + (2/P) Σ_{k ≥ 1} ((1 + (k ω)²)^{-1/2} - 1/(k ω)) cos(k ω x).
 *
 * On a side of length L
 *
 *     ‖q‖²_{-1/2} = ∫∫ q(s) q(t) (κ(s - t) + κ(s + t)) ds dt,  P = 2 L;
 *
 * on a closed side P = L, and the second term is missing.
 */
class DualKernel
{
public:
  explicit DualKernel(double period);

  double period() const
  {
    return period_;
  }
  /** Returns the distance from a point to the nearest singularity, a multiple of P. */
  double distance(double x) const;
  /** Returns κ(x) with an error below 1e-8. At singularities it returns the value 1e-18 P next
   * to them. */
  double operator()(double x) const;

private:
  double period_, omega_;
};

/**
 * Returns the Gram matrix of the basis of Q^H in the cosine norm. It is block diagonal: the square
 * of the norm is the sum over the sides.
 *
 * Constants on patches of about the same length take the series of SpectralNorm. Series do not
 * resolve the patches of graded meshes; there
 *
 *     ∫_I ∫_J ψ(s) φ(t) κ(s - t) ds dt = ∫ κ(x) A(x) dx,
 *     A(x) = ∫ ψ(s) φ(s - x) ds,
 *
 * with A a polynomial between differences of the ends of I and J, and rules that are refined
 * towards the singularities of κ.
 */
FullMatrix<double> dual_gram_matrix(const MultiplierSpace<2> &multipliers);

/** Returns the same matrix in 3-D, where patches have constants: the series of RectangleNorm. */
FullMatrix<double> dual_gram_matrix(const MultiplierSpace<3> &multipliers);

/**
 * The paper's norm on one side of length L: the dual of
 *
 *     ‖v‖²_{1/2} = ‖v‖²_0 + ∫∫ (v(x) - v(y))² / (x - y)² dx dy,
 *
 * taken over the piecewise linear v on a uniform grid of n_cells cells: ‖q‖² = bᵀ G⁻¹ b,  b_j =
 * ∫ q φ_j,  G the Gram matrix of ‖.‖_{1/2}. This is a lower bound that grows with the grid. It
 * costs n_cells³/3 operations.
 */
class SlobodeckijNorm
{
public:
  SlobodeckijNorm(double length, unsigned int n_cells);

  /** Returns the norm of a function given at quadrature points by value times weight. */
  double dual_norm(const std::vector<double> &arc_lengths,
                   const std::vector<double> &weighted_values) const;

  /** Returns |v|²_{1/2} of the piecewise linear function with these nodal values. */
  double squared_seminorm(const dealii::Vector<double> &nodal_values) const;

  unsigned int n_cells() const
  {
    return n_cells_;
  }

private:
  double length_;
  unsigned int n_cells_;
  FullMatrix<double> seminorm_;
  /** The Cholesky factor of G. */
  LAPACKFullMatrix<double> factor_;
};
} // namespace Signorini
