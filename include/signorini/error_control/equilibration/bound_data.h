// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/solvers/methods/solved.h>

namespace Signorini {
/** The data of the bound: a solved level, and its energies. Everything must outlive it. */
struct BoundData : Solved<2> {
  BoundData(const Solved<2> &solved, const double energy, const EnergyScale &scale)
    : Solved<2>(solved)
    , energy(energy)
    , scale(scale)
    , inverse(*solved.contact.inverse)
    , condensed_D(solved.discretization.condensed_D) {}

  /** The energy J(u_h) = a(u_h, u_h)/2 - f(u_h) (force x length per thickness). */
  double energy;
  EnergyScale scale;
  const StiffnessInverse &inverse;
  const Coupling &condensed_D;

  bool has_friction() const {
    return P.has_friction();
  }
};
} // namespace Signorini
