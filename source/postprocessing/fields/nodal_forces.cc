// SPDX-License-Identifier: LGPL-2.1-or-later
// The balance of forces, node by node, and the reactions of plates.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/nodal_forces.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <limits>

namespace Signorini {
double NodalForces::largest() const {
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

namespace {
/** The displacement V = U without the translation of the whole body, and the size of that. */
struct Deformation {
  Displacement V;
  /** NodalForces::translation. */
  double translation = 1.;
};

/** Computes U without the translation, which is the middle of the range of each component. */
template <int dim>
Deformation deformation(const DisplacementSpace<dim> &space, const Displacement &U) {
  Deformation result = {U};
  double range = 0.;
  const std::vector<IndexSet> components = DoFTools::locally_owned_dofs_per_component(space.dofs());
  for (unsigned int d = space.mesh().is_axisymmetric() ? 1 : 0; d < dim; ++d) {
    const IndexSet &rows = components[d];
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const auto i : rows) {
      low = std::min(low, U(i));
      high = std::max(high, U(i));
    }
    low = Utilities::MPI::min(low, space.mesh().communicator());
    high = Utilities::MPI::max(high, space.mesh().communicator());
    range = std::max(range, 0.5 * (high - low));
    for (const auto i : rows)
      result.V(i) -= 0.5 * (low + high);
  }
  result.V.update_ghost_values();
  const double size = U.linfty_norm();
  if (range < size)
    result.translation = size / std::max(range, std::numeric_limits<double>::epsilon() * size);
  return result;
}
} // namespace

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
  const Deformation deformed = deformation(body.space, body.U);
  forces.strain_energy = 0.5 * (deformed.V * forces.internal);
  forces.translation = deformed.translation;
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
