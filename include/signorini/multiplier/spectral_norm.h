// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/contact_partition.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/**
 * The dual of the interpolation norm between L2 and H1 on one side of length L:
 *
 *     ‖q‖²_{-1/2} = sum_{k>=0} (1 + (k pi/L)²)^{-1/2} q_k²,
 *     q_0 = L^{-1/2} int q,   q_k = (2/L)^{1/2} int q cos(k pi s/L).
 *
 * 8192 modes are summed; what piecewise constants leave beyond them is added from the mean over the
 * last modes, L²/pi³ mean(S_k²)/K² with S_k = sum of jumps times sin(k pi s_i/L).
 */
class SpectralNorm
{
public:
  using Vector = dealii::Vector<double>;

  explicit SpectralNorm(double length);

  /** The coefficients q_k of a function given by its values times quadrature weights. */
  Vector coefficients(const std::vector<double> &arc_lengths,
                      const std::vector<double> &weighted_values) const;

  /** The coefficients of a piecewise constant function, values[i] from ends[i] to ends[i+1]. */
  Vector coefficients_of_constants(const std::vector<double> &ends, const Vector &values) const;

  /** ‖f - q_H‖ for a continuous f with the coefficients @p f and a piecewise constant q_H. */
  double distance(const Vector &f, const std::vector<double> &ends, const Vector &values) const;

  /** Gram matrix of the characteristic functions of the intervals. */
  dealii::FullMatrix<double> gram_matrix(const std::vector<double> &ends) const;

private:
  /** (1 + (k pi/L)²)^{-1/2}. */
  double weight(unsigned int k) const;
  /** How many of the last modes make a mean for m intervals. */
  static unsigned int n_tail_modes(unsigned int m);

  double length_;
};

/** The arc lengths at which the patches [first, last) of one side begin and end. */
std::vector<double> patch_ends(const std::vector<Patch> &patches,
                               unsigned int first,
                               unsigned int last);

/** Calls visit(first, last) for the patches [first, last) of each side. */
template <typename Visitor>
void for_each_side(const std::vector<Patch> &patches, const Visitor &visit)
{
  unsigned int first = 0;
  while (first < patches.size())
  {
    unsigned int last = first;
    while (last < patches.size() && patches[last].side == patches[first].side)
      ++last;
    visit(first, last);
    first = last;
  }
}

/** Block diagonal Gram matrix of Q^H: the square of its norm is the sum over the sides. */
template <int dim>
dealii::FullMatrix<double> dual_gram_matrix(const std::vector<Patch> &patches,
                                            const Geometry<dim> &geometry);
} // namespace Signorini
