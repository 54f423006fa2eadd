// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocess/nodal_forces.h>

#include <vector>

namespace Signorini
{
/** What acts on the body through a plate (per thickness). */
struct PlateForce
{
  /** Along the plate's direction. */
  double force = 0.;
  /** About the plate's centre, counter-clockwise. */
  double moment = 0.;
};

/** For every plate of the scene: the work of NodalForces::residual on its motions. A node at the
 * end of the plate belongs to the plate. */
template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space,
                                     const Scene<dim> &scene,
                                     const NodalForces &forces);
} // namespace Signorini
