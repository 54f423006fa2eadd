// SPDX-License-Identifier: LGPL-2.1-or-later
// What expressions must be worth: checked at points that the integrals will use or come close to.

#include "described_checks.h"

#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>

#include "exact_checks.h"

namespace Signorini
{
namespace
{
template <int dim>
using Points = std::vector<dealii::Point<dim>>;

/** Shares of the unit interval: Gauss points, and points close to its ends. */
std::vector<double> shares()
{
  std::vector<double> values = {1e-4, 1e-3, 1. - 1e-3, 1. - 1e-4};
  const dealii::QGauss<1> gauss(13);
  for (const dealii::Point<1> &q : gauss.get_points())
    values.push_back(q[0]);
  std::sort(values.begin(), values.end());
  return values;
}

/** Points of the cells of the coarse mesh; of every cell, or of some of very many. */
Points<2> sample_cells(const Geometry<2> &geometry)
{
  constexpr unsigned int enough = 500;
  dealii::Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  const unsigned int stride = 1 + mesh.n_active_cells() / enough;
  const dealii::MappingQ1<2> mapping;
  const double close = 1e-3;
  Points<2> points;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->active_cell_index() % stride == 0)
      for (const double r : {close, 0.3, 0.7, 1. - close})
        for (const double s : {close, 0.3, 0.7, 1. - close})
          points.push_back(mapping.transform_unit_to_real_cell(cell, dealii::Point<2>(r, s)));
  return points;
}

Points<2> sample_body(const Geometry<2> &geometry)
{
  if (!geometry.star_shaped)
    return sample_cells(geometry);
  const dealii::Point<2> inside = geometry.inner_point();
  const std::vector<double> unit = shares();
  Points<2> points;
  for (const Side<2> &side : geometry.sides)
    for (const double s : unit)
      for (const double r : unit)
        points.push_back(inside + r * (side.point(s * side.length()) - inside));
  return points;
}

/** A box. */
Points<3> sample_body(const Geometry<3> &geometry)
{
  const dealii::Tensor<1, 3> extent = geometry.upper - geometry.lower;
  const std::vector<double> unit = {1e-4, 0.05, 0.2, 0.37, 0.5, 0.63, 0.8, 0.95, 1. - 1e-4};
  Points<3> points;
  for (const double r : unit)
    for (const double s : unit)
      for (const double t : unit)
        points.push_back(geometry.lower +
                         dealii::Tensor<1, 3>({r * extent[0], s * extent[1], t * extent[2]}));
  return points;
}

/** Inside of a side and, for what is evaluated at nodes, at its ends. */
Points<2> sample_side(const Side<2> &side, const bool with_ends)
{
  // A side of very many pieces has short ones: their middles tell enough.
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

/** Expression functions that are data of the problem refuse bad values themselves. */
template <int dim>
void evaluate(const FunctionPointer<dim> &data, const Points<dim> &points)
{
  if (data == nullptr)
    return;
  for (const dealii::Point<dim> &x : points)
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
  for (const dealii::Point<dim> &x : points)
    for (unsigned int c = 0; c < function->n_components; ++c)
    {
      const double value = function->value(x, c);
      if (!(std::abs(value) <= largest_magnitude))
        refuse_value(where,
                     "the value " + number_text(value) + " of component " + std::to_string(c + 1),
                     x,
                     "values up to " + number_text(largest_magnitude) + " on the whole body");
    }
}

/** Contact cannot pull. */
template <int dim>
void check_pressure(const FunctionPointer<dim> &pressure,
                    const Points<dim> &points,
                    const std::string &where)
{
  if (pressure == nullptr)
    return;
  check_finite(pressure, points, where);
  double largest = 0.;
  for (const dealii::Point<dim> &x : points)
    largest = std::max(largest, std::abs(pressure->value(x)));
  for (const dealii::Point<dim> &x : points)
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
  for (const dealii::Point<dim> &x : sample_body(geometry))
  {
    double largest = 0.;
    for (const Expression<dim> &modulus : moduli)
      largest = std::max(largest, std::abs(modulus(x)));
    // Signs and what is no number are the business of the material.
    if (largest > largest_magnitude || (largest > 0. && largest < smallest_magnitude))
      refuse_value(moduli[0].where(),
                   number_text(largest),
                   x,
                   "moduli from " + number_text(smallest_magnitude) + " to " +
                     number_text(largest_magnitude) + "; take other units");
  }
}

template <int dim>
void check_described_scene(const ExactSolutionParameters &exact, const Scene<dim> &scene)
{
  const Points<dim> body = sample_body(scene.geometry);
  for (const dealii::Point<dim> &x : body)
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
} // namespace Signorini
