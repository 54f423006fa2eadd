// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound of the energy error, summed up from stress and contact.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/reference/hidden_load.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace Signorini {
namespace {
/** Returns the name of the cell with the largest part, such as "the cell at (0.5, 0.25)". */
std::string name_of_worst_cell(const StressBound &bound, const DisplacementSpace<2> &space) {
  std::size_t worst = 0;
  const auto part = [&](const std::size_t cell) {
    return bound.misfit[cell] + bound.oscillation[cell];
  };
  for (std::size_t cell = 1; cell < bound.misfit.size(); ++cell)
    if (part(cell) > part(worst))
      worst = cell;
  std::size_t number = 0;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (number++ == worst) {
      std::ostringstream name;
      name << "the cell at (" << cell->center()[0] << ", " << cell->center()[1] << ")";
      return name.str();
    }
  return "";
}

/** Returns the roots of numbers that are not negative, up to rounding. */
template <typename Numbers>
std::vector<double> roots(const Numbers &squares) {
  std::vector<double> result;
  result.reserve(squares.size());
  for (const double square : squares)
    result.push_back(std::sqrt(std::max(0., square)));
  return result;
}

double ratio(const double value, const double scale) {
  if (value == 0.)
    return 0.;
  return scale > 0. ? value / scale : std::numeric_limits<double>::infinity();
}

double total(const double stress_square, const double lift, const ContactBound &contact) {
  return lift + std::sqrt(stress_square + std::max(0., contact.square()));
}

/** Adds the bracket of the energy and the bound of the force.
 * @param J_star bounds of J*(τ). @param stress_error that of ‖σ(u) - τ‖.
 * @param change ∫ (τ_n - p_H) over Γ_c. */
void add_consequences(const BoundData &data, const Bracket &J_star, const StressBound &stress,
                      const ContactLift &lift, const double stress_error, const double change,
                      ErrorBound &result) {
  const Bracket energy = energy_bracket(
    J_star, std::sqrt(stress.square), std::sqrt(lift.bound->lift_energy), lift.bound->contact_term);
  result.energy_lower = energy.lower - data.energies.plates;
  result.energy_upper = energy.upper - data.energies.plates;
  // The contact force is that of one pair.
  if (data.scene.has_pairs() && data.scene.contacts.size() > 1)
    return;
  if (const auto unit_lift = norm_of_unit_lift(data, lift.trace))
    result.force_error = contact_force_bound(stress_error, *unit_lift) + std::abs(change);
}

/** Adds the results that need an exact stress: the bracket of the energy, the bound of the contact
 * force, and the reference. */
void add_guaranteed(const BoundData &data, const BestStress &best, const ContactLift &lift,
                    const double scale, const bool keeps_stress, LocatedBound &located) {
  ErrorBound &result = located.bound;
  if (!result.only_estimated.empty())
    return;
  const auto &[stress, stress_data] = best;
  const auto &J = stress_data.complementary_energy;
  // The work of the hidden load on u - u_h is that on a field as large as the error's share of u_h.
  const HiddenLoad load(data.scene);
  const double work = lift.trace.work_of_penetration(),
               hidden_work = load.work(data.space, data.U) +
                             load.force() * data.U.linfty_norm() * result.relative.value_or(1.),
               margin = hidden_work + 2e-13 * scale * scale; // and rounding
  const Bracket J_star =
    J ? Bracket{J->lower + work - margin, J->upper + work + margin} : Bracket{0., 0.};
  const double stress_error = stress_error_bound(
    std::sqrt(stress_data.square), std::sqrt(lift.bound->lift_energy), lift.bound->contact_term);
  if (keeps_stress && data.space.mesh().is_graded())
    located.reference = make_reference(data, best, stress_error);
  // With Coulomb's law the stress is compared with that of another solution.
  if (result.is_conditional)
    return;
  const double change =
    stress.contact_force(data.scene) - data.P.normal() * data.multipliers.integrals();
  add_consequences(data, J_star, stress_data, lift, stress_error, change, result);
  constexpr double most_hidden = 0.01;
  if (!J || hidden_work > most_hidden * std::abs(J->upper))
    result.energy_lower = result.energy_upper = {};
  if (auto &reference = located.reference) {
    if (result.energy_lower && result.energy_upper)
      reference->J = Bracket{*result.energy_lower, *result.energy_upper};
    if (result.force_error)
      reference->contact_force =
        WithMargin{stress.contact_force(data.scene), *result.force_error - std::abs(change)};
  }
}

/** Returns the sentence for a bound that would not hold; empty for others. */
std::string doubt(const StressBound &stress, const ContactLift &lift) {
  if (stress.lift_misfit > 0.02)
    return "the prescribed displacements jump, or vary too fast within the edge of a cell";
  if (lift.bound && !(std::isfinite(stress.square) && std::isfinite(lift.bound->square())))
    return "the sums of the bound are no finite numbers";
  return lift.no_bound;
}

/** Returns whether the lifted traction of an edge is the given one between the points of a lift, in
 * the middles of the parts into which breaks divide the edge. */
bool is_resolved(const Scene<2> &scene, const TractionEdge &edge) {
  constexpr unsigned int n = 12;
  constexpr double allowed = 1e-8;
  const Side<2> on("", edge.line);
  if (scene.kinks.crossings(on, 0., edge.length()).size() > 2)
    return false;
  const std::vector<double> cuts = scene.kinks.cut(on, 0., edge.length());
  double largest = 0., size = 0.;
  for (unsigned int c = 0; c < 2; ++c) {
    const auto t = [&](const double position) {
      return scene.boundary[edge.side].data->value(edge.point(position), c);
    };
    const std::vector<double> coefficients = legendre_projection(n - 1, QGauss<1>(n), t);
    for (const double coefficient : coefficients)
      size = std::max(size, std::abs(coefficient));
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double position = 0.5 * (cuts[i] + cuts[i + 1]) / edge.length();
      const std::vector<double> L = legendre_values(n - 1, position);
      largest = std::max(largest, std::abs(std::inner_product(L.begin(), L.end(),
                                                              coefficients.begin(), -t(position))));
    }
  }
  return largest <= allowed * size;
}

/** Returns the part of a curved body that the proof of the bound does not cover, one sentence;
 * empty if there is none. */
std::string gap_of_proof(const BoundData &data, const BestStress &best) {
  const Scene<2> &scene = data.scene;
  if (const std::string gap = gap_on_all_meshes(data); !gap.empty())
    return gap;
  if (!data.space.mesh().is_curved())
    return "";
  for (const TractionEdge &edge : best.stress.tractions.space.edges())
    if (!edge.line.is_flat() && scene.boundary[edge.side].role == Role::traction &&
        !is_resolved(scene, edge))
      return "the traction on a curved side jumps or varies fast";
  for (const auto &cell : data.space.mesh().triangulation().active_cell_iterators())
    if (varies_fast(scene.law_kinks, cell))
      return "the material jumps or varies fast in a curved body";
  return "";
}

/** Sums up a bound from the stress. */
LocatedBound sum_up(const BoundData &data, const BestStress &best, const bool keeps_stress) {
  LocatedBound located;
  ErrorBound &result = located.bound;
  const StressBound &stress_data = best.bound;
  const ContactLift lift(data, best.stress.face_tractions(data.multipliers.surface()));
  result.penetration = lift.trace.max_penetration();
  result.place_of_penetration = name_of(lift.trace.point_of_largest(), data.scene);
  result.missing = doubt(stress_data, lift);
  result.only_estimated = gap_of_proof(data, best);
  // On graded meshes the estimate has been compared with other steps.
  if (result.missing.empty() && data.space.mesh().is_graded())
    result.missing = result.only_estimated;
  if (!result.missing.empty())
    return located;
  const ContactBound &contact = *lift.bound;
  result.oscillation = std::sqrt(stress_data.oscillation_square) + stress_data.lift;
  result.mesh =
    std::max(0., std::sqrt(stress_data.square) - std::sqrt(stress_data.oscillation_square));
  result.contact = std::sqrt(std::max(0., contact.square()));
  result.algebra = best.stress.defect;
  // The inequality holds for u_h + z with the prescribed displacement itself; z is zero on contact.
  result.absolute = total(stress_data.square, stress_data.lift, contact);
  const double scale = EnergyScale{stress_data.energy_norm, data.scale.rigid}.of(*result.absolute);
  result.relative = ratio(*result.absolute, scale);
  result.is_conditional = data.P.is_coupled();
  add_guaranteed(data, best, lift, scale, keeps_stress, located);
  result.largest_cell = name_of_worst_cell(stress_data, data.space);
  if (!data.scene.contacts.empty())
    result.worst_face = name_of(contact.dominant_part, data.scene);
  located.fields = {stress_data.misfit, stress_data.oscillation, roots(contact.cell_energies),
                    roots(contact.face_terms)};
  return located;
}
} // namespace

std::string gap_on_all_meshes(const DisplacedBody<2> &body) {
  const Scene<2> &scene = body.scene;
  if (!body.space.mesh().is_curved())
    return "";
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (!scene.geometry.sides[i].is_flat() && scene.boundary[i].role == Role::roller)
      return "rollers hold a curved side";
  if (scene.body_force != nullptr && !is_constant(*scene.body_force))
    for (const auto &cell : body.space.mesh().triangulation().active_cell_iterators())
      if (may_jump(scene.kinks, cell))
        return "the body force jumps in a curved body, or varies faster than the smallest boxes "
               "show";
  return "";
}

LocatedBound compute_located_bound(const BoundData &data, const bool keeps_stress) {
  LocatedBound none;
  none.bound.missing = objection_to_stress(data);
  if (!none.bound.missing.empty())
    return none;
  try {
    return sum_up(data, find_best_stress(data), keeps_stress);
  } catch (const ComputationError &error) {
    none.bound.missing = error.what();
    return none;
  }
}

Columns<ErrorBound> ErrorBound::columns() {
  return {{"bound_energy", &ErrorBound::absolute},
          {"bound_relative", &ErrorBound::relative},
          {"bound_mesh", &ErrorBound::mesh},
          {"bound_oscillation", &ErrorBound::oscillation},
          {"bound_contact", &ErrorBound::contact},
          {"bound_algebra", &ErrorBound::algebra},
          {"bound_post_energy", &ErrorBound::post_absolute},
          {"bound_post_relative", &ErrorBound::post_relative},
          {"distance", &ErrorBound::distance},
          {"margin", &ErrorBound::margin},
          {"post_distance", &ErrorBound::post_distance},
          {"post_margin", &ErrorBound::post_margin},
          {"max_penetration", &ErrorBound::penetration},
          {"energy_lower", &ErrorBound::energy_lower},
          {"energy_upper", &ErrorBound::energy_upper},
          {"contact_force_error", &ErrorBound::force_error}};
}

ErrorBound::Part ErrorBound::dominant_part() const {
  const double largest =
    std::max({mesh.value_or(0.), oscillation.value_or(0.), contact.value_or(0.)});
  if (largest == contact.value_or(0.))
    return Part::contact;
  return largest == mesh.value_or(0.) ? Part::mesh : Part::oscillation;
}
} // namespace Signorini
