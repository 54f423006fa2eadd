// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand side of (14) and (33).

#include <signorini/base/exceptions.h>
#include <signorini/errors/pressure_errors.h>
#include <signorini/postprocess/contact_pressure.h>

#include <cmath>

namespace Signorini
{
template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space,
                                       const dealii::Vector<double> &P,
                                       const unsigned int n_points)
{
  const RecoveredPressure<dim> recovered(space, P);
  double l2 = 0.;
  double post_l2 = 0.;
  std::vector<double> p;
  for (const Piece<dim> &piece : space.surface().pieces())
  {
    const SurfaceRule<dim> rule = space.surface().rule(
      piece, n_points + space.unknowns_on(piece.patch).size() - 1, Grading::towards_kinks);
    p.resize(rule.size());
    space.surface().condition(piece).exact_pressure->value_list(rule.points, p);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double difference = p[q] - space.value(P, piece.patch, rule.on_side[q]);
      const double post = p[q] - recovered(piece.patch, rule.on_side[q]);
      l2 += difference * difference * rule.weights[q];
      post_l2 += post * post * rule.weights[q];
    }
  }
  if (!std::isfinite(l2))
    throw InputError(
      "the exact pressure has no finite value at a quadrature point, allowed: finite "
      "values inside the contact sides.");
  return {std::sqrt(l2), std::sqrt(post_l2)};
}

Columns<PressureErrors> PressureErrors::columns()
{
  return {{"p_l2", &PressureErrors::l2}, {"p_post_l2", &PressureErrors::post_l2}};
}

template PressureErrors compute_pressure_errors(const MultiplierSpace<2> &,
                                                const dealii::Vector<double> &,
                                                unsigned int);
template PressureErrors compute_pressure_errors(const MultiplierSpace<3> &,
                                                const dealii::Vector<double> &,
                                                unsigned int);
} // namespace Signorini
