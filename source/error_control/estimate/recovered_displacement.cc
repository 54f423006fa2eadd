// SPDX-License-Identifier: LGPL-2.1-or-later
// The best interpolation of u_h, cell by cell of T^h.

#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/error_control/estimate/recovered_displacement.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

namespace Signorini
{
template <int dim>
RecoveredDisplacement<dim>::RecoveredDisplacement(const DisplacementSpace<dim> &space,
                                                  const Displacement &U)
  : element_(dealii::FE_Q<dim>(2 * space.element().degree), dim)
  , dofs_(space.mesh().triangulation())
{
  dofs_.distribute_dofs(element_);
  values_.reinit(dofs_.n_dofs());
  const dealii::Quadrature<dim> nodes(element_.base_element(0).get_unit_support_points());
  dealii::FEValues<dim> at_nodes(
    space.mesh().mapping(), space.element(), nodes, dealii::update_inverse_jacobians);
  PatchInterpolation<dim> interpolation(space, nodes, best_interpolation(space, U));
  dealii::Vector<double> cell_values(element_.n_dofs_per_cell());
  auto cell = dofs_.begin_active();
  for (const auto &own_cell : space.dofs().active_cell_iterators())
  {
    at_nodes.reinit(own_cell);
    const FieldValues<dim> &recovered = interpolation.evaluate(U, own_cell, at_nodes);
    for (unsigned int i = 0; i < cell_values.size(); ++i)
    {
      const auto component_and_node = element_.system_to_component_index(i);
      cell_values[i] = recovered.values[component_and_node.second][component_and_node.first];
    }
    cell->set_dof_values(cell_values, values_);
    ++cell;
  }
}

template class RecoveredDisplacement<2>;
} // namespace Signorini
