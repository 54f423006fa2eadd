// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>

#include <vector>

namespace Signorini
{
/**
 * pi^{2h} u_h of (30) at the nodes of the next level, where T^{2h} exists, else u_h: a start for
 * V-cycles on that level. In single precision, 4 dim 3^dim bytes for each cell.
 */
template <int dim>
class CoarseDisplacement
{
public:
  /** Elements of degree one. */
  CoarseDisplacement(const DisplacementSpace<dim> &space, const Displacement &U);

  /** Nodal values on the next level, which is refined everywhere; empty if @p space is not that.
   */
  Displacement at_nodes_of(const DisplacementSpace<dim> &space) const;

private:
  /** The level of the cells. */
  unsigned int level_;
  /** A vertex of every cell, by which it is recognised. */
  std::vector<dealii::Point<dim>> first_vertices_;
  /** By cell (its index on the level), point and component. */
  std::vector<float> values_;
};
} // namespace Signorini
