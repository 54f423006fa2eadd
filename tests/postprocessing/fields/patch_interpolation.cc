// SPDX-License-Identifier: LGPL-2.1-or-later
// pi^{2h} reproduces functions of degree two per direction, and the error estimate is the distance
// of such functions from their bilinear interpolant.

#include <signorini/discretization/space/patch_interpolation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q.h>

#include <array>
#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::Tensor;

namespace {
const std::string sides = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** sum_ij c_ij x^i y^j, i, j <= degree, for each component. */
struct Polynomial {
  explicit Polynomial(const unsigned int seed, const unsigned int degree = 2)
    : n(degree + 1) {
    RandomNumbers random(seed);
    for (auto &component : coefficients)
      for (unsigned int i = 0; i < n * n; ++i)
        component.push_back(random());
  }
  Tensor<1, 2> value(const Point<2> &x) const {
    Tensor<1, 2> sum;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int i = 0; i < n * n; ++i)
        sum[k] += coefficients[k][i] * std::pow(x[0], i % n) * std::pow(x[1], i / n);
    return sum;
  }
  Tensor<2, 2> gradient(const Point<2> &x) const {
    const auto slope = [](const double t, const unsigned int i) {
      return i == 0 ? 0. : i * std::pow(t, i - 1);
    };
    Tensor<2, 2> sum;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int i = 0; i < n * n; ++i) {
        sum[k][0] += coefficients[k][i] * slope(x[0], i % n) * std::pow(x[1], i / n);
        sum[k][1] += coefficients[k][i] * std::pow(x[0], i % n) * slope(x[1], i / n);
      }
    return sum;
  }

  unsigned int n;
  std::array<std::vector<double>, 2> coefficients;
};

using Gradient = std::function<Tensor<2, 2>(const Point<2> &)>;

/** Largest distance of the interpolation of U and its gradient from a function at points of all
 * cells. */
double max_distance(const OneLevel &level, const Displacement &U, const Field &value,
                    const Gradient &gradient, const unsigned int n_generations) {
  const DisplacementSpace<2> &space = level.space();
  PatchInterpolation<2> interpolation(space, U, dealii::QGauss<2>(2), n_generations);
  double largest = 0.;
  for (const unsigned int n_points : {2U, 4U}) {
    dealii::FEValues<2> values(space.mesh().mapping(), space.element(), dealii::QGauss<2>(n_points),
                               dealii::update_quadrature_points | dealii::update_inverse_jacobians);
    for (const auto &cell : space.dofs().active_cell_iterators()) {
      values.reinit(cell);
      const FieldValues<2> &result = interpolation.evaluate(cell, values);
      for (const unsigned int q : values.quadrature_point_indices()) {
        const Point<2> &x = values.quadrature_point(q);
        largest = std::max({largest, (result.values[q] - value(x)).norm(),
                            gradient ? (result.gradients[q] - gradient(x)).norm() : 0.});
      }
    }
  }
  return largest;
}

void reproduces(Checks &checks, const std::string &name, const OneLevel &level, const Field &value,
                const Gradient &gradient, const unsigned int n_generations = 1) {
  checks.near(
    name, max_distance(level, nodal_values(level.space(), value), value, gradient, n_generations),
    0., 1e-12);
}

void polynomials(Checks &checks) {
  const Tensor<2, 2> slope({{0.3, -0.7}, {1.1, 0.4}});
  const OneLevel distorted("Geometry/Distortion = 0.3\n" + sides, 3);
  reproduces(
    checks, "linear function on distorted parents", distorted,
    [&](const Point<2> &x) { return slope * x; }, [&](const Point<2> &) { return slope; });
  // pi^{2h} U takes the values U at the nodes: I^h pi^{2h} = identity, so pi^{2h} is a projection.
  RandomNumbers random(2);
  const Displacement U = random_rows(distorted.space(), random);
  PatchInterpolation<2> interpolation(distorted.space(), U);
  dealii::FEValues<2> vertices(distorted.discretization.mesh.mapping(), distorted.space().element(),
                               dealii::QTrapezoid<2>(), dealii::update_inverse_jacobians);
  double largest = 0.;
  for (const auto &cell : distorted.space().dofs().active_cell_iterators()) {
    vertices.reinit(cell);
    const FieldValues<2> &result = interpolation.evaluate(cell, vertices);
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
        largest =
          std::max(largest, std::abs(result.values[v][d] - U[cell->vertex_dof_index(v, d)]));
  }
  checks.near("nodal values are taken", largest, 0., 1e-15);
}

/** On one quadrilateral parent: biquadratic in the coordinates of its bilinear map F. */
void mapped_parent(Checks &checks) {
  const OneLevel level(
    "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 2,-0.5; 2.5,1.5; -0.3,1\n"
    "Boundary/Clamped = side2\nBoundary/Contact = side0\n",
    1);
  const Polynomial q(3);
  const auto parent = level.discretization.mesh.triangulation().begin(0);
  reproduces(
    checks, "biquadratic function of the parent's coordinates", level,
    [&](const Point<2> &x) {
      return q.value(dealii::MappingQ<2>(1).transform_real_to_unit_cell(parent, x));
    },
    Gradient());
}

/** Degree 2^k on the k-th mesh before, and not one more. */
void generations(Checks &checks) {
  const OneLevel rectangles(
    "subsection Geometry\nset Upper right = 2, 1\nset Cells = 3, 2\nend\n" + sides, 2);
  const OneLevel squares(sides, 3);
  for (const unsigned int k : {0U, 1U, 2U, 3U}) {
    const std::string name = std::to_string(k) + " generations";
    const Polynomial q(5 + k, 1U << k);
    const Field value = [&](const Point<2> &x) { return q.value(x); };
    const Gradient gradient = [&](const Point<2> &x) { return q.gradient(x); };
    if (k < 3)
      reproduces(checks, name + " on rectangles", rectangles, value, gradient, k);
    reproduces(checks, name + " on squares", squares, value, gradient, k);
    const unsigned int degree = (1U << k) + 1;
    const Field power = [&](const Point<2> &x) {
      return Point<2>(std::pow(x[0], degree), std::pow(x[1], degree));
    };
    checks.that(name + ": one degree more is too much",
                max_distance(squares, nodal_values(squares.space(), power), power, Gradient(), k) >
                  1e-6);
  }
  const auto n_ancestors = [](const OneLevel &level) {
    return level.discretization.mesh.n_nested_ancestors();
  };
  const std::string distorted = "Geometry/Distortion = 0.3\n" + sides;
  checks.near("ancestors without distortion", n_ancestors(squares), 3, 0);
  // The coarsest level, 2 by default, is the one that is distorted.
  checks.near("ancestors on a distorted level", n_ancestors(OneLevel(distorted, 2)), 0, 0);
  checks.near("ancestors two levels below it", n_ancestors(OneLevel(distorted, 4)), 2, 0);
}

/** Degree four is taken where the mesh resolves the function. */
void choice(Checks &checks) {
  const auto wave = [](const double frequency) {
    return [frequency](const Point<2> &x) {
      return Point<2>(std::sin(frequency * x[0]), std::sin(frequency * x[1]));
    };
  };
  const OneLevel level(sides, 4);
  const auto best = [&](const double frequency) {
    return best_interpolation(level.space(), nodal_values(level.space(), wave(frequency)));
  };
  checks.near("a wave on 40 cells", best(0.8 * dealii::numbers::PI), 2, 0);
  checks.near("a wave on 2.5 cells", best(12.8 * dealii::numbers::PI), 1, 0);
  const auto on_level = [](const unsigned int number) {
    const OneLevel coarse(sides, number);
    return best_interpolation(coarse.space(),
                              nodal_values(coarse.space(), [](const Point<2> &x) { return x; }));
  };
  checks.near("no parents", on_level(0), 0, 0);
  checks.near("no grandparents", on_level(1), 1, 0);
}

/**
 * x^2 differs from its interpolant by h^2/3 (slope) and h^4/30 (value), squared. For (x^2, y^2) the
 * strains e11 and e22 of the difference have the mean zero in each cell and depend on one
 * coordinate each: |||.|||^2 = (lambda + 2 mu) 2 h^2/3. Those of the interpolant take the middle
 * values of 2 x and 2 y, whose squares have the mean 4/3 - h^2/3.
 */
void estimates(Checks &checks) {
  const std::string material =
    "subsection Material\nset Young's modulus = 5\nset Poisson's ratio = 0.25\nend\n";
  const double lambda = 2., mu = 2.;
  for (const unsigned int number : {1U, 3U}) {
    const OneLevel level(sides + material, number);
    const double h = std::pow(0.5, number);
    const Displacement U = nodal_values(
      level.space(), [](const Point<2> &x) { return Point<2>(x[0] * x[0], x[1] * x[1]); });
    const ErrorEstimate estimate = level.estimate(U);
    const double exact = std::sqrt(2. * (h * h / 3. + std::pow(h, 4) / 30.));
    const std::string name = "estimate on level " + std::to_string(number);
    checks.near(name + ": distance to the interpolant", estimate.h1.value(), exact, 1e-14);
    const double energy = std::sqrt((lambda + 2. * mu) * 2. * h * h / 3.);
    const double square = (4. - h * h) / 3.;
    const double scale = std::sqrt(lambda * (2. * square + 2.) + 2. * mu * 2. * square);
    checks.near(name + ": in the energy norm", estimate.energy, energy, 1e-13);
    checks.near(name + ": relative", estimate.relative, energy / scale, 1e-13);
    checks.that(name + ": no pressure",
                estimate.mesh == estimate.energy && estimate.pressure == 0.);
    Displacement moved(U);
    moved.add(1000.);
    checks.near(name + ": relative, after a translation", level.estimate(moved).relative,
                energy / scale, 1e-10);
  }
  // E = 1 + x: int (1 + x) (2 x - m(x))^2 = 3/2 h^2/3, and the same for y.
  const OneLevel graded(sides + "Material/Young's modulus = 1+x\n"
                                "Material/Poisson's ratio = 0\n",
                        2);
  const Displacement squares = nodal_values(
    graded.space(), [](const Point<2> &x) { return Point<2>(x[0] * x[0], x[1] * x[1]); });
  checks.near("a material that varies", graded.estimate(squares).energy, 0.25, 1e-14);
  const OneLevel distorted("Geometry/Distortion = 0.3\n" + sides, 3);
  const Displacement linear = nodal_values(distorted.space(), [](const Point<2> &x) { return x; });
  checks.near("linear functions have no error", distorted.estimate(linear).h1.value(), 0., 1e-13);
  const Displacement zero =
    nodal_values(distorted.space(), [](const Point<2> &) { return Point<2>(); });
  checks.near("nothing moves", distorted.estimate(zero).relative, 0., 0.);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {polynomials, mapped_parent, generations, choice, estimates});
}
