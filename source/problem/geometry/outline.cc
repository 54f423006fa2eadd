// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega between closed loops of segments and arcs: polygons with their corners on the sides, which
// are checked and filled with quadrilaterals.

#include <signorini/base/message.h>
#include <signorini/problem/geometry/arc_cell.h>
#include <signorini/problem/geometry/outline.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/numerics/rtree.h>

#include <boost/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "triangles.h"

namespace Signorini {
namespace {
using Ends = std::pair<unsigned int, unsigned int>;

/** Returns the maps of the quadrilaterals with edges on arcs, by the numbers of the cells. */
std::map<std::size_t, ArcCell> arc_cells(const CoarseMesh &mesh) {
  std::map<Ends, Point<2>> centres;
  for (const CoarseMesh::Edge &edge : mesh.edges)
    if (edge.piece->radius() > 0.)
      centres[{edge.start, edge.end}] = edge.piece->centre_of_circle();
  std::map<std::size_t, ArcCell> found;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    std::array<Point<2>, 4> corners;
    std::array<std::optional<Point<2>>, 4> centres_of_edges;
    bool is_curved = false;
    AssertDimension(mesh.cells[c].size(), 4);
    for (unsigned int i = 0; i < 4; ++i) {
      corners[i] = mesh.vertices[mesh.cells[c][i]];
      const auto centre = centres.find({mesh.cells[c][i], mesh.cells[c][(i + 1) % 4]});
      if (centre == centres.end())
        continue;
      centres_of_edges[i] = centre->second;
      is_curved = true;
    }
    if (is_curved)
      found.emplace(c, ArcCell(corners, centres_of_edges));
  }
  return found;
}
} // namespace

CoarseMesh split_cells(const CoarseMesh &mesh) {
  CoarseMesh fine;
  fine.vertices = mesh.vertices;
  std::map<Ends, unsigned int> middles;
  const auto middle_of = [&](const unsigned int a, const unsigned int b) {
    const auto [entry, is_new] = middles.emplace(std::minmax(a, b), fine.vertices.size());
    if (is_new)
      fine.vertices.push_back(mesh.vertices[a] + 0.5 * (mesh.vertices[b] - mesh.vertices[a]));
    return entry->second;
  };
  for (const CoarseMesh::Edge &edge : mesh.edges) {
    const unsigned int middle = middle_of(edge.start, edge.end);
    Point<2> &x = fine.vertices[middle];
    x = edge.piece->point(edge.piece->arc_length(x));
    fine.edges.push_back({edge.start, middle, edge.side, edge.piece});
    fine.edges.push_back({middle, edge.end, edge.side, edge.piece});
  }
  for (const std::vector<unsigned int> &corners : mesh.cells) {
    const std::size_t n = corners.size();
    std::vector<unsigned int> middles_of_cell;
    Point<2> mean;
    for (std::size_t i = 0; i < n; ++i) {
      middles_of_cell.push_back(middle_of(corners[i], corners[(i + 1) % n]));
      mean += fine.vertices[middles_of_cell[i]] / static_cast<double>(n);
    }
    const auto centre = static_cast<unsigned int>(fine.vertices.size());
    fine.vertices.push_back(mean);
    for (std::size_t i = 0; i < n; ++i)
      fine.cells.push_back(
        {corners[i], middles_of_cell[i], centre, middles_of_cell[(i + n - 1) % n]});
  }
  return fine;
}

std::optional<std::size_t> find_folded_cell(const CoarseMesh &mesh, const double min_ratio) {
  for (const auto &[cell, map] : arc_cells(mesh))
    if (!map.is_valid(min_ratio))
      return cell;
  return {};
}

Geometry<2> make_body(const std::vector<Side<2>> &sides, const CoarseMesh &mesh) {
  Geometry<2> geometry = bounded_by(sides);
  geometry.star_shaped = false;
  geometry.n_coarse_cells = static_cast<double>(mesh.cells.size());
  std::vector<std::shared_ptr<const Manifold<2>>> manifolds;
  std::vector<CellData<2>> cells;
  const Point<2> middle = geometry.lower + 0.5 * (geometry.upper - geometry.lower);
  for (const std::vector<unsigned int> &corners : mesh.cells) {
    cells.emplace_back();
    cells.back().vertices = {corners[0], corners[1], corners[3], corners[2]};
    Point<2> centre;
    for (const unsigned int corner : corners)
      centre += 0.25 * mesh.vertices[corner];
    if (!geometry.inside || centre.distance(middle) < geometry.inside->distance(middle))
      geometry.inside = centre;
  }
  for (const auto &[cell, map] : arc_cells(mesh)) {
    cells[cell].manifold_id = manifolds.size();
    manifolds.push_back(std::make_shared<ArcCell>(map));
  }
  GridTools::consistently_order_cells(cells);
  SubCellData edges;
  std::map<const Curve *, types::manifold_id> circles;
  for (const CoarseMesh::Edge &edge : mesh.edges) {
    CellData<1> line;
    line.vertices = {edge.start, edge.end};
    line.boundary_id = edge.side;
    if (edge.piece->radius() > 0.) {
      const auto [circle, is_new] = circles.emplace(edge.piece, manifolds.size());
      if (is_new)
        manifolds.push_back(std::make_shared<PolarManifold<2>>(edge.piece->centre_of_circle()));
      line.manifold_id = circle->second;
    }
    edges.boundary_lines.push_back(line);
  }
  geometry.make_coarse_mesh = [vertices = mesh.vertices, cells, edges,
                               manifolds](Triangulation<2> &triangulation) {
    triangulation.create_triangulation(vertices, cells, edges);
    for (unsigned int i = 0; i < manifolds.size(); ++i)
      triangulation.set_manifold(i, *manifolds[i]);
  };
  return geometry;
}

namespace {
/** How sides become chords. */
struct Chording {
  /** The largest angle of a chord of an arc (radians), and the smallest number of them. */
  double step, least;
  /** The largest length of a chord; 0: any. */
  double mesh_size = 0.;
};

/** Returns the polygons between the sides as a mesh without cells. Beyond max_coarse_cells chords
 * it ends. */
CoarseMesh make_chords(const std::vector<Side<2>> &sides, const Chording &wanted) {
  CoarseMesh chords;
  unsigned int first = 0;
  for (unsigned int i = 0; i < sides.size(); ++i) {
    for (unsigned int k = 0; k < sides[i].n_pieces(); ++k) {
      const Curve &piece = sides[i].piece(k);
      const bool is_arc = piece.radius() > 0.;
      const double by_angle =
        is_arc ? std::max(wanted.least, piece.length() / piece.radius() / wanted.step) : 1.;
      const double by_size = wanted.mesh_size > 0. ? piece.length() / wanted.mesh_size : 1.;
      const double n = std::ceil(std::max({1., by_angle, by_size}) * (1. - 1e-10));
      for (double j = 0.; j < n && chords.vertices.size() <= max_coarse_cells; ++j) {
        const auto number = static_cast<unsigned int>(chords.vertices.size());
        chords.vertices.push_back(piece.point(j / n * piece.length()));
        chords.edges.push_back({number, number + 1, i, &piece});
      }
    }
    // Holes are closed sides behind those of the outer loop.
    if (i + 1 == sides.size() || sides[i + 1].is_closed()) {
      chords.edges.back().end = first;
      first = static_cast<unsigned int>(chords.vertices.size());
    }
  }
  return chords;
}

using Segment = boost::geometry::model::segment<Point<2>>;

/** A chord of a side, and the closed side that this is, or 0 for the sides around the body. */
struct Chord {
  Segment ends;
  unsigned int side, loop;
};

/** Returns whether two chords meet; those with a common end, whether they fold onto each other. */
bool meet(const Chord &p, const Chord &q, const double tolerance) {
  const auto &[a, b] = p.ends;
  const auto &[c, d] = q.ends;
  const Tensor<1, 2> in = b - a, out = d - c;
  if (p.loop == q.loop && (b.distance(c) < tolerance || d.distance(a) < tolerance))
    return in * out < 0. && std::abs(in * cross_product_2d(out)) < 1e-6 * in.norm() * out.norm();
  return boost::geometry::distance(p.ends, q.ends) < tolerance;
}

/** The chords of a mesh without cells. */
std::vector<Chord> chords_of(const CoarseMesh &polygons, const std::vector<Side<2>> &sides) {
  std::vector<Chord> chords;
  for (const CoarseMesh::Edge &edge : polygons.edges)
    chords.push_back({{polygons.vertices[edge.start], polygons.vertices[edge.end]},
                      edge.side,
                      sides[edge.side].is_closed() ? edge.side : 0});
  return chords;
}

/** Returns the numbers of two chords that cross or touch; none if all polygons are simple. */
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const std::vector<Chord> &chords,
                                                                 const double tolerance) {
  namespace index = boost::geometry::index;
  std::vector<std::pair<Segment, std::size_t>> ends;
  for (const Chord &chord : chords)
    ends.emplace_back(chord.ends, ends.size());
  const auto tree = pack_rtree(ends);
  for (const auto &[p, i] : ends) {
    BoundingBox<2> near(std::vector<Point<2>>{p.first, p.second});
    near.extend(tolerance);
    for (const auto &[q, j] : tree | index::adaptors::queried(index::intersects(near)))
      if (i < j && meet(chords[i], chords[j], tolerance))
        return std::make_pair(i, j);
  }
  return {};
}

/** The share of the body's size below which two points are one. */
constexpr double same_point = 1e-9;

/** Returns chords that stand for the sides: they turn by 2 degrees, and by less where longer ones
 * cross. @throws InputError if sides cross or touch elsewhere than at common ends. */
std::vector<Chord> simple_chords(const std::vector<Side<2>> &sides, const double size,
                                 const std::string &where) {
  std::vector<Chord> chords;
  std::pair<std::size_t, std::size_t> crossing;
  for (const double n_per_2_degrees : {1., 8., 64.}) {
    const CoarseMesh polygons =
      make_chords(sides, {numbers::PI / 90. / n_per_2_degrees, n_per_2_degrees});
    if (n_per_2_degrees > 1. && polygons.vertices.size() > max_coarse_cells)
      break;
    chords = chords_of(polygons, sides);
    const auto found = find_crossing(chords, same_point * size);
    if (!found)
      return chords;
    crossing = *found;
  }
  const Chord &p = chords[crossing.first], &q = chords[crossing.second];
  const auto [first, second] = std::minmax(sides[p.side].name(), sides[q.side].name());
  throw input_error(where, ": the sides ", first, " and ", second, " cross or touch near (",
                    q.ends.first + 0.5 * (q.ends.second - q.ends.first),
                    "), allowed: sides that meet at their ends only.");
}

/** Refuses sides that cross or touch elsewhere than at common ends, and holes that are not inside
 * of the body, each by itself. @return the area of the body. */
double check_outline(const std::vector<Side<2>> &sides, const double size,
                     const std::string &where) {
  std::map<unsigned int, boost::geometry::model::ring<Point<2>, false, false>> loops;
  for (const Chord &chord : simple_chords(sides, size, where))
    loops[chord.loop].push_back(chord.ends.first);
  for (const auto &[hole, unused] : loops)
    for (const auto &[loop, ring] : loops)
      if (hole > 0 && loop != hole &&
          boost::geometry::within(sides[hole].start(), ring) != (loop == 0))
        throw input_error(where, ": ", sides[hole].name(), " lies ",
                          loop == 0 ? "outside of the body" : "inside of " + sides[loop].name(),
                          ", allowed: holes inside of the body, each by itself.");
  // Holes run clockwise: their area is negative.
  double area = 0.;
  for (const auto &loop : loops)
    area += boost::geometry::area(loop.second);
  return area;
}

[[noreturn]] void refuse_many_cells(const std::string &where) {
  throw input_error(where, ": found more than ", max_coarse_cells,
                    " coarse cells, allowed: a larger Mesh size, and sides that do not come very "
                    "close to each other.");
}

/** Returns the mesh of make_outlined_body() with these chords; none if they cross or a cell comes
 * out folded. */
std::optional<CoarseMesh> mesh_outline(const std::vector<Side<2>> &sides, const Chording &wanted,
                                       const double size, const std::string &where) {
  constexpr double min_ratio = 0.1;
  const CoarseMesh chords = make_chords(sides, wanted);
  // A mesh of n vertices has fewer than 2 n triangles.
  Triangles triangles;
  triangles.too_many = chords.vertices.size() > max_coarse_cells;
  if (!triangles.too_many) {
    if (find_crossing(chords_of(chords, sides), same_point * size))
      return {};
    triangles = triangulate(chords.vertices, chords.edges, wanted.mesh_size, max_coarse_cells / 6);
  }
  if (triangles.too_many)
    refuse_many_cells(where);
  CoarseMesh mesh = {triangles.points, triangles.triangles, {}};
  std::map<unsigned int, unsigned int> next;
  for (const auto &[start, end] : triangles.boundary)
    next[start] = end;
  for (const CoarseMesh::Edge &chord : chords.edges)
    for (unsigned int v = chord.start; v != chord.end; v = next[v]) {
      if (next.count(v) == 0 || mesh.edges.size() == next.size())
        return {};
      // Points that were added to a chord lie off its arc.
      if (v != chord.start)
        mesh.vertices[v] = chord.piece->point(chord.piece->arc_length(mesh.vertices[v]));
      mesh.edges.push_back({v, next[v], chord.side, chord.piece});
    }
  mesh = split_cells(mesh);
  if (mesh.cells.empty() || find_folded_cell(mesh, min_ratio))
    return {};
  return mesh;
}
} // namespace

Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides, const double mesh_size,
                               const std::string &where) {
  const double size = bounded_by(sides).diameter(), area = check_outline(sides, size, where);
  // No triangle is larger than an equilateral one, and each becomes three cells.
  if (3. * area > max_coarse_cells * 0.25 * std::sqrt(3.) * mesh_size * mesh_size && mesh_size > 0.)
    refuse_many_cells(where);
  // With shorter chords the cells next to arcs are less bent. Arcs of few degrees, which no angle
  // divides, need several chords where another side is close to them.
  for (double least = 1.; least < 10.; least *= 2.) {
    double step = 0.25 * numbers::PI;
    for (unsigned int attempt = 0; attempt < 10; ++attempt, step *= 0.7)
      if (const auto mesh = mesh_outline(sides, {step, least, mesh_size}, size, where))
        return make_body(sides, *mesh);
  }
  throw input_error(where,
                    ": no mesh was found for this shape, allowed: arcs that do not come very "
                    "close to other sides or meet them at very small angles.");
}
} // namespace Signorini
