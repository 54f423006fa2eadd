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

  /** Returns how far a point lies outside (length). */
  double distance(const dealii::Point<2> &x) const
  {
    return centre.distance(x) - radius;
  }
};

/** The edges [first, last) of a chain, which are one segment or one arc. */
struct ChainPiece
{
  std::size_t first, last;
  Curve curve;
  /** The circle of an arc; empty for a segment. */
  std::optional<FittedCircle> circle;
};

/** The share of the radius by which nodes may lie off their circle. */
constexpr double arc_tolerance = 1e-6;

/**
 * Returns the circle through @p start and @p end with the least squares of distances from the
 * points between; where both are the same, the best circle. Infinite radii stand for straight
 * lines.
 */
FittedCircle fit_circle(const dealii::Point<2> &start,
                        const dealii::Point<2> &end,
                        const std::vector<dealii::Point<2>> &between);

/** Returns the whole chain as one arc. @throws InputError that begins with @p where if it is none.
 */
ChainPiece make_arc(const FileMesh &mesh,
                    const std::vector<FileMesh::Edge> &chain,
                    const std::string &where);

/** Divides a chain into segments and arcs: edges of second order that are bent are parts of arcs.
 */
std::vector<ChainPiece> divide_chain(const FileMesh &mesh,
                                     const std::vector<FileMesh::Edge> &chain);

/** Moves the vertices inside of a piece onto it. */
void move_onto(const ChainPiece &piece, const std::vector<FileMesh::Edge> &chain, FileMesh &mesh);
} // namespace Signorini
