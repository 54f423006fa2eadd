// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/cell_id.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * Returns the level whose cells are the roots of the subtrees that ranks own: the first one with at
 * least eight cells per rank, or the coarse mesh on a single rank.
 */
unsigned int level_of_subtrees(double n_coarse_cells, unsigned int dim, unsigned int n_ranks);

/** Returns the identity of a cell, the same on any number of ranks: its cell of the coarse mesh,
 * and the children that lead to it. (The identities of a mesh that ranks share contain p4est's
 * order of the coarse mesh.) */
template <int dim>
CellId identity_of(const CellAccessor<dim, dim> &cell) {
  int tree = cell.index();
  if (cell.level() > 0) {
    auto root = cell.parent();
    while (root->level() > 0)
      root = root->parent();
    tree = root->index();
  }
  const CellId id = cell.id();
  const auto children = id.get_child_indices();
  return {static_cast<types::coarse_cell_id>(tree),
          std::vector<std::uint8_t>(children.begin(), children.end())};
}

/** Returns the identity of the cell @p n_generations before. */
inline CellId ancestor_of(const CellId &cell, const unsigned int n_generations) {
  const auto children = cell.get_child_indices();
  return {cell.get_coarse_cell_id(),
          std::vector<std::uint8_t>(children.begin(), children.end() - n_generations)};
}

/**
 * The mesh T^h of one level, quadrilaterals or hexahedra, with T^{2h} as its parents.
 *
 * A single rank stores the whole mesh. Of several ranks each owns whole subtrees of cells of one
 * coarse level (subtree_level()), and stores them, their neighbours and the coarse mesh.
 */
template <int dim>
class Mesh {
public:
  /**
   * Refines the coarse mesh @p level times. A distortion moves the interior vertices of
   * @p coarsest_level, so that finer levels stay nested in it; on one rank only.
   * @throws InputError if it leaves a cell that is not convex.
   */
  Mesh(const Geometry<dim> &geometry, unsigned int coarsest_level, unsigned int level,
       MPI_Comm communicator);

  /**
   * Makes a mesh that is refined where @p must_split returns true, until no cell has to be split.
   * It begins with @p base_level refinements of the coarse mesh, which without distortion follow
   * the @p guides. Cells that share an edge differ by at most one refinement. The maps of curved
   * cells have the degree @p mapping_degree. Serial.
   * @param must_split also gets the number of splits of the cell since the first mesh.
   */
  using Splits = std::function<bool(const typename Triangulation<dim>::active_cell_iterator &cell,
                                    unsigned int n_splits)>;
  Mesh(const Geometry<dim> &geometry, unsigned int base_level, const MeshGuides<dim> &guides,
       const Splits &must_split, unsigned int mapping_degree);

  const Triangulation<dim> &triangulation() const {
    return *triangulation_;
  }
  const Mapping<dim> &mapping() const {
    return *mapping_;
  }
  /** Returns the map onto the body of size one, (x - lower)/l with the length l of size(). A
   * stiffness matrix that is integrated with it depends neither on the unit of length nor on the
   * position of the origin, to the last digit. */
  const Mapping<dim> &unit_mapping() const {
    return *unit_mapping_;
  }
  /** Returns the point that unit_mapping() maps to @p x. */
  Point<dim> from_unit_body(const Point<dim> &x) const {
    return lower_ + size_ * (x - Point<dim>());
  }
  /** Returns the longest edge of the box around the body (length). */
  double size() const {
    return size_;
  }
  /** Returns whether cells are curved: their edges are parabolas, close to the sides to the order
   * h^4. */
  bool is_curved() const {
    return curved_;
  }
  /** Returns whether cells of T^{2h} are no images of the maps of their children: in space maps are
   * trilinear, and vertices lie on curved sides. */
  bool has_bent_parents() const {
    return has_bent_parents_;
  }
  /** Returns whether the body is one of revolution: the maps give dx and ds the weight 2 pi x. */
  bool is_axisymmetric() const {
    return axisymmetric_;
  }
  MPI_Comm communicator() const {
    return triangulation_->get_communicator();
  }
  /** Returns the number of refinements of the coarse mesh. */
  unsigned int level() const {
    return triangulation_->n_global_levels() - 1;
  }
  /** Returns the level whose cells are the roots of the subtrees that ranks own. */
  unsigned int subtree_level() const {
    return subtree_level_;
  }
  /** Returns whether several ranks share the mesh. */
  bool is_shared() const {
    return Utilities::MPI::n_mpi_processes(communicator()) > 1;
  }
  /** Returns the cell with an identity; this rank must have it. */
  typename Triangulation<dim>::cell_iterator cell_at(const CellId &identity) const {
    typename Triangulation<dim>::cell_iterator cell(
      triangulation_.get(), 0, static_cast<int>(identity.get_coarse_cell_id()));
    for (const unsigned int child : identity.get_child_indices())
      cell = cell->child(child);
    return cell;
  }
  /** Returns the lengths of the shortest and of the longest edge. Collective. */
  std::pair<double, double> range_of_edges() const;
  /** Returns h: the longest edge (length). */
  double longest_edge() const {
    return range_of_edges().second;
  }
  /** Returns the number of splits of a cell since the mesh was uniform. */
  unsigned int splits(const typename Triangulation<dim>::cell_iterator &cell) const {
    return cell->level() - uniform_levels_;
  }
  /** Returns the number of levels before this one whose cells are unions of cells of this one: all
   * of them, or those from the level at which vertices were moved. */
  unsigned int n_nested_ancestors() const {
    return n_nested_ancestors_;
  }
  /** Returns whether the mesh was refined where must_split returned true. */
  bool is_graded() const {
    return is_graded_;
  }
  /** Returns whether T^{2h} exists. */
  bool has_parents() const {
    return n_nested_ancestors_ > 0;
  }

private:
  /** Makes the maps of the given degree, for curved bodies. */
  void make_mappings(unsigned int degree);

  std::unique_ptr<parallel::TriangulationBase<dim>> triangulation_;
  unsigned int subtree_level_;
  bool curved_, has_bent_parents_, is_graded_, axisymmetric_;
  Point<dim> lower_;
  double size_;
  std::unique_ptr<const Mapping<dim>> mapping_, unit_mapping_;
  unsigned int n_nested_ancestors_;
  unsigned int uniform_levels_;
};
} // namespace Signorini
