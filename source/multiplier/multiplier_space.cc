// SPDX-License-Identifier: LGPL-2.1-or-later
// Q^H, and G of (22).

#include <signorini/base/exceptions.h>
#include <signorini/multiplier/multiplier_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** The Gauss points of every number from 1 on, between 0 and 1, with their weights. */
const dealii::QGauss<1> &gauss_rule(const unsigned int n_points)
{
  static const std::vector<dealii::QGauss<1>> rules = []() {
    constexpr unsigned int most = 24;
    std::vector<dealii::QGauss<1>> all;
    for (unsigned int n = 1; n <= most; ++n)
      all.emplace_back(n);
    return all;
  }();
  return rules.at(n_points - 1);
}

/** Where a point of the side lies on a patch, between 0 and 1. */
template <int dim>
double position(const Patch<dim> &patch, const dealii::Point<dim - 1> &s)
{
  return (s[0] - patch.lower[0]) / (patch.upper[0] - patch.lower[0]);
}
} // namespace

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface)
  : MultiplierSpace(surface, std::vector<unsigned int>(surface.patches().size(), 1))
{
}

template <int dim>
MultiplierSpace<dim>::MultiplierSpace(const ContactSurface<dim> &surface,
                                      const std::vector<unsigned int> &n_unknowns)
  : surface_(surface)
  , first_({0})
{
  AssertDimension(n_unknowns.size(), surface.patches().size());
  for (unsigned int patch = 0; patch < n_unknowns.size(); ++patch)
  {
    Assert(dim == 2 || n_unknowns[patch] == 1, dealii::ExcNotImplemented());
    patch_of_.insert(patch_of_.end(), n_unknowns[patch], patch);
    first_.push_back(patch_of_.size());
  }
}

template <int dim>
unsigned int MultiplierSpace<dim>::largest_degree() const
{
  unsigned int largest = 0;
  for (unsigned int patch = 0; patch + 1 < first_.size(); ++patch)
    largest = std::max(largest, n_of(patch) - 1);
  return largest;
}

template <int dim>
dealii::Point<dim - 1> MultiplierSpace<dim>::node(const unsigned int unknown) const
{
  const Patch<dim> &patch = surface_.patches()[patch_of(unknown)];
  const unsigned int n = n_of(patch_of(unknown));
  if (n == 1)
    return patch.centre();
  const double t = gauss_rule(n).point(unknown - first_of(patch_of(unknown)))[0];
  return patch.lower + t * (patch.upper - patch.lower);
}

template <int dim>
double MultiplierSpace<dim>::shape_value(const unsigned int unknown,
                                         const dealii::Point<dim - 1> &s) const
{
  const unsigned int patch = patch_of(unknown), n = n_of(patch);
  if (n == 1)
    return 1.;
  const auto &nodes = gauss_rule(n).get_points();
  const unsigned int i = unknown - first_of(patch);
  const double t = position(surface_.patches()[patch], s);
  double value = 1.;
  for (unsigned int j = 0; j < n; ++j)
    if (j != i)
      value *= (t - nodes[j][0]) / (nodes[i][0] - nodes[j][0]);
  return value;
}

template <int dim>
double MultiplierSpace<dim>::value(const Vector &P,
                                   const unsigned int patch,
                                   const dealii::Point<dim - 1> &s) const
{
  double p = 0.;
  for (unsigned int k = first_of(patch); k < first_of(patch + 1); ++k)
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
  {
    const unsigned int patch = patch_of(k);
    integrals[k] =
      surface_.patches()[patch].measure * gauss_rule(n_of(patch)).weight(k - first_of(patch));
  }
  return integrals;
}

template <int dim>
dealii::Vector<double> MultiplierSpace<dim>::project(const Vector &moments) const
{
  // int psi_j psi_k = delta_jk int psi_k: Gauss' rule integrates the product exactly.
  Vector coefficients = moments;
  const Vector squares = integrals();
  for (unsigned int k = 0; k < n_multipliers(); ++k)
    coefficients[k] /= squares[k];
  return coefficients;
}

template <int dim>
dealii::Vector<double> assemble_gap(const MultiplierSpace<dim> &space,
                                    const unsigned int n_points,
                                    const Grading grading)
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
  return integrate_against_multipliers(space, n_points, grading, gap_on);
}

template class MultiplierSpace<2>;
template class MultiplierSpace<3>;
template dealii::Vector<double> assemble_gap(const MultiplierSpace<2> &, unsigned int, Grading);
template dealii::Vector<double> assemble_gap(const MultiplierSpace<3> &, unsigned int, Grading);
} // namespace Signorini
