// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy norm |||u_h||| without the rounding errors of a rigid translation, and whether the
// body only moves as a whole.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
template <int dim>
double energy_norm(const DisplacementSpace<dim> &space,
                   const Scene<dim> &scene,
                   const Displacement &U)
{
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> on_cell;
  double energy = 0.;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const auto &element = cell->get_fe();
      on_cell.reinit(element.n_dofs_per_cell());
      cell->get_dof_values(U, on_cell);
      dealii::Tensor<1, dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = on_cell[element.component_to_system_index(d, 0)];
      for (unsigned int i = 0; i < on_cell.size(); ++i)
        on_cell[i] -= corner[element.system_to_component_index(i).first];
      energy += stiffness(cell).matrix_norm_square(on_cell);
    }
  energy = dealii::Utilities::MPI::sum(energy, space.mesh().communicator());
  return std::sqrt(std::max(0., energy * stiffness_unit(space, *scene.material)));
}

template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           const Displacement &U)
{
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
  const double motion = U.linfty_norm(), size = space.mesh().size();
  // Of a body that moves far, the strains are not known: they are less than rounding of U.
  if (unit_roundoff * motion > 1e-12 * size)
    return {};
  // Rounding, or what V-cycles leave: strains below 1e-10, and below 1e-9 of the motion.
  const double tolerance =
    std::max(1e3 * unit_roundoff, 1e-10 * size / std::max(motion, 0.1 * size));
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> on_cell, forces;
  bool rigid = true;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (rigid && cell->is_locally_owned())
    {
      on_cell.reinit(cell->get_fe().n_dofs_per_cell());
      forces.reinit(on_cell.size());
      cell->get_dof_values(U, on_cell);
      const dealii::FullMatrix<double> &K = stiffness(cell);
      K.vmult(forces, on_cell);
      rigid = forces.linfty_norm() <= tolerance * K.linfty_norm() * motion;
    }
  if (dealii::Utilities::MPI::min(rigid ? 1 : 0, space.mesh().communicator()) == 0)
    return {};
  // A body at rest, too, has a size that rounding is compared with.
  constexpr double least_motion = 1e-10;
  return std::max(motion, least_motion * size) * std::sqrt(stiffness_unit(space, *scene.material));
}

template <int dim>
double energy_scale(const double norm,
                    const double error,
                    const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const Displacement &U)
{
  constexpr double rounding = 1e-7;
  const std::optional<double> rigid = norm_of_rigid_motion(space, scene, U);
  if (!rigid)
    return norm;
  return error <= rounding * *rigid ? *rigid : error;
}

template double energy_norm(const DisplacementSpace<2> &, const Scene<2> &, const Displacement &);
template double energy_norm(const DisplacementSpace<3> &, const Scene<3> &, const Displacement &);
template std::optional<double> norm_of_rigid_motion(const DisplacementSpace<2> &,
                                                    const Scene<2> &,
                                                    const Displacement &);
template std::optional<double> norm_of_rigid_motion(const DisplacementSpace<3> &,
                                                    const Scene<3> &,
                                                    const Displacement &);
template double
energy_scale(double, double, const DisplacementSpace<2> &, const Scene<2> &, const Displacement &);
template double
energy_scale(double, double, const DisplacementSpace<3> &, const Scene<3> &, const Displacement &);
} // namespace Signorini
