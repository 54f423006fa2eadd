// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of one level, put together.

#include <signorini/answer/answer.h>
#include <signorini/elasticity/trace_values.h>

namespace Signorini
{
namespace
{
/** The sum of the forces. Its line of action is given by the point nearest to the mean of theirs.
 */
SideForce total_force(const std::vector<SideForce> &parts)
{
  SideForce total;
  double sizes = 0.;
  dealii::Tensor<1, 2> centre;
  for (const SideForce &part : parts)
  {
    total.resultant += part.resultant;
    if (part.through)
    {
      const double size = part.resultant.force.norm();
      sizes += size;
      centre += size * *part.through;
    }
  }
  if (sizes > 0.)
    total.through = point_of_action(total.resultant, dealii::Point<2>(centre / sizes), sizes);
  return total;
}
} // namespace

std::optional<Penetration> largest_penetration(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const NodalVector &U)
{
  constexpr unsigned int n_intervals = 16;
  std::vector<dealii::Point<1>> positions;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    positions.emplace_back(static_cast<double>(i) / n_intervals);
  const ContactSurface<2> &surface = multipliers.surface();
  TraceValues<2> traces(space);
  std::optional<Penetration> largest;
  for (const Piece<2> &piece : surface.pieces())
  {
    const SurfaceRule<2> rule = surface.at(piece, positions);
    const std::vector<double> u_n =
      traces.normal_displacement(surface.faces()[piece.face], rule, U);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double depth = u_n[q] - surface.condition(piece).data->value(rule.points[q]);
      if (!largest || depth > largest->value)
        largest = {depth,
                   {surface.side(surface.patches()[piece.patch]).name(),
                    rule.on_side[q][0],
                    rule.points[q]}};
    }
  }
  return largest;
}

Columns<Answer> Answer::columns()
{
  return {{"peak_pressure",
           [](const Answer &answer) {
             return answer.peak_pressure ? std::optional<double>(answer.peak_pressure->value)
                                         : std::nullopt;
           }},
          {"largest_von_mises", [](const Answer &answer) { return answer.von_mises.value; }}};
}

Answer compute_answer(const DisplacementSpace<2> &space,
                      const Scene<2> &scene,
                      const MultiplierSpace<2> &multipliers,
                      const NodalForces &forces,
                      const NodalVector &U,
                      const dealii::Vector<double> &P)
{
  Answer answer;
  answer.size = scene.geometry.diameter();
  answer.contact_by_side = contact_forces(multipliers, scene, P);
  answer.contact_force = total_force(answer.contact_by_side);
  answer.reactions = reactions(space, scene, forces);
  answer.peak_pressure = peak_pressure(multipliers, P);
  answer.zones = contact_zones(multipliers, P);
  answer.penetration = largest_penetration(space, multipliers, U);
  answer.von_mises = largest_von_mises(space, scene, U);
  return answer;
}
} // namespace Signorini
