// SPDX-License-Identifier: LGPL-2.1-or-later
// |||.|||_{-1/2,Gamma_c} by cosine series, side by side.

#include <signorini/multiplier/spectral_norm.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>

namespace Signorini
{
namespace
{
constexpr unsigned int n_modes = 8192;
using dealii::numbers::PI;

/** Sums up amount * sin(k theta) (or cos) for k = 1..n_modes over many theta. */
template <bool sine>
class Harmonics
{
public:
  explicit Harmonics(dealii::Vector<double> &sums)
    : sums_(sums)
  {
  }
  ~Harmonics()
  {
    flush();
  }
  Harmonics(const Harmonics &) = delete;
  Harmonics &operator=(const Harmonics &) = delete;

  void add(const double theta, const double amount)
  {
    cos_[n_] = x_[n_] = std::cos(theta);
    sin_[n_] = y_[n_] = std::sin(theta);
    amount_[n_] = amount;
    if (++n_ == n_lanes)
      flush();
  }

private:
  /** Several angles side by side keep the processor busy. */
  static constexpr unsigned int n_lanes = 16;
  using Lanes = std::array<double, n_lanes>;

  /** Rotates unit vectors by theta; their errors add up to n_modes * 1e-16 only. */
  void flush()
  {
    for (unsigned int k = 1; k <= n_modes && n_ > 0; ++k)
    {
      double sum = 0.;
      for (unsigned int l = 0; l < n_lanes; ++l)
      {
        sum += amount_[l] * (sine ? y_[l] : x_[l]);
        const double x = x_[l] * cos_[l] - y_[l] * sin_[l];
        y_[l] = x_[l] * sin_[l] + y_[l] * cos_[l];
        x_[l] = x;
      }
      sums_[k] += sum;
    }
    amount_ = {};
    n_ = 0;
  }

  dealii::Vector<double> &sums_;
  unsigned int n_ = 0;
  Lanes cos_ = {}, sin_ = {}, x_ = {}, y_ = {}, amount_ = {};
};
} // namespace

SpectralNorm::SpectralNorm(const double length)
  : length_(length)
{
}

double SpectralNorm::weight(const unsigned int k) const
{
  const double frequency = k * PI / length_;
  return 1. / std::sqrt(1. + frequency * frequency);
}

unsigned int SpectralNorm::n_tail_modes(const unsigned int m)
{
  // S_k has the period 2 m on equal intervals.
  const unsigned int period = 2 * std::max(m, 1U);
  return period < n_modes / 2 ? period * ((n_modes / 2) / period) : n_modes / 2;
}

SpectralNorm::Vector SpectralNorm::coefficients(const std::vector<double> &arc_lengths,
                                                const std::vector<double> &weighted_values) const
{
  Vector sums(n_modes + 1);
  {
    Harmonics<false> cosines(sums);
    for (std::size_t q = 0; q < arc_lengths.size(); ++q)
    {
      sums[0] += weighted_values[q];
      cosines.add(PI * arc_lengths[q] / length_, weighted_values[q]);
    }
  }
  sums *= std::sqrt(2. / length_);
  sums[0] /= std::sqrt(2.);
  return sums;
}

SpectralNorm::Vector SpectralNorm::coefficients_of_constants(const std::vector<double> &ends,
                                                             const Vector &values) const
{
  // int q cos(k pi s/L) = -(L/(k pi)) sum of jumps times sin; the sines vanish at both ends.
  Vector sums(n_modes + 1);
  {
    Harmonics<true> sines(sums);
    for (unsigned int i = 1; i < values.size(); ++i)
      sines.add(PI * ends[i] / length_, values[i] - values[i - 1]);
  }
  for (unsigned int k = 1; k <= n_modes; ++k)
    sums[k] *= -std::sqrt(2. / length_) * length_ / (k * PI);
  sums[0] = 0.;
  for (unsigned int i = 0; i < values.size(); ++i)
    sums[0] += values[i] * (ends[i + 1] - ends[i]) / std::sqrt(length_);
  return sums;
}

double SpectralNorm::distance(const Vector &f,
                              const std::vector<double> &ends,
                              const Vector &values) const
{
  const Vector q_H = coefficients_of_constants(ends, values);
  double square = 0.;
  for (unsigned int k = 0; k <= n_modes; ++k)
    square += weight(k) * (f[k] - q_H[k]) * (f[k] - q_H[k]);
  // q_k = -(2/L)^{1/2} L/(k pi) S_k: the mean of S_k² gives the rest of the sum.
  const unsigned int n_last = n_tail_modes(values.size());
  double mean = 0.;
  for (unsigned int k = n_modes - n_last + 1; k <= n_modes; ++k)
    mean += std::pow(q_H[k] * k * PI / length_, 2) * length_ / 2. / n_last;
  square += length_ * length_ / (PI * PI * PI) * mean / (double(n_modes) * (n_modes + 1.));
  return std::sqrt(square);
}

dealii::FullMatrix<double> SpectralNorm::gram_matrix(const std::vector<double> &ends) const
{
  const unsigned int m = ends.size() - 1;
  const unsigned int n_last = n_tail_modes(m);
  // Modes from here on count for the infinitely many after them, too.
  const unsigned int first_last = n_modes - n_last + 1;
  const double tail = length_ * length_ / (PI * PI * PI) / (double(n_modes) * (n_modes + 1.));
  dealii::FullMatrix<double> weighted(m, n_modes + 1);
  Vector unit(m);
  for (unsigned int i = 0; i < m; ++i)
  {
    unit = 0.;
    unit[i] = 1.;
    const Vector q = coefficients_of_constants(ends, unit);
    for (unsigned int k = 0; k <= n_modes; ++k)
    {
      double square = weight(k);
      if (k >= first_last)
        square += tail * std::pow(k * PI / length_, 2) * length_ / 2. / n_last;
      weighted(i, k) = std::sqrt(square) * q[k];
    }
  }
  dealii::FullMatrix<double> gram(m, m);
  weighted.mTmult(gram, weighted);
  return gram;
}

std::vector<double> patch_ends(const std::vector<Patch> &patches,
                               const unsigned int first,
                               const unsigned int last)
{
  std::vector<double> ends = {patches[first].start};
  for (unsigned int t = first; t < last; ++t)
    ends.push_back(patches[t].end);
  return ends;
}

template <int dim>
dealii::FullMatrix<double> dual_gram_matrix(const std::vector<Patch> &patches,
                                            const Geometry<dim> &geometry)
{
  dealii::FullMatrix<double> gram(patches.size(), patches.size());
  for_each_side(patches, [&](const unsigned int first, const unsigned int last) {
    const SpectralNorm norm(geometry.sides[patches[first].side].length());
    gram.fill(norm.gram_matrix(patch_ends(patches, first, last)), first, first, 0, 0);
  });
  return gram;
}

template dealii::FullMatrix<double> dual_gram_matrix(const std::vector<Patch> &,
                                                     const Geometry<2> &);
} // namespace Signorini
