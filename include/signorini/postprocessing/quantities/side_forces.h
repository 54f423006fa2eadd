// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/answer_vector.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The force that acts on the body through one side (force, in the plane per thickness). */
struct SideForce
{
  /** The force, and its moment about the origin: one number in the plane, three in space. */
  struct Total
  {
    AnswerVector force, moment;
  };
  std::string side;
  Total resultant;
  /** A point on the line of action: there the moment vanishes, or in space is parallel to the
   * force. None where the force vanishes. */
  std::optional<AnswerVector> through;
};

/** int p_H n over every contact side. The line of action is given by its point nearest to the
 * centre of pressure, which lies on a straight side. */
template <int dim>
std::vector<SideForce> contact_forces(const MultiplierSpace<dim> &multipliers,
                                      const Scene<dim> &scene,
                                      const dealii::Vector<double> &P);

/**
 * The reaction of every clamped, prescribed and roller side: the sum of NodalForces::residual over
 * its nodes, which is in balance with loads and contact forces to rounding.
 *
 * Where held sides meet (two, in space up to three), the node's reaction is divided: rollers take
 * what acts along their normals, and sides that hold all components share the rest equally. So the
 * division is known up to the stress at the corner times h, in space at the edge times h. The line
 * of action is given by its point nearest to the middle of the side.
 */
template <int dim>
std::vector<SideForce> reactions(const DisplacementSpace<dim> &space,
                                 const Scene<dim> &scene,
                                 const NodalForces &forces);

/** The point of the line of action x × F = M (in space of the axis on which the moment is parallel
 * to F) that is nearest to @p centre; none where |F| is rounding against @p scale (force). */
template <int dim>
std::optional<dealii::Point<dim>> point_of_action(const Resultant<dim> &resultant,
                                                  const dealii::Point<dim> &centre,
                                                  double scale);
} // namespace Signorini
