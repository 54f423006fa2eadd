// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria_description.h>

#include <optional>
#include <vector>

#include "outline_checks.h"

namespace Signorini
{
/** A coarse mesh between sides. */
struct OutlineMesh
{
  /** Of cells that are curved; other cells have none, edges on circles[k] have k + 1. */
  static constexpr dealii::types::manifold_id curved_cells = 0;

  std::vector<dealii::Point<2>> vertices;
  std::vector<dealii::CellData<2>> cells;
  /** Edges on sides, with the numbers of the sides. */
  dealii::SubCellData lines;
  /** The centres of arcs. */
  std::vector<dealii::Point<2>> circles;
};

/**
 * The mesh of make_outlined_body(), with chords of at most @p step (radians) on arcs; none if
 * chords cross or a cell comes out folded.
 * @throws InputError beginning with @p where if there are more than @p most_cells.
 */
std::optional<OutlineMesh> mesh_outline(const std::vector<Side<2>> &sides,
                                        const std::vector<Loop> &loops,
                                        double mesh_size,
                                        double step,
                                        std::size_t most_cells,
                                        const std::string &where);
} // namespace Signorini
