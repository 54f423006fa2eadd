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
} // namespace

int main()
{
  Checks checks;
  check_checkerboards(checks);
  check_constants(checks);
  check_seminorm(checks);
  check_coefficients(checks);
  return checks.exit_code();
}
