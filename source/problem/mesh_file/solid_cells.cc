// SPDX-License-Identifier: LGPL-2.1-or-later
// From a mesh in space to hexahedra in order, with their vertices on the surfaces of the sides.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
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
  explicit CellSplitter(const FileMesh<3> &mesh) {
    const bool is_split = std::any_of(mesh.cells.begin(), mesh.cells.end(),
                                      [](const auto &cell) { return cell.n_corners != 8; });
    for (unsigned int c = 0; c < mesh.cells.size(); ++c) {
      const auto &cell = mesh.cells[c];
      if (is_split)
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

/** Returns the first corner at which the determinant of a cell's map is too small, if one is. */
std::optional<unsigned int> find_bad_corner(const std::array<Point<3>, 8> &x) {
  std::array<double, 8> determinant, share;
  double mean = 0.;
  for (unsigned int v = 0; v < 8; ++v) {
    std::array<Tensor<1, 3>, 3> edges;
    for (unsigned int d = 0; d < 3; ++d)
      edges[d] = x[v | 1U << d] - x[v & ~(1U << d)];
    determinant[v] = edges[0] * cross_product_3d(edges[1], edges[2]);
    share[v] = determinant[v] / (edges[0].norm() * edges[1].norm() * edges[2].norm());
    mean += determinant[v] / 8.;
  }
  for (unsigned int v = 0; v < 8; ++v)
    if (!(determinant[v] > min_share_of_mean * mean && share[v] > min_share_of_edges))
      return v;
  return {};
}

/** Refuses a cell for one of its corners. */
[[noreturn]] void refuse_shape(const FileMesh<3> &mesh, const Pieces &pieces,
                               const unsigned int cell, const unsigned int corner,
                               const bool is_moved) {
  // Every piece has one corner of its element, and every other one is in the middle of several.
  const auto &element = mesh.cells[pieces.element[cell]];
  unsigned int node = pieces.nodes[pieces.cells[cell][corner]][0];
  for (const unsigned int v : pieces.cells[cell])
    if (pieces.nodes[pieces.cells[cell][corner]].size() > 1 && pieces.nodes[v].size() == 1)
      node = pieces.nodes[v][0];
  throw input_error(mesh.location(element.line), "the element ", element.tag,
                    " is flat or turned inside out at node ", mesh.nodes[node].tag,
                    is_moved ? " by its faces on a curved side, allowed: a finer mesh there."
                             : ", allowed: elements whose determinants at all corners are above " +
                                 number_text(min_share_of_mean) + " of their mean.");
}

/** Checks the cells with these positions of their vertices. @throws InputError */
void check_shapes(const FileMesh<3> &mesh, const Pieces &pieces, const Positions &x,
                  const bool is_moved) {
  for (unsigned int c = 0; c < pieces.cells.size(); ++c) {
    std::array<Point<3>, 8> corners;
    for (unsigned int v = 0; v < 8; ++v)
      corners[v] = x[pieces.cells[c][v]];
    if (const auto bad = find_bad_corner(corners))
      refuse_shape(mesh, pieces, c, *bad, is_moved);
  }
}

/** Checks the cells of the first refined mesh, whose new vertices are on the surfaces.
 * @throws InputError */
void check_refined(const FileMesh<3> &mesh, const Pieces &pieces, const Solid &solid) {
  Triangulation<3> refined;
  make_geometry(solid).make_coarse_mesh(refined);
  refined.refine_global();
  for (const auto &cell : refined.cell_iterators_on_level(0))
    for (unsigned int i = 0; i < 8; ++i) {
      std::array<Point<3>, 8> corners;
      for (unsigned int v = 0; v < 8; ++v)
        corners[v] = cell->child(i)->vertex(v);
      // The part i of a cell is at its corner i.
      if (find_bad_corner(corners))
        refuse_shape(mesh, pieces, cell->index(), i, true);
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

/** Moves the vertices of pieces onto the surfaces of their sides. */
class SurfaceMover {
public:
  SurfaceMover(const Pieces &pieces, const std::vector<std::vector<unsigned int>> &faces_at,
               const std::vector<BoundaryFace> &faces, const SolidSides &sides, Positions drawn)
    : x_(std::move(drawn)) {
    for (const Point<3> &x : x_)
      size_ = std::max(size_, x.distance(x_[0]));
    for (unsigned int v = 0; v < x_.size(); ++v)
      vertex_of_[pieces.nodes[v]] = v;
    // Nodes, edges, then faces and cells, which follow their edges.
    for (const std::size_t n : {1, 2, 3})
      for (unsigned int v = 0; v < x_.size(); ++v)
        if (std::min<std::size_t>(pieces.nodes[v].size(), 3) == n) {
          std::set<unsigned int> at;
          for (const unsigned int f : faces_at[v])
            at.insert(faces[f].side);
          std::vector<Surface> surfaces;
          for (const unsigned int side : at)
            surfaces.push_back(sides.sides[side].second);
          x_[v] = projected(n == 1 ? x_[v] : middle(pieces.nodes[v]), surfaces);
        }
  }

  const Positions &positions() const {
    return x_;
  }

private:
  /** Returns the middle of an edge, a face or a cell: that of its corners, and a share of how far
   * the middles of its edges are off their chords. The shares make polynomials of degree two of
   * triangles (4/9) and tetrahedra (1/4), and transfinite interpolations of quadrilaterals (1/2)
   * and hexahedra (1/4). */
  Point<3> middle(const std::vector<unsigned int> &nodes) const {
    std::vector<Point<3>> corners, bends;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      corners.push_back(x_[vertex_of_.at({nodes[i]})]);
      for (std::size_t j = 0; j < i && nodes.size() > 2; ++j)
        if (const auto edge = vertex_of_.find({nodes[j], nodes[i]}); edge != vertex_of_.end())
          bends.emplace_back(x_[edge->second] - mean_of({x_[vertex_of_.at({nodes[j]})],
                                                         x_[vertex_of_.at({nodes[i]})]}));
    }
    const std::size_t n = bends.size();
    const double share = n == 3 ? 4. / 9. : n == 4 ? 0.5 : 0.25;
    const Point<3> mean = mean_of(corners);
    return n == 0 ? mean : mean + share * n * Tensor<1, 3>(mean_of(bends));
  }

  /** Returns a point on surfaces; one that lies on all of them but for rounding stays. */
  Point<3> projected(const Point<3> &x, const std::vector<Surface> &surfaces) const {
    const bool is_on_all =
      std::all_of(surfaces.begin(), surfaces.end(), [&](const Surface &surface) {
        return x.distance(surface.project(x)) <= on_surface * size_;
      });
    return is_on_all ? x : project_on_all(surfaces, x, size_);
  }

  Positions x_;
  double size_ = 0.;
  std::map<std::vector<unsigned int>, unsigned int> vertex_of_;
};

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
  check_shapes(mesh, pieces, drawn, false);
  std::vector<BoundaryFace> faces = find_boundary(mesh);
  const SolidSides sides = find_sides(mesh, faces, kinds, where);
  const auto faces_at = faces_of_vertices(mesh, pieces, faces);
  const Positions x = SurfaceMover(pieces, faces_at, faces, sides, drawn).positions();
  check_shapes(mesh, pieces, x, true);
  sort_pieces(pieces, x);
  SolidBody body;
  body.solid.sides = sides.sides;
  add_solid_regions(mesh, pieces, body.solid);
  add_cells(pieces, x, faces_at, faces, body.solid);
  check_refined(mesh, pieces, body.solid);
  const std::string note = split_note(mesh);
  body.note = note + (note.empty() || sides.note.empty() ? "" : "; ") + sides.note;
  return body;
}
} // namespace Signorini
