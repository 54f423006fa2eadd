// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

namespace Signorini {
/** The data of the bound: a level, its solution, and A⁻¹. Everything must outlive it. */
struct BoundData {
  const DisplacementSpace<2> &space;
  const Scene<2> &scene;
  const MultiplierSpace<2> &multipliers;
  const Displacement &U;
  const Multiplier &P;
  const StiffnessInverse &inverse;
  const Coupling &condensed_D;
  /** The energy J(u_h) = a(u_h, u_h)/2 - f(u_h) (force x length per thickness). */
  double energy;
  EnergyScale scale;

  bool has_friction() const {
    return P.has_friction();
  }
};
} // namespace Signorini
