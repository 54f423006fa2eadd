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
  for (const Piece &piece : space.partition().pieces)
  {
    const auto &condition = space.condition(space.partition().patches[piece.patch]);
    const auto rule = space.rule(piece, n_points, true);
    p.resize(rule.points.size());
    condition.exact_pressure->value_list(rule.points, p);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
    {
      const double difference = p[q] - P[piece.patch];
      const double post = p[q] - recovered(piece.patch, rule.arc_lengths[q]);
      l2 += difference * difference * rule.weights[q];
      post_l2 += post * post * rule.weights[q];
    }
  }
  if (!std::isfinite(l2))
    throw InputError("Exact solution/Pressure: it has no finite value at a quadrature point, "
                     "allowed: finite values inside the contact sides.");
  return {std::sqrt(l2), std::sqrt(post_l2)};
}

Columns<PressureErrors> PressureErrors::columns()
{
  return {{"p_l2", &PressureErrors::l2}, {"p_post_l2", &PressureErrors::post_l2}};
}

template PressureErrors compute_pressure_errors(const MultiplierSpace<2> &,
                                                const dealii::Vector<double> &,
                                                unsigned int);
} // namespace Signorini
