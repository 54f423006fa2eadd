// SPDX-License-Identifier: LGPL-2.1-or-later
// The two norms |||.|||_{-1/2} against closed forms and values of an independent implementation.

#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/slobodeckij_norm.h>

#include <deal.II/base/quadrature_lib.h>

#include <functional>
#include <utility>
#include <vector>

#include "tests.h"

using namespace Signorini;

namespace {
std::vector<double> equal_ends(const unsigned int m, const double length) {
  std::vector<double> ends;
  for (unsigned int i = 0; i <= m; ++i)
    ends.push_back(i * length / m);
  return ends;
}

dealii::Vector<double> checkerboard(const unsigned int m) {
  dealii::Vector<double> q(m);
  for (unsigned int i = 0; i < m; ++i)
    q[i] = i % 2 == 0 ? 1. : -1.;
  return q;
}

/** A function at Gauss points of n cells of every interval between given positions: s, and the
 * values times weights. */
struct Samples {
  Samples(const std::vector<double> &positions, const unsigned int n, const unsigned int n_points,
          const std::function<double(double)> &f) {
    const dealii::QGauss<1> gauss(n_points);
    for (std::size_t i = 0; i + 1 < positions.size(); ++i)
      for (unsigned int c = 0; c < n; ++c)
        for (unsigned int p = 0; p < n_points; ++p) {
          const double h = (positions[i + 1] - positions[i]) / n;
          s.push_back(positions[i] + (c + gauss.point(p)[0]) * h);
          w.push_back(f(s.back()) * gauss.weight(p) * h);
        }
  }

  std::vector<double> s, w;
};

/** On a grid of n cells. */
double slobodeckij(const dealii::Vector<double> &q, const double length,
                   const unsigned int n_cells) {
  const Samples samples({0., length}, n_cells, 2, [&](const double s) {
    return q[static_cast<unsigned int>(s / length * q.size())];
  });
  return SlobodeckijNorm(length, n_cells).dual_norm(samples.s, samples.w);
}

double spectral(const dealii::Vector<double> &q, const double length) {
  return CosineNorm<2>(length).distance(CosineNorm<2>::Modes(8193), equal_ends(q.size(), length),
                                        q);
}

void check_checkerboards(Checks &checks) {
  struct Value {
    unsigned int m;
    double spectral, slobodeckij;
  };
  for (const Value &value : {Value{4, 0.33513274, 0.15832630}, Value{8, 0.22021147, 0.09929304},
                             Value{16, 0.14652069, 0.06354739}, Value{32, 0.09911219, 0.04171025},
                             Value{64, 0.06804309, 0.02803214}}) {
    const auto q = checkerboard(value.m);
    const std::string name = "(-1)^i, m = " + std::to_string(value.m);
    checks.near(name + ", cosine norm", spectral(q, 1.), value.spectral, 1e-6 * value.spectral);
    checks.near(name + ", paper's norm", slobodeckij(q, 1., 16 * value.m), value.slobodeckij, 2e-8);
    auto image = q;
    CosineNorm<2>(1.).gram_matrix(equal_ends(value.m, 1.)).vmult(image, q);
    checks.near(name + ", Gram matrix", std::sqrt(q * image), value.spectral,
                1e-6 * value.spectral);
  }
}

/** ‖1‖_{-1/2} on a side of length L: only the constant mode, and b = M 1, so sqrt(L) in both. */
void check_constants(Checks &checks) {
  for (const double length : {1., 2.5}) {
    dealii::Vector<double> one(5);
    one = 1.;
    checks.near("constant, cosine norm", spectral(one, length), std::sqrt(length), 1e-12);
    checks.near("constant, paper's norm", slobodeckij(one, length, 40), std::sqrt(length), 1e-12);
  }
}

/** |x|²_{1/2} = 1 exactly on every grid, |x²|²_{1/2} = 7/6 in the limit. */
void check_seminorm(Checks &checks) {
  double before = 0.;
  for (const unsigned int n : {4U, 16U, 64U}) {
    const auto gram = seminorm_matrix(n);
    const auto square = [&](const dealii::Vector<double> &v) {
      dealii::Vector<double> product(v.size());
      gram.vmult(product, v);
      return v * product;
    };
    dealii::Vector<double> linear(n + 1), quadratic(n + 1);
    for (unsigned int i = 0; i <= n; ++i) {
      linear[i] = double(i) / n;
      quadratic[i] = linear[i] * linear[i];
    }
    checks.near("|x|_{1/2}, N = " + std::to_string(n), square(linear), 1., 1e-10);
    const double error = std::abs(square(quadratic) - 7. / 6.);
    if (before > 0.)
      checks.that("|x^2|_{1/2} converges", error < 0.1 * before);
    before = error;
  }
}

/** p = -10 (xi - x)_+^3: int p cos(a x) = -10 (3 xi²/a² - 6 (1 - cos(a xi))/a⁴), a = k pi. */
void check_coefficients(Checks &checks) {
  const double xi = std::sqrt(0.5);
  const Samples samples({0., xi}, 4096, 8,
                        [&](const double x) { return -10. * std::pow(xi - x, 3); });
  const auto q = CosineNorm<2>(1.).coefficients(samples.s, samples.w);
  double largest = std::abs(q[0] + 2.5 * std::pow(xi, 4));
  for (unsigned int k = 1; k <= 8192; ++k) {
    const double a = k * dealii::numbers::PI;
    const double exact = -10. * std::sqrt(2.) *
                         (3. * xi * xi / (a * a) - 6. * (1. - std::cos(a * xi)) / std::pow(a, 4));
    largest = std::max(largest, std::abs(q[k] - exact));
  }
  checks.near("cosine coefficients of a cubic", largest, 0., 1e-11);
}
/**
 * On a closed side of length L, (-1)^i on m patches is a square wave of m/2 periods: the harmonics
 * j = 1, 3, 5, ... of the frequency pi m/L, with the squares 8 L/(pi j)².
 */
void check_closed_side(Checks &checks) {
  const double pi = dealii::numbers::PI;
  for (const double length : {2. * pi, 4. * pi})
    for (const unsigned int m : {4U, 8U, 32U}) {
      double square = 0.;
      for (unsigned int j = 1; j < 200000; j += 2)
        square +=
          8. * length / std::pow(pi * j, 2) / std::sqrt(1. + std::pow(j * pi * m / length, 2));
      const double exact = std::sqrt(square);
      const CosineNorm<2> norm(length, /*closed=*/true);
      const auto ends = equal_ends(m, length);
      const auto q = checkerboard(m);
      const std::string name = "closed side, (-1)^i, m = " + std::to_string(m);
      const double found = norm.distance(norm.coefficients({}, {}), ends, q);
      checks.near(name, found, exact, 1e-7 * exact);
      auto image = q;
      norm.gram_matrix(ends).vmult(image, q);
      checks.near(name + ", Gram matrix", std::sqrt(q * image), exact, 1e-7 * exact);
      dealii::Vector<double> one(m);
      one = 1.;
      checks.near("closed side, constant", norm.distance(norm.coefficients({}, {}), ends, one),
                  std::sqrt(length), 1e-12);
    }

  // 3 cos(2 s) - sin(5 s) on the unit circle: pi (9 (1 + 4)^{-1/2} + (1 + 25)^{-1/2}).
  const Samples samples({0., 2. * pi}, 64, 8,
                        [](const double x) { return 3. * std::cos(2. * x) - std::sin(5. * x); });
  const CosineNorm<2> circle(2. * pi, true);
  auto modes = circle.coefficients(samples.s, samples.w);
  // The rule is exact up to some 8 * 64 oscillations only.
  for (unsigned int c = 0; c < modes.size(); ++c)
    modes[c] = (c - 1) % 4096 < 100 ? modes[c] : 0.;
  dealii::Vector<double> nothing(1);
  checks.near("closed side, harmonics",
              circle.distance(modes, std::vector<double>{0., 2. * pi}, nothing),
              std::sqrt(pi * (9. / std::sqrt(5.) + 1. / std::sqrt(26.))), 1e-12);
}

/** ‖f‖_{1/2} of a function that is smooth between the given positions. */
double primal(const std::vector<double> &positions, const unsigned int n_pieces,
              const std::function<double(double)> &f) {
  const double length = positions.back();
  const Samples samples(positions, (n_pieces + 4095) / n_pieces, 8, f);
  const CosineNorm<2> norm(length);
  return norm.primal_norm(norm.coefficients(samples.s, samples.w), n_pieces);
}

/**
 * A hat with its tip at c, slopes a and -b: int f cos(x s) = -(a (1 - cos(x c)) - b (cos(x c) -
 * cos(x L)))/x², x = k pi/L; the series is summed here up to k = 2e6.
 */
void check_primal_hat(Checks &checks) {
  const double length = 2.5, c = 0.7, a = 1. / c, b = 1. / (length - c);
  double square = 0.25 * length; // (int f)²/L, int f = L/2
  for (unsigned int k = 2000000; k >= 1; --k) {
    const double x = k * dealii::numbers::PI / length;
    const double integral =
      (a * (1. - std::cos(x * c)) - b * (std::cos(x * c) - std::cos(x * length))) / (x * x);
    square += std::sqrt(1. + x * x) * 2. / length * integral * integral;
  }
  checks.near(
    "|hat|_{1/2}",
    primal({0., c, length}, 2, [&](double s) { return s < c ? a * s : b * (length - s); }),
    std::sqrt(square), 1e-9);
}

/**
 * Bubbles t (1 - t) h² on n equal intervals of length h, t from 0 to 1 on each: t (1 - t) = 1/6 -
 * sum_j cos(2 pi j t)/(pi j)², so that only the modes 2 n j occur. This is what a parabola differs
 * by from its interpolant.
 */
void check_primal_bubbles(Checks &checks) {
  using dealii::numbers::PI;
  const double length = 2.;
  for (const auto &[n, tolerance] : std::vector<std::pair<unsigned int, double>>{
         {1, 1e-9}, {16, 1e-7}, {128, 2e-5}, {1000, 3e-3}}) {
    const double h = length / n;
    double square = length * std::pow(h, 4) / 36.;
    for (unsigned int j = 100000; j >= 1; --j)
      square += std::sqrt(1. + std::pow(2. * n * j * PI / length, 2)) * 0.5 * length *
                std::pow(h / (PI * j), 4);
    const double exact = std::sqrt(square);
    checks.near("|bubbles|_{1/2}, n = " + std::to_string(n),
                primal(equal_ends(n, length), n,
                       [&](double s) {
                         const double t = s / h - std::floor(s / h);
                         return t * (1. - t) * h * h;
                       }),
                exact, tolerance * exact);
  }
}
} // namespace

int main() {
  return run_tests({check_checkerboards, check_constants, check_seminorm, check_coefficients,
                    check_closed_side, check_primal_hat, check_primal_bubbles});
}
