// SPDX-License-Identifier: LGPL-2.1-or-later
// Entries that exist in 2-D or for one shape or law only.

#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameters.h>

#include <string>
#include <vector>

#include "input.h"

namespace Signorini {
void refuse_foreign_entries(const bool belong, const std::vector<const Entry *> &entries,
                            const std::string &owner, const std::string &found) {
  for (const Entry *entry : entries)
    if (!belong && entry->changed)
      throw error_at(*entry, "this entry belongs to ", owner, ", found ", found, ".");
}

namespace {
template <typename Option>
void refuse_option(const Given<Option> &given, const Option option, const std::string &allowed) {
  if (given == option)
    throw error_at(given, "found '", to_text(given.value),
                   "' with Dimension = 3, allowed: ", allowed, ".");
}
} // namespace

void refuse_2d_entries(const Parameters &parameters) {
  const struct {
    std::vector<const Entry *> entries;
    const char *in_space;
  } table[] = {
    {{&parameters.material.orthotropic_moduli, &parameters.material.orientation,
      &parameters.material.moduli_across},
     "Law = general with Hooke tensor"},
    {{&parameters.load_cases.sequence}, "independent cases"},
    {{&parameters.discretization.patches}, "Patch ratio"},
    {{&parameters.geometry.arcs, &parameters.geometry.thickness, &parameters.material.plane_state,
      &parameters.discretization.kinks_at_x, &parameters.discretization.kinks_at_y,
      &parameters.output.lemmas, &parameters.verify.file},
     "nothing in its place"}};
  for (const auto &[entries, in_space] : table)
    refuse_foreign_entries(false, entries, "Dimension = 2",
                           std::string("Dimension = 3, allowed with it: ") + in_space);
  refuse_option(parameters.material.law, MaterialLaw::orthotropic, "isotropic, general");
  refuse_option(parameters.discretization.strategy, Strategy::hp, to_text(Strategy::nested));
  refuse_option(parameters.discretization.element, Element::q1_b_bar,
                to_text(Element::q1) + ", " + to_text(Element::q2));
  const Given<unsigned int> &ratio = parameters.discretization.patch_ratio;
  if (ratio < 2 && parameters.discretization.element != Element::q2)
    throw error_at(ratio, "found '", ratio.value,
                   "' with Dimension = 3, allowed: 2 or more; in space the inf-sup constant of "
                   "H = h falls like h^2.");
  unsigned int n_generations = 0;
  while (1U << n_generations < ratio)
    ++n_generations;
  if (1U << n_generations != ratio)
    throw error_at(ratio, "found '", ratio.value,
                   "' with Dimension = 3, allowed: powers of two; patches in space are faces of "
                   "coarser meshes.");
  const Given<unsigned int> &coarsest = parameters.discretization.coarsest_level;
  if (coarsest < n_generations)
    throw error_at(coarsest, "found '", coarsest.value,
                   "' with Dimension = 3, allowed: ", n_generations,
                   " or more; patches in space are faces of coarser meshes.");
}

} // namespace Signorini
