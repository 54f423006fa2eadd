// SPDX-License-Identifier: LGPL-2.1-or-later
// |||.|||_{-1/2,Γ_c} by cosine or Fourier series, side by side.

#include <signorini/base/instantiate.h>
#include <signorini/verification/norms/cosine_norm.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace Signorini {
namespace {
using numbers::PI;

using Complex = std::complex<double>;
using ComplexMatrix = LAPACKFullMatrix<Complex>;

/** Returns e^{i j step θ}, j = 0, ..., n - 1 in rows, for the angles θ in columns. The numbers are
 * rotated by step θ from row to row; their errors add up to 1e-16 per row only. */
ComplexMatrix powers(const std::vector<double> &theta, const std::size_t first,
                     const std::size_t last, const unsigned int step, const unsigned int n) {
  ComplexMatrix result(n, last - first);
  for (std::size_t q = first; q < last; ++q) {
    const Complex rotation = std::polar(1., step * theta[q]);
    Complex power = 1.;
    for (unsigned int j = 0; j < n; ++j, power *= rotation)
      result(j, q - first) = power;
  }
  return result;
}

/**
 * Returns Σ amount e^{i k θ} for k = 0, ..., n_modes. With k = a + A b,
 *
 *     e^{i k θ} = e^{i a θ} e^{i A b θ},
 *
 * and the sums over θ for all a and b are a product of matrices.
 */
CosineNorm<2>::Modes sum_of_waves(const std::vector<double> &theta,
                                  const std::vector<double> &amount, const unsigned int n_modes) {
  constexpr unsigned int A = 128, chunk = 256;
  const unsigned int n_blocks = n_modes / A + 1;
  ComplexMatrix sums(n_blocks, A);
  for (std::size_t first = 0; first < theta.size(); first += chunk) {
    const std::size_t last = std::min<std::size_t>(first + chunk, theta.size());
    ComplexMatrix coarse = powers(theta, first, last, A, n_blocks);
    for (unsigned int b = 0; b < n_blocks; ++b)
      for (std::size_t q = first; q < last; ++q)
        coarse(b, q - first) *= amount[q];
    coarse.mTmult(sums, powers(theta, first, last, 1, A), true);
  }
  CosineNorm<2>::Modes modes(n_modes + 1);
  for (unsigned int k = 0; k <= n_modes; ++k)
    modes[k] = sums(k / A, k % A);
  return modes;
}
} // namespace

CosineNorm<2>::CosineNorm(const double length, const bool closed)
  : length_(length)
  , closed_(closed)
  , omega_((closed ? 2. : 1.) * PI / length)
  // The highest frequency is the same for both kinds.
  , n_modes_(closed ? 4096 : 8192) {}

double CosineNorm<2>::weight(const unsigned int k) const {
  const double frequency = k * omega_;
  return 1. / std::sqrt(1. + frequency * frequency);
}

unsigned int CosineNorm<2>::n_tail_modes(const unsigned int m) const {
  // S_k has this period on equal intervals.
  const unsigned int period = std::max(1U, (closed_ ? 1U : 2U) * m);
  return period < n_modes_ / 2 ? period * ((n_modes_ / 2) / period) : n_modes_ / 2;
}

double CosineNorm<2>::weight_with_tail(const unsigned int k, const unsigned int m) const {
  // q_k = (2/L)^{1/2} S_k/(k ω): the mean of S_k² over the last modes gives the rest of the sum.
  const unsigned int n_last = n_tail_modes(m);
  const double tail = 1. / (omega_ * 2. * double(n_modes_) * (n_modes_ + 1.));
  return weight(k) + (k > n_modes_ - n_last ? tail * k * k / n_last : 0.);
}

CosineNorm<2>::Modes CosineNorm<2>::normalised(Modes modes) const {
  modes[0] /= std::sqrt(2.);
  for (Complex &mode : modes)
    mode = std::sqrt(2. / length_) * (closed_ ? mode : mode.real());
  return modes;
}

CosineNorm<2>::Modes CosineNorm<2>::coefficients(const std::vector<double> &arc_lengths,
                                                 const std::vector<double> &weighted_values) const {
  std::vector<double> theta = arc_lengths;
  for (double &angle : theta)
    angle *= omega_;
  return normalised(sum_of_waves(theta, weighted_values, n_modes_));
}

CosineNorm<2>::Modes CosineNorm<2>::coefficients_of_constants(const std::vector<double> &ends,
                                                              const Vector &values) const {
  AssertDimension(ends.size(), values.size() + 1);
  // ∫ q e^{i k ω s} is -Σ jump e^{i k ω s}/(i k ω), with the jumps at both ends of the side.
  std::vector<double> theta, jumps;
  for (unsigned int i = 0; i <= values.size(); ++i) {
    const double jump = (i < values.size() ? values[i] : 0.) - (i > 0 ? values[i - 1] : 0.);
    if (jump == 0.)
      continue;
    theta.push_back(omega_ * ends[i]);
    jumps.push_back(jump);
  }
  Modes modes = sum_of_waves(theta, jumps, n_modes_);
  modes[0] = 0.;
  for (unsigned int k = 1; k <= n_modes_; ++k)
    modes[k] *= Complex(0., 1. / (k * omega_));
  for (unsigned int i = 0; i < values.size(); ++i)
    modes[0] += values[i] * (ends[i + 1] - ends[i]);
  return normalised(std::move(modes));
}

double CosineNorm<2>::distance(const Modes &f, const std::vector<double> &ends,
                               const Vector &values) const {
  const Modes q_H = coefficients_of_constants(ends, values);
  double square = 0.;
  for (unsigned int k = 0; k < q_H.size(); ++k)
    square += weight(k) * std::norm(f.empty() ? q_H[k] : f[k] - q_H[k]) +
              (weight_with_tail(k, values.size()) - weight(k)) * std::norm(q_H[k]);
  return std::sqrt(square);
}

double CosineNorm<2>::distance(const Modes &f, const PatchGrid &grid, const Vector &P) const {
  Vector values(grid.n(0));
  P.extract_subvector_to(grid.patches.begin(), grid.patches.end(), values.begin());
  return distance(f, grid.ends[0], values);
}

double CosineNorm<2>::primal_norm(const Modes &f, const unsigned int n_pieces) const {
  const unsigned int n_last = n_tail_modes(n_pieces);
  double square = 0., mean = 0.;
  for (unsigned int k = 0; k < f.size(); ++k) {
    square += std::norm(f[k]) / weight(k);
    if (k > n_modes_ - n_last)
      mean += std::pow(k, 4) * std::norm(f[k]) / n_last;
  }
  // The sum of (k ω) k^-4 over k > K is about ω/(2 K²).
  return std::sqrt(square + omega_ * mean / (2. * double(n_modes_) * (n_modes_ + 1.)));
}

FullMatrix<double> CosineNorm<2>::gram_matrix(const std::vector<double> &ends) const {
  Assert(ends.size() > 1, ExcMessage("A side has a patch at least."));
  const unsigned int m = ends.size() - 1, n = n_modes_ + 1;
  FullMatrix<double> weighted(m, closed_ ? 2 * n : n), gram(m, m);
  Vector unit(m);
  for (unsigned int i = 0; i < m; ++i) {
    unit = 0.;
    unit[i] = 1.;
    const Modes q = coefficients_of_constants(ends, unit);
    for (unsigned int k = 0; k < n; ++k) {
      const double root = std::sqrt(weight_with_tail(k, m));
      weighted(i, k) = root * q[k].real();
      if (closed_)
        weighted(i, n + k) = root * q[k].imag();
    }
  }
  weighted.mTmult(gram, weighted);
  return gram;
}

template <int dim>
FullMatrix<double> dual_gram_matrix(const ContactSurface<dim> &surface) {
  FullMatrix<double> gram(surface.patches().size(), surface.patches().size());
  for (const PatchGrid &grid : patch_grids(surface)) {
    const FullMatrix<double> on_side =
      CosineNorm<dim>(surface.scene().geometry.sides[grid.side]).gram_matrix(grid);
    for (unsigned int k = 0; k < on_side.m(); ++k)
      for (unsigned int l = 0; l < on_side.n(); ++l)
        gram(grid.patches[k], grid.patches[l]) = on_side(k, l);
  }
  return gram;
}
INSTANTIATE_FUNCTION(dual_gram_matrix);
} // namespace Signorini
