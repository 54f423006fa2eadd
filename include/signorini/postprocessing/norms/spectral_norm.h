// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/problem/parameters/options.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <complex>
#include <vector>

namespace Signorini {
/** Assembles (A_1)_ij = (φ_j, φ_i)_{1,Ω} = ∫ φ_j.φ_i + grad φ_j : grad φ_i,
 * condensed like A. Collective. */
template <int dim>
TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space);

/**
 * The dual of the interpolation norm between L2 and H1 on one side of length L:
 *
 *     ‖q‖²_{-1/2} = Σ_{k≥0} (1 + (k π/L)²)^{-1/2} q_k²,
 *     q_0 = L^{-1/2} ∫ q,   q_k = (2/L)^{1/2} ∫ q cos(k π s/L).
 *
 * On a closed side the frequencies k π/L become 2 k π/L, and sines join the cosines.
 *
 * 8192 modes are summed; the remainder of piecewise constants is estimated by the mean over the
 * last modes, (2/L) ω^{-3} mean(S_k²)/(2 K²), where ω k is the frequency of mode k and S_k
 * the sum of jumps times sin(k ω s_i) (and of jumps times cos).
 */
class SpectralNorm {
public:
  using Vector = dealii::Vector<double>;
  /** The coefficients q_k; on a closed side those of the cosine and of the sine of mode k. */
  using Modes = std::vector<std::complex<double>>;

  explicit SpectralNorm(double length, bool closed = false);

  /** Returns the coefficients q_k of a function given by its values times quadrature weights. */
  Modes coefficients(const std::vector<double> &arc_lengths,
                     const std::vector<double> &weighted_values) const;

  /** Returns the coefficients of a piecewise constant function, values[i] from ends[i] to
   * ends[i+1]. */
  Modes coefficients_of_constants(const std::vector<double> &ends, const Vector &values) const;

  /** Returns ‖f - q_H‖ for a continuous f with the coefficients @p f and a piecewise constant q_H.
   */
  double distance(const Modes &f, const std::vector<double> &ends, const Vector &values) const;

  /** Returns the norm to which this one is dual, ‖f‖²_{1/2} = sum (1 + (k π/L)²)^{1/2} f_k², of a
   * continuous function with the coefficients @p f that is smooth on each of @p n_pieces intervals:
   * f_k ~ k^-2. The remainder beyond the modes is estimated by the mean of k⁴ f_k² over the last of
   * them. */
  double primal_norm(const Modes &f, unsigned int n_pieces) const;

  /** Returns the Gram matrix of the characteristic functions of the intervals. */
  FullMatrix<double> gram_matrix(const std::vector<double> &ends) const;

private:
  /** Returns (1 + (k ω)²)^{-1/2}. */
  double weight(unsigned int k) const;
  /** Returns the weight of |q_k|² for constants on m intervals; the last modes count for the
   * infinitely many after them, too. */
  double weight_with_tail(unsigned int k, unsigned int m) const;
  /** Returns the number of the last modes that make a mean for m intervals. */
  unsigned int n_tail_modes(unsigned int m) const;
  /** Returns q_k for the integrals ∫ q e^{i k ω s}. */
  Modes normalised(Modes modes) const;

  double length_;
  bool closed_;
  /** The frequency π/L, on a closed side 2 π/L. */
  double omega_;
  unsigned int n_modes_;
};

/** Returns the norm on a side. */
inline SpectralNorm spectral_norm_on(const Side<2> &side) {
  return SpectralNorm(side.length(), side.is_closed());
}

/** Returns the block diagonal Gram matrix of the constants on the patches: the square of its norm
 * is the sum over the sides, in 3-D with the norm of RectangleNorm. */
template <int dim>
FullMatrix<double> dual_gram_matrix(const ContactSurface<dim> &surface);

/**
 * Returns the constant of Lemma 1,
 *
 *     β² = min_q (qᵀ Dᵀ A_1⁻¹ D q) / (qᵀ S q),
 *
 * where A_1 is the Gram matrix of V^h in (.,.)_{1,Ω}, and S that of Q^H in the cosine norm
 * |||.|||_{-1/2}. It takes one factorisation of its own and m solves. Collective.
 */
template <int dim>
double measure_inf_sup(const DisplacementSpace<dim> &space, const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D, LinearSolver linear_solver);
} // namespace Signorini
