// SPDX-License-Identifier: LGPL-2.1-or-later
// The two norms |||.|||_{-1/2} against closed forms and values of an independent implementation.

#include <signorini/multiplier/slobodeckij_norm.h>
#include <signorini/multiplier/spectral_norm.h>

#include <deal.II/base/quadrature_lib.h>

#include "tests.h"

using namespace Signorini;

namespace
{
std::vector<double> equal_ends(const unsigned int m, const double length)
{
  std::vector<double> ends;
  for (unsigned int i = 0; i <= m; ++i)
    ends.push_back(i * length / m);
  return ends;
}

dealii::Vector<double> checkerboard(const unsigned int m)
{
  dealii::Vector<double> q(m);
  for (unsigned int i = 0; i < m; ++i)
    q[i] = i % 2 == 0 ? 1. : -1.;
  return q;
}

/** A piecewise constant function at two Gauss points of every cell of a fine grid. */
double slobodeckij(const dealii::Vector<double> &q, const double length, const unsigned int n_cells)
{
  const dealii::QGauss<1> gauss(2);
  std::vector<double> s, w;
  const double h = length / n_cells;
  for (unsigned int c = 0; c < n_cells; ++c)
    for (unsigned int p = 0; p < gauss.size(); ++p)
    {
      s.push_back((c + gauss.point(p)[0]) * h);
      w.push_back(q[c * q.size() / n_cells] * h * gauss.weight(p));
    }
  return SlobodeckijNorm(length, n_cells).dual_norm(s, w);
}

double spectral(const dealii::Vector<double> &q, const double length)
{
  return SpectralNorm(length).distance(
    dealii::Vector<double>(8193), equal_ends(q.size(), length), q);
}

void check_checkerboards(Checks &checks)
{
  struct Value
  {
    unsigned int m;
    double spectral, slobodeckij;
  };
  for (const Value &value : {Value{4, 0.33513274, 0.15832630},
                             Value{8, 0.22021147, 0.09929304},
                             Value{16, 0.14652069, 0.06354739},
                             Value{32, 0.09911219, 0.04171025},
                             Value{64, 0.06804309, 0.02803214}})
  {
    const auto q = checkerboard(value.m);
    const std::string name = "(-1)^i, m = " + std::to_string(value.m);
    checks.near(name + ", cosine norm", spectral(q, 1.), value.spectral, 1e-6 * value.spectral);
    checks.near(name + ", paper's norm", slobodeckij(q, 1., 16 * value.m), value.slobodeckij, 2e-8);
    auto image = q;
    SpectralNorm(1.).gram_matrix(equal_ends(value.m, 1.)).vmult(image, q);
    checks.near(
      name + ", Gram matrix", std::sqrt(q * image), value.spectral, 1e-6 * value.spectral);
  }
}

/** ‖1‖_{-1/2} on a side of length L: only the constant mode, and b = M 1, so sqrt(L) in both. */
void check_constants(Checks &checks)
{
  for (const double length : {1., 2.5})
  {
    dealii::Vector<double> one(5);
    one = 1.;
    checks.near("constant, cosine norm", spectral(one, length), std::sqrt(length), 1e-12);
    checks.near("constant, paper's norm", slobodeckij(one, length, 40), std::sqrt(length), 1e-12);
  }
}

/** |x|²_{1/2} = 1 exactly on every grid, |x²|²_{1/2} = 7/6 in the limit. */
void check_seminorm(Checks &checks)
{
  double before = 0.;
  for (const unsigned int n : {4U, 16U, 64U})
  {
    const SlobodeckijNorm norm(1., n);
    dealii::Vector<double> linear(n + 1), quadratic(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
    {
      linear[i] = double(i) / n;
      quadratic[i] = linear[i] * linear[i];
    }
    checks.near("|x|_{1/2}, N = " + std::to_string(n), norm.squared_seminorm(linear), 1., 1e-10);
    const double error = std::abs(norm.squared_seminorm(quadratic) - 7. / 6.);
    if (before > 0.)
      checks.that("|x^2|_{1/2} converges", error < 0.1 * before);
    before = error;
  }
}

/** p = -10 (xi - x)_+^3: int p cos(a x) = -10 (3 xi²/a² - 6 (1 - cos(a xi))/a⁴), a = k pi. */
void check_coefficients(Checks &checks)
{
  const double xi = std::sqrt(0.5);
  const dealii::QGauss<1> gauss(8);
  std::vector<double> s, w;
  const unsigned int n = 4096;
  for (unsigned int c = 0; c < n; ++c)
    for (unsigned int p = 0; p < gauss.size(); ++p)
    {
      s.push_back(xi * (c + gauss.point(p)[0]) / n);
      w.push_back(-10. * std::pow(xi - s.back(), 3) * gauss.weight(p) * xi / n);
    }
  const auto q = SpectralNorm(1.).coefficients(s, w);
  double largest = std::abs(q[0] + 2.5 * std::pow(xi, 4));
  for (unsigned int k = 1; k <= 8192; ++k)
  {
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
void check_closed_side(Checks &checks)
{
  const double pi = dealii::numbers::PI;
  for (const double length : {2. * pi, 4. * pi})
    for (const unsigned int m : {4U, 8U, 32U})
    {
      double square = 0.;
      for (unsigned int j = 1; j < 200000; j += 2)
        square +=
          8. * length / std::pow(pi * j, 2) / std::sqrt(1. + std::pow(j * pi * m / length, 2));
      const double exact = std::sqrt(square);
      const SpectralNorm norm(length, /*closed=*/true);
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
      checks.near("closed side, constant",
                  norm.distance(norm.coefficients({}, {}), ends, one),
                  std::sqrt(length),
                  1e-12);
    }

  // 3 cos(2 s) - sin(5 s) on the unit circle: pi (9 (1 + 4)^{-1/2} + (1 + 25)^{-1/2}).
  const dealii::QGauss<1> gauss(8);
  const unsigned int n = 64;
  std::vector<double> s, w;
  for (unsigned int c = 0; c < n; ++c)
    for (unsigned int p = 0; p < gauss.size(); ++p)
    {
      s.push_back(2. * pi * (c + gauss.point(p)[0]) / n);
      w.push_back((3. * std::cos(2. * s.back()) - std::sin(5. * s.back())) * gauss.weight(p) * 2. *
                  pi / n);
    }
  const SpectralNorm circle(2. * pi, true);
  auto modes = circle.coefficients(s, w);
  // The rule is exact up to some 8 * 64 oscillations only.
  for (unsigned int c = 0; c < modes.size(); ++c)
    modes[c] = (c - 1) % 4096 < 100 ? modes[c] : 0.;
  dealii::Vector<double> nothing(1);
  checks.near("closed side, harmonics",
              circle.distance(modes, {0., 2. * pi}, nothing),
              std::sqrt(pi * (9. / std::sqrt(5.) + 1. / std::sqrt(26.))),
              1e-12);
}
} // namespace

int main()
{
  Checks checks;
  check_checkerboards(checks);
  check_constants(checks);
  check_seminorm(checks);
  check_coefficients(checks);
  check_closed_side(checks);
  return checks.exit_code();
}
