// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** A coarse mesh between sides, of cells whose corners are counter-clockwise. */
struct CoarseMesh {
  /** An edge of the boundary; the body lies on its left. */
  struct Edge {
    unsigned int start, end;
    unsigned int side;
    /** The segment or the arc on which the edge lies, a piece of the side. */
    const Curve *piece;
  };

  std::vector<Point<2>> vertices;
  std::vector<std::vector<unsigned int>> cells;
  std::vector<Edge> edges;
};

/** Splits cells with any number of corners into quadrilaterals, one for each corner, by their
 * centres and the middles of their edges. Those of the boundary lie on its curves. */
CoarseMesh split_cells(const CoarseMesh &mesh);

/** Returns a cell with edges on arcs of which the determinant of the map is not positive somewhere,
 * or below @p min_ratio times the largest one. */
std::optional<std::size_t> find_folded_cell(const CoarseMesh &mesh, double min_ratio);

/** Returns the body with this mesh of quadrilaterals. Edges on arcs follow them in every
 * refinement, and their cells are transfinite interpolations of their edges. */
Geometry<2> make_body(const std::vector<Side<2>> &sides, const CoarseMesh &mesh);

constexpr unsigned int max_coarse_cells = 300000;

/**
 * Returns the body between closed loops of sides, each of which begins where the one before it
 * ends, with the body on the left: first the sides around the body, then a closed side for each
 * hole. The body is filled with triangles whose angles are not small (where the sides let them),
 * each of which is split into three coarse cells.
 *
 * @param mesh_size the longest edge of the triangles (length); 0: as long as their angles allow.
 * @param where the beginning of messages.
 * @throws InputError if sides cross or touch, or a hole lies outside of the body, or if no mesh of
 * at most max_coarse_cells cells was found.
 */
Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides, double mesh_size,
                               const std::string &where);
} // namespace Signorini
