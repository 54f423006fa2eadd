// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound of the energy error, summed up from stress and contact.

#include <signorini/bound/error_bound.h>
#include <signorini/bound/prescribed_rest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
namespace
{
/** |||u_h|||. */
double energy_norm(const StressData &data)
{
  const NodalVector forces(internal_forces(data.space, data.scene, data.U).forces);
  return std::sqrt(std::max(0., data.U * forces));
}

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

/** Turns the bound of ‖sigma(u_h) - tau‖ into one of ‖sigma(u_h + z) - tau‖. */
void add(const PrescribedRest &rest, StressBound &bound)
{
  bound.square = bound.oscillation_square = 0.;
  for (std::size_t cell = 0; cell < bound.misfit.size(); ++cell)
  {
    bound.oscillation[cell] += rest.norms[cell];
    bound.square += std::pow(bound.misfit[cell] + bound.oscillation[cell], 2);
    bound.oscillation_square += std::pow(bound.oscillation[cell], 2);
  }
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
  StressBound of_stress = stress.bound();
  const PrescribedRest rest = make_prescribed_rest(given.space, given.scene, given.U);
  if (rest.jumps)
  {
    result.missing = "prescribed displacements of two sides do not agree where the sides meet";
    return result;
  }
  add(rest, of_stress);
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
  result.oscillation = std::sqrt(of_stress.oscillation_square);
  result.mesh = std::max(0., std::sqrt(of_stress.square) - *result.oscillation);
  result.contact = std::sqrt(std::max(0., contact.square()));
  result.algebra = of_stress.algebra;
  result.absolute =
    std::sqrt(of_stress.square + std::max(0., contact.square())) + std::sqrt(rest.square);
  result.relative = ratio(*result.absolute, energy_norm(given));
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
          {"bound_algebra", &ErrorBound::algebra},
          {"max_penetration", &ErrorBound::penetration}};
}
} // namespace Signorini
