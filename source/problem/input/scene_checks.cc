// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of expressions, checked at points that the integrals will use or come close to.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "input.h"

namespace Signorini
{
/** Throws InputError with "WHERE: found FOUND at (X), allowed: ALLOWED." */
template <int dim>
[[noreturn]] void refuse_value(const std::string &where,
                               const std::string &found,
                               const Point<dim> &x,
                               const std::string &allowed);

/**
 * Checks a gradient given by expressions against differences of the displacement at points inside
 * the body. Points where two differences do not agree (kinks, singularities) are skipped.
 * @throws InputError if it is wrong at three points.
 */
template <int dim>
void check_exact_gradient(const ExactSolutionParameters &exact,
                          const Scene<dim> &scene,
                          const std::vector<Point<dim>> &points);

/**
 * Checks that an exact displacement satisfies what the scene prescribes on a side: u = 0, u·n = 0,
 * u = u_D, or u·n <= g.
 * @throws InputError
 */
template <int dim>
void check_exact_on_side(const ExactSolutionParameters &exact,
                         const Scene<dim> &scene,
                         unsigned int side,
                         const std::vector<Point<dim>> &points);

namespace
{
template <int dim>
using Points = std::vector<Point<dim>>;

/** Returns shares of the unit interval: Gauss points, and points close to its ends. */
std::vector<double> shares()
{
  std::vector<double> values = {1e-4, 1e-3, 1. - 1e-3, 1. - 1e-4};
  const QGauss<1> gauss(13);
  for (const Point<1> &q : gauss.get_points())
    values.push_back(q[0]);
  std::sort(values.begin(), values.end());
  return values;
}

/** Returns points of the cells of the coarse mesh; of every cell, or of some if there are very
 * many. */
Points<2> sample_cells(const Geometry<2> &geometry)
{
  constexpr unsigned int enough = 500;
  Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  const unsigned int stride = 1 + mesh.n_active_cells() / enough;
  const MappingQ1<2> mapping;
  const double close = 1e-3;
  Points<2> points;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->active_cell_index() % stride == 0)
      for (const double r : {close, 0.3, 0.7, 1. - close})
        for (const double s : {close, 0.3, 0.7, 1. - close})
          points.push_back(mapping.transform_unit_to_real_cell(cell, Point<2>(r, s)));
  return points;
}

Points<2> sample_body(const Geometry<2> &geometry)
{
  if (!geometry.star_shaped)
    return sample_cells(geometry);
  const Point<2> inside = geometry.inner_point();
  const std::vector<double> unit = shares();
  Points<2> points;
  for (const Side<2> &side : geometry.sides)
    for (const double s : unit)
      for (const double r : unit)
        points.push_back(inside + r * (side.point(s * side.length()) - inside));
  return points;
}

/** Returns points of a box. */
Points<3> sample_body(const Geometry<3> &geometry)
{
  const Tensor<1, 3> extent = geometry.upper - geometry.lower;
  const std::vector<double> unit = {1e-4, 0.05, 0.2, 0.37, 0.5, 0.63, 0.8, 0.95, 1. - 1e-4};
  Points<3> points;
  for (const double r : unit)
    for (const double s : unit)
      for (const double t : unit)
        points.push_back(geometry.lower +
                         Tensor<1, 3>({r * extent[0], s * extent[1], t * extent[2]}));
  return points;
}

/** Returns points inside of a side and, for what is evaluated at nodes, at its ends. */
Points<2> sample_side(const Side<2> &side, const bool with_ends)
{
  // A side of very many pieces has short ones: their middles suffice.
  constexpr unsigned int many = 100;
  Points<2> points;
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
  {
    const Curve &piece = side.piece(k);
    for (const double s : side.n_pieces() > many ? std::vector<double>{0.5} : shares())
      points.push_back(piece.point(s * piece.length()));
  }
  if (with_ends)
    points.insert(points.end(), {side.start(), side.end()});
  return points;
}
Points<3> sample_side(const Side<3> &side, const bool with_ends)
{
  std::vector<double> unit = shares();
  if (with_ends)
    unit.insert(unit.end(), {0., 1.});
  Points<3> points;
  for (const double r : unit)
    for (const double s : unit)
      points.push_back(side.point({r * side.lengths()[0], s * side.lengths()[1]}));
  return points;
}

/** Evaluates data at points: expression functions that are data of the problem throw for bad
 * values. */
template <int dim>
void evaluate(const FunctionPointer<dim> &data, const Points<dim> &points)
{
  if (data == nullptr)
    return;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < data->n_components; ++c)
      data->value(x, c);
}

template <int dim>
void check_finite(const FunctionPointer<dim> &function,
                  const Points<dim> &points,
                  const std::string &where)
{
  if (function == nullptr)
    return;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < function->n_components; ++c)
    {
      const double value = function->value(x, c);
      if (!(std::abs(value) <= max_magnitude))
        refuse_value(where,
                     "the value " + number_text(value) + " of component " + std::to_string(c + 1),
                     x,
                     "values up to " + number_text(max_magnitude) + " on the whole body");
    }
}

/** Refuses a positive pressure: contact cannot pull. */
template <int dim>
void check_pressure(const FunctionPointer<dim> &pressure,
                    const Points<dim> &points,
                    const std::string &where)
{
  if (pressure == nullptr)
    return;
  check_finite(pressure, points, where);
  double largest = 0.;
  for (const Point<dim> &x : points)
    largest = std::max(largest, std::abs(pressure->value(x)));
  for (const Point<dim> &x : points)
    if (pressure->value(x) > 1e-6 * largest)
      refuse_value(where,
                   "the tension " + number_text(pressure->value(x)),
                   x,
                   "p = sigma_n <= 0, negative in compression");
}
} // namespace

template <int dim>
void check_moduli(const std::vector<Expression<dim>> &moduli, const Geometry<dim> &geometry)
{
  for (const Point<dim> &x : sample_body(geometry))
  {
    double largest = 0.;
    for (const Expression<dim> &modulus : moduli)
      largest = std::max(largest, std::abs(modulus(x)));
    // The material checks signs, and refuses what is no number.
    if (largest > max_magnitude || (largest > 0. && largest < min_magnitude))
      refuse_value(moduli[0].where(),
                   number_text(largest),
                   x,
                   "moduli from " + number_text(min_magnitude) + " to " +
                     number_text(max_magnitude) + "; take other units");
  }
}

template <int dim>
void check_described_scene(const ExactSolutionParameters &exact, const Scene<dim> &scene)
{
  const Points<dim> body = sample_body(scene.geometry);
  for (const Point<dim> &x : body)
    scene.material->hooke(x);
  evaluate(scene.body_force, body);
  check_finite(scene.exact_displacement, body, exact.displacement.where());
  check_exact_gradient(exact, scene, body);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const BoundaryCondition<dim> &condition = scene.boundary[i];
    const Side<dim> &side = scene.geometry.sides[i];
    evaluate(condition.data, sample_side(side, condition.role != Role::traction));
    check_exact_on_side(exact, scene, i, sample_side(side, false));
    check_pressure(condition.exact_pressure, sample_side(side, false), exact.pressure.where());
  }
}
template void check_moduli(const std::vector<Expression<2>> &, const Geometry<2> &);
template void check_moduli(const std::vector<Expression<3>> &, const Geometry<3> &);
template void check_described_scene(const ExactSolutionParameters &, const Scene<2> &);
template void check_described_scene(const ExactSolutionParameters &, const Scene<3> &);

// An exact solution that contradicts the scene, or itself.

namespace
{
/** The share of the largest displacement by which a constant with few digits may differ. */
constexpr double tolerated_difference = 1e-4;

/** Returns (u_c(x + h e_d) - u_c(x - h e_d)) / 2h. */
template <int dim>
double difference(const Function<dim> &u,
                  const Point<dim> &x,
                  const unsigned int c,
                  const unsigned int d,
                  const double h)
{
  const Tensor<1, dim> step = h * Point<dim>::unit_vector(d);
  return (u.value(x + step, c) - u.value(x - step, c)) / (2. * h);
}

/** Returns a point a little aside, because kinks lie on lines of symmetry. */
template <int dim>
Point<dim> aside(const Point<dim> &x, const Geometry<dim> &geometry)
{
  const Tensor<1, dim> to_inside = geometry.inner_point() - x;
  const double h = geometry.shortest_extent();
  Tensor<1, dim> offset;
  for (unsigned int d = 0; d < dim; ++d)
    offset[d] = std::array<double, 3>{1.37e-5, 0.73e-5, 0.91e-5}[d];
  return x + 1e-4 * to_inside + h * offset;
}

template <int dim>
double max_displacement(const Function<dim> &u, const std::vector<Point<dim>> &points)
{
  double largest = 0.;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < dim; ++c)
      largest = std::max(largest, std::abs(u.value(x, c)));
  return largest;
}

/** The derivative of the displacement at a point, as given and as found by a difference. */
struct Derivative
{
  double given, found;
  /** Whether it is certain that they are different. */
  bool differ;
};

/** Compares a given derivative with a difference. @param largest |u| and |grad u|, for what counts
 * as zero. */
template <int dim>
Derivative compare_derivative(const Function<dim> &u,
                              const Point<dim> &x,
                              const unsigned int c,
                              const unsigned int d,
                              const double h,
                              const std::pair<double, double> &largest)
{
  const double given = u.gradient(x, c)[d], found = difference(u, x, c, d, h);
  const double coarse = difference(u, x, c, d, 2. * h);
  const double noise = 1e-14 * largest.first / h;
  const double tolerance = 10. * noise + 1e-4 * largest.second + 1e-3 * std::abs(found);
  return {given,
          found,
          std::abs(found - coarse) < 0.1 * tolerance && !(std::abs(found - given) < tolerance)};
}
} // namespace

template <int dim>
void refuse_value(const std::string &where,
                  const std::string &found,
                  const Point<dim> &x,
                  const std::string &allowed)
{
  std::ostringstream message;
  message << where << ": found " << found << " at (" << x << "), allowed: " << allowed << ".";
  throw InputError(message.str());
}

template <int dim>
void check_exact_gradient(const ExactSolutionParameters &exact,
                          const Scene<dim> &scene,
                          const std::vector<Point<dim>> &points)
{
  if (exact.displacement_gradient.value.empty())
    return;
  const Function<dim> &u = *scene.exact_displacement;
  const std::string where = exact.displacement_gradient.where();
  const double h = 1e-5 * scene.geometry.shortest_extent();
  double max_gradient = 0.;
  for (const Point<dim> &x : points)
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double size = u.gradient(x, c).norm();
      if (!(size <= max_magnitude))
        refuse_value(where,
                     "the gradient " + number_text(size) + " of component " + std::to_string(c + 1),
                     x,
                     "values up to " + number_text(max_magnitude) + " on the whole body");
      max_gradient = std::max(max_gradient, size);
    }
  const std::pair<double, double> largest = {max_displacement(u, points), max_gradient};
  constexpr unsigned int several = 3;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
    {
      unsigned int n_objections = 0;
      for (const Point<dim> &sample : points)
      {
        const Point<dim> x = aside(sample, scene.geometry);
        const Derivative derivative = compare_derivative(u, x, c, d, h, largest);
        n_objections += derivative.differ ? 1 : 0;
        if (n_objections == several)
          refuse_value(where,
                       "du" + std::to_string(c + 1) + "/d" + "xyz"[d] + " = " +
                         number_text(derivative.given),
                       x,
                       number_text(derivative.found) + ", the derivative of " +
                         exact.displacement.name + ", or no gradient");
      }
    }
}

template <int dim>
void check_exact_on_side(const ExactSolutionParameters &exact,
                         const Scene<dim> &scene,
                         const unsigned int i,
                         const std::vector<Point<dim>> &points)
{
  if (scene.exact_displacement == nullptr)
    return;
  const Function<dim> &u = *scene.exact_displacement;
  const Side<dim> &side = scene.geometry.sides[i];
  const BoundaryCondition<dim> &condition = scene.boundary[i];
  const double size =
    std::max(max_displacement(u, points), max_displacement(u, {scene.geometry.inner_point()}));
  const double tolerance = tolerated_difference * size;
  const auto check = [&](const bool holds,
                         const double found,
                         const Point<dim> &x,
                         const std::string &name,
                         const std::string &allowed) {
    if (!holds)
      refuse_value(exact.displacement.where(),
                   name + " = " + number_text(found) + " on the side " + side.name(),
                   x,
                   allowed);
  };
  for (const Point<dim> &x : points)
  {
    const Tensor<1, dim> normal = side.normal(side.coordinates(x));
    double u_n = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      u_n += u.value(x, c) * normal[c];
    if (condition.role == Role::clamped || condition.role == Role::displacement)
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double given = condition.data == nullptr ? 0. : condition.data->value(x, c);
        check(std::abs(u.value(x, c) - given) <= tolerance + tolerated_difference * std::abs(given),
              u.value(x, c),
              x,
              "u" + std::to_string(c + 1),
              number_text(given) + ", which is prescribed there");
      }
    else if (condition.role == Role::roller)
      check(std::abs(u_n) <= tolerance, u_n, x, "u.n", "0 on rollers");
    else if (condition.role == Role::contact)
    {
      const double gap = condition.data->value(x);
      check(u_n <= gap + tolerance, u_n, x, "u.n", "at most the gap " + number_text(gap));
    }
  }
}
template void
refuse_value(const std::string &, const std::string &, const Point<2> &, const std::string &);
template void check_exact_gradient(const ExactSolutionParameters &,
                                   const Scene<2> &,
                                   const std::vector<Point<2>> &);
template void check_exact_on_side(const ExactSolutionParameters &,
                                  const Scene<2> &,
                                  unsigned int,
                                  const std::vector<Point<2>> &);
template void
refuse_value(const std::string &, const std::string &, const Point<3> &, const std::string &);
template void check_exact_gradient(const ExactSolutionParameters &,
                                   const Scene<3> &,
                                   const std::vector<Point<3>> &);
template void check_exact_on_side(const ExactSolutionParameters &,
                                  const Scene<3> &,
                                  unsigned int,
                                  const std::vector<Point<3>> &);
} // namespace Signorini
