// SPDX-License-Identifier: LGPL-2.1-or-later
// The balance of forces, node by node, and the reactions of plates.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/nodal_forces.h>

#include <algorithm>

namespace Signorini {
double NodalForces::largest() const {
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

template <int dim>
NodalForces nodal_forces(const BodyInContact<dim> &body, const DualVector &loads,
                         const Coupling &D) {
  NodalForces forces;
  const InternalForces<dim> internal = internal_forces(body);
  forces.internal = internal.forces;
  forces.loads = loads;
  forces.contact = body.space.make_vector();
  D.add_product(body.P.values(), forces.contact);
  forces.residual = forces.internal;
  forces.residual -= forces.loads;
  forces.residual -= forces.contact;
  body.space.carry_to_masters(forces.residual);
  forces.magnitude = internal.magnitudes.l2_norm();
  forces.energy = {internal.energy_norm, norm_of_rigid_motion(body)};
  return forces;
}

template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                     const NodalForces &forces) {
  std::vector<PlateForce> result;
  for (std::size_t p = 0; p < scene.plates.size(); ++p) {
    const auto work_on = [&](const PlateMotion &motion) {
      std::vector<PlateMotion> motions(scene.plates.size());
      motions[p] = motion;
      return space.prescribed(with_only_plates_moved(scene, motions)) * forces.residual;
    };
    result.push_back({work_on({1., 0., 0.}), work_on({0., 1., 0.}), work_on({0., 0., 1.})});
  }
  return result;
}

INSTANTIATE_FUNCTION(nodal_forces);
INSTANTIATE_FUNCTION(plate_forces);
} // namespace Signorini
