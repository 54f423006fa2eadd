// SPDX-License-Identifier: LGPL-2.1-or-later
// Exponents at corners against published values, and against the determinant of the conditions on
// the two edges for the general solution r^lambda, which shows that no root is left out.

#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <array>
#include <complex>
#include <utility>
#include <vector>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
using Matrix = std::array<std::array<Complex, 4>, 4>;

constexpr EdgeSupport free_edge = EdgeSupport::free, held = EdgeSupport::held,
                      sliding = EdgeSupport::sliding;

/** u_r, u_theta (times 2 mu / r^lambda) and sigma_theta theta, sigma_r theta (over lambda
 * r^(lambda-1)) of phi = A z^lambda, psi = B z^lambda with A = 1, A = -i, B = 1 and B = -i in
 * 2 mu (u_x + i u_y) = kappa phi - z conj(phi') - conj(psi), Kolosov's formula. */
Matrix general_solution(const Complex lambda, const double theta, const double kappa)
{
  const Complex x = (lambda - 1.) * theta, y = (lambda + 1.) * theta;
  const Complex cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y);
  return {{{(kappa - lambda) * cx, (kappa - lambda) * sx, -cy, -sy},
           {(kappa + lambda) * sx, -(kappa + lambda) * cx, sy, -cy},
           {(lambda + 1.) * cx, (lambda + 1.) * sx, cy, sy},
           {(lambda - 1.) * sx, -(lambda - 1.) * cx, sy, -cy}}};
}

/** One of the four fields in Cartesian components, real lambda, 2 mu = 1. */
dealii::Tensor<1, 2>
displacement(const unsigned int field, const double lambda, const double kappa, const double r[2])
{
  const double radius = std::hypot(r[0], r[1]), theta = std::atan2(r[1], r[0]);
  const Matrix rows = general_solution(lambda, theta, kappa);
  const double scale = std::pow(radius, lambda);
  const double radial = scale * rows[0][field].real(), turning = scale * rows[1][field].real();
  return dealii::Tensor<1, 2>({radial * std::cos(theta) - turning * std::sin(theta),
                               radial * std::sin(theta) + turning * std::cos(theta)});
}

/** Hooke's law and equilibrium of the four fields by central differences. */
void test_general_solution(Checks &checks)
{
  const double h = 1e-3, radius = 1.1, theta = 0.7, mu = 0.5;
  double law = 0., equilibrium = 0.;
  for (const double kappa : {1.4, 1.8, 2.7})
    for (const double lambda : {0.3, 0.5445, 1.6})
      for (unsigned int field = 0; field < 4; ++field)
      {
        // lambda of Lame from kappa = (lambda + 3 mu)/(lambda + mu).
        const double lame = mu * (3. - kappa) / (kappa - 1.);
        const auto u = [&](const double dx, const double dy) {
          const double x[2] = {radius * std::cos(theta) + h * dx,
                               radius * std::sin(theta) + h * dy};
          return displacement(field, lambda, kappa, x);
        };
        const auto ux = (u(1., 0.) - u(-1., 0.)) / (2. * h),
                   uy = (u(0., 1.) - u(0., -1.)) / (2. * h);
        const double trace = ux[0] + uy[1];
        const dealii::Tensor<1, 2> e({-std::sin(theta), std::cos(theta)}), r({e[1], -e[0]});
        const auto stress = [&](const dealii::Tensor<1, 2> &a) {
          return lame * trace * (a * e) + mu * ((a * ux) * e[0] + (a * uy) * e[1]) +
                 mu * ((e * ux) * a[0] + (e * uy) * a[1]);
        };
        const Matrix rows = general_solution(lambda, theta, kappa);
        const double scale = lambda * std::pow(radius, lambda - 1.);
        law = std::max(law, std::abs(stress(e) - scale * rows[2][field].real()));
        law = std::max(law, std::abs(stress(r) - scale * rows[3][field].real()));
        const auto uxx = (u(1., 0.) - 2. * u(0., 0.) + u(-1., 0.)) / (h * h);
        const auto uyy = (u(0., 1.) - 2. * u(0., 0.) + u(0., -1.)) / (h * h);
        const auto uxy = (u(1., 1.) - u(1., -1.) - u(-1., 1.) + u(-1., -1.)) / (4. * h * h);
        const double fx = mu * (uxx[0] + uyy[0]) + (lame + mu) * (uxx[0] + uxy[1]);
        const double fy = mu * (uxx[1] + uyy[1]) + (lame + mu) * (uxy[0] + uyy[1]);
        equilibrium = std::max(equilibrium, std::hypot(fx, fy));
      }
  checks.near("general solution: Hooke's law", law, 0., 2e-5);
  checks.near("general solution: equilibrium", equilibrium, 0., 2e-5);
}

/** Which two of the four rows vanish on an edge. */
std::array<unsigned int, 2> rows_of(const EdgeSupport support)
{
  if (support == EdgeSupport::free)
    return {{2, 3}};
  return support == EdgeSupport::held ? std::array<unsigned int, 2>{{0, 1}}
                                      : std::array<unsigned int, 2>{{1, 3}};
}

Complex determinant(Matrix m)
{
  Complex product = 1.;
  for (unsigned int k = 0; k < 4; ++k)
  {
    unsigned int pivot = k;
    for (unsigned int i = k + 1; i < 4; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k]))
        pivot = i;
    if (pivot != k)
    {
      std::swap(m[k], m[pivot]);
      product = -product;
    }
    product *= m[k][k];
    for (unsigned int i = k + 1; i < 4; ++i)
      for (unsigned int j = 4; j-- > k;)
        m[i][j] -= m[i][k] / m[k][k] * m[k][j];
  }
  return product;
}

/** A corner and the determinant of its four conditions, an entire function of lambda. */
struct Problem
{
  double angle;
  EdgeSupport first, second;
  double kappa;

  double exponent() const
  {
    return corner_exponent(angle, first, second, kappa);
  }
  Complex operator()(const Complex lambda) const
  {
    const Matrix one = general_solution(lambda, 0., kappa),
                 other = general_solution(lambda, angle, kappa);
    const auto a = rows_of(first), b = rows_of(second);
    return determinant({{one[a[0]], one[a[1]], other[b[0]], other[b[1]]}});
  }
  /** The angle by which the determinant turns on the way from a to b. */
  double turn(const Complex a, const Complex b, const Complex at_a, const Complex at_b) const
  {
    const double change = std::arg(at_b / at_a);
    if (std::abs(change) < 0.5 || std::abs(b - a) < 1e-9)
      return change;
    const Complex middle = 0.5 * (a + b), at_middle = (*this)(middle);
    return turn(a, middle, at_a, at_middle) + turn(middle, b, at_middle, at_b);
  }
  /** The number of roots in from < Re < to, |Im| < height, by the principle of the argument. */
  double n_roots(const double from, const double to, const double height) const
  {
    const Complex corners[] = {{from, -height}, {to, -height}, {to, height}, {from, height}};
    const unsigned int n = 40;
    double sum = 0.;
    for (unsigned int side = 0; side < 4; ++side)
    {
      const Complex start = corners[side], step = (corners[(side + 1) % 4] - start) / double(n);
      for (unsigned int i = 0; i < n; ++i)
      {
        const Complex a = start + double(i) * step, b = start + double(i + 1) * step;
        sum += turn(a, b, (*this)(a), (*this)(b));
      }
    }
    return sum / (2. * PI);
  }
};

/** Integers are the only roots before the exponent, and the exponent is one. */
void test_completeness(Checks &checks)
{
  const std::vector<std::pair<EdgeSupport, EdgeSupport>> pairs = {{free_edge, free_edge},
                                                                  {held, held},
                                                                  {held, free_edge},
                                                                  {sliding, free_edge},
                                                                  {held, sliding},
                                                                  {sliding, sliding}};
  const std::vector<std::string> names = {
    "free, free", "held, held", "held, free", "sliding, free", "held, sliding", "sliding, sliding"};
  const double margin = 1e-4;
  std::vector<double> angles = {0.5 * PI, 0.75 * PI, PI, 1.5 * PI, 2. * PI};
  for (double angle = 0.31; angle < 2. * PI; angle += 0.293)
    angles.push_back(angle);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    double before = 0., at = 0., order = 0.;
    for (const double angle : angles)
      for (const double kappa : {1.04, 1.4, 1.8, 2.2, 6.})
      {
        const Problem problem = {angle, pairs[i].first, pairs[i].second, kappa};
        const double exponent = problem.exponent(), height = 8. / angle;
        double integers = 0.;
        for (unsigned int n = 1; n < exponent - margin; ++n)
          integers += problem.n_roots(n - margin, n + margin, margin);
        const double start = std::min(0.02, 0.5 * exponent);
        before =
          std::max(before, std::abs(problem.n_roots(start, exponent - margin, height) - integers));
        if (exponent < max_corner_exponent)
          at = std::max(at, 1. - problem.n_roots(exponent - margin, exponent + margin, height));
        order = std::max(
          order,
          std::abs(exponent - corner_exponent(angle, pairs[i].second, pairs[i].first, kappa)));
      }
    checks.near(names[i] + ": roots before the exponent that are no integers", before, 0., 1e-6);
    checks.that(names[i] + ": the exponent is a root", at < 1e-6);
    checks.near(names[i] + ": the order of the edges does not matter", order, 0., 1e-12);
  }
}

void test_known_values(Checks &checks)
{
  const double kappa = 3. - 4. * 0.3;
  const auto near = [&](const std::string &name,
                        const double degrees,
                        const EdgeSupport first,
                        const EdgeSupport second,
                        const double value,
                        const double tolerance) {
    checks.near(name, corner_exponent(degrees * PI / 180., first, second, kappa), value, tolerance);
  };
  near("crack", 360., free_edge, free_edge, 0.5, 1e-10);
  near("L-shaped body, free", 270., free_edge, free_edge, 0.544483737, 1e-9);
  near("L-shaped body, free: half of it", 135., sliding, free_edge, 0.544483737, 1e-9);
  near("free square: complex roots", 90., free_edge, free_edge, 2.739593, 1e-6);
  near("straight free edge", 180., free_edge, free_edge, 3., 0.);
  near("straight held edge", 180., held, held, 3., 0.);
  near("held square, free next to it", 90., held, free_edge, 0.71117, 1e-5);
  near("straight edge, half of it held", 180., held, free_edge, 0.5, 1e-10);
  near("crack held on one side", 360., held, free_edge, 0.25, 1e-10);
  near("end of a flat punch", 180., sliding, free_edge, 0.5, 1e-10);
  near("straight edge, held and sliding", 180., held, sliding, 0.5, 1e-10);
  near("rollers next to a free edge at a right angle", 90., sliding, free_edge, 3., 0.);
  near("rollers on two edges at a right angle", 90., sliding, sliding, 3., 0.);
  near("rollers at 60 degrees", 60., sliding, sliding, 3., 0.);
  near("rollers at 135 degrees", 135., sliding, sliding, 1. / 3., 1e-10);
  near("rollers at 270 degrees", 270., sliding, sliding, 1. / 3., 1e-10);
  // Both components of u vanish for an incompressible fluid in Moffatt's corner, r^(2.74 + 1.12 i).
  checks.near(
    "Moffatt's eddies in a right angle", corner_exponent(0.5 * PI, held, held, 1.), 2.739593, 1e-6);
  // nu = 0: tension without contraction is linear and meets both conditions.
  checks.between("held and free at a right angle, nu = 0",
                 corner_exponent(0.5 * PI, held, free_edge, 3.),
                 1.01,
                 1.99);
}

void test_kolosov(Checks &checks)
{
  using Tensors = dealii::Physics::Elasticity::StandardTensors<2>;
  const auto kappa = [](const double lambda, const double mu) {
    return kolosov_constant(lambda * Tensors::IxI + 2. * mu * Tensors::S);
  };
  for (const double nu : {-0.4, 0., 0.3, 0.49})
  {
    const double mu = 3., lambda = 2. * mu * nu / (1. - 2. * nu);
    const std::string name = "nu = " + std::to_string(nu);
    checks.near(name + ", plane strain", kappa(lambda, mu), 3. - 4. * nu, 1e-12);
    checks.near(name + ", plane stress",
                kappa(2. * lambda * mu / (lambda + 2. * mu), mu),
                (3. - nu) / (1. + nu),
                1e-12);
  }
  // The mean over rotations does not see what E_1111 takes from E_2222.
  dealii::SymmetricTensor<4, 2> hooke = 1.5 * Tensors::IxI + 2. * Tensors::S;
  const double isotropic = kolosov_constant(hooke);
  hooke[0][0][0][0] += 0.4;
  hooke[1][1][1][1] -= 0.4;
  checks.near("stiffer along x, softer along y", kolosov_constant(hooke), isotropic, 1e-12);
}
} // namespace

int main()
{
  Checks checks;
  test_known_values(checks);
  test_kolosov(checks);
  test_general_solution(checks);
  test_completeness(checks);
  return checks.exit_code();
}
