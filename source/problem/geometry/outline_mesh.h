// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>
#include <signorini/problem/geometry/geometry.h>

#include <deal.II/grid/tria_description.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** Consecutive sides [first, last) that return to where they start. */
struct Loop
{
  std::size_t first, last;
};

/** Returns the loops that sides in this order form. @throws InputError if they do not. */
std::vector<Loop> find_loops(const std::vector<Side<2>> &sides,
                             double size,
                             const std::string &where);

/** Checks the sides and their loops. @throws InputError if sides cross or touch elsewhere than at
 * common ends, or if the loops are not one around the body and others inside of it around holes. */
void check_outline(const std::vector<Side<2>> &sides,
                   const std::vector<Loop> &loops,
                   double size,
                   const std::string &where);

/** A coarse mesh between sides. */
struct OutlineMesh
{
  std::vector<dealii::Point<2>> vertices;
  std::vector<CellData<2>> cells;
  /** The edges on sides, with the numbers of the sides. */
  SubCellData lines;
  /** The centres of arcs: edges on circles[k] have the manifold k. */
  std::vector<dealii::Point<2>> circles;
  /** The cells with an arc: the k-th has the manifold circles.size() + k. */
  std::vector<ArcCell> curved_cells;
};

/**
 * Returns the mesh of make_outlined_body(), with chords of at most @p step (radians) on arcs; none
 * if chords cross or a cell comes out folded.
 * @throws InputError beginning with @p where if there are more than @p max_cells.
 */
std::optional<OutlineMesh> mesh_outline(const std::vector<Side<2>> &sides,
                                        const std::vector<Loop> &loops,
                                        double mesh_size,
                                        double step,
                                        std::size_t max_cells,
                                        const std::string &where);
} // namespace Signorini
