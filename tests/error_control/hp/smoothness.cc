// SPDX-License-Identifier: LGPL-2.1-or-later
// The indicator for functions whose Legendre coefficients are known.

#include <signorini/error_control/hp/cell_indicator.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** One cell, -1 < x, y < 1, lambda = mu = 1. */
const std::string one_cell =
  "subsection Geometry\nset Lower left = -1, -1\nset Upper right = 1, 1\nend\n"
  "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
  "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

CellIndicator indicate_one(const unsigned int degree, const Field &u) {
  const GradedLevel level(one_cell, uniform_plan(0, degree));
  return indicate(level.body(nodal_values(level.space(), u))).at(0);
}

/** The derivative 1/(a - x) of -log(a - x) has the normalised coefficients c_n ~ rho^n,
 * 1/rho = a + (a² - 1)^{1/2}. */
void analytic(Checks &checks) {
  for (const double a : {1.05, 1.2, 1.5, 2.})
    for (const unsigned int degree : {5U, 7U, 9U})
      for (const unsigned int d : {0U, 1U}) {
        const double rho = 1. / (a + std::sqrt(a * a - 1.));
        const CellIndicator found = indicate_one(degree, [&](const Point<2> &x) {
          dealii::Tensor<1, 2> u;
          u[1 - d] = -std::log(a - x[d]);
          return u;
        });
        checks.between("1/(a - x), a = " + std::to_string(a) + ", p = " + std::to_string(degree) +
                         (d == 0 ? ", along x" : ", along y"),
                       found.decay / rho, 0.8, 1.2);
      }
}

/**
 * The interpolant of (-log(a - x), 0) misses, with sigma_11 = 3 eps_11, about
 * (3 * 2 int (1/(a - x) - its part of degree p - 1)²)^{1/2}.
 */
void errors(Checks &checks) {
  const dealii::QGauss<1> gauss(40);
  for (const double a : {1.2, 2.})
    for (const unsigned int degree : {4U, 6U, 8U}) {
      double square = 0.;
      std::vector<double> rest(gauss.size());
      for (unsigned int q = 0; q < gauss.size(); ++q)
        rest[q] = 1. / (a - (2. * gauss.point(q)[0] - 1.));
      for (unsigned int n = 0; n < degree; ++n) {
        double coefficient = 0.;
        for (unsigned int q = 0; q < gauss.size(); ++q)
          coefficient += (2. * n + 1.) * gauss.weight(q) * rest[q] *
                         std::legendre(n, 2. * gauss.point(q)[0] - 1.);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          rest[q] -= coefficient * std::legendre(n, 2. * gauss.point(q)[0] - 1.);
      }
      for (unsigned int q = 0; q < gauss.size(); ++q)
        square += 3. * 2. * 2. * gauss.weight(q) * rest[q] * rest[q];
      const CellIndicator found =
        indicate_one(degree, [&](const Point<2> &x) { return Point<2>(-std::log(a - x[0]), 0.); });
      checks.between("error, a = " + std::to_string(a) + ", p = " + std::to_string(degree),
                     found.error / std::sqrt(square), 0.4, 2.5);
    }
}

/** Where the derivative is a root, coefficients fall like n^-2: no ratio below 1/2. */
void singular(Checks &checks) {
  for (const unsigned int degree : {6U, 9U}) {
    const CellIndicator found = indicate_one(degree, [](const Point<2> &x) {
      return Point<2>(0., std::pow(std::max(1. + x[0], 0.), 1.5));
    });
    checks.between("r^{3/2}, p = " + std::to_string(degree), found.decay, 0.4, 0.95);
  }
}

/** Twice the displacement: twice the error, the same decay. Polynomials of a lower degree: none. */
void scales(Checks &checks) {
  const Field u = [](const Point<2> &x) {
    return Point<2>(std::exp(x[0] - 0.3 * x[1]), std::sin(x[1]));
  };
  const CellIndicator once = indicate_one(4, u);
  const CellIndicator twice = indicate_one(4, [&u](const Point<2> &x) { return 2. * u(x); });
  checks.near("twice the displacement: error", twice.error / once.error, 2., 1e-10);
  checks.near("twice the displacement: decay", twice.decay / once.decay, 1., 1e-10);
  const CellIndicator polynomial = indicate_one(
    6, [](const Point<2> &x) { return Point<2>(x[0] * x[0] * x[1], x[1] * x[1] - x[0]); });
  checks.near("a polynomial has no error", polynomial.error, 0., 1e-10);
  checks.near("total", total({{3., 0.}, {4., 0.5}}), 5., 1e-15);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {analytic, errors, singular, scales});
}
