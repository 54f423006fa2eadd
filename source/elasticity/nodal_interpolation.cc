// SPDX-License-Identifier: LGPL-2.1-or-later
// I^h. (VectorTools::interpolate fills in the locally owned cells only.)

#include <signorini/elasticity/nodal_interpolation.h>
#include <signorini/elasticity/node_positions.h>

namespace Signorini
{
template <int dim>
NodalVector interpolate_at_nodes(const DisplacementSpace<dim> &space,
                                 const dealii::Function<dim> &u)
{
  NodePositions<dim> positions(space);
  NodalVector values(space.dofs().n_dofs());
  std::vector<bool> visited(values.size(), false);
  std::vector<dealii::types::global_dof_index> indices;
  dealii::Vector<double> u_at_node(dim);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const dealii::FiniteElement<dim> &element = cell->get_fe();
    const std::vector<dealii::Point<dim>> &nodes = positions(cell);
    indices.resize(element.n_dofs_per_cell());
    cell->get_dof_indices(indices);
    for (unsigned int node = 0; node < nodes.size(); ++node)
    {
      if (visited[indices[element.component_to_system_index(0, node)]])
        continue;
      u.vector_value(nodes[node], u_at_node);
      for (unsigned int d = 0; d < dim; ++d)
      {
        const auto index = indices[element.component_to_system_index(d, node)];
        values[index] = u_at_node[d];
        visited[index] = true;
      }
    }
  }
  return values;
}

template NodalVector interpolate_at_nodes(const DisplacementSpace<2> &,
                                          const dealii::Function<2> &);
template NodalVector interpolate_at_nodes(const DisplacementSpace<3> &,
                                          const dealii::Function<3> &);
} // namespace Signorini
