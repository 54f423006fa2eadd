// SPDX-License-Identifier: LGPL-2.1-or-later
// Exponents at corners against published values, and against the determinant of the conditions on
// the two edges for the general solution r^lambda, which shows that no root is left out.

#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <algorithm>
#include <array>
#include <complex>
#include <utility>
#include <vector>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Complex = std::complex<double>;
using Matrix = std::array<std::array<Complex, 4>, 4>;

constexpr EdgeSupport free_edge = EdgeSupport::free, held = EdgeSupport::held,
                      sliding = EdgeSupport::sliding;

/** u_r, u_theta (times 2 mu / r^lambda) and sigma_theta theta, sigma_r theta (over lambda
 * r^(lambda-1)) of phi = A z^lambda, psi = B z^lambda with A = 1, A = -i, B = 1 and B = -i in
 * 2 mu (u_x + i u_y) = kappa phi - z conj(phi') - conj(psi), Kolosov's formula. */
Matrix general_solution(const Complex lambda, const double theta, const double kappa) {
  const Complex x = (lambda - 1.) * theta, y = (lambda + 1.) * theta;
  const Complex cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y);
  return {{{(kappa - lambda) * cx, (kappa - lambda) * sx, -cy, -sy},
           {(kappa + lambda) * sx, -(kappa + lambda) * cx, sy, -cy},
           {(lambda + 1.) * cx, (lambda + 1.) * sx, cy, sy},
           {(lambda - 1.) * sx, -(lambda - 1.) * cx, sy, -cy}}};
}

/** Which two of the four rows vanish on an edge. */
std::array<unsigned int, 2> rows_of(const EdgeSupport support) {
  return support == free_edge
           ? std::array<unsigned int, 2>{{2, 3}}
           : std::array<unsigned int, 2>{{support == held ? 0U : 1U, support == held ? 1U : 3U}};
}

/** By Gauss' elimination. */
template <std::size_t n>
Complex determinant(std::array<std::array<Complex, n>, n> m) {
  Complex product = 1.;
  for (std::size_t k = 0; k < n; ++k) {
    const auto largest =
      std::max_element(m.begin() + k, m.end(), [k](const auto &a, const auto &b) {
        return std::abs(a[k]) < std::abs(b[k]);
      });
    if (largest != m.begin() + k) {
      std::swap(*largest, m[k]);
      product *= -1.;
    }
    product *= m[k][k];
    for (std::size_t i = k + 1; i < n && m[k][k] != 0.; ++i)
      for (std::size_t j = n; j-- > k;)
        m[i][j] -= m[i][k] / m[k][k] * m[k][j];
  }
  return product;
}

/** A corner of one or two materials and the determinant of its conditions, an entire function of
 * lambda: those of the edges, and u and the traction, which do not jump. */
struct Problem {
  std::vector<WedgeLayer> layers;
  EdgeCondition first, second;

  double angle() const {
    return layers.front().angle + (layers.size() > 1 ? layers.back().angle : 0.);
  }
  Complex operator()(const Complex lambda) const {
    return layers.size() == 1 ? with_one(lambda) : with_two(lambda);
  }
  /** The angle by which the determinant turns on the way from a to b. */
  double turn(const Complex a, const Complex b, const Complex at_a, const Complex at_b) const {
    const double change = std::arg(at_b / at_a);
    if (std::abs(change) < 0.5 || std::abs(b - a) < 1e-9)
      return change;
    const Complex middle = 0.5 * (a + b), at_middle = (*this)(middle);
    return turn(a, middle, at_a, at_middle) + turn(middle, b, at_middle, at_b);
  }
  /** The number of roots in from < Re < to, |Im| < height, by the principle of the argument. */
  double n_roots(const double from, const double to, const double height) const {
    const Complex corners[] = {{from, -height}, {to, -height}, {to, height}, {from, height}};
    const unsigned int n = 40;
    double sum = 0.;
    for (unsigned int side = 0; side < 4; ++side) {
      const Complex start = corners[side], step = (corners[(side + 1) % 4] - start) / double(n);
      for (unsigned int i = 0; i < n; ++i) {
        const Complex a = start + double(i) * step, b = start + double(i + 1) * step;
        sum += turn(a, b, (*this)(a), (*this)(b));
      }
    }
    return sum / (2. * PI);
  }

private:
  static Matrix rows(const Complex lambda, const WedgeLayer &layer, const double angle) {
    Matrix m = general_solution(lambda, angle, layer.kappa);
    for (unsigned int i = 0; i < 2; ++i)
      for (Complex &entry : m[i])
        entry /= layer.shear_modulus;
    return m;
  }
  /** The two conditions on an edge. */
  static std::array<std::array<Complex, 4>, 2> conditions(const EdgeCondition &edge,
                                                          const Matrix &m) {
    const auto numbers = rows_of(edge.support);
    std::array<std::array<Complex, 4>, 2> chosen = {{m[numbers[0]], m[numbers[1]]}};
    if (edge.support == sliding)
      for (unsigned int j = 0; j < 4; ++j)
        chosen[1][j] += edge.ratio * m[2][j];
    return chosen;
  }
  Complex with_one(const Complex lambda) const {
    const auto one = conditions(first, rows(lambda, layers[0], 0.)),
               other = conditions(second, rows(lambda, layers[0], layers[0].angle));
    return determinant(Matrix{{one[0], one[1], other[0], other[1]}});
  }
  Complex with_two(const Complex lambda) const {
    const double middle = layers[0].angle;
    const auto one = conditions(first, rows(lambda, layers[0], 0.)),
               other = conditions(second, rows(lambda, layers[1], angle()));
    const Matrix before = rows(lambda, layers[0], middle), after = rows(lambda, layers[1], middle);
    std::array<std::array<Complex, 8>, 8> m = {};
    for (unsigned int j = 0; j < 4; ++j) {
      for (unsigned int i = 0; i < 2; ++i) {
        m[i][j] = one[i][j];
        m[i + 2][j + 4] = other[i][j];
      }
      for (unsigned int i = 0; i < 4; ++i) {
        m[i + 4][j] = before[i][j];
        m[i + 4][j + 4] = -after[i][j];
      }
    }
    return determinant(m);
  }
};

/** Integers are the only roots before the exponent, and the exponent is one. */
void test_completeness(Checks &checks) {
  const double margin = 1e-4;
  std::vector<double> angles = {0.5 * PI, 0.75 * PI, PI, 1.5 * PI, 2. * PI};
  for (double angle = 0.31; angle < 2. * PI; angle += 0.293)
    angles.push_back(angle);
  for (const auto &[first, second] :
       {std::pair(free_edge, free_edge), std::pair(held, held), std::pair(held, free_edge),
        std::pair(sliding, free_edge), std::pair(held, sliding), std::pair(sliding, sliding)})
    for (const double angle : angles)
      for (const double kappa : {1.04, 1.4, 1.8, 2.2, 6.}) {
        const Problem problem = {{{angle, kappa, 1.}}, {first}, {second}};
        const double exponent = corner_exponent(angle, first, second, kappa), height = 8. / angle;
        double integers = 0.;
        for (unsigned int n = 1; n < exponent - margin; ++n)
          integers += problem.n_roots(n - margin, n + margin, margin);
        checks.near("roots before the exponent are integers",
                    problem.n_roots(std::min(0.02, 0.5 * exponent), exponent - margin, height),
                    integers, 1e-6);
        if (exponent < max_corner_exponent)
          checks.that("the exponent is a root",
                      problem.n_roots(exponent - margin, exponent + margin, height) > 1. - 1e-6);
        checks.near("the order of the edges does not matter",
                    corner_exponent(angle, second, first, kappa), exponent, 1e-12);
      }
}

/** There is no root before the exponent of two materials, or of an edge with friction, and the
 * exponent is one unless it is 1. */
void test_layers(Checks &checks) {
  const double margin = 1e-3;
  std::vector<Problem> problems;
  for (const double ratio : {1e-3, 0.2, 30.})
    for (const auto &[a, b] : {std::pair(0.5 * PI, 0.5 * PI), std::pair(0.7, 1.9)})
      for (const EdgeSupport first : {free_edge, held, sliding})
        problems.push_back({{{a, 1.8, 1.}, {b, 2.2, ratio}}, {first}, {free_edge}});
  for (const double f : {-0.8, -0.3, 0.3, 0.8})
    for (const double angle : {0.4 * PI, 0.5 * PI, 0.8 * PI, 1.4 * PI})
      for (const EdgeSupport other : {free_edge, held}) {
        problems.push_back({{{angle, 1.8, 1.}}, {sliding, f}, {other}});
        problems.push_back({{{angle, 1.8, 1.}}, {other}, {sliding, f}});
      }
  for (const Problem &problem : problems) {
    const double exponent = corner_exponent(problem.layers, problem.first, problem.second),
                 height = 8. / problem.angle();
    checks.near("layers: no root before the exponent",
                problem.n_roots(std::min(0.02, 0.5 * exponent), exponent - margin, height), 0.,
                1e-6);
    if (exponent < 1. - margin)
      checks.that("layers: the exponent is a root",
                  problem.n_roots(exponent - margin, exponent + margin, height) > 1. - 1e-6);
  }
}

/** A crack along an interface has r^{1/2 + i e}; the pressure under a flat punch that slides has
 * r^{-1/2 + g}, tan(pi g) = f (kappa - 1)/(kappa + 1), with 1/2 - g at its other end. */
void test_layers_against_closed_forms(Checks &checks) {
  for (const double ratio : {1e-6, 0.1, 1., 1e6})
    checks.near("crack along an interface",
                corner_exponent({{PI, 1.8, 1.}, {PI, 2.2, ratio}}, {free_edge}, {free_edge}), 0.5,
                1e-7);
  const double kappa = 1.8;
  for (const double f : {0.2, 0.6}) {
    const double g = std::atan(f * (kappa - 1.) / (kappa + 1.)) / PI;
    const std::vector<WedgeLayer> half_plane = {{PI, kappa, 1.}};
    std::vector<double> found = {corner_exponent(half_plane, {sliding, f}, {free_edge}),
                                 corner_exponent(half_plane, {sliding, -f}, {free_edge})};
    checks.near("opposite friction at the other end",
                {corner_exponent(half_plane, {free_edge}, {sliding, -f}),
                 corner_exponent(half_plane, {free_edge}, {sliding, f})},
                found, 1e-9);
    std::sort(found.begin(), found.end());
    checks.near("sliding punch", found, {0.5 - g, 0.5 + g}, 1e-9);
  }
  checks.near("equal layers are one",
              corner_exponent({{PI, 1.8, 1.}, {0.5 * PI, 1.8, 1.}}, {free_edge}, {free_edge}),
              0.544483737, 1e-8);
}

void test_known_values(Checks &checks) {
  struct Row {
    std::string name;
    double degrees;
    EdgeSupport first, second;
    double value, tolerance;
  };
  for (const Row &row : std::vector<Row>{
         {"crack", 360., free_edge, free_edge, 0.5, 1e-10},
         {"L-shaped body, free", 270., free_edge, free_edge, 0.544483737, 1e-9},
         {"L-shaped body, free: half of it", 135., sliding, free_edge, 0.544483737, 1e-9},
         {"free square: complex roots", 90., free_edge, free_edge, 2.739593, 1e-6},
         {"straight free edge", 180., free_edge, free_edge, 3., 0.},
         {"straight held edge", 180., held, held, 3., 0.},
         {"held square, free next to it", 90., held, free_edge, 0.71117, 1e-5},
         {"straight edge, half of it held", 180., held, free_edge, 0.5, 1e-10},
         {"crack held on one side", 360., held, free_edge, 0.25, 1e-10},
         {"end of a flat punch", 180., sliding, free_edge, 0.5, 1e-10},
         {"straight edge, held and sliding", 180., held, sliding, 0.5, 1e-10},
         {"rollers next to a free edge at a right angle", 90., sliding, free_edge, 3., 0.},
         {"rollers on two edges at a right angle", 90., sliding, sliding, 3., 0.},
         {"rollers at 60 degrees", 60., sliding, sliding, 3., 0.},
         {"rollers at 135 degrees", 135., sliding, sliding, 1. / 3., 1e-10},
         {"rollers at 270 degrees", 270., sliding, sliding, 1. / 3., 1e-10}})
    checks.near(row.name,
                corner_exponent(row.degrees * PI / 180., row.first, row.second, 3. - 4. * 0.3),
                row.value, row.tolerance);
  // Both components of u vanish for an incompressible fluid in Moffatt's corner, r^(2.74 + 1.12 i).
  checks.near("Moffatt's eddies in a right angle", corner_exponent(0.5 * PI, held, held, 1.),
              2.739593, 1e-6);
  // nu = 0: tension without contraction is linear and meets both conditions.
  checks.between("held and free at a right angle, nu = 0",
                 corner_exponent(0.5 * PI, held, free_edge, 3.), 1.01, 1.99);
}

void test_kolosov(Checks &checks) {
  using Tensors = dealii::Physics::Elasticity::StandardTensors<2>;
  const auto layer = [](const double lambda, const double mu) {
    return make_layer(lambda * Tensors::IxI + 2. * mu * Tensors::S, 1.);
  };
  const auto kappa = [&](const double lambda, const double mu) { return layer(lambda, mu).kappa; };
  for (const double nu : {-0.4, 0., 0.3, 0.49}) {
    const double mu = 3., lambda = 2. * mu * nu / (1. - 2. * nu);
    checks.near("plane strain", kappa(lambda, mu), 3. - 4. * nu, 1e-12);
    checks.near("plane stress", kappa(2. * lambda * mu / (lambda + 2. * mu), mu),
                (3. - nu) / (1. + nu), 1e-12);
    checks.near("shear modulus", layer(lambda, mu).shear_modulus, mu, 1e-12);
  }
  // The mean over rotations does not see a part that E_1111 takes from E_2222.
  dealii::SymmetricTensor<4, 2> hooke = 1.5 * Tensors::IxI + 2. * Tensors::S;
  const double isotropic = make_layer(hooke, 1.).kappa;
  hooke[0][0][0][0] += 0.4;
  hooke[1][1][1][1] -= 0.4;
  checks.near("stiffer along x, softer along y", make_layer(hooke, 1.).kappa, isotropic, 1e-12);
}

/** A right corner on a half-plane with E times its modulus, nu = 0.3: roots of an 8 x 8 determinant
 * of an independent program (Williams' functions of both wedges). */
void test_slipping_wedges(Checks &checks) {
  struct Row {
    double E, without, with, against, stick;
  };
  constexpr double kappa = 3. - 4. * 0.3;
  const EdgeCondition free_edge;
  for (const Row &row : std::vector<Row>{{1e-3, 0.5006, 0.5275, 0.4738, NAN},
                                         {0.1, 0.5557, 0.5514, 0.5603, 0.5204},
                                         {1., 0.7740, 0.6380, 0.9799, 0.5445},
                                         {10., 0.9622, 0.7011, 1., 0.6690},
                                         {1e3, 0.9996, 0.7128, 1., 0.7107}}) {
    const std::vector<WedgeLayer> corner = {{0.5 * PI, kappa, 1.}}, plane = {{PI, kappa, row.E}};
    const auto slip = [&](const double friction) {
      return corner_exponent(SlippingWedges{corner, plane, friction}, free_edge, free_edge);
    };
    checks.near("frictionless", slip(0.), row.without, 1e-4);
    checks.near("slip with either sign",
                {std::min(slip(0.3), slip(-0.3)), std::max(slip(0.3), slip(-0.3))},
                {std::min(row.with, row.against), std::max(row.with, row.against)}, 1e-4);
    checks.near("in the other order",
                corner_exponent(SlippingWedges{plane, corner, 0.}, free_edge, free_edge), slip(0.),
                1e-9);
    if (std::isfinite(row.stick))
      checks.near("stick", corner_exponent({corner[0], plane[0]}, free_edge, free_edge), row.stick,
                  1e-4);
  }
  const std::vector<WedgeLayer> quarter = {{0.5 * PI, kappa, 1.}};
  checks.near("two right corners: no singular stress",
              corner_exponent(SlippingWedges{quarter, quarter, 0.}, free_edge, free_edge), 1., 0.);
}
} // namespace

int main() {
  return run_tests({test_known_values, test_kolosov, test_completeness, test_layers,
                    test_layers_against_closed_forms, test_slipping_wedges});
}
