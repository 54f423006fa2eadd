// SPDX-License-Identifier: LGPL-2.1-or-later
// T^h by nested refinement, partitioned by METIS.

#include <signorini/mesh/mesh.h>

#include <deal.II/grid/grid_tools.h>

namespace Signorini
{
template <int dim>
Mesh<dim>::Mesh(const Geometry<dim> &geometry, const unsigned int coarsest_level,
                const unsigned int level, MPI_Comm communicator)
    : triangulation_(communicator, dealii::Triangulation<dim>::none,
                     /*allow_artificial_cells=*/false,
                     dealii::parallel::shared::Triangulation<dim>::partition_metis)
    , parents_are_nested_(level > 0 && (geometry.distortion == 0. || level > coarsest_level))
{
  const unsigned int first = std::min(coarsest_level, level);
  geometry.make_coarse_mesh(triangulation_);
  triangulation_.refine_global(first);
  if (geometry.distortion > 0.)
    dealii::GridTools::distort_random(geometry.distortion, triangulation_, true);
  triangulation_.refine_global(level - first);
}

template <int dim>
double Mesh<dim>::longest_edge() const
{
  double longest = 0.;
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const unsigned int line : cell->line_indices())
      longest = std::max(longest, cell->line(line)->diameter());
  return longest;
}

template <int dim>
bool Mesh<dim>::has_parents() const
{
  return parents_are_nested_;
}

template class Mesh<2>;
} // namespace Signorini
