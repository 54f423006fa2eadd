// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of one level, put together.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/quantities/answer.h>

#include <type_traits>

namespace Signorini
{
namespace
{
template <int dim>
Tensor<1, dim> to_tensor(const AnswerVector &x)
{
  Tensor<1, dim> tensor;
  for (unsigned int d = 0; d < dim; ++d)
    tensor[d] = x[d];
  return tensor;
}

/** Sets the place of growth if a maximum lies at a singular place and stands out. */
template <int dim, typename Maximum>
void set_growth(const std::vector<SingularPlace<dim>> &places,
                const MultiplierSpace<dim> &multipliers,
                const Pressure &P,
                const AnswerVector &point,
                Maximum &largest)
{
  // A constant stress has no singular part.
  constexpr double rounding = 1e-6;
  if (!largest.away || largest.value > (1. + rounding) * largest.away->value)
    largest.grows_at = growth_at(Point<dim>(to_tensor<dim>(point)), places, multipliers, P);
}

/** Returns the sum of the forces. Its line of action is given by the point nearest to the mean of
 * theirs. */
template <int dim>
SideForce total_force(const std::vector<SideForce> &parts)
{
  Resultant<dim> sum;
  double sizes = 0.;
  Tensor<1, dim> centre;
  for (const SideForce &part : parts)
  {
    const Tensor<1, dim> force = to_tensor<dim>(part.resultant.force);
    sum.force += force;
    sum.moment += to_tensor<Moment<dim>::dimension>(part.resultant.moment);
    if (part.through)
    {
      const double size = force.norm();
      sizes += size;
      centre += size * to_tensor<dim>(*part.through);
    }
  }
  SideForce total = {{}, {sum.force, sum.moment}, {}};
  if (sizes > 0.)
    total.through = point_of_action(sum, Point<dim>(centre / sizes), sizes);
  return total;
}

/** Returns the largest pressure, and the place where it grows without limit. */
template <int dim>
std::optional<PeakPressure> describe_peak(const MultiplierSpace<dim> &multipliers,
                                          const Pressure &P,
                                          const std::vector<SingularPlace<dim>> &places)
{
  const std::optional<PressureMaximum> largest = peak_pressure(multipliers, P);
  if (!largest)
    return {};
  PeakPressure peak = {*largest, {}, {}};
  if (!places.empty())
    peak.away = peak_pressure(multipliers, P, places);
  set_growth(places, multipliers, P, largest->place.point, peak);
  return peak;
}

/** Returns positions between 0 and 1 on a piece. */
std::vector<Point<1>> sample_positions(std::integral_constant<int, 2> /*dim*/)
{
  constexpr unsigned int n_intervals = 16;
  std::vector<Point<1>> positions;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    positions.emplace_back(static_cast<double>(i) / n_intervals);
  return positions;
}
std::vector<Point<2>> sample_positions(std::integral_constant<int, 3> /*dim*/)
{
  constexpr unsigned int n_intervals = 4;
  std::vector<Point<2>> positions;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    for (unsigned int j = 0; j <= n_intervals; ++j)
      positions.emplace_back(static_cast<double>(i) / n_intervals,
                             static_cast<double>(j) / n_intervals);
  return positions;
}
} // namespace

template <int dim>
std::optional<Penetration> max_penetration(const DisplacementSpace<dim> &space,
                                           const MultiplierSpace<dim> &multipliers,
                                           const Displacement &U)
{
  const auto positions = sample_positions(std::integral_constant<int, dim>());
  const ContactSurface<dim> &surface = multipliers.surface();
  TraceValues<dim> traces(space);
  std::optional<Penetration> largest;
  for (const Piece<dim> &piece : surface.pieces())
  {
    const SurfaceRule<dim> rule = surface.at(piece, positions);
    const std::vector<double> u_n =
      traces.normal_displacement(surface.faces()[piece.face], rule, U);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double depth = u_n[q] - surface.condition(piece).data->value(rule.points[q]);
      if (!largest || depth > largest->value)
        largest = {depth,
                   {surface.side(surface.patches()[piece.patch]).name(),
                    dim == 2 ? rule.on_side[q][0] : 0.,
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

template <int dim>
Answer compute_answer(const DisplacementSpace<dim> &space,
                      const Scene<dim> &scene,
                      const MultiplierSpace<dim> &multipliers,
                      const NodalForces &forces,
                      const Displacement &U,
                      const Pressure &P)
{
  Answer answer;
  answer.dimension = dim;
  answer.size = scene.geometry.diameter();
  answer.contact_by_side = contact_forces(multipliers, scene, P);
  answer.contact_force = total_force<dim>(answer.contact_by_side);
  answer.reactions = reactions(space, scene, forces);
  const std::vector<SingularPlace<dim>> places = singular_places(scene);
  answer.peak_pressure = describe_peak(multipliers, P, places);
  if constexpr (dim == 2)
    answer.zones = contact_zones(multipliers, P);
  answer.penetration = max_penetration(space, multipliers, U);
  answer.von_mises = largest_von_mises(space, scene, U, places);
  set_growth(places, multipliers, P, answer.von_mises.point, answer.von_mises);
  return answer;
}

template std::optional<Penetration> max_penetration(const DisplacementSpace<2> &,
                                                    const MultiplierSpace<2> &,
                                                    const Displacement &);
template Answer compute_answer(const DisplacementSpace<2> &,
                               const Scene<2> &,
                               const MultiplierSpace<2> &,
                               const NodalForces &,
                               const Displacement &,
                               const Pressure &);
template std::optional<Penetration> max_penetration(const DisplacementSpace<3> &,
                                                    const MultiplierSpace<3> &,
                                                    const Displacement &);
template Answer compute_answer(const DisplacementSpace<3> &,
                               const Scene<3> &,
                               const MultiplierSpace<3> &,
                               const NodalForces &,
                               const Displacement &,
                               const Pressure &);
} // namespace Signorini
