// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/curve.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <string>

namespace Signorini
{
/** A circle that edges lie on. */
struct FittedCircle
{
  dealii::Point<2> centre;
  double radius;

  /** How far a point lies outside (length). */
  double distance(const dealii::Point<2> &x) const
  {
    return centre.distance(x) - radius;
  }
};

/** Edges in a row, [first, last) of a chain, that are one segment or one arc. */
struct ChainPiece
{
  std::size_t first, last;
  Curve curve;
  /** Only of arcs. */
  std::optional<FittedCircle> circle;
};

/** Nodes may lie off their circle by this share of its radius. */
constexpr double arc_tolerance = 1e-6;

/**
 * The circle through @p start and @p end with the least squares of distances from the points
 * between; where both are the same, the best circle. Infinite radii stand for straight lines.
 */
FittedCircle fit_circle(const dealii::Point<2> &start,
                        const dealii::Point<2> &end,
                        const std::vector<dealii::Point<2>> &between);

/** All of a chain as one arc. @throws InputError that begins with @p where if it is none. */
ChainPiece make_arc(const FileMesh &mesh,
                    const std::vector<FileMesh::Edge> &chain,
                    const std::string &where);

/** A chain in segments and arcs: edges of second order that are bent are parts of arcs. */
std::vector<ChainPiece> divide_chain(const FileMesh &mesh,
                                     const std::vector<FileMesh::Edge> &chain);

/** Moves the vertices inside of a piece onto it. */
void move_onto(const ChainPiece &piece, const std::vector<FileMesh::Edge> &chain, FileMesh &mesh);
} // namespace Signorini
