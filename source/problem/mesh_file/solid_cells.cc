// SPDX-License-Identifier: LGPL-2.1-or-later
// From a mesh in space to hexahedra in order, with their vertices on the surfaces of the sides.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "solid_mesh.h"

namespace Signorini {
namespace {
/** Bounds of determinants at the corners of hexahedra: as a share of their mean, and of the product
 * of the lengths of the three edges. */
constexpr double min_share_of_mean = 1e-3, min_share_of_edges = 1e-6;

/** The share of the body's size within which a vertex lies on a surface. */
constexpr double on_surface = 1e-13;

/** Hexahedra of a mesh file, or pieces of its cells. */
struct Pieces {
  /** The nodes in whose middle each vertex lies, in order: one, or those of an edge, a face or a
   * cell. */
  std::vector<std::vector<unsigned int>> nodes;
  /** The vertices in the order of deal.II. */
  std::vector<std::array<unsigned int, 8>> cells;
  /** The indices of the elements of the file. */
  std::vector<unsigned int> element;
};

using Positions = std::vector<Point<3>>;

/** Divides cells. */
class CellSplitter {
public:
  explicit CellSplitter(const FileMesh<3> &mesh)
    : mesh_(mesh) {
    is_split_ = std::any_of(mesh.cells.begin(), mesh.cells.end(),
                            [](const auto &cell) { return cell.n_corners != 8; });
    for (unsigned int c = 0; c < mesh.cells.size(); ++c) {
      const auto &cell = mesh.cells[c];
      if (is_split_)
        split(cell);
      else
        pieces_.cells.push_back(
          {{vertex(cell, {0}), vertex(cell, {1}), vertex(cell, {3}), vertex(cell, {2}),
            vertex(cell, {4}), vertex(cell, {5}), vertex(cell, {7}), vertex(cell, {6})}});
      pieces_.element.resize(pieces_.cells.size(), c);
    }
  }

  Pieces pieces() && {
    return std::move(pieces_);
  }

private:
  /** Returns the vertex in the middle of corners of a cell. */
  unsigned int vertex(const FileMesh<3>::Element &cell, std::vector<unsigned int> corners) {
    for (unsigned int &corner : corners)
      corner = cell.nodes[corner];
    std::sort(corners.begin(), corners.end());
    const auto [entry, is_new] = number_.emplace(corners, pieces_.nodes.size());
    if (is_new)
      pieces_.nodes.push_back(corners);
    return entry->second;
  }

  /** Adds one hexahedron for each corner of a cell, at which three edges and three faces meet. */
  void split(const FileMesh<3>::Element &cell) {
    const SolidShape &shape = solid_shape(cell.n_corners);
    std::vector<unsigned int> all;
    for (unsigned int v = 0; v < cell.n_corners; ++v)
      all.push_back(v);
    for (const unsigned int v : all) {
      // Around the corner every face leads from one edge to the next one.
      std::map<unsigned int, std::pair<unsigned int, std::vector<unsigned int>>> turn;
      for (const std::vector<unsigned int> &face : shape.faces)
        for (std::size_t i = 0, n = face.size(); i < n; ++i)
          if (face[i] == v)
            turn[face[(i + 1) % n]] = {face[(i + n - 1) % n], face};
      const unsigned int a = turn.begin()->first, c = turn[a].first, b = turn[c].first;
      pieces_.cells.push_back(
        {{vertex(cell, {v}), vertex(cell, {v, a}), vertex(cell, {v, b}),
          vertex(cell, turn[b].second), vertex(cell, {v, c}), vertex(cell, turn[a].second),
          vertex(cell, turn[c].second), vertex(cell, all)}});
    }
  }

  const FileMesh<3> &mesh_;
  bool is_split_;
  Pieces pieces_;
  std::map<std::vector<unsigned int>, unsigned int> number_;
};

/** Returns the vertices in the middles of their nodes. */
Positions drawn_positions(const FileMesh<3> &mesh, const Pieces &pieces) {
  Positions drawn;
  for (const std::vector<unsigned int> &nodes : pieces.nodes) {
    std::vector<Point<3>> points;
    for (const unsigned int node : nodes)
      points.push_back(mesh.nodes[node].x);
    drawn.push_back(mean_of(points));
  }
  return drawn;
}

/** Checks the determinants of the maps of all cells at their corners. @throws InputError, with
 * what is @p allowed. */
void check_shapes(const FileMesh<3> &mesh, const Pieces &pieces, const Positions &x,
                  const std::string &reason, const std::string &allowed) {
  for (unsigned int c = 0; c < pieces.cells.size(); ++c) {
    const std::array<unsigned int, 8> &cell = pieces.cells[c];
    std::array<double, 8> determinant, share;
    double mean = 0.;
    for (unsigned int v = 0; v < 8; ++v) {
      std::array<Tensor<1, 3>, 3> edges;
      for (unsigned int d = 0; d < 3; ++d)
        edges[d] = x[cell[v | 1 << d]] - x[cell[v & ~(1U << d)]];
      determinant[v] = edges[0] * cross_product_3d(edges[1], edges[2]);
      share[v] = determinant[v] / (edges[0].norm() * edges[1].norm() * edges[2].norm());
      mean += determinant[v] / 8.;
    }
    for (unsigned int v = 0; v < 8; ++v) {
      if (determinant[v] > min_share_of_mean * mean && share[v] > min_share_of_edges)
        continue;
      // Every piece has one corner of its element, the first vertex.
      const auto &nodes =
        pieces.nodes[cell[v]].size() == 1 ? pieces.nodes[cell[v]] : pieces.nodes[cell[0]];
      const auto &element = mesh.cells[pieces.element[c]];
      throw input_error(mesh.location(element.line), "the element ", element.tag,
                        " is flat or turned inside out at node ", mesh.nodes[nodes[0]].tag, reason,
                        ", allowed: ", allowed);
    }
  }
}

/** Returns the faces of the boundary to which all nodes of each vertex belong. */
std::vector<std::vector<unsigned int>> faces_of_vertices(const FileMesh<3> &mesh,
                                                         const Pieces &pieces,
                                                         const std::vector<BoundaryFace> &faces) {
  std::vector<std::vector<unsigned int>> at_node(mesh.nodes.size()), found;
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (const unsigned int node : faces[f].corners)
      at_node[node].push_back(f);
  for (const std::vector<unsigned int> &nodes : pieces.nodes) {
    found.push_back(at_node[nodes[0]]);
    for (const unsigned int node : nodes) {
      std::vector<unsigned int> common;
      std::set_intersection(found.back().begin(), found.back().end(), at_node[node].begin(),
                            at_node[node].end(), std::back_inserter(common));
      found.back() = common;
    }
  }
  return found;
}

/** Returns a point on several surfaces: onto each in turn until nothing moves. */
Point<3> project_on_all(Point<3> x, const std::vector<const Surface *> &surfaces,
                        const double tolerance) {
  constexpr unsigned int max_turns = 1000;
  for (unsigned int turn = 0; turn < max_turns; ++turn) {
    const Point<3> before = x;
    for (const Surface *surface : surfaces)
      if (x.distance(surface->project(x)) > tolerance)
        x = surface->project(x);
    if (x == before)
      break;
  }
  return x;
}

/** Returns the vertices on the surfaces of their sides; middles are those of moved nodes. */
Positions move_onto_surfaces(const Pieces &pieces,
                             const std::vector<std::vector<unsigned int>> &faces_at,
                             const std::vector<BoundaryFace> &faces, const SolidSides &sides,
                             Positions drawn) {
  double size = 0.;
  for (const Point<3> &x : drawn)
    size = std::max(size, x.distance(drawn[0]));
  std::map<unsigned int, unsigned int> vertex_of_node;
  for (unsigned int v = 0; v < drawn.size(); ++v)
    if (pieces.nodes[v].size() == 1)
      vertex_of_node[pieces.nodes[v][0]] = v;
  for (const bool are_nodes : {true, false})
    for (unsigned int v = 0; v < drawn.size(); ++v) {
      if ((pieces.nodes[v].size() == 1) != are_nodes)
        continue;
      std::vector<Point<3>> points;
      for (const unsigned int node : pieces.nodes[v])
        points.push_back(drawn[vertex_of_node.at(node)]);
      std::set<unsigned int> at;
      for (const unsigned int f : faces_at[v])
        at.insert(faces[f].side);
      std::vector<const Surface *> surfaces;
      for (const unsigned int side : at)
        surfaces.push_back(&sides.sides[side].second);
      drawn[v] = project_on_all(mean_of(points), surfaces, on_surface * size);
    }
  return drawn;
}

/** Returns whether a direction points more along the coordinates than another one: first along the
 * one with this number, then along those that follow. Directions that differ by less than 1e-6 are
 * equal. */
bool points_more_along(const unsigned int first, const Tensor<1, 3> &a, const Tensor<1, 3> &b) {
  for (unsigned int d = first; d < first + 3; ++d)
    if (std::abs(a[d % 3] - b[d % 3]) > 1e-6)
      return a[d % 3] > b[d % 3];
  return false;
}

/** Lets the first coordinate of a cell's map point along x and the second one along y as far as
 * possible: then cells of a regular mesh are translations of one another. */
void turn_to_coordinates(std::array<unsigned int, 8> &cell, const Positions &x) {
  // The directions of the coordinates 0, 1, 2, and 3, 4, 5 against them.
  std::array<Tensor<1, 3>, 6> directions;
  for (unsigned int d = 0; d < 3; ++d) {
    for (unsigned int v = 0; v < 8; ++v)
      directions[d] += ((v >> d & 1) == 1 ? 1. : -1.) * x[cell[v]];
    directions[d] /= directions[d].norm();
    directions[d + 3] = -directions[d];
  }
  std::array<unsigned int, 3> axes = {0, 0, 0};
  for (unsigned int d = 1; d < 6; ++d)
    if (points_more_along(0, directions[d], directions[axes[0]]))
      axes[0] = d;
  axes[1] = (axes[0] + 1) % 3;
  for (unsigned int d = 0; d < 6; ++d)
    if (d % 3 != axes[0] % 3 && points_more_along(1, directions[d], directions[axes[1]]))
      axes[1] = d;
  // A turned cell has no mirror image.
  axes[2] = 3 - axes[0] % 3 - axes[1] % 3;
  const bool is_even = (axes[0] + 1) % 3 == axes[1] % 3;
  if (is_even == (axes[0] / 3 != axes[1] / 3))
    axes[2] += 3;
  const std::array<unsigned int, 8> before = cell;
  for (unsigned int v = 0; v < 8; ++v) {
    unsigned int old = 0;
    for (unsigned int d = 0; d < 3; ++d)
      old |= ((v >> d & 1) ^ (axes[d] / 3)) << axes[d] % 3;
    cell[v] = before[old];
  }
}

/** Turns cells to the coordinates and sorts them along Hilbert's curve through their centres. */
void sort_pieces(Pieces &pieces, const Positions &x) {
  Positions centres;
  for (std::array<unsigned int, 8> &cell : pieces.cells) {
    std::vector<Point<3>> corners;
    for (const unsigned int v : cell)
      corners.push_back(x[v]);
    centres.push_back(mean_of(corners));
    turn_to_coordinates(cell, x);
  }
  Pieces sorted;
  for (const unsigned int i : order_on_curve(centres)) {
    sorted.cells.push_back(pieces.cells[i]);
    sorted.element.push_back(pieces.element[i]);
  }
  pieces.cells = std::move(sorted.cells);
  pieces.element = std::move(sorted.element);
}

/** Names the regions of a body that has several. */
void add_solid_regions(const FileMesh<3> &mesh, const Pieces &pieces, Solid &solid) {
  std::set<std::string> names;
  for (const auto &cell : mesh.cells)
    names.insert(mesh.name_of(cell, 3));
  if (names.size() == 1)
    return;
  solid.regions.assign(names.begin(), names.end());
  for (const unsigned int element : pieces.element)
    solid.region_of_cell.push_back(
      std::distance(names.begin(), names.find(mesh.name_of(mesh.cells[element], 3))));
}

/** Adds cells, their vertices in the order of the cells, and their faces on the boundary. */
void add_cells(const Pieces &pieces, const Positions &x,
               const std::vector<std::vector<unsigned int>> &faces_at,
               const std::vector<BoundaryFace> &faces, Solid &solid) {
  // With outward normals.
  constexpr std::array<std::array<unsigned int, 4>, 6> vertices_of_face = {{{{0, 4, 2, 6}},
                                                                            {{1, 3, 5, 7}},
                                                                            {{0, 1, 4, 5}},
                                                                            {{2, 6, 3, 7}},
                                                                            {{0, 2, 1, 3}},
                                                                            {{4, 5, 6, 7}}}};
  constexpr unsigned int unused = std::numeric_limits<unsigned int>::max();
  std::vector<unsigned int> number(x.size(), unused);
  for (const std::array<unsigned int, 8> &cell : pieces.cells) {
    solid.cells.emplace_back();
    for (unsigned int v = 0; v < 8; ++v) {
      if (number[cell[v]] == unused) {
        number[cell[v]] = solid.vertices.size();
        solid.vertices.push_back(x[cell[v]]);
      }
      solid.cells.back()[v] = number[cell[v]];
    }
    for (const std::array<unsigned int, 4> &face : vertices_of_face) {
      // The face of the boundary on which all vertices lie.
      std::vector<unsigned int> at = faces_at[cell[face[0]]];
      for (const unsigned int v : face) {
        std::vector<unsigned int> common;
        const std::vector<unsigned int> &others = faces_at[cell[v]];
        std::set_intersection(at.begin(), at.end(), others.begin(), others.end(),
                              std::back_inserter(common));
        at = common;
      }
      if (at.empty())
        continue;
      solid.faces.emplace_back();
      for (unsigned int i = 0; i < 4; ++i)
        solid.faces.back().vertices[i] = number[cell[face[i]]];
      solid.faces.back().side = faces[at[0]].side;
    }
  }
}

/** Returns a remark on cells that were split; empty without them. */
std::string split_note(const FileMesh<3> &mesh) {
  std::map<unsigned int, std::size_t> n;
  for (const auto &cell : mesh.cells)
    ++n[cell.n_corners];
  std::vector<std::string> notes;
  if (n[4] > 0)
    notes.push_back("each tetrahedron of the mesh is split into four hexahedra (" +
                    std::to_string(n[4]) + " tetrahedra)");
  if (n[6] > 0)
    notes.push_back("each prism of the mesh is split into six hexahedra (" + std::to_string(n[6]) +
                    " prisms)");
  if (n[4] > 0)
    notes.emplace_back("good tetrahedra take 3 to 4 times as many unknowns as hexahedra for the "
                       "same error, flat ones 10 times");
  return join(notes, "; ");
}
} // namespace

SolidBody make_solid(FileMesh<3> mesh, const SurfaceKinds &kinds, const std::string &where) {
  std::set<unsigned int> used;
  for (const auto &cell : mesh.cells)
    used.insert(cell.nodes.begin(), cell.nodes.begin() + cell.n_corners);
  std::vector<const FileMesh<3>::Node *> nodes;
  for (const unsigned int node : used)
    nodes.push_back(&mesh.nodes[node]);
  check_cracks(mesh, nodes);
  turn_cells_outwards(mesh);
  Pieces pieces = CellSplitter(mesh).pieces();
  const Positions drawn = drawn_positions(mesh, pieces);
  check_shapes(mesh, pieces, drawn, "",
               "elements whose determinants at all corners are above " +
                 number_text(min_share_of_mean) + " of their mean.");
  std::vector<BoundaryFace> faces = find_boundary(mesh);
  const SolidSides sides = find_sides(mesh, faces, kinds, where);
  const auto faces_at = faces_of_vertices(mesh, pieces, faces);
  const Positions x = move_onto_surfaces(pieces, faces_at, faces, sides, drawn);
  check_shapes(mesh, pieces, x, " by its faces on a curved side", "a finer mesh there.");
  sort_pieces(pieces, x);
  SolidBody body;
  body.solid.sides = sides.sides;
  add_solid_regions(mesh, pieces, body.solid);
  add_cells(pieces, x, faces_at, faces, body.solid);
  const std::string note = split_note(mesh);
  body.note = note + (note.empty() || sides.note.empty() ? "" : "; ") + sides.note;
  return body;
}
} // namespace Signorini
