// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocess/nodal_forces.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The force that acts on the body through one side (force per thickness). */
struct SideForce
{
  std::string side;
  /** About the origin. */
  Resultant<2> resultant;
  /** A point on the line of action x × F = M; none where the force vanishes. */
  std::optional<dealii::Point<2>> through;
};

/** int p_H n over every contact side. The line of action is given by its point nearest to the
 * centre of pressure, which lies on a straight side. */
std::vector<SideForce> contact_forces(const MultiplierSpace<2> &multipliers,
                                      const Scene<2> &scene,
                                      const dealii::Vector<double> &P);

/**
 * The reaction of every clamped, prescribed and roller side: the sum of NodalForces::residual over
 * its nodes, which is in balance with loads and contact forces to rounding.
 *
 * Where two held sides meet, the node's reaction is divided: a roller takes what acts along its
 * normal, two rollers both components, and two sides that hold all components take one half each.
 * So the division between the two is known up to the stress at the corner times h. The line of
 * action is given by its point nearest to the middle of the side.
 */
std::vector<SideForce> reactions(const DisplacementSpace<2> &space,
                                 const Scene<2> &scene,
                                 const NodalForces &forces);

/** The point of the line of action x × F = M that is nearest to @p centre; none where |F| is
 * rounding against @p scale (force). */
std::optional<dealii::Point<2>> point_of_action(const Resultant<2> &resultant,
                                                const dealii::Point<2> &centre,
                                                double scale);
} // namespace Signorini
