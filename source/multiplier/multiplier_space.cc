// SPDX-License-Identifier: LGPL-2.1-or-later
// Q^H, and G of (22).

#include <signorini/base/exceptions.h>
#include <signorini/multiplier/multiplier_space.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface)
  : surface_(surface)
{
}

template <int dim>
double MultiplierSpace<dim>::shape_value(const unsigned int /*unknown*/,
                                         const dealii::Point<dim - 1> & /*s*/) const
{
  return 1.;
}

template <int dim>
double MultiplierSpace<dim>::value(const Vector &P,
                                   const unsigned int patch,
                                   const dealii::Point<dim - 1> &s) const
{
  double p = 0.;
  for (unsigned int k = first_of(patch); k < first_of(patch) + n_per_patch; ++k)
    p += P[k] * shape_value(k, s);
  return p;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::upper_bounds() const
{
  return Vector(n_multipliers());
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::integrals() const
{
  Vector integrals(n_multipliers());
  for (unsigned int k = 0; k < n_multipliers(); ++k)
    integrals[k] = surface_.patches()[patch_of(k)].measure;
  return integrals;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::project(const Vector &moments) const
{
  Vector means = moments;
  const Vector measures = integrals();
  for (unsigned int k = 0; k < n_multipliers(); ++k)
    means[k] /= measures[k];
  return means;
}

template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space, const unsigned int n_points)
{
  const auto gap_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
    std::vector<double> g(rule.size());
    space.surface().condition(piece).data->value_list(rule.points, g);
    for (std::size_t q = 0; q < rule.size(); ++q)
      if (!std::isfinite(g[q]))
      {
        std::ostringstream message;
        message << "the gap has the value " << g[q] << " at (" << rule.points[q]
                << "), allowed: finite values on the whole side.";
        throw InputError(message.str());
      }
    return g;
  };
  // g contains u_n, which may have a fractional power at an end of contact.
  return integrate_against_multipliers(space, n_points, Grading::towards_kinks, gap_on);
}

template class MultiplierSpace<2>;
template class MultiplierSpace<3>;
template dealii::Vector<double> assemble_gap(const MultiplierSpace<2> &, unsigned int);
template dealii::Vector<double> assemble_gap(const MultiplierSpace<3> &, unsigned int);
} // namespace Signorini
