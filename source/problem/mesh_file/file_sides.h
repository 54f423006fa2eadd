// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/curve.h>
#include <signorini/problem/geometry/geometry.h>
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

/** The sides of the body that the edges of the boundary form. */
struct FileSides
{
  /** An edge with the numbers of its side and of its circle. */
  struct Edge
  {
    FileMesh::Edge edge;
    unsigned int side;
    /** The index of the circle in centres; negative for a straight edge. */
    int circle;
  };

  /** The sides: one for every chain of edges with one name, counter-clockwise around the body. */
  std::vector<Side<2>> sides;
  std::vector<Edge> edges;
  std::vector<dealii::Point<2>> centres;
};

/**
 * Finds the sides. A name that has several chains of edges gives name.1, name.2, ... from left to
 * right by their first points. Straight edges in a row on a line become one segment, edges of
 * second order arcs: as long as possible, at least one for each edge. The edges of a side in
 * @p arcs are one arc per chain. Vertices move onto their segments and arcs, by less than 1e-6 of
 * the length or radius.
 * @param where how messages about @p arcs begin.
 * @throws InputError if an arc is none, or a name is unknown or found twice.
 */
FileSides find_sides(FileMesh &mesh,
                     const std::vector<std::string> &arcs,
                     const std::string &where);

/** Adds the names and the loops of the boundary to a mesh that has its vertices and cells.
 * @param cells those of the mesh, with the nodes of the file, in the same order.
 * @throws InputError if edges, lines and names do not fit together. */
void add_boundary(const GmshMesh &gmsh,
                  const std::vector<GmshMesh::Element> &cells,
                  FileMesh &mesh);
} // namespace Signorini
