// SPDX-License-Identifier: LGPL-2.1-or-later
// |||u_h||| without what a rigid translation would add by rounding.

#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/elasticity/energy_norm.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
template <int dim>
double energy_norm(const DisplacementSpace<dim> &space,
                   const Scene<dim> &scene,
                   const NodalVector &U)
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
double energy_scale(const double norm,
                    const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const NodalVector &U)
{
  const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * U.linfty_norm() *
                          std::sqrt(stiffness_unit(space, *scene.material));
  return std::max(norm, rounding);
}

template <int dim>
double energy_scale(const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const NodalVector &U)
{
  return energy_scale(energy_norm(space, scene, U), space, scene, U);
}

template double energy_norm(const DisplacementSpace<2> &, const Scene<2> &, const NodalVector &);
template double energy_norm(const DisplacementSpace<3> &, const Scene<3> &, const NodalVector &);
template double
energy_scale(double, const DisplacementSpace<2> &, const Scene<2> &, const NodalVector &);
template double
energy_scale(double, const DisplacementSpace<3> &, const Scene<3> &, const NodalVector &);
template double energy_scale(const DisplacementSpace<2> &, const Scene<2> &, const NodalVector &);
template double energy_scale(const DisplacementSpace<3> &, const Scene<3> &, const NodalVector &);
} // namespace Signorini
