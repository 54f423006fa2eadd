// SPDX-License-Identifier: LGPL-2.1-or-later
// A displacement carried over to the next level.

#include <signorini/postprocessing/fields/coarse_displacement.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

namespace Signorini
{
namespace
{
/** 3^dim. */
template <int dim>
constexpr unsigned int n_next_nodes = dim == 2 ? 9 : 27;

/** Its vertices and the middles between them, lexicographically. */
template <int dim>
dealii::Quadrature<dim> next_nodes()
{
  std::vector<dealii::Point<dim>> points(n_next_nodes<dim>);
  for (unsigned int i = 0; i < points.size(); ++i)
    for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 3)
      points[i][d] = 0.5 * (rest % 3);
  return dealii::Quadrature<dim>(points);
}

/** The place of vertex v of child c among these. */
template <int dim>
unsigned int place_of_vertex(const unsigned int child, const unsigned int vertex)
{
  unsigned int place = 0;
  for (unsigned int d = 0, power = 1; d < dim; ++d, power *= 3)
    place += power * (((child >> d) & 1U) + ((vertex >> d) & 1U));
  return place;
}
} // namespace

template <int dim>
CoarseDisplacement<dim>::CoarseDisplacement(const DisplacementSpace<dim> &space,
                                            const Displacement &U)
  : level_(space.mesh().level())
  , first_vertices_(space.mesh().triangulation().n_cells(level_))
  , values_(first_vertices_.size() * n_next_nodes<dim> * dim)
{
  PatchInterpolation<dim> interpolation(
    space, next_nodes<dim>(), space.mesh().has_parents() ? 1 : 0);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const auto number = static_cast<std::size_t>(cell->index());
    first_vertices_[number] = cell->vertex(0);
    const std::vector<dealii::Tensor<1, dim>> &values = interpolation.values(U, cell);
    for (unsigned int q = 0; q < n_next_nodes<dim>; ++q)
      for (unsigned int d = 0; d < dim; ++d)
        values_[(number * n_next_nodes<dim> + q) * dim + d] = static_cast<float>(values[q][d]);
  }
}

template <int dim>
Displacement CoarseDisplacement<dim>::at_nodes_of(const DisplacementSpace<dim> &space) const
{
  const auto &mesh = space.mesh().triangulation();
  if (space.mesh().level() != level_ + 1 || mesh.n_cells(level_) != first_vertices_.size())
    return {};
  Displacement U = space.zero();
  const double rounding = 1e-10 * space.mesh().size();
  for (const auto &parent : space.dofs().cell_iterators_on_level(level_))
  {
    const auto number = static_cast<std::size_t>(parent->index());
    if (parent->is_active() || parent->vertex(0).distance(first_vertices_[number]) > rounding)
      return {};
    for (unsigned int c = 0; c < parent->n_children(); ++c)
      for (const unsigned int v : parent->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          U[parent->child(c)->vertex_dof_index(v, d)] =
            values_[(number * n_next_nodes<dim> + place_of_vertex<dim>(c, v)) * dim + d];
  }
  U.update_ghost_values();
  return U;
}

template class CoarseDisplacement<2>;
template class CoarseDisplacement<3>;
} // namespace Signorini
