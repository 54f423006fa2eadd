// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/bound_data.h>

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <vector>

namespace Signorini {
/**
 * The mesh of a stress in equilibrium, with the degrees of tractions.
 *
 * A graded mesh of u_h is that of the stress, too, or on curved bodies has the same cells with
 * edges that are straight inside of the body, and tractions of degree three at least. For u_h on a
 * uniform mesh of level L the stress has a mesh of its own over the same body: stresses of a high
 * degree need few cells. It is the mesh of level L - 4, or of a finer one with at least 64 cells,
 * split up to level L where the stress is less smooth: at corners and ends of sides, at ends of
 * contact, where Hooke's tensor jumps or varies much, where loads are not resolved, and where an
 * arc turns too much in a cell. Its edges inside of the body are straight. The degree rises with
 * the size of the cells.
 */
class EquilibrationMesh {
public:
  using Cell = Triangulation<2>::active_cell_iterator;

  explicit EquilibrationMesh(const BoundData &data);

  /** Returns whether the stress lives on the mesh of u_h. */
  static bool is_that_of_u(const BoundData &data) {
    return data.space.mesh().is_graded() && !data.space.mesh().is_curved();
  }
  bool is_own() const {
    return own_ != nullptr;
  }
  /** Returns whether every cell of u_h is a part of one cell of the stress. */
  bool is_aligned() const {
    return !own_ || aligns(data_);
  }
  /** Returns whether a mesh of its own would be aligned with that of u_h. */
  static bool aligns(const BoundData &data) {
    return !data.space.mesh().is_curved() && data.scene.geometry.distortion == 0.;
  }
  const Triangulation<2> &triangulation() const {
    return own_ ? *own_ : data_.space.mesh().triangulation();
  }
  /** Returns the degree of tractions on the sides of a cell, that on the boundary, where it rises
   * with the degree of stresses in the cell, and this one. */
  unsigned int degree(const Cell &cell) const;
  unsigned int boundary_degree(const Cell &cell) const;
  unsigned int inner_degree(const Cell &cell) const;
  /** Splits cells that are larger than those of an aligned mesh of u_h, and raises the degree of
   * stresses in others if @p by_degree. @return whether there is a change. */
  bool refine(const std::vector<Cell> &cells, bool by_degree);
  /** Returns the active cell that contains an active cell of an aligned mesh of u_h. */
  Cell find(const Cell &cell_of_u) const;

private:
  /** Splits the cells that are split in the mesh of u_h. */
  void split_like_u();
  bool is_rough(const Cell &cell, const std::vector<Point<2>> &singular) const;

  const BoundData &data_;
  /** The level of the mesh of u_h, and the degree of cells of this level. */
  unsigned int finest_, lowest_ = 2;
  std::unique_ptr<Triangulation<2>> own_;
  /** The increase of the stress degree per cell. */
  std::map<CellId, unsigned int> raised_;
};
} // namespace Signorini
