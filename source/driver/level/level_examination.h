// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/driver/level/level_pressure.h>
#include <signorini/solvers/contact/recovery.h>

namespace Signorini
{
/** What a level was solved with. */
template <int dim>
struct SolvedSystem
{
  const LinearSystem<dim> &system;
  const StiffnessInverse &inverse;
  /** With plates and body where they have moved to. */
  const FreeState &free;
  const Pressure &pressure;
  const MotionModes<dim> &modes;
};

/** What follows from U and P: beta, the certificate, the answer, and the estimate and the bound of
 * the error, as far as they are asked for. Collective. */
template <int dim>
void examine(const Parameters &parameters,
             const Discretization<dim> &discretization,
             const SolvedSystem<dim> &solved,
             const Progress &progress,
             LevelSolution<dim> &solution);
} // namespace Signorini
