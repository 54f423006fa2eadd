// SPDX-License-Identifier: LGPL-2.1-or-later
// What is not there in space.

#include "space_input.h"

#include <signorini/base/exceptions.h>

#include <utility>
#include <vector>

namespace Signorini
{
namespace
{
/** Entries that must stay at their defaults. */
std::vector<const Entry *> entries_of_the_plane(const Parameters &parameters)
{
  return {&parameters.geometry.arcs,
          &parameters.material.plane_state,
          &parameters.material.orthotropic_moduli,
          &parameters.material.orientation,
          &parameters.material.moduli_across,
          &parameters.boundary.plates,
          &parameters.load.plate_force,
          &parameters.load.plate_moment,
          &parameters.load.plate_travel,
          &parameters.contact.foundation,
          &parameters.contact.foundation_position,
          &parameters.load_cases.cases,
          &parameters.load_cases.fields,
          &parameters.discretization.kinks_at_x,
          &parameters.discretization.kinks_at_y,
          &parameters.discretization.patches,
          &parameters.output.lemmas,
          &parameters.output.pictures};
}

template <typename Option>
void refuse_option(const Given<Option> &given, const Option option, const std::string &allowed)
{
  if (given == option)
    throw InputError(given.where() + ": found '" + to_text(given.value) +
                     "' with Dimension = 3, allowed: " + allowed + ".");
}
} // namespace

void refuse_what_is_plane(const Parameters &parameters)
{
  for (const Entry *entry : entries_of_the_plane(parameters))
    if (entry->changed)
      throw InputError(entry->where() +
                       ": this entry exists with Dimension = 2 only, found Dimension = 3.");
  refuse_option(parameters.material.law, MaterialLaw::orthotropic, "isotropic, general");
  refuse_option(parameters.discretization.strategy, Strategy::hp, to_text(Strategy::nested));
  refuse_option(parameters.discretization.element, Element::q1_b_bar, to_text(Element::q1));
  const Given<unsigned int> &ratio = parameters.discretization.patch_ratio;
  if (ratio < 2)
    throw InputError(ratio.where() + ": found '" + std::to_string(ratio.value) +
                     "' with Dimension = 3, allowed: 2 or more; in space the inf-sup constant of "
                     "H = h falls like h^2.");
}
} // namespace Signorini
