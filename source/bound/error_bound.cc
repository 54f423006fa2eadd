// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound of the energy error, summed up from stress and contact.

#include <signorini/bound/error_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
namespace
{
/** "bottom at (0.25, 0)". */
std::string name_of(const SidePlace &place, const Scene<2> &scene)
{
  const Side<2> &side = scene.geometry.sides[place.side];
  const dealii::Point<2> x = side.point(place.arc_length);
  std::ostringstream name;
  name << side.name() << " at (" << x[0] << ", " << x[1] << ")";
  return name.str();
}

/** "the cell at (0.5, 0.25)". */
std::string name_of_worst_cell(const StressBound &bound, const DisplacementSpace<2> &space)
{
  std::size_t worst = 0;
  const auto part = [&](const std::size_t cell) {
    return bound.misfit[cell] + bound.oscillation[cell];
  };
  for (std::size_t cell = 1; cell < bound.misfit.size(); ++cell)
    if (part(cell) > part(worst))
      worst = cell;
  std::size_t number = 0;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (number++ == worst)
    {
      std::ostringstream name;
      name << "the cell at (" << cell->center()[0] << ", " << cell->center()[1] << ")";
      return name.str();
    }
  return "";
}

double ratio(const double value, const double scale)
{
  if (value == 0.)
    return 0.;
  return scale > 0. ? value / scale : std::numeric_limits<double>::infinity();
}
} // namespace

ErrorBound compute_error_bound(const BoundData &data)
{
  const StressData &given = data.stress;
  ErrorBound result;
  result.missing = EquilibratedStress::objection(given);
  if (!result.missing.empty())
    return result;
  const EquilibratedStress stress(given);
  const StressBound of_stress = stress.bound();
  const ContactLift lift(
    given.space,
    given.scene,
    given.multipliers,
    given.U,
    given.P,
    ContactLift::DualData{data.inverse, data.condensed_D, 0.05 * of_stress.square});
  result.penetration = lift.trace().largest_penetration();
  result.place_of_penetration = name_of(lift.trace().place_of_largest(), given.scene);
  result.missing = lift.no_bound();
  if (!lift.bound())
    return result;
  const ContactBound &contact = *lift.bound();
  if (!std::isfinite(of_stress.square) || !std::isfinite(contact.square()))
  {
    result.missing = "the sums of the bound are no finite numbers";
    return result;
  }
  result.oscillation = std::sqrt(of_stress.oscillation_square) + of_stress.lift;
  result.mesh = std::max(0.,
                         std::sqrt(of_stress.square) - std::sqrt(of_stress.oscillation_square) -
                           std::sqrt(of_stress.geometry_square));
  result.contact = std::sqrt(std::max(0., contact.square()));
  result.algebra = of_stress.algebra;
  // The inequality holds for u_h + E with the prescribed displacement itself; E is zero on contact.
  result.absolute = of_stress.lift + std::sqrt(of_stress.square + std::max(0., contact.square()));
  // Where the body moves as a whole, |||u_h||| and the bound are nothing but rounding.
  const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * given.U.linfty_norm() *
                          std::sqrt(given.scene.material->modulus());
  result.relative = ratio(*result.absolute, std::max(stress.energy_norm(), rounding));
  result.guaranteed = stress.is_guaranteed();
  result.geometry = std::sqrt(of_stress.geometry_square);
  result.relative_geometry = ratio(*result.geometry, std::max(stress.energy_norm(), rounding));
  // A polygon says nothing about the last digits of the energy, nor about the force on a curve.
  if (result.guaranteed)
  {
    const double J_star = of_stress.complementary_energy - given.P * data.G;
    const double eta = std::sqrt(of_stress.square), lift_norm = std::sqrt(contact.lift_energy);
    const Bracket energy = energy_bracket(J_star, eta, lift_norm, contact.contact_term);
    result.energy_lower = energy.lower;
    result.energy_upper = energy.upper;
    if (const auto unit_lift =
          norm_of_unit_lift(given.space, given.scene, lift.trace(), data.inverse))
      result.force_error =
        contact_force_bound(stress_error_bound(eta, lift_norm, contact.contact_term), *unit_lift);
  }
  result.largest_cell = name_of_worst_cell(of_stress, given.space);
  if (!given.scene.contact_sides().empty())
    result.largest_face = name_of(contact.largest_part, given.scene);
  return result;
}

Columns<ErrorBound> ErrorBound::columns()
{
  return {{"bound_energy", &ErrorBound::absolute},
          {"bound_relative", &ErrorBound::relative},
          {"bound_mesh", &ErrorBound::mesh},
          {"bound_oscillation", &ErrorBound::oscillation},
          {"bound_contact", &ErrorBound::contact},
          {"bound_geometry", &ErrorBound::geometry},
          {"bound_algebra", &ErrorBound::algebra},
          {"max_penetration", &ErrorBound::penetration},
          {"energy_lower", &ErrorBound::energy_lower},
          {"energy_upper", &ErrorBound::energy_upper},
          {"contact_force_error", &ErrorBound::force_error}};
}

ErrorBound::Part ErrorBound::largest_part() const
{
  const double largest =
    std::max({mesh.value_or(0.), oscillation.value_or(0.), contact.value_or(0.)});
  if (largest == contact.value_or(0.))
    return Part::contact;
  return largest == mesh.value_or(0.) ? Part::mesh : Part::oscillation;
}
} // namespace Signorini
