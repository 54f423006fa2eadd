// SPDX-License-Identifier: LGPL-2.1-or-later
// A U cell by cell, and |||u_h||| without the rounding errors of a rigid translation.

#include <signorini/base/instantiate.h>
#include <signorini/base/instructions.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/discretization/space/internal_forces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace Signorini {
namespace {
/** Calls work(cell, K, U) with the matrix of every cell of this rank where U does not vanish, and
 * the values of U there, as long as it returns true. Prescribed displacements vanish in most cells.
 */
template <int dim, typename Work>
void for_each_cell(const DisplacedBody<dim> &body, const Work &work) {
  const DisplacementSpace<dim> &space = body.space;
  CellStiffness<dim> stiffness(space, body.scene);
  dealii::Vector<double> on_cell;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      on_cell.reinit(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_values(body.U, on_cell);
      if (!on_cell.all_zero() && !work(cell, stiffness(cell), on_cell))
        return;
    }
}

/** Computes K v and |K| |u| with the symmetric matrix K of a cell. Registers sum columns, which are
 * rows of K: four components at a time, some of them twice where their number is no multiple. */
void multiply(const FullMatrix<double> &K, const dealii::Vector<double> &v,
              const dealii::Vector<double> &u, dealii::Vector<double> &product,
              dealii::Vector<double> &magnitudes) {
  typedef double Lanes __attribute__((vector_size(32)));
  constexpr unsigned int width = sizeof(Lanes) / sizeof(double);
  const unsigned int n = u.size();
  product.reinit(n, true);
  magnitudes.reinit(n, true);
  run(instructions_of_this_machine(), [&](auto) SIGNORINI_INLINE {
    for (unsigned int begin = 0; begin < n; begin += width) {
      const unsigned int first = std::min(begin, n - width);
      Lanes column, sum = {}, sizes = {};
      for (unsigned int j = 0; j < n; ++j) {
        std::memcpy(&column, &K(j, first), sizeof(Lanes));
        sum += column * v[j];
        column *= u[j];
        sizes += column < 0. ? -column : column;
      }
      std::memcpy(&product[first], &sum, sizeof(Lanes));
      std::memcpy(&magnitudes[first], &sizes, sizeof(Lanes));
    }
  });
}
} // namespace

template <int dim>
InternalForces<dim> internal_forces(const DisplacedBody<dim> &body) {
  const DisplacementSpace<dim> &space = body.space;
  InternalForces<dim> result = {space.make_vector(), space.make_vector()};
  dealii::Vector<double> strained, forces, magnitudes;
  std::vector<types::global_dof_index> indices;
  double energy = 0.;
  for_each_cell(body, [&](const auto &cell, const FullMatrix<double> &K, const auto &on_cell) {
    const FiniteElement<dim> &element = cell->get_fe();
    Tensor<1, dim> corner;
    // A translation away from an axis is no rigid motion.
    for (unsigned int d = space.mesh().is_axisymmetric() ? 1 : 0; d < dim; ++d)
      corner[d] = on_cell[element.component_to_system_index(d, 0)];
    strained = on_cell;
    for (unsigned int i = 0; i < on_cell.size(); ++i)
      strained[i] -= corner[element.system_to_component_index(i).first];
    multiply(K, strained, on_cell, forces, magnitudes);
    energy += strained * forces;
    indices.resize(on_cell.size());
    cell->get_dof_indices(indices);
    result.forces.add(indices, forces);
    result.magnitudes.add(indices, magnitudes);
    return true;
  });
  const double unit = stiffness_unit(space, *body.scene.material);
  for (DualVector *const vector : {&result.forces, &result.magnitudes}) {
    vector->compress(VectorOperation::add);
    *vector *= unit;
  }
  energy = Utilities::MPI::sum(energy, space.mesh().communicator());
  result.energy_norm = std::sqrt(std::max(0., energy * unit));
  return result;
}

template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacedBody<dim> &body) {
  const DisplacementSpace<dim> &space = body.space;
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
  const double motion = body.U.linfty_norm(), size = space.mesh().size();
  // Of a body that moves far, the strains are not known: they are less than rounding of U.
  if (unit_roundoff * motion > 1e-12 * size)
    return {};
  // Rounding, or the remainder of V-cycles: strains below 1e-10, and below 1e-9 of the motion.
  const double tolerance =
    std::max(1e3 * unit_roundoff, 1e-10 * size / std::max(motion, 0.1 * size));
  dealii::Vector<double> forces;
  bool rigid = true;
  for_each_cell(body, [&](const auto &, const FullMatrix<double> &K, const auto &on_cell) {
    forces.reinit(on_cell.size());
    K.vmult(forces, on_cell);
    rigid = forces.linfty_norm() <= tolerance * K.linfty_norm() * motion;
    return rigid;
  });
  if (Utilities::MPI::min(rigid ? 1 : 0, space.mesh().communicator()) == 0)
    return {};
  // A body at rest, too, has a size that rounding is compared with.
  return std::max(motion, 1e-6 * size) * std::sqrt(stiffness_unit(space, *body.scene.material));
}

INSTANTIATE_FUNCTION(internal_forces);
INSTANTIATE_FUNCTION(norm_of_rigid_motion);
} // namespace Signorini
