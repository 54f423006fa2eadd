// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>

namespace Signorini
{
/**
 * The patch interpolation of u_h that comes closest to u, π^{2h} u_h or the one of degree four
 * (best_interpolation()), as a function of degree 2 p per direction on T^h, for elements of degree
 * p. Stresses come from it.
 */
template <int dim>
class RecoveredDisplacement
{
public:
  /** Interpolates u_h. The space must outlive the object, and Mesh::has_parents() must be true.
   * Collective. */
  RecoveredDisplacement(const DisplacementSpace<dim> &space, const Displacement &U);

  const dealii::DoFHandler<dim> &dofs() const
  {
    return dofs_;
  }
  /** Returns the nodal values, set on the cells that this rank stores. */
  const Displacement &values() const
  {
    return values_;
  }

private:
  dealii::FESystem<dim> element_;
  dealii::DoFHandler<dim> dofs_;
  Displacement values_;
};
} // namespace Signorini
