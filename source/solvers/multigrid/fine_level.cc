// SPDX-License-Identifier: LGPL-2.1-or-later
// The blocks of the finest level, from deal.II's mesh and degrees of freedom.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/solvers/multigrid/cell_integration.h>

#include <deal.II/base/exceptions.h>

#include <array>
#include <functional>
#include <limits>

#include "multigrid_internal.h"

namespace Signorini
{
namespace
{
/** The numbers of Gauss points per direction where products are integrated: those of the assembly,
 * and those that V-cycles need. */
constexpr unsigned int n_points_of_products = 4, n_points_of_cycles = 2;

template <int dim>
using Place = std::array<unsigned int, dim>;

/** Calls f(active cell, its place in the block) for all active descendants of a cell, whose place
 * on its level is given. */
template <int dim, typename Cell, typename Function>
void for_descendants(const Cell &cell, const Place<dim> &place, const Function &f)
{
  if (!cell->has_children())
  {
    f(cell, place);
    return;
  }
  for (unsigned int child = 0; child < cell->n_children(); ++child)
  {
    Place<dim> child_place;
    for (int d = 0; d < dim; ++d)
      child_place[d] = 2 * place[d] + ((child >> d) & 1U);
    for_descendants<dim>(cell->child(child), child_place, f);
  }
}

/** Returns the lexicographic number of a place in a block with n places per direction. */
template <int dim>
std::size_t number(const Place<dim> &place, const std::size_t n)
{
  std::size_t result = 0;
  for (int d = dim; d-- > 0;)
    result = result * n + place[d];
  return result;
}

template <int dim>
std::size_t power(const std::size_t n)
{
  std::size_t result = n;
  for (int d = 1; d < dim; ++d)
    result *= n;
  return result;
}

/** Calls f(place in all blocks, cell, vertex) for all nodes of all blocks, once for each place. */
template <int dim, typename Function>
void for_nodes(const DisplacementSpace<dim> &space, const Function &f)
{
  const std::size_t n = std::size_t(1) << space.mesh().level();
  std::size_t begin = 0;
  for (const auto &block : space.dofs().cell_iterators_on_level(0))
  {
    for_descendants<dim>(block, Place<dim>{}, [&](const auto &cell, const Place<dim> &place) {
      for (unsigned int v = 0; v < (1U << dim); ++v)
      {
        // Every node once, from the cell behind it.
        Place<dim> node_data = place;
        bool is_seen_later = false;
        for (int d = 0; d < dim; ++d)
        {
          node_data[d] += (v >> d) & 1U;
          is_seen_later = is_seen_later || (((v >> d) & 1U) != 0 && place[d] + 1 < n);
        }
        if (is_seen_later)
          continue;
        f(begin + number<dim>(node_data, n + 1), cell, v);
      }
    });
    begin += power<dim>(n + 1);
  }
}

/** Returns the degrees of freedom divided by dim at all places of all blocks. */
template <int dim>
std::vector<NodeNumber> node_identities(const DisplacementSpace<dim> &space)
{
  std::vector<NodeNumber> places(space.mesh().triangulation().n_cells(0) *
                                 power<dim>((std::size_t(1) << space.mesh().level()) + 1));
  for_nodes<dim>(space, [&](const std::size_t place, const auto &cell, const unsigned int v) {
    const auto first = cell->vertex_dof_index(v, 0, cell->active_fe_index());
    Assert(first % dim == 0, ExcInternalError());
    places[place] = static_cast<NodeNumber>(first / dim);
  });
  return places;
}

/**
 * Returns the positions of the nodes in the body of size one.
 * @param numbers of nodes by place.
 */
template <int dim>
NodePlaces<dim> node_places(const DisplacementSpace<dim> &space,
                            const std::vector<NodeNumber> &numbers,
                            const unsigned int n_nodes)
{
  const Point<dim> origin = space.mesh().from_unit_body(Point<dim>());
  NodePlaces<dim> result(n_nodes);
  for_nodes<dim>(space, [&](const std::size_t place, const auto &cell, const unsigned int v) {
    const Tensor<1, dim> x = (cell->vertex(v) - origin) / space.mesh().size();
    for (int d = 0; d < dim; ++d)
      result[d][numbers[place]] = x[d];
  });
  return result;
}

/** Returns whether all descendants of a cell are congruent: it is a parallelogram or
 * parallelepiped, and only straight edges were halved. */
template <int dim, typename Cell>
bool has_congruent_descendants(const Mesh<dim> &mesh, const Cell &cell)
{
  if (mesh.is_curved() || mesh.n_nested_ancestors() < mesh.level())
    return false;
  for (unsigned int v = 0; v < (1U << dim); ++v)
  {
    Tensor<1, dim> difference = cell->vertex(v) - cell->vertex(0);
    for (int d = 0; d < dim; ++d)
      if (((v >> d) & 1U) != 0)
        difference -= cell->vertex(1U << d) - cell->vertex(0);
    if (!(difference.norm() < 1e-12 * cell->diameter()))
      return false;
  }
  return true;
}

/** Fills the matrices of a level, with the unknowns of a cell in the order of the kernels. */
template <int dim>
class MatrixFiller
{
public:
  using Matrices = CellMatrices<dim, double>;

  MatrixFiller(const DisplacementSpace<dim> &space,
               const Scene<dim> &scene,
               const BlockGrid<dim> &grid,
               Matrices &matrices)
    : space_(space)
    , scene_(scene)
    , grid_(grid)
    , matrices_(matrices)
    , stiffness_(space, scene)
  {
    for (unsigned int v = 0; v < (1U << dim); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        dof_index_[v * dim + c] = space.element().component_to_system_index(c, v);
  }

  /**
   * Fills the matrices.
   * @param numbers of nodes by place.
   */
  void fill(const std::vector<NodeNumber> &numbers)
  {
    find_shared();
    const bool all_shared = choose_shared();
    if (all_shared)
      return;
    const Mesh<dim> &mesh = space_.mesh();
    if (mesh.is_curved() || space_.strain_operator() != StrainOperator::symmetric_gradient)
    {
      store_others();
      integrate_cells([](const auto & /*cell*/) { return true; });
      return;
    }
    const NodePlaces<dim> places = node_places(space_, numbers, grid_.n_nodes());
    const CellIntegration<dim> integration(mesh, *scene_.material);
    if (scene_.material->is_constant())
    {
      matrices_.rule = make_point_rule<dim, double>(
        places, grid_.n_nodes(), integration.constant_moduli(), n_points_of_products);
      for (int &batch_storage : matrices_.batch_storage)
        batch_storage = batch_storage < 0 ? Matrices::integrated : batch_storage;
      return;
    }
    store_others();
    integration.integrate(matrices_, grid_, places);
    integrate_cells([&](const auto &cell) { return needs_cuts<dim>(scene_.kinks, cell); });
  }

private:
  /** Integrates the matrices of the cells that satisfy the condition one by one, and copies shared
   * ones. */
  template <typename Condition>
  void integrate_cells(const Condition &condition)
  {
    std::size_t begin = 0;
    const std::size_t per_block = power<dim>(grid_.n());
    for (const auto &block : space_.mesh().triangulation().cell_iterators_on_level(0))
    {
      if (shared_by_block_[begin / per_block] >= 0)
        copy_shared(begin, begin + per_block);
      else
        for_descendants<dim>(block, Place<dim>{}, [&](const auto &cell, const Place<dim> &place) {
          if (condition(cell))
            store(begin + number<dim>(place, grid_.n()),
                  stiffness_(typename CellStiffness<dim>::CellIterator(cell)));
        });
      begin += per_block;
    }
  }

  /** Finds one matrix for each shape of blocks with congruent cells. */
  void find_shared()
  {
    std::vector<typename CellStiffness<dim>::Matrix> known;
    for (const auto &block : space_.mesh().triangulation().cell_iterators_on_level(0))
    {
      int found = -1;
      if (scene_.material->is_constant() && has_congruent_descendants<dim>(space_.mesh(), block))
      {
        auto cell = block;
        while (cell->has_children())
          cell = cell->child(0);
        const auto matrix = stiffness_.share(typename CellStiffness<dim>::CellIterator(cell));
        const auto same = std::find(known.begin(), known.end(), matrix);
        found = static_cast<int>(same - known.begin());
        if (same == known.end())
        {
          known.push_back(matrix);
          for (const unsigned int i : dof_index_)
            for (const unsigned int j : dof_index_)
              matrices_.shared.push_back(0.5 * ((*matrix)(i, j) + (*matrix)(j, i)));
        }
      }
      shared_by_block_.push_back(found);
    }
  }
  /**
   * Chooses the batches with one matrix.
   * @return whether all have one.
   */
  bool choose_shared()
  {
    const std::size_t per_block = power<dim>(grid_.n());
    bool all_shared = true;
    for (std::size_t batch = 0; batch < grid_.n_batches(); ++batch)
    {
      const std::size_t first = batch * n_lanes / per_block,
                        last = (std::min((batch + 1) * n_lanes, grid_.n_cells()) - 1) / per_block;
      int common = shared_by_block_[first];
      for (std::size_t block = first; block <= last; ++block)
        if (shared_by_block_[block] != common)
          common = -1;
      matrices_.batch_storage[batch] = common;
      all_shared = all_shared && common >= 0;
    }
    return all_shared;
  }
  /** Allocates the matrices of all other batches. */
  void store_others()
  {
    std::size_t n_stored = 0;
    for (const int batch_storage : matrices_.batch_storage)
      n_stored += batch_storage < 0 ? 1 : 0;
    matrices_.stored.reserve(n_stored * Matrices::batch_size);
    for (std::size_t batch = 0; batch < grid_.n_batches(); ++batch)
      if (matrices_.batch_storage[batch] < 0)
        matrices_.store(batch);
  }
  /** Writes a shared matrix where a batch mixes blocks. */
  void copy_shared(const std::size_t begin, const std::size_t end)
  {
    const double *const matrix =
      &matrices_
         .shared[shared_by_block_[begin / (end - begin)] * dof_index_.size() * dof_index_.size()];
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const std::size_t batch = cell / n_lanes;
      if (matrices_.is_shared(batch))
      {
        cell = (batch + 1) * n_lanes - 1;
        continue;
      }
      double *const target = matrices_.stored_matrices(batch) + cell % n_lanes;
      for (unsigned int i = 0; i < dof_index_.size(); ++i)
        for (unsigned int j = 0; j <= i; ++j)
          target[Matrices::entry(i, j) * n_lanes] = matrix[i * dof_index_.size() + j];
    }
  }
  void store(const std::size_t cell, const FullMatrix<double> &matrix)
  {
    double *const target = matrices_.stored_matrices(cell / n_lanes) + cell % n_lanes;
    for (unsigned int i = 0; i < dof_index_.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        target[Matrices::entry(i, j) * n_lanes] = matrix(dof_index_[i], dof_index_[j]);
  }

  const DisplacementSpace<dim> &space_;
  const Scene<dim> &scene_;
  const BlockGrid<dim> &grid_;
  Matrices &matrices_;
  CellStiffness<dim> stiffness_;
  /** The number of each unknown in deal.II's order. */
  std::array<unsigned int, Matrices::n_dofs> dof_index_;
  /** The number of the matrix that the cells of a block share, or -1. */
  std::vector<int> shared_by_block_;
};

/** Returns the constraints of the space, which never join two nodes on a mesh without hanging
 * nodes. */
template <int dim>
ConstrainedNodes<dim> conditions_of(const DisplacementSpace<dim> &space,
                                    const std::vector<NodeNumber> &identities)
{
  const auto &constraints = space.constraints();
  ConstrainedNodes<dim> conditions;
  for (NodeNumber node = 0; node < identities.size(); ++node)
  {
    const auto first = static_cast<types::global_dof_index>(identities[node]) * dim;
    bool is_free = true;
    Tensor<2, dim> T;
    for (unsigned int c = 0; c < dim; ++c)
      if (const auto *const line = constraints.get_constraint_entries(first + c))
      {
        is_free = false;
        for (const auto &[other, weight] : *line)
        {
          AssertThrow(other >= first && other < first + dim,
                      ExcMessage("Multigrid: a condition joins two nodes."));
          T[c][other - first] = weight;
        }
      }
      else
        T[c][c] = 1.;
    if (!is_free)
      conditions.push_back({node, T, projection_onto_range(T)});
  }
  return conditions;
}
} // namespace

template <int dim>
FineLevel<dim>::FineLevel(const DisplacementSpace<dim> &space, const Scene<dim> &scene)
  : places(node_identities(space))
  , grid(std::make_shared<const BlockGrid<dim>>(space.mesh().triangulation().n_cells(0),
                                                1U << space.mesh().level(),
                                                places,
                                                space.dofs().n_dofs() / dim))
  , matrices(grid->n_batches())
  , conditions(conditions_of(space, grid->identities()))
{
  MatrixFiller<dim>(space, scene, *grid, matrices).fill(places);
}

template <int dim>
CellMatrices<dim, float> FineLevel<dim>::matrices_in_single_precision() const
{
  std::shared_ptr<const PointRule<dim, float>> rule;
  if (matrices.rule != nullptr)
    rule = make_point_rule<dim, float>(
      matrices.rule->places, grid->n_nodes(), matrices.rule->moduli, n_points_of_cycles);
  return CellMatrices<dim, float>(matrices, rule);
}

template struct FineLevel<2>;
template struct FineLevel<3>;
} // namespace Signorini
