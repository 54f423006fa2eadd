// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of one level, put together.

#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/postprocessing/quantities/answer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini {
namespace {
/** Sets the edge of growth if a maximum lies at a singular edge and stands out. */
template <int dim, typename Maximum>
void set_growth(const std::vector<SingularEdge<dim>> &edges, const BodyInContact<dim> &body,
                const AnswerVector &point, Maximum &largest) {
  // A constant stress has no singular part.
  constexpr double rounding = 1e-6;
  Point<dim> x;
  std::copy(point.begin(), point.end(), x.begin_raw());
  if (!largest.away || largest.value > (1. + rounding) * largest.away->value)
    largest.grows_at = growth_at(x, edges, body);
}

/** Returns the largest pressure, and the edge where it grows without limit. */
template <int dim>
std::optional<PeakPressure> describe_peak(const BodyInContact<dim> &body,
                                          const std::vector<SingularEdge<dim>> &edges) {
  const Pressure &P = body.P.normal();
  const std::optional<PressureMaximum> largest = peak_pressure(body.multipliers, P);
  if (!largest)
    return {};
  PeakPressure peak = {*largest, {}, {}};
  if (!edges.empty())
    peak.away = peak_pressure(body.multipliers, P, edges);
  set_growth(edges, body, largest->at.point, peak);
  return peak;
}
} // namespace

template <int dim>
std::optional<Penetration> max_penetration(const DisplacedBody<dim> &body,
                                           const ContactSurface<dim> &surface) {
  const QIterated<dim - 1> positions(QTrapezoid<1>(), dim == 2 ? 16 : 4);
  TraceValues<dim> traces(body.space);
  // A depth by its face, its value, and its position.
  using Depth = std::tuple<unsigned int, double, double, Point<dim>>;
  std::vector<Depth> largest;
  // Of equal ones, the first: rounding must not choose.
  const auto take_larger = [&largest](const Depth &next) {
    constexpr double rounding = 1e-9;
    const double before = largest.empty() ? -HUGE_VAL : std::get<1>(largest[0]);
    if (largest.empty() || std::get<1>(next) > before + rounding * std::abs(before))
      largest = {next};
  };
  for (const Piece<dim> &piece : surface.pieces()) {
    const SurfaceRule<dim> rule = surface.at(piece, positions.get_points());
    const std::vector<double> depths = PairedPiece<dim>(surface, piece).closing(body, rule, traces);
    for (std::size_t q = 0; q < rule.size(); ++q)
      take_larger({piece.face, depths[q], dim == 2 ? rule.on_side[q][0] : 0., rule.points[q]});
  }
  std::vector<Depth> all = collect(largest, surface.communicator());
  std::sort(all.begin(), all.end(),
            [](const Depth &a, const Depth &b) { return std::get<0>(a) < std::get<0>(b); });
  largest.clear();
  std::for_each(all.begin(), all.end(), take_larger);
  if (largest.empty())
    return {};
  const auto &[face, depth, s, x] = largest[0];
  return Penetration{depth, {body.scene.geometry.sides[surface.faces()[face].side].name(), s, x}};
}

/** Returns Answer::turn_of_normals, at the middles of the pieces. */
template <int dim>
double turn_of_normals(const MultiplierSpace<dim> &multipliers, const Pressure &P) {
  const ContactSurface<dim> &surface = multipliers.surface();
  double turn = 0.;
  for (const Piece<dim> &piece : surface.pieces()) {
    const SurfaceRule<dim> middle = surface.at(piece, QMidpoint<dim - 1>().get_points());
    if (multipliers.value(P, piece.patch, middle.on_side[0]) < pressing_threshold(P))
      turn = std::max(turn, PairedPiece<dim>(surface, piece).turn_of_normals(middle, 0));
  }
  return Utilities::MPI::max(turn, surface.communicator());
}

Columns<Answer> Answer::columns() {
  return {{"peak_pressure",
           [](const Answer &answer) {
             return answer.peak_pressure ? std::optional<double>(answer.peak_pressure->value)
                                         : std::nullopt;
           }},
          {"largest_von_mises", [](const Answer &answer) { return answer.von_mises.value; }}};
}

namespace {
/** Forces all around an axis have no moment, and no line of action but the axis. */
void remove_moments(Answer &answer) {
  const auto remove = [](SideForce &force) {
    force.resultant.moment = AnswerVector(Moment<2>());
    force.through.reset();
  };
  remove(answer.contact_force);
  std::for_each(answer.reactions.begin(), answer.reactions.end(), remove);
  for (std::vector<ContactForce> *const forces : {&answer.contact_by_side, &answer.zone_forces})
    std::for_each(forces->begin(), forces->end(), remove);
}
} // namespace

template <int dim>
Answer compute_answer(const BodyInContact<dim> &body, const NodalForces &forces) {
  const auto &[scene, multipliers, multiplier] = std::tie(body.scene, body.multipliers, body.P);
  Answer answer;
  answer.dimension = dim;
  answer.size = scene.geometry.diameter();
  answer.contact_by_side = contact_forces(multipliers, multiplier);
  if (!scene.contacts.empty())
    answer.contact_force = contact_force(multipliers, contacts_of_contact_force(scene), multiplier,
                                         body_of_contact_force(scene));
  answer.contact_force.side.clear();
  answer.reactions = reactions(body.space, scene, forces);
  if constexpr (dim == 2) {
    answer.zones = contact_zones(multipliers, multiplier.normal());
    answer.zone_forces = zone_forces(multipliers, multiplier, answer.zones);
  } else {
    const std::vector<PressedArea> areas = pressed_areas(multipliers, multiplier.normal());
    for (const PressedArea &area : areas)
      answer.zones.push_back(area.zone);
    answer.zone_forces = zone_forces(multipliers, multiplier, areas);
  }
  answer.axisymmetric = scene.geometry.axisymmetric;
  if (answer.axisymmetric)
    remove_moments(answer);
  const std::vector<SingularEdge<dim>> edges = singular_edges(scene);
  answer.peak_pressure = describe_peak(body, edges);
  answer.turn_of_normals = turn_of_normals(multipliers, multiplier.normal());
  answer.penetration = max_penetration(body, body.surface());
  answer.von_mises = largest_von_mises(body, edges);
  set_growth(edges, body, answer.von_mises.point, answer.von_mises);
  answer.reports = report_on_probes(body, edges);
  return answer;
}

INSTANTIATE_FUNCTION(max_penetration);
INSTANTIATE_FUNCTION(compute_answer);
} // namespace Signorini
