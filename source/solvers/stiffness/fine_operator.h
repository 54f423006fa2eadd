// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/stiffness/cell_operator.h>

#include <deal.II/grid/cell_id.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini {
/** A cell of some level by its tree, a cell of the coarse mesh, and its position among the cells of
 * the level there. */
template <int dim>
using BlockPlace = std::pair<types::coarse_cell_id, std::array<unsigned int, dim>>;

/** Returns the blocks of this rank: the subtrees that it owns. */
template <int dim>
std::vector<BlockPlace<dim>> own_blocks(const Mesh<dim> &mesh);

/** Returns K on the finest level, with the matrices that would be assembled. The identities of
 * nodes are their rows in a vector of this rank, divided by dim; own ones come first. */
template <int dim>
CellOperator<dim, double> make_fine_operator(const DisplacementSpace<dim> &space,
                                             const Scene<dim> &scene);
} // namespace Signorini
