// SPDX-License-Identifier: LGPL-2.1-or-later
// The nodes of multipliers that press.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/contact_pressure.h>
#include <signorini/postprocessing/fields/forces.h>

#include <algorithm>

namespace Signorini
{
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers, const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<SideNodes> sides;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<2> &patch = surface.patches()[multipliers.patch_of(k)];
    if (sides.empty() || sides.back().number != patch.side)
    {
      const Side<2> &side = surface.side(patch);
      sides.push_back({patch.side, side.length(), side.is_closed(), {}});
    }
    sides.back().nodes.push_back({multipliers.node(k)[0], P[k] < threshold});
  }
  return sides;
}

// The balance of forces, node by node, and the resultants of the contact pressure.

double NodalForces::largest() const
{
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const DistributedVector &loads,
                         const Coupling &D,
                         const Displacement &U,
                         const Pressure &P)
{
  NodalForces forces;
  const InternalForces<dim> internal = internal_forces(space, scene, U);
  forces.internal = space.dual(internal.forces);
  forces.loads = space.dual(loads);
  DistributedVector contact = space.make_vector();
  D.add_product(P, contact);
  contact.compress(dealii::VectorOperation::add);
  forces.contact = space.dual(contact);
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
                                 const Pressure &P,
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
                                  const Displacement &,
                                  const Pressure &);
template NodalForces nodal_forces(const DisplacementSpace<3> &,
                                  const Scene<3> &,
                                  const DistributedVector &,
                                  const Coupling &,
                                  const Displacement &,
                                  const Pressure &);
template Resultant<2> contact_resultant(const MultiplierSpace<2> &,
                                        const Pressure &,
                                        const Piece<2> &);
template Resultant<3> contact_resultant(const MultiplierSpace<3> &,
                                        const Pressure &,
                                        const Piece<3> &);

// The reactions of plates.

template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space,
                                     const Scene<dim> &scene,
                                     const NodalForces &forces)
{
  std::vector<PlateForce> result;
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
  {
    const auto work_on = [&](const PlateMotion &motion) {
      std::vector<PlateMotion> motions(scene.plates.size());
      motions[p] = motion;
      return space.prescribed(with_only_plates_moved(scene, motions)) * forces.residual;
    };
    result.push_back({work_on({1., 0.}), work_on({0., 1.})});
  }
  return result;
}

template std::vector<PlateForce> plate_forces(const DisplacementSpace<2> &,
                                              const Scene<2> &,
                                              const NodalForces &);
template std::vector<PlateForce> plate_forces(const DisplacementSpace<3> &,
                                              const Scene<3> &,
                                              const NodalForces &);
} // namespace Signorini
