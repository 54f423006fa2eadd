// SPDX-License-Identifier: LGPL-2.1-or-later
// A U cell by cell, and the energy norm |||u_h||| without the rounding errors of a rigid
// translation.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** Calls work(cell, K, U) with the matrix of every cell of this rank and the values of U there, as
 * long as it returns true. */
template <int dim, typename Work>
void for_each_cell(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                   const Displacement &U, const Work &work) {
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> on_cell;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      on_cell.reinit(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_values(U, on_cell);
      if (!work(cell, stiffness(cell), on_cell))
        return;
    }
}
} // namespace

template <int dim>
InternalForces<dim> internal_forces(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                    const Displacement &U) {
  InternalForces<dim> result = {space.make_vector(), space.make_vector()};
  dealii::Vector<double> forces, magnitudes;
  double energy = 0.;
  for_each_cell(space, scene, U, [&](const auto &cell, const FullMatrix<double> &K, auto &on_cell) {
    forces.reinit(on_cell.size());
    magnitudes.reinit(on_cell.size());
    K.vmult(forces, on_cell);
    for (unsigned int i = 0; i < on_cell.size(); ++i)
      for (unsigned int j = 0; j < on_cell.size(); ++j)
        magnitudes[i] += std::abs(K(i, j) * on_cell[j]);
    const auto indices = space.cell_dofs(cell);
    result.forces.add(indices, forces);
    result.magnitudes.add(indices, magnitudes);
    const FiniteElement<dim> &element = cell->get_fe();
    Tensor<1, dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = on_cell[element.component_to_system_index(d, 0)];
    for (unsigned int i = 0; i < on_cell.size(); ++i)
      on_cell[i] -= corner[element.system_to_component_index(i).first];
    energy += K.matrix_norm_square(on_cell);
    return true;
  });
  const double unit = stiffness_unit(space, *scene.material);
  for (DualVector *const vector : {&result.forces, &result.magnitudes}) {
    vector->compress(VectorOperation::add);
    *vector *= unit;
  }
  energy = Utilities::MPI::sum(energy, space.mesh().communicator());
  result.energy_norm = std::sqrt(std::max(0., energy * unit));
  return result;
}

template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene, const Displacement &U) {
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
  const double motion = U.linfty_norm(), size = space.mesh().size();
  // Of a body that moves far, the strains are not known: they are less than rounding of U.
  if (unit_roundoff * motion > 1e-12 * size)
    return {};
  // Rounding, or what V-cycles leave: strains below 1e-10, and below 1e-9 of the motion.
  const double tolerance =
    std::max(1e3 * unit_roundoff, 1e-10 * size / std::max(motion, 0.1 * size));
  dealii::Vector<double> forces;
  bool rigid = true;
  for_each_cell(space, scene, U,
                [&](const auto &, const FullMatrix<double> &K, const auto &on_cell) {
                  forces.reinit(on_cell.size());
                  K.vmult(forces, on_cell);
                  rigid = forces.linfty_norm() <= tolerance * K.linfty_norm() * motion;
                  return rigid;
                });
  if (Utilities::MPI::min(rigid ? 1 : 0, space.mesh().communicator()) == 0)
    return {};
  // A body at rest, too, has a size that rounding is compared with.
  return std::max(motion, 1e-6 * size) * std::sqrt(stiffness_unit(space, *scene.material));
}

// B: the normal trace of V^h on Γ_c.

template <int dim>
TraceValues<dim>::TraceValues(const DisplacementSpace<dim> &space)
  : space_(space) {}

template <int dim>
const FEFaceValues<dim> &TraceValues<dim>::reinit(const ContactFace<dim> &face,
                                                  const std::vector<Point<dim - 1>> &on_face) {
  const unsigned int number = space_.element_number(face.cell);
  if (values_ == nullptr || number != element_number_ || on_face != on_face_) {
    on_face_ = on_face;
    element_number_ = number;
    values_ =
      std::make_unique<FEFaceValues<dim>>(space_.mesh().mapping(), space_.elements()[number],
                                          Quadrature<dim - 1>(on_face), update_values);
  }
  values_->reinit(space_.dof_cell(face.cell), face.face_no);
  return *values_;
}

template <int dim>
std::vector<Tensor<1, dim>> TraceValues<dim>::displacement(const ContactFace<dim> &face,
                                                           const SurfaceRule<dim> &rule,
                                                           const Displacement &U) {
  const auto &values = reinit(face, rule.on_face);
  std::vector<Tensor<1, dim>> u(rule.size());
  values[FEValuesExtractors::Vector(0)].get_function_values(U.entries(), u);
  return u;
}

template <int dim>
std::vector<double> TraceValues<dim>::normal_displacement(const ContactFace<dim> &face,
                                                          const SurfaceRule<dim> &rule,
                                                          const Displacement &U) {
  const std::vector<Tensor<1, dim>> u = displacement(face, rule, U);
  std::vector<double> u_n(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q)
    u_n[q] = u[q] * rule.normals[q];
  return u_n;
}

template <int dim>
Displacement interpolate_at_nodes(const DisplacementSpace<dim> &space, const Function<dim> &u) {
  Displacement values = space.zero();
  values.zero_out_ghost_values();
  VectorTools::interpolate(space.mesh().mapping(), space.dofs(), u, values.entries());
  values.update_ghost_values();
  return values;
}

INSTANTIATE_FUNCTION(internal_forces);
INSTANTIATE_FUNCTION(norm_of_rigid_motion);
INSTANTIATE_FUNCTION(interpolate_at_nodes);
template class TraceValues<2>;
template class TraceValues<3>;
} // namespace Signorini
