// SPDX-License-Identifier: LGPL-2.1-or-later
// I^h. (VectorTools::interpolate fills in the locally owned cells only.)

#include <signorini/postprocess/nodal_interpolation.h>

namespace Signorini
{
template <int dim>
NodalVector interpolate_at_nodes(const DisplacementSpace<dim> &space,
                                 const dealii::Function<dim> &u)
{
  NodalVector values(space.dofs().n_dofs());
  std::vector<bool> visited(space.mesh().triangulation().n_vertices(), false);
  dealii::Vector<double> u_at_vertex(dim);
  for (const auto &cell : space.dofs().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (!visited[cell->vertex_index(v)])
      {
        visited[cell->vertex_index(v)] = true;
        u.vector_value(cell->vertex(v), u_at_vertex);
        for (unsigned int d = 0; d < dim; ++d)
          values[cell->vertex_dof_index(v, d)] = u_at_vertex[d];
      }
  return values;
}

template NodalVector interpolate_at_nodes(const DisplacementSpace<2> &,
                                          const dealii::Function<2> &);
} // namespace Signorini
