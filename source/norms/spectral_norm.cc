// SPDX-License-Identifier: LGPL-2.1-or-later
// |||.|||_{-1/2,Gamma_c} by cosine or Fourier series, side by side.

#include <signorini/norms/spectral_norm.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <vector>

namespace Signorini
{
namespace
{
using dealii::numbers::PI;

/**
 * Sums up amount * sin(k theta) (or cos) for k = 1..n_modes over many theta. With k = a + A b,
 *
 *     cos(k theta) = cos(a theta) cos(A b theta) - sin(a theta) sin(A b theta),
 *
 * and the sums over theta for all a and b are products of matrices.
 */
template <bool sine>
class Harmonics
{
public:
  explicit Harmonics(const unsigned int n_modes)
    : n_modes_(n_modes)
    , n_blocks_(n_modes / block + 1)
    , products_(n_blocks_, block)
  {
  }
  void add(const double theta, const double amount)
  {
    theta_.push_back(theta);
    amount_.push_back(amount);
    if (theta_.size() == 256)
      flush();
  }

  /** sums[first + k - 1] += the sum of mode k, for all modes. */
  void add_to(dealii::Vector<double> &sums, const unsigned int first)
  {
    flush();
    for (unsigned int k = 1; k <= n_modes_ && used_; ++k)
      sums[first + k - 1] += products_(k / block, k % block);
  }

private:
  /** A. */
  static constexpr unsigned int block = 128;

  /** cos(i step theta) and sin(i step theta), row i. Unit vectors are rotated by step theta; their
   * errors add up to 1e-16 per row only. */
  void tabulate(const unsigned int step,
                dealii::FullMatrix<double> &cosines,
                dealii::FullMatrix<double> &sines) const
  {
    for (unsigned int q = 0; q < theta_.size(); ++q)
    {
      cosines(0, q) = 1.;
      sines(0, q) = 0.;
      cosines(1, q) = std::cos(step * theta_[q]);
      sines(1, q) = std::sin(step * theta_[q]);
    }
    for (unsigned int i = 2; i < cosines.m(); ++i)
      for (unsigned int q = 0; q < theta_.size(); ++q)
      {
        cosines(i, q) = cosines(i - 1, q) * cosines(1, q) - sines(i - 1, q) * sines(1, q);
        sines(i, q) = sines(i - 1, q) * cosines(1, q) + cosines(i - 1, q) * sines(1, q);
      }
  }

  void flush()
  {
    const unsigned int n = theta_.size();
    if (n == 0)
      return;
    used_ = true;
    dealii::FullMatrix<double> fine_cos(block, n), fine_sin(block, n);
    dealii::FullMatrix<double> coarse_cos(n_blocks_, n), coarse_sin(n_blocks_, n);
    tabulate(1, fine_cos, fine_sin);
    tabulate(block, coarse_cos, coarse_sin);
    for (unsigned int b = 0; b < n_blocks_; ++b)
      for (unsigned int q = 0; q < n; ++q)
      {
        coarse_cos(b, q) *= amount_[q];
        coarse_sin(b, q) *= sine ? amount_[q] : -amount_[q];
      }
    coarse_cos.mTmult(products_, sine ? fine_sin : fine_cos, true);
    coarse_sin.mTmult(products_, sine ? fine_cos : fine_sin, true);
    theta_.clear();
    amount_.clear();
  }

  unsigned int n_modes_;
  /** The number of b. */
  unsigned int n_blocks_;
  bool used_ = false;
  /** The sum for k = a + A b in row b and column a. */
  dealii::FullMatrix<double> products_;
  std::vector<double> theta_, amount_;
};
} // namespace

SpectralNorm::SpectralNorm(const double length, const bool closed)
  : length_(length)
  , closed_(closed)
  , omega_((closed ? 2. : 1.) * PI / length)
  // The highest frequency is the same for both kinds.
  , n_modes_(closed ? 4096 : 8192)
{
}

unsigned int SpectralNorm::mode(const unsigned int coefficient) const
{
  return coefficient <= n_modes_ ? coefficient : coefficient - n_modes_;
}

double SpectralNorm::weight(const unsigned int k) const
{
  const double frequency = k * omega_;
  return 1. / std::sqrt(1. + frequency * frequency);
}

unsigned int SpectralNorm::n_tail_modes(const unsigned int m) const
{
  // S_k has this period on equal intervals.
  const unsigned int period = std::max(1U, (closed_ ? 1U : 2U) * m);
  return period < n_modes_ / 2 ? period * ((n_modes_ / 2) / period) : n_modes_ / 2;
}

double SpectralNorm::tail() const
{
  return 2. / length_ / std::pow(omega_, 3) / (2. * double(n_modes_) * (n_modes_ + 1.));
}

SpectralNorm::Vector SpectralNorm::coefficients(const std::vector<double> &arc_lengths,
                                                const std::vector<double> &weighted_values) const
{
  Vector sums(1 + (closed_ ? 2 : 1) * n_modes_);
  Harmonics<false> cosines(n_modes_);
  Harmonics<true> sines(n_modes_);
  for (std::size_t q = 0; q < arc_lengths.size(); ++q)
  {
    sums[0] += weighted_values[q];
    cosines.add(omega_ * arc_lengths[q], weighted_values[q]);
    if (closed_)
      sines.add(omega_ * arc_lengths[q], weighted_values[q]);
  }
  cosines.add_to(sums, 1);
  sines.add_to(sums, 1 + n_modes_);
  sums *= std::sqrt(2. / length_);
  sums[0] /= std::sqrt(2.);
  return sums;
}

SpectralNorm::Vector SpectralNorm::coefficients_of_constants(const std::vector<double> &ends,
                                                             const Vector &values) const
{
  // int q cos(k omega s) = -sum of jumps times sin / (k omega): on an open side the sines vanish at
  // both ends. int q sin = +sum of jumps times cos / (k omega).
  Vector sums(1 + (closed_ ? 2 : 1) * n_modes_);
  Harmonics<true> sines(n_modes_);
  Harmonics<false> cosines(n_modes_);
  for (unsigned int i = closed_ ? 0 : 1; i < values.size(); ++i)
  {
    const double jump = values[i] - (i > 0 ? values[i - 1] : values[values.size() - 1]);
    if (jump == 0.)
      continue;
    sines.add(omega_ * ends[i], -jump);
    if (closed_)
      cosines.add(omega_ * ends[i], jump);
  }
  sines.add_to(sums, 1);
  cosines.add_to(sums, 1 + n_modes_);
  for (unsigned int c = 1; c < sums.size(); ++c)
    sums[c] *= std::sqrt(2. / length_) / (mode(c) * omega_);
  for (unsigned int i = 0; i < values.size(); ++i)
    sums[0] += values[i] * (ends[i + 1] - ends[i]) / std::sqrt(length_);
  return sums;
}

double SpectralNorm::distance(const Vector &f,
                              const std::vector<double> &ends,
                              const Vector &values) const
{
  const Vector q_H = coefficients_of_constants(ends, values);
  const unsigned int n_last = n_tail_modes(values.size());
  double square = 0., mean = 0.;
  for (unsigned int c = 0; c < q_H.size(); ++c)
  {
    const unsigned int k = mode(c);
    square += weight(k) * (f[c] - q_H[c]) * (f[c] - q_H[c]);
    // q_k = (2/L)^{1/2} S_k/(k omega): the mean of S_k² gives the rest of the sum.
    if (k > n_modes_ - n_last)
      mean += std::pow(q_H[c] * k * omega_, 2) * length_ / 2. / n_last;
  }
  return std::sqrt(square + tail() * mean);
}

double SpectralNorm::primal_norm(const Vector &f, const unsigned int n_pieces) const
{
  const unsigned int n_last = n_tail_modes(n_pieces);
  double square = 0., mean = 0.;
  for (unsigned int c = 0; c < f.size(); ++c)
  {
    const unsigned int k = mode(c);
    square += f[c] * f[c] / weight(k);
    if (k > n_modes_ - n_last)
      mean += std::pow(k, 4) * f[c] * f[c] / n_last;
  }
  // The sum of (k omega) k^-4 over k > K is about omega/(2 K²).
  return std::sqrt(square + omega_ * mean / (2. * double(n_modes_) * (n_modes_ + 1.)));
}

dealii::FullMatrix<double> SpectralNorm::gram_matrix(const std::vector<double> &ends) const
{
  const unsigned int m = ends.size() - 1;
  const unsigned int n_last = n_tail_modes(m);
  dealii::FullMatrix<double> weighted(m, 1 + (closed_ ? 2 : 1) * n_modes_);
  Vector unit(m);
  for (unsigned int i = 0; i < m; ++i)
  {
    unit = 0.;
    unit[i] = 1.;
    const Vector q = coefficients_of_constants(ends, unit);
    for (unsigned int c = 0; c < q.size(); ++c)
    {
      const unsigned int k = mode(c);
      double square = weight(k);
      // The last modes count for the infinitely many after them, too.
      if (k > n_modes_ - n_last)
        square += tail() * std::pow(k * omega_, 2) * length_ / 2. / n_last;
      weighted(i, c) = std::sqrt(square) * q[c];
    }
  }
  dealii::FullMatrix<double> gram(m, m);
  weighted.mTmult(gram, weighted);
  return gram;
}

std::vector<double> patch_ends(const std::vector<Patch<2>> &patches,
                               const unsigned int first,
                               const unsigned int last)
{
  std::vector<double> ends = {patches[first].lower[0]};
  for (unsigned int t = first; t < last; ++t)
    ends.push_back(patches[t].upper[0]);
  return ends;
}

dealii::FullMatrix<double> dual_gram_matrix(const ContactSurface<2> &surface)
{
  const std::vector<Patch<2>> &patches = surface.patches();
  dealii::FullMatrix<double> gram(patches.size(), patches.size());
  for_each_side(patches, [&](const unsigned int first, const unsigned int last) {
    const SpectralNorm norm = spectral_norm_on(surface.side(patches[first]));
    gram.fill(norm.gram_matrix(patch_ends(patches, first, last)), first, first, 0, 0);
  });
  return gram;
}
} // namespace Signorini
