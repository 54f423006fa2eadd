// SPDX-License-Identifier: LGPL-2.1-or-later
// The balance of forces, node by node, and the resultants of the contact pressure.

#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/elasticity/energy_norm.h>
#include <signorini/postprocess/nodal_forces.h>

#include <algorithm>

namespace Signorini
{
double NodalForces::largest() const
{
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const DistributedVector &loads,
                         const Coupling &D,
                         const NodalVector &U,
                         const dealii::Vector<double> &P)
{
  NodalForces forces;
  const InternalForces<dim> internal = internal_forces(space, scene, U);
  forces.internal = NodalVector(internal.forces);
  forces.loads = NodalVector(loads);
  DistributedVector contact = space.make_vector();
  D.add_product(P, contact);
  contact.compress(dealii::VectorOperation::add);
  forces.contact = NodalVector(contact);
  forces.residual = forces.internal;
  forces.residual -= forces.loads;
  forces.residual -= forces.contact;
  space.carry_to_masters(forces.residual);
  forces.magnitude = internal.magnitudes.l2_norm();
  forces.rigid = norm_of_rigid_motion(space, scene, U);
  return forces;
}

template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const dealii::Vector<double> &P,
                                 const Piece<dim> &piece)
{
  Resultant<dim> resultant;
  const SurfaceRule<dim> &rule = piece.on_mesh;
  for (std::size_t q = 0; q < rule.size(); ++q)
    resultant.add(multipliers.value(P, piece.patch, rule.on_side[q]) * rule.weights[q] *
                    rule.normals[q],
                  rule.points[q]);
  return resultant;
}

template NodalForces nodal_forces(const DisplacementSpace<2> &,
                                  const Scene<2> &,
                                  const DistributedVector &,
                                  const Coupling &,
                                  const NodalVector &,
                                  const dealii::Vector<double> &);
template NodalForces nodal_forces(const DisplacementSpace<3> &,
                                  const Scene<3> &,
                                  const DistributedVector &,
                                  const Coupling &,
                                  const NodalVector &,
                                  const dealii::Vector<double> &);
template Resultant<2> contact_resultant(const MultiplierSpace<2> &,
                                        const dealii::Vector<double> &,
                                        const Piece<2> &);
template Resultant<3> contact_resultant(const MultiplierSpace<3> &,
                                        const dealii::Vector<double> &,
                                        const Piece<3> &);
} // namespace Signorini
