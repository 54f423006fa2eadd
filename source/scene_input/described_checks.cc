// SPDX-License-Identifier: LGPL-2.1-or-later
// What expressions must be worth: checked at points that the integrals will use or come close to.

#include "described_checks.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
using Points = std::vector<dealii::Point<2>>;

[[noreturn]] void refuse(const std::string &where,
                         const std::string &found,
                         const dealii::Point<2> &x,
                         const std::string &allowed)
{
  std::ostringstream message;
  message << where << ": found " << found << " at (" << x << "), allowed: " << allowed << ".";
  throw InputError(message.str());
}

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

Points sample_body(const Geometry<2> &geometry)
{
  const dealii::Point<2> inside = geometry.inner_point();
  const std::vector<double> unit = shares();
  Points points;
  for (const Side<2> &side : geometry.sides)
    for (const double s : unit)
      for (const double r : unit)
        points.push_back(inside + r * (side.point(s * side.length()) - inside));
  return points;
}

/** Inside of a side and, for what is evaluated at nodes, at its ends. */
Points sample_side(const Side<2> &side, const bool with_ends)
{
  Points points;
  for (const double s : shares())
    points.push_back(side.point(s * side.length()));
  if (with_ends)
    points.insert(points.end(), {side.start(), side.end()});
  return points;
}

/** Expression functions that are data of the problem refuse bad values themselves. */
void evaluate(const FunctionPointer<2> &data, const Points &points)
{
  if (data == nullptr)
    return;
  for (const dealii::Point<2> &x : points)
    for (unsigned int c = 0; c < data->n_components; ++c)
      data->value(x, c);
}

void check_finite(const FunctionPointer<2> &function,
                  const Points &points,
                  const std::string &where)
{
  if (function == nullptr)
    return;
  for (const dealii::Point<2> &x : points)
    for (unsigned int c = 0; c < function->n_components; ++c)
    {
      const double value = function->value(x, c);
      if (!(std::abs(value) <= largest_magnitude))
        refuse(where,
               "the value " + number_text(value) + " of component " + std::to_string(c + 1),
               x,
               "values up to " + number_text(largest_magnitude) + " on the whole body");
    }
}

/** Central differences of second order, from inside the body. */
dealii::Tensor<1, 2>
difference(const dealii::Function<2> &u, const dealii::Point<2> &x, const unsigned int c, double h)
{
  dealii::Tensor<1, 2> gradient;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const dealii::Tensor<1, 2> step = h * dealii::Point<2>::unit_vector(d);
    gradient[d] = (u.value(x + step, c) - u.value(x - step, c)) / (2. * h);
  }
  return gradient;
}

/**
 * A gradient that is given by expressions must have values, and be that of the displacement at
 * most points at least: kinks and singularities excuse a few.
 */
void check_gradient(const ExactSolutionParameters &exact,
                    const Scene<2> &scene,
                    const Points &points)
{
  if (exact.displacement_gradient.value.empty())
    return;
  const std::string where = exact.displacement_gradient.where();
  const double h = 1e-6 * scene.geometry.diameter();
  for (unsigned int c = 0; c < 2; ++c)
  {
    std::size_t n_wrong = 0;
    double largest = 0.;
    for (const dealii::Point<2> &x : points)
    {
      const dealii::Tensor<1, 2> given = scene.exact_displacement->gradient(x, c);
      if (!(given.norm() <= largest_magnitude))
        refuse(where,
               "the gradient " + number_text(given.norm()) + " of component " +
                 std::to_string(c + 1),
               x,
               "values up to " + number_text(largest_magnitude) + " on the whole body");
      largest = std::max(largest, given.norm());
      const double scale =
        std::max(std::abs(scene.exact_displacement->value(x, c)) / h * 1e-12, 1e-2 * largest);
      n_wrong += (difference(*scene.exact_displacement, x, c, h) - given).norm() > scale ? 1 : 0;
    }
    if (2 * n_wrong > points.size())
      throw InputError(where + ": component " + std::to_string(c + 1) + " is not the gradient of " +
                       exact.displacement.name +
                       ", allowed: du1/dx; du1/dy; du2/dx; du2/dy, or nothing.");
  }
}

/** Contact cannot pull. */
void check_pressure(const FunctionPointer<2> &pressure,
                    const Points &points,
                    const std::string &where)
{
  if (pressure == nullptr)
    return;
  check_finite(pressure, points, where);
  double largest = 0.;
  for (const dealii::Point<2> &x : points)
    largest = std::max(largest, std::abs(pressure->value(x)));
  for (const dealii::Point<2> &x : points)
    if (pressure->value(x) > 1e-6 * largest)
      refuse(where,
             "the tension " + number_text(pressure->value(x)),
             x,
             "p = sigma_n <= 0, negative in compression");
}
} // namespace

void check_moduli(const std::vector<Expression<2>> &moduli, const Geometry<2> &geometry)
{
  for (const dealii::Point<2> &x : sample_body(geometry))
  {
    double largest = 0.;
    for (const Expression<2> &modulus : moduli)
      largest = std::max(largest, std::abs(modulus(x)));
    // Signs and what is no number are the business of the material.
    if (largest > largest_magnitude || (largest > 0. && largest < smallest_magnitude))
      refuse(moduli[0].where(),
             number_text(largest),
             x,
             "moduli from " + number_text(smallest_magnitude) + " to " +
               number_text(largest_magnitude) + "; take other units");
  }
}

void check_described_scene(const ExactSolutionParameters &exact, const Scene<2> &scene)
{
  const Points body = sample_body(scene.geometry);
  for (const dealii::Point<2> &x : body)
    scene.material->hooke(x);
  evaluate(scene.body_force, body);
  check_finite(scene.exact_displacement, body, exact.displacement.where());
  check_gradient(exact, scene, body);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const BoundaryCondition<2> &condition = scene.boundary[i];
    const Side<2> &side = scene.geometry.sides[i];
    evaluate(condition.data, sample_side(side, condition.role != Role::traction));
    check_pressure(condition.exact_pressure, sample_side(side, false), exact.pressure.where());
  }
}
} // namespace Signorini
