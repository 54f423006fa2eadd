// SPDX-License-Identifier: LGPL-2.1-or-later
// The balance of forces, node by node, and the reactions of plates.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/nodal_forces.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini {
double NodalForces::largest() const {
  return std::max({internal.l2_norm(), loads.l2_norm(), contact.l2_norm()});
}

namespace {
/** Returns NodalForces::translation: the size of U against that without the translation, which is
 * the middle of the range of each component. */
template <int dim>
double translation_of(const DisplacementSpace<dim> &space, const Displacement &U) {
  std::array<double, dim> low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(-low[0]);
  dealii::Vector<double> on_cell;
  for (const auto &cell :
       space.dofs().active_cell_iterators() | IteratorFilters::LocallyOwnedCell()) {
    const FiniteElement<dim> &element = cell->get_fe();
    on_cell.reinit(element.n_dofs_per_cell());
    cell->get_dof_values(U.entries(), on_cell);
    for (unsigned int i = 0; i < on_cell.size(); ++i) {
      const unsigned int d = element.system_to_component_index(i).first;
      low[d] = std::min(low[d], on_cell[i]);
      high[d] = std::max(high[d], on_cell[i]);
    }
  }
  double range = 0.;
  for (unsigned int d = space.mesh().is_axisymmetric() ? 1 : 0; d < dim; ++d)
    range = std::max(range, 0.5 * (Utilities::MPI::max(high[d], space.mesh().communicator()) -
                                   Utilities::MPI::min(low[d], space.mesh().communicator())));
  const double size = U.linfty_norm();
  return range < size ? size / std::max(range, std::numeric_limits<double>::epsilon() * size) : 1.;
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
  // Products of forces and displacements would contain the rounding of every cell's motion.
  forces.strain_energy = 0.5 * std::pow(internal.energy_norm, 2);
  forces.translation = translation_of(body.space, body.U);
  forces.energy = {internal.energy_norm, norm_of_rigid_motion(body)};
  return forces;
}

template <int dim>
std::vector<PlateForce<dim>> plate_forces(const DisplacementSpace<dim> &space,
                                          const Scene<dim> &scene, const NodalForces &forces) {
  std::vector<PlateForce<dim>> result(scene.plates.size());
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
    for (const PlateMotion<dim> &unit : scene.plates[p].unit_motions()) {
      std::vector<PlateMotion<dim>> motions(scene.plates.size());
      motions[p] = unit;
      Scene<dim> moved = with_only_plates_moved(scene, motions);
      const double work = space.prescribed(moved) * forces.residual;
      result[p].force += work * unit.travel;
      result[p].cross_force += work * unit.drift;
      result[p].moment += work * unit.rotation;
    }
  return result;
}

INSTANTIATE_FUNCTION(nodal_forces);
INSTANTIATE_FUNCTION(plate_forces);
} // namespace Signorini
