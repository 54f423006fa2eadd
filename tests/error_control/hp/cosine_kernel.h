// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/multiplier_space.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

/** The norm |||.|||_{-1/2,Γ_c} of polynomials on patches of all lengths, by its kernel. */
namespace cosine_kernel {
using namespace Signorini;
/** Returns the modified Bessel function K_0, for x > 0. */
inline double bessel_K_0(const double x) {
  using DoubleOnly = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return boost::math::cyl_bessel_k(0, x, DoubleOnly());
}

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
class DualKernel {
public:
  explicit DualKernel(const double period)
    : period_(period)
    , omega_(2. * numbers::PI / period) {}

  /** Returns the distance from a point to the nearest singularity, a multiple of P. */
  double distance(const double x) const {
    return std::abs(std::remainder(x, period_));
  }

  /** Returns κ(x) with an error below 1e-8. At singularities it returns the value 1e-18 P next to
   * them. */
  double operator()(const double x) const {
    using numbers::PI;
    constexpr double min_period_with_images = PI, negligible = 40.;
    // Where ends of patches are equal up to rounding, rules may have a point there.
    const double r = std::max(distance(x), 1e-18 * period_);
    double sum = 0.;
    if (period_ > min_period_with_images) {
      for (const double nearest : {r, period_ - r})
        for (double image = nearest; image < negligible; image += period_)
          sum += bessel_K_0(image);
      return sum / PI;
    }
    // The rest of the sum is below 1/(4 π 4096²).
    const double cosine = std::cos(omega_ * r);
    double before = 1., now = cosine;
    for (double frequency = omega_; frequency < 4096. + omega_; frequency += omega_) {
      // (1 + f²)^{-1/2} - 1/f without cancellation.
      const double root = std::sqrt(1. + frequency * frequency);
      sum -= now / (frequency * root * (frequency + root));
      before = std::exchange(now, 2. * cosine * now - before);
    }
    return 1. / period_ - std::log(2. * std::sin(0.5 * omega_ * r)) / PI + 2. / period_ * sum;
  }

private:
  double period_, omega_;
};

/** Returns the Gauss rule that integrates polynomials of the given degree on [0, 1]. */
inline const QGauss<1> &rule_of_degree(const unsigned int degree) {
  static const std::vector<QGauss<1>> rules = []() {
    constexpr unsigned int most = 40;
    std::vector<QGauss<1>> all;
    for (unsigned int n = 1; n <= most; ++n)
      all.emplace_back(n);
    return all;
  }();
  return rules.at(degree / 2);
}

/** The integrals ∫∫ ψ_i(s) ψ_j(t) κ(s -+ t) over two patches of a side. */
class PairIntegrals {
public:
  /**
   * Prepares the integrals.
   * @param mirrored whether the kernel is that of s + t.
   */
  PairIntegrals(const MultiplierSpace<2> &space, const DualKernel &kernel, const unsigned int first,
                const unsigned int second, const bool mirrored)
    : space_(space)
    , kernel_(kernel)
    , first_(first)
    , second_(second)
    , sign_(mirrored ? -1. : 1.)
    , degree_(space.n_of(first) + space.n_of(second) - 2)
    , I_(ends(first))
    , J_(ends(second))
    , block_(space.n_of(first), space.n_of(second)) {
    for (double &end : J_)
      end *= sign_;
    std::sort(J_.begin(), J_.end());
  }

  /** Adds the integrals to the matrix, for two patches also in the other order. */
  void add_to(FullMatrix<double> &gram) {
    std::array<double, 4> breaks = {{I_[0] - J_[1], I_[0] - J_[0], I_[1] - J_[1], I_[1] - J_[0]}};
    std::sort(breaks.begin(), breaks.end());
    for (unsigned int i = 0; i < 3; ++i)
      // Differences may be equal, up to rounding.
      if (breaks[i + 1] - breaks[i] > 1e-14 * (breaks[3] - breaks[0]))
        integrate(breaks[i], breaks[i + 1], 0);
    const unsigned int rows = space_.first_of(first_), columns = space_.first_of(second_);
    for (unsigned int i = 0; i < block_.m(); ++i)
      for (unsigned int j = 0; j < block_.n(); ++j) {
        gram(rows + i, columns + j) += block_(i, j);
        if (first_ != second_)
          gram(columns + j, rows + i) += block_(i, j);
      }
  }

private:
  std::array<double, 2> ends(const unsigned int patch) const {
    const Patch<2> &interval = space_.surface().patches()[patch];
    return {{interval.lower[0], interval.upper[0]}};
  }

  /** Adds ∫ κ(x) A(x) dx between two points; halves the interval until the next singularity
   * is as far away as its ends are from one another. */
  void integrate(const double from, const double to, const unsigned int n_halvings) {
    // The rest next to a singularity is 2^-50 of the whole.
    constexpr unsigned int max_halvings = 50;
    if (n_halvings > max_halvings)
      return;
    if (std::min(kernel_.distance(from), kernel_.distance(to)) < (1. - 1e-6) * (to - from)) {
      const double middle = 0.5 * (from + to);
      integrate(from, middle, n_halvings + 1);
      integrate(middle, to, n_halvings + 1);
      return;
    }
    // A has the degree degree_ + 1. The kernel is analytic on the ellipse with ρ = 3 + 8^{1/2},
    // and eight points more leave ρ^-16 of it.
    const QGauss<1> &rule = rule_of_degree(degree_ + 1 + 16);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double x = from + (to - from) * rule.point(q)[0];
      add_products(x, (to - from) * rule.weight(q) * kernel_(x));
    }
  }

  /** Adds @p factor A(x). */
  void add_products(const double x, const double factor) {
    const double from = std::max(I_[0], J_[0] + x), to = std::min(I_[1], J_[1] + x);
    const QGauss<1> &rule = rule_of_degree(degree_);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double s = from + (to - from) * rule.point(q)[0];
      values(first_, s, on_first_);
      values(second_, sign_ * (s - x), on_second_);
      const double weight = factor * (to - from) * rule.weight(q);
      for (unsigned int i = 0; i < on_first_.size(); ++i)
        for (unsigned int j = 0; j < on_second_.size(); ++j)
          block_(i, j) += weight * on_first_[i] * on_second_[j];
    }
  }

  /** Computes the values of the basis of a patch at a point. */
  void values(const unsigned int patch, const double s, std::vector<double> &values) const {
    values.resize(space_.n_of(patch));
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] = space_.shape_value(space_.first_of(patch) + i, Point<1>(s));
  }

  const MultiplierSpace<2> &space_;
  const DualKernel &kernel_;
  unsigned int first_, second_;
  double sign_;
  /** The degree of a product of two functions. */
  unsigned int degree_;
  /** The intervals of s and of -+t. */
  std::array<double, 2> I_, J_;
  FullMatrix<double> block_;
  std::vector<double> on_first_, on_second_;
};

/**
 * Returns the Gram matrix of the basis of Q^H in the cosine norm. It is block diagonal: the square
 * of the norm is the sum over the sides. Series do not resolve the patches of graded meshes; there
 *
 *     ∫_I ∫_J ψ(s) φ(t) κ(s - t) ds dt = ∫ κ(x) A(x) dx,
 *     A(x) = ∫ ψ(s) φ(s - x) ds,
 *
 * with A a polynomial between differences of the ends of I and J, and rules that are refined
 * towards the singularities of κ.
 */
inline FullMatrix<double> gram_matrix(const MultiplierSpace<2> &multipliers) {
  const ContactSurface<2> &surface = multipliers.surface();
  const unsigned int m = multipliers.n_multipliers();
  FullMatrix<double> gram(m, m);
  for (const PatchGrid &grid : patch_grids(surface.patches())) {
    const Side<2> &side = surface.scene().geometry.sides[grid.side];
    const DualKernel kernel((side.is_closed() ? 1. : 2.) * side.length());
    for (const unsigned int i : grid.patches)
      for (unsigned int j = grid.patches[0]; j <= i; ++j)
        for (const bool mirrored : {false, true})
          if (!mirrored || !side.is_closed())
            PairIntegrals(multipliers, kernel, i, j, mirrored).add_to(gram);
  }
  return gram;
}
} // namespace cosine_kernel
