// SPDX-License-Identifier: LGPL-2.1-or-later
// The finest level, from deal.II's mesh and degrees of freedom.

#include "fine_operator.h"

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/cell_stiffness.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

#include "point_kernel.h"

namespace Signorini {
namespace {
template <int dim>
using BlockCells = std::vector<typename DoFHandler<dim>::active_cell_iterator>;

/** Returns the roots of the subtrees that this rank owns. */
template <int dim>
std::vector<typename Triangulation<dim>::cell_iterator> own_roots(const Mesh<dim> &mesh) {
  std::vector<typename Triangulation<dim>::cell_iterator> roots;
  for (const auto &cell : mesh.triangulation().cell_iterators_on_level(mesh.subtree_level())) {
    auto leaf = cell;
    while (leaf->has_children())
      leaf = leaf->child(0);
    if (leaf->is_active() && leaf->is_locally_owned())
      roots.push_back(cell);
  }
  return roots;
}

/** Puts the active cells below a cell in the order of a BlockGrid. @param position that of the cell
 * among the cells of its level in the block. @param block the first of n^dim cells. */
template <int dim>
void put_cells(const typename DoFHandler<dim>::cell_iterator &cell,
               const std::array<unsigned int, dim> &position, const std::size_t n,
               const typename BlockCells<dim>::iterator &block) {
  if (cell->is_active()) {
    std::size_t number = 0;
    for (int d = dim; d-- > 0;)
      number = number * n + position[d];
    block[number] = cell;
  } else
    for (unsigned int child = 0; child < cell->n_children(); ++child) {
      std::array<unsigned int, dim> below;
      for (int d = 0; d < dim; ++d)
        below[d] = 2 * position[d] + ((child >> d) & 1U);
      put_cells<dim>(cell->child(child), below, n, block);
    }
}

/** Returns whether all descendants of a cell are congruent: it is a parallelogram or
 * parallelepiped, and only straight edges were halved. */
template <int dim>
bool has_congruent_descendants(const Mesh<dim> &mesh,
                               const typename Triangulation<dim>::cell_iterator &cell) {
  return !mesh.is_curved() && mesh.n_nested_ancestors() >= mesh.level() && is_affine<dim>(cell);
}

/** Fills the matrices of an operator, with the unknowns of a cell in the order of the kernels. */
template <int dim>
class MatrixFiller {
public:
  using Operator = CellOperator<dim, double>;

  MatrixFiller(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
               const BlockCells<dim> &cells, Operator &K)
    : space_(space)
    , mesh_(space.mesh())
    , scene_(scene)
    , cells_(cells)
    , K_(K)
    , stiffness_(space, scene) {
    for (unsigned int v = 0; v < (1U << dim); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        dof_index_[v * dim + c] = space.element().component_to_system_index(c, v);
  }

  void fill() {
    if (scene_.material->is_constant() && !mesh_.is_axisymmetric())
      share_matrices();
    if (*std::min_element(K_.storage.begin(), K_.storage.end()) >= 0)
      return;
    const bool is_straight = !mesh_.is_curved() && !mesh_.is_axisymmetric() &&
                             space_.strain_operator() == StrainOperator::symmetric_gradient;
    if (is_straight) {
      set_positions();
      if (scene_.material->is_constant()) {
        K_.moduli.resize(Operator::n_moduli * n_lanes);
        for (unsigned int l = 0; l < n_lanes; ++l)
          set_moduli(&K_.moduli[l], Point<dim>());
        return;
      }
    }
    K_.store_matrices();
    if (is_straight)
      integrate_matrices();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      if (!K_.is_shared(cell / n_lanes) &&
          (!is_straight || needs_cuts<dim>(scene_.law_kinks, cells_[cell])))
        copy(stiffness_(typename CellStiffness<dim>::CellIterator(cells_[cell])), cell);
    K_.positions = LevelVector<dim, double>();
  }

private:
  /** Finds one matrix for each shape of blocks with congruent cells, and the batches inside such
   * blocks. */
  void share_matrices() {
    const std::size_t per_block = K_.grid->n_cells / K_.grid->n_blocks;
    std::vector<typename CellStiffness<dim>::Matrix> known;
    std::vector<int> shared_by_block(K_.grid->n_blocks, -1);
    for (unsigned int block = 0; block < K_.grid->n_blocks; ++block)
      if (has_congruent_descendants<dim>(mesh_, root(block))) {
        const auto matrix =
          stiffness_.share(typename CellStiffness<dim>::CellIterator(cells_[block * per_block]));
        const auto same = std::find(known.begin(), known.end(), matrix);
        shared_by_block[block] = static_cast<int>(same - known.begin());
        if (same != known.end())
          continue;
        known.push_back(matrix);
        for (const unsigned int i : dof_index_)
          for (const unsigned int j : dof_index_)
            K_.shared.push_back(0.5 * ((*matrix)(i, j) + (*matrix)(j, i)));
      }
    for (std::size_t batch = 0; batch < K_.grid->n_batches(); ++batch) {
      const auto first = shared_by_block.begin() + batch * n_lanes / per_block,
                 last = shared_by_block.begin() +
                        (std::min((batch + 1) * n_lanes, K_.grid->n_cells) - 1) / per_block;
      if (std::all_of(first, last + 1, [&](const int matrix) { return matrix == *first; }))
        K_.storage[batch] = *first;
    }
  }

  /** Returns the cell that is a whole block. */
  typename Triangulation<dim>::cell_iterator root(const unsigned int block) const {
    typename Triangulation<dim>::cell_iterator cell =
      cells_[block * (K_.grid->n_cells / K_.grid->n_blocks)];
    while (cell->level() > static_cast<int>(mesh_.subtree_level()))
      cell = cell->parent();
    return cell;
  }

  /** Sets the positions of the nodes in the body of size one. */
  void set_positions() {
    const Point<dim> origin = mesh_.from_unit_body(Point<dim>());
    K_.positions = LevelVector<dim, double>(K_.grid->n_nodes());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      for (unsigned int v = 0; v < (1U << dim); ++v)
        for (int d = 0; d < dim; ++d)
          K_.positions[d][K_.grid->nodes(cell)[v]] =
            (cells_[cell]->vertex(v)[d] - origin[d]) / mesh_.size();
  }

  /** Writes E/E_0 at a point of the body of size one, [modulus][lane] of one lane. */
  void set_moduli(double *const moduli, const Point<dim> &x) const {
    using Strain = SymmetricTensor<2, dim>;
    const SymmetricTensor<4, dim> hooke = scene_.material->relative_hooke(mesh_.from_unit_body(x));
    for (unsigned int s = 0; s < Operator::n_strains; ++s)
      for (unsigned int t = 0; t <= s; ++t) {
        const auto a = Strain::unrolled_to_component_indices(s),
                   b = Strain::unrolled_to_component_indices(t);
        moduli[lower(s, t) * n_lanes] = hooke[a[0]][a[1]][b[0]][b[1]];
      }
  }

  /** Integrates all stored matrices with the moduli at each point. */
  void integrate_matrices() {
    constexpr std::size_t stride = Operator::n_moduli * n_lanes;
    const QGauss<dim> gauss(n_stiffness_points<dim>(scene_.material->is_constant()));
    std::vector<double> moduli(gauss.size() * stride);
    for (std::size_t batch = 0; batch < K_.grid->n_batches(); ++batch)
      if (!K_.is_shared(batch)) {
        for (unsigned int l = 0; l < n_lanes; ++l) {
          const auto nodes = K_.grid->nodes(std::min(batch * n_lanes + l, K_.grid->n_cells - 1));
          for (unsigned int q = 0; q < gauss.size(); ++q) {
            Point<dim> x;
            for (unsigned int v = 0; v < nodes.size(); ++v)
              for (int d = 0; d < dim; ++d)
                x[d] += GeometryInfo<dim>::d_linear_shape_function(gauss.point(q), v) *
                        K_.positions[d][nodes[v]];
            set_moduli(&moduli[q * stride + l], x);
          }
        }
        K_.integrate(K_.stored_matrices(batch), batch, moduli.data(), stride);
      }
  }

  /** Copies the matrix of a cell. */
  void copy(const FullMatrix<double> &matrix, const std::size_t cell) {
    double *const target = K_.stored_matrices(cell / n_lanes) + cell % n_lanes;
    for (unsigned int i = 0; i < dof_index_.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        target[lower(i, j) * n_lanes] = matrix(dof_index_[i], dof_index_[j]);
  }

  const DisplacementSpace<dim> &space_;
  const Mesh<dim> &mesh_;
  const Scene<dim> &scene_;
  const BlockCells<dim> &cells_;
  Operator &K_;
  CellStiffness<dim> stiffness_;
  /** The number of each unknown in deal.II's order. */
  std::array<unsigned int, Operator::n_dofs> dof_index_;
};
} // namespace

template <int dim>
std::vector<BlockPlace<dim>> own_blocks(const Mesh<dim> &mesh) {
  std::vector<BlockPlace<dim>> blocks;
  for (const auto &root : own_roots(mesh)) {
    const CellId id = identity_of(*root);
    BlockPlace<dim> &block =
      blocks.emplace_back(id.get_coarse_cell_id(), std::array<unsigned int, dim>());
    for (const unsigned int child : id.get_child_indices())
      for (int d = 0; d < dim; ++d)
        block.second[d] = 2 * block.second[d] + ((child >> d) & 1U);
  }
  return blocks;
}

template <int dim>
CellOperator<dim, double> make_fine_operator(const DisplacementSpace<dim> &space,
                                             const Scene<dim> &scene) {
  const auto roots = own_roots(space.mesh());
  const unsigned int n = 1U << (space.mesh().level() - space.mesh().subtree_level());
  const std::size_t n_cells = Utilities::fixed_power<dim>(std::size_t(n));
  BlockCells<dim> cells(roots.size() * n_cells);
  for (std::size_t block = 0; block < roots.size(); ++block)
    put_cells<dim>(typename DoFHandler<dim>::cell_iterator(*roots[block], &space.dofs()), {}, n,
                   cells.begin() + block * n_cells);
  // Own nodes come first, as in a vector of this rank.
  const Utilities::MPI::Partitioner &rows = *space.make_vector().get_partitioner();
  CellOperator<dim, double> K(
    std::make_shared<const BlockGrid<dim>>(roots.size(), n,
                                           [&](const std::size_t cell, const unsigned int v) {
                                             return static_cast<NodeNumber>(
                                               rows.global_to_local(cells[cell]->vertex_dof_index(
                                                 v, 0, cells[cell]->active_fe_index())) /
                                               dim);
                                           }),
    n_stiffness_points<dim>(scene.material->is_constant()));
  agree(space.mesh().communicator(), [&]() { MatrixFiller<dim>(space, scene, cells, K).fill(); });
  return K;
}

INSTANTIATE_FUNCTION(own_blocks);
INSTANTIATE_FUNCTION(make_fine_operator);
} // namespace Signorini
