// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/fields/energies.h>

namespace Signorini {
/** The data of the bound: a solved level, A⁻¹, its energies and the size of u_h. Everything must
 * outlive it. */
struct BoundData : Solved<2> {
  BoundData(const Solved<2> &solved, const StiffnessInverse &inverse, const Energies &energies,
            const EnergyScale &scale)
    : Solved<2>(solved)
    , inverse(inverse)
    , energies(energies)
    , scale(scale)
    , condensed_D(solved.discretization.condensed_D) {}

  const StiffnessInverse &inverse;
  const Energies &energies;
  EnergyScale scale;
  const Coupling &condensed_D;

  bool has_tangential_part() const {
    return P.has_tangential_part();
  }
};
} // namespace Signorini
