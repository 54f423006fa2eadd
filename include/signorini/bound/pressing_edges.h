// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/bound/edge_mesh.h>
#include <signorini/multiplier/multiplier_space.h>

#include <array>
#include <vector>

namespace Signorini
{
/** Contact edges on which p_H presses everywhere: all pieces face ∩ patch are below
 * pressing_threshold(). */
std::vector<unsigned int> pressing_edges(const EdgeMesh &mesh,
                                         const MultiplierSpace<2> &multipliers,
                                         const dealii::Vector<double> &P);

/** tau_n at both ends of an edge, in the order of Edge::vertices (force/area). */
std::array<double, 2> normal_tractions(const Edge &edge,
                                       unsigned int number,
                                       const std::vector<double> &moments);

/** Whether tau_n pulls at an end of the edge. */
inline bool pulls(const std::array<double, 2> &tractions)
{
  return tractions[0] > 0. || tractions[1] > 0.;
}
} // namespace Signorini
