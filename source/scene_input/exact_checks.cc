// SPDX-License-Identifier: LGPL-2.1-or-later
// An exact solution that contradicts the scene, or itself.

#include "exact_checks.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** Of the largest displacement: what may be a constant with few digits. */
constexpr double tolerated_difference = 1e-4;

/** (u_c(x + h e_d) - u_c(x - h e_d)) / 2h. */
template <int dim>
double difference(const dealii::Function<dim> &u,
                  const dealii::Point<dim> &x,
                  const unsigned int c,
                  const unsigned int d,
                  const double h)
{
  const dealii::Tensor<1, dim> step = h * dealii::Point<dim>::unit_vector(d);
  return (u.value(x + step, c) - u.value(x - step, c)) / (2. * h);
}

/** Points on lines of symmetry are where kinks are; these are a little aside. */
template <int dim>
dealii::Point<dim> aside(const dealii::Point<dim> &x, const Geometry<dim> &geometry)
{
  const dealii::Tensor<1, dim> to_inside = geometry.inner_point() - x;
  const double h = geometry.shortest_extent();
  dealii::Tensor<1, dim> offset;
  for (unsigned int d = 0; d < dim; ++d)
    offset[d] = std::array<double, 3>{1.37e-5, 0.73e-5, 0.91e-5}[d];
  return x + 1e-4 * to_inside + h * offset;
}

template <int dim>
double largest_displacement(const dealii::Function<dim> &u,
                            const std::vector<dealii::Point<dim>> &points)
{
  double largest = 0.;
  for (const dealii::Point<dim> &x : points)
    for (unsigned int c = 0; c < dim; ++c)
      largest = std::max(largest, std::abs(u.value(x, c)));
  return largest;
}

/** What a derivative of the displacement is and what is given for it, at a point. */
struct Derivative
{
  double given, found;
  /** Whether it is certain that they are different. */
  bool differ;
};

/** @param largest |u| and |grad u|, for what counts as zero. */
template <int dim>
Derivative compare_derivative(const dealii::Function<dim> &u,
                              const dealii::Point<dim> &x,
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
                  const dealii::Point<dim> &x,
                  const std::string &allowed)
{
  std::ostringstream message;
  message << where << ": found " << found << " at (" << x << "), allowed: " << allowed << ".";
  throw InputError(message.str());
}

template <int dim>
void check_exact_gradient(const ExactSolutionParameters &exact,
                          const Scene<dim> &scene,
                          const std::vector<dealii::Point<dim>> &points)
{
  if (exact.displacement_gradient.value.empty())
    return;
  const dealii::Function<dim> &u = *scene.exact_displacement;
  const std::string where = exact.displacement_gradient.where();
  const double h = 1e-5 * scene.geometry.shortest_extent();
  double largest_gradient = 0.;
  for (const dealii::Point<dim> &x : points)
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double size = u.gradient(x, c).norm();
      if (!(size <= largest_magnitude))
        refuse_value(where,
                     "the gradient " + number_text(size) + " of component " + std::to_string(c + 1),
                     x,
                     "values up to " + number_text(largest_magnitude) + " on the whole body");
      largest_gradient = std::max(largest_gradient, size);
    }
  const std::pair<double, double> largest = {largest_displacement(u, points), largest_gradient};
  constexpr unsigned int several = 3;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
    {
      unsigned int n_objections = 0;
      for (const dealii::Point<dim> &sample : points)
      {
        const dealii::Point<dim> x = aside(sample, scene.geometry);
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
                         const std::vector<dealii::Point<dim>> &points)
{
  if (scene.exact_displacement == nullptr)
    return;
  const dealii::Function<dim> &u = *scene.exact_displacement;
  const Side<dim> &side = scene.geometry.sides[i];
  const BoundaryCondition<dim> &condition = scene.boundary[i];
  const double size = std::max(largest_displacement(u, points),
                               largest_displacement(u, {scene.geometry.inner_point()}));
  const double tolerance = tolerated_difference * size;
  const auto check = [&](const bool holds,
                         const double found,
                         const dealii::Point<dim> &x,
                         const std::string &name,
                         const std::string &allowed) {
    if (!holds)
      refuse_value(exact.displacement.where(),
                   name + " = " + number_text(found) + " on the side " + side.name(),
                   x,
                   allowed);
  };
  for (const dealii::Point<dim> &x : points)
  {
    const dealii::Tensor<1, dim> normal = side.normal(side.coordinates(x));
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
template void refuse_value(const std::string &,
                           const std::string &,
                           const dealii::Point<2> &,
                           const std::string &);
template void check_exact_gradient(const ExactSolutionParameters &,
                                   const Scene<2> &,
                                   const std::vector<dealii::Point<2>> &);
template void check_exact_on_side(const ExactSolutionParameters &,
                                  const Scene<2> &,
                                  unsigned int,
                                  const std::vector<dealii::Point<2>> &);
template void refuse_value(const std::string &,
                           const std::string &,
                           const dealii::Point<3> &,
                           const std::string &);
template void check_exact_gradient(const ExactSolutionParameters &,
                                   const Scene<3> &,
                                   const std::vector<dealii::Point<3>> &);
template void check_exact_on_side(const ExactSolutionParameters &,
                                  const Scene<3> &,
                                  unsigned int,
                                  const std::vector<dealii::Point<3>> &);
} // namespace Signorini
