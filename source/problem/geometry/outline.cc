// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega between closed loops of segments and arcs, filled with quadrilaterals.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/outline.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "triangles.h"

namespace Signorini
{
namespace
{
using Ends = std::pair<unsigned int, unsigned int>;

/** Returns the maps of the cells with edges on arcs, by the numbers of the cells. */
std::map<std::size_t, ArcCell> arc_cells(const CoarseMesh &mesh)
{
  std::map<Ends, Point<2>> centres;
  for (const CoarseMesh::Edge &edge : mesh.edges)
    if (edge.piece->radius() > 0.)
      centres[{edge.start, edge.end}] = edge.piece->centre_of_circle();
  std::map<std::size_t, ArcCell> found;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    std::array<Point<2>, 4> corners;
    std::array<std::optional<Point<2>>, 4> centres_of_edges;
    bool is_curved = false;
    for (unsigned int i = 0; i < 4; ++i)
    {
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

CoarseMesh split_cells(const CoarseMesh &mesh)
{
  CoarseMesh fine;
  fine.vertices = mesh.vertices;
  std::map<Ends, unsigned int> middles;
  const auto middle_of = [&](const unsigned int a, const unsigned int b) {
    const auto [entry, is_new] = middles.emplace(std::minmax(a, b), fine.vertices.size());
    if (is_new)
      fine.vertices.push_back(mesh.vertices[a] + 0.5 * (mesh.vertices[b] - mesh.vertices[a]));
    return entry->second;
  };
  for (const CoarseMesh::Edge &edge : mesh.edges)
  {
    const unsigned int middle = middle_of(edge.start, edge.end);
    Point<2> &x = fine.vertices[middle];
    x = edge.piece->point(edge.piece->arc_length(x));
    fine.edges.push_back({edge.start, middle, edge.side, edge.piece});
    fine.edges.push_back({middle, edge.end, edge.side, edge.piece});
  }
  for (const std::vector<unsigned int> &corners : mesh.cells)
  {
    const std::size_t n = corners.size();
    std::vector<unsigned int> middles_of_cell;
    Point<2> mean;
    for (std::size_t i = 0; i < n; ++i)
    {
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

std::optional<std::size_t> find_folded_cell(const CoarseMesh &mesh, const double min_ratio)
{
  for (const auto &[cell, map] : arc_cells(mesh))
    if (!map.is_valid(min_ratio))
      return cell;
  return {};
}

Geometry<2> make_body(const std::vector<Side<2>> &sides, const CoarseMesh &mesh)
{
  Geometry<2> geometry = bounded_by(sides);
  geometry.star_shaped = false;
  geometry.n_coarse_cells = static_cast<double>(mesh.cells.size());
  std::vector<std::shared_ptr<const Manifold<2>>> manifolds;
  std::vector<CellData<2>> cells;
  const Point<2> middle = geometry.lower + 0.5 * (geometry.upper - geometry.lower);
  for (const std::vector<unsigned int> &corners : mesh.cells)
  {
    cells.emplace_back();
    cells.back().vertices = {corners[0], corners[1], corners[3], corners[2]};
    Point<2> centre;
    for (const unsigned int corner : corners)
      centre += 0.25 * mesh.vertices[corner];
    if (!geometry.inside || centre.distance(middle) < geometry.inside->distance(middle))
      geometry.inside = centre;
  }
  for (const auto &[cell, map] : arc_cells(mesh))
  {
    cells[cell].manifold_id = manifolds.size();
    manifolds.push_back(std::make_shared<ArcCell>(map));
  }
  GridTools::consistently_order_cells(cells);
  SubCellData edges;
  std::map<const Curve *, types::manifold_id> circles;
  for (const CoarseMesh::Edge &edge : mesh.edges)
  {
    CellData<1> line;
    line.vertices = {edge.start, edge.end};
    line.boundary_id = edge.side;
    if (edge.piece->radius() > 0.)
    {
      const auto [circle, is_new] = circles.emplace(edge.piece, manifolds.size());
      if (is_new)
        manifolds.push_back(std::make_shared<SphericalManifold<2>>(edge.piece->centre_of_circle()));
      line.manifold_id = circle->second;
    }
    edges.boundary_lines.push_back(line);
  }
  geometry.make_coarse_mesh =
    [vertices = mesh.vertices, cells, edges, manifolds](Triangulation<2> &triangulation) {
      triangulation.create_triangulation(vertices, cells, edges);
      for (unsigned int i = 0; i < manifolds.size(); ++i)
        triangulation.set_manifold(i, *manifolds[i]);
    };
  return geometry;
}

// Outlines: polygons with their corners on the sides, which are checked and filled.

namespace
{
/** Returns the polygons between the sides as a mesh without cells, with chords of at most @p step
 * (radians) on arcs and @p mesh_size (length) everywhere, if that is positive. Beyond
 * @p max_chords of them it ends. */
CoarseMesh make_chords(const std::vector<Side<2>> &sides,
                       const double step,
                       const double mesh_size,
                       const std::size_t max_chords)
{
  CoarseMesh chords;
  unsigned int first = 0;
  for (unsigned int i = 0; i < sides.size(); ++i)
  {
    for (unsigned int k = 0; k < sides[i].n_pieces(); ++k)
    {
      const Curve &piece = sides[i].piece(k);
      const double by_angle = piece.radius() > 0. ? piece.length() / piece.radius() / step : 1.;
      const double by_size = mesh_size > 0. ? piece.length() / mesh_size : 1.;
      const double n = std::ceil(std::max({1., by_angle, by_size}) * (1. - 1e-10));
      for (double j = 0.; j < n && chords.vertices.size() <= max_chords; ++j)
      {
        const auto number = static_cast<unsigned int>(chords.vertices.size());
        chords.vertices.push_back(piece.point(j / n * piece.length()));
        chords.edges.push_back({number, number + 1, i, &piece});
      }
    }
    // Holes are closed sides behind those of the outer loop.
    if (i + 1 == sides.size() || sides[i + 1].is_closed())
    {
      chords.edges.back().end = first;
      first = static_cast<unsigned int>(chords.vertices.size());
    }
  }
  return chords;
}

/** A chord with its ends. */
struct Chord
{
  Point<2> a, b;
  /** The side, and the hole that it is, or the side 0. */
  unsigned int side, loop;
};

double cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a * cross_product_2d(b);
}

/** Returns the distance from a point to a segment. */
double distance(const Point<2> &x, const Chord &chord)
{
  const Tensor<1, 2> d = chord.b - chord.a;
  return x.distance(chord.a + std::clamp(((x - chord.a) * d) / (d * d), 0., 1.) * d);
}

/** Returns whether two chords meet; those with a common end, whether they fold onto each other. */
bool meet(const Chord &p, const Chord &q, const double tolerance)
{
  const Tensor<1, 2> in = p.b - p.a, out = q.b - q.a;
  if (p.loop == q.loop && (p.b.distance(q.a) < tolerance || q.b.distance(p.a) < tolerance))
    return in * out < 0. && std::abs(cross_product(in, out)) < 1e-6 * in.norm() * out.norm();
  const bool cross = cross_product(in, q.a - p.a) * cross_product(in, q.b - p.a) < 0. &&
                     cross_product(out, p.a - q.a) * cross_product(out, p.b - q.a) < 0.;
  return cross ||
         std::min({distance(p.a, q), distance(p.b, q), distance(q.a, p), distance(q.b, p)}) <
           tolerance;
}

/** Refuses chords that cross or touch. */
void refuse_crossings(const std::vector<Side<2>> &sides,
                      std::vector<Chord> chords,
                      const double tolerance,
                      const std::string &where)
{
  const auto lowest = [](const Chord &chord) { return std::min(chord.a[0], chord.b[0]); };
  std::sort(chords.begin(), chords.end(), [&](const Chord &p, const Chord &q) {
    return lowest(p) < lowest(q);
  });
  for (auto p = chords.begin(); p != chords.end(); ++p)
    for (auto q = p + 1; q != chords.end() && lowest(*q) < std::max(p->a[0], p->b[0]) + tolerance;
         ++q)
      if (std::min(p->a[1], p->b[1]) <= std::max(q->a[1], q->b[1]) + tolerance &&
          std::max(p->a[1], p->b[1]) >= std::min(q->a[1], q->b[1]) - tolerance &&
          meet(*p, *q, tolerance))
      {
        const auto [first, second] = std::minmax(sides[p->side].name(), sides[q->side].name());
        std::ostringstream message;
        message << where << ": "
                << (first == second ? "the side " + first + " crosses or touches itself"
                                    : "the sides " + first + " and " + second + " cross or touch")
                << " near (" << q->a + 0.5 * (q->b - q->a)
                << "), allowed: sides that meet at their ends only.";
        throw InputError(message.str());
      }
}

/** Returns whether a ray to the right of a point meets a loop an odd number of times. */
bool encloses(const std::vector<Chord> &chords, const unsigned int loop, const Point<2> &x)
{
  bool odd = false;
  for (const Chord &chord : chords)
    if (chord.loop == loop && (chord.a[1] > x[1]) != (chord.b[1] > x[1]))
    {
      const double t = (x[1] - chord.a[1]) / (chord.b[1] - chord.a[1]);
      odd = odd != (chord.a[0] + t * (chord.b[0] - chord.a[0]) > x[0]);
    }
  return odd;
}

/** Refuses sides that cross or touch elsewhere than at common ends, and holes that are not inside
 * of the body, each by itself. Chords that turn by 2 degrees stand for the sides. */
void check_outline(const std::vector<Side<2>> &sides, const double size, const std::string &where)
{
  constexpr double same_point = 1e-9;
  const CoarseMesh polygons = make_chords(sides, numbers::PI / 90., 0., max_coarse_cells);
  std::vector<Chord> chords;
  for (const CoarseMesh::Edge &edge : polygons.edges)
    chords.push_back({polygons.vertices[edge.start],
                      polygons.vertices[edge.end],
                      edge.side,
                      sides[edge.side].is_closed() ? edge.side : 0});
  refuse_crossings(sides, chords, same_point * size, where);
  for (unsigned int hole = 1; hole < sides.size(); ++hole)
    for (unsigned int loop = 0; loop < sides.size() && sides[hole].is_closed(); ++loop)
      if (loop != hole && encloses(chords, loop, sides[hole].start()) != (loop == 0))
        throw InputError(where + ": " + sides[hole].name() + " lies " +
                         (loop == 0 ? "outside of the body" : "inside of " + sides[loop].name()) +
                         ", allowed: holes inside of the body, each by itself.");
}

/** Returns the mesh of make_outlined_body(), with chords of at most @p step (radians) on arcs; none
 * if chords cross or a cell comes out folded. */
std::optional<CoarseMesh> mesh_outline(const std::vector<Side<2>> &sides,
                                       const double mesh_size,
                                       const double step,
                                       const std::string &where)
{
  constexpr double min_ratio = 0.1;
  const CoarseMesh chords = make_chords(sides, step, mesh_size, max_coarse_cells);
  // A mesh of n vertices has fewer than 2 n triangles.
  Triangles triangles;
  triangles.too_many = chords.vertices.size() > max_coarse_cells;
  if (!triangles.too_many)
    triangles = triangulate(chords.vertices, chords.edges, mesh_size, max_coarse_cells / 6);
  if (triangles.too_many)
    throw InputError(where + ": found more than " + std::to_string(max_coarse_cells) +
                     " coarse cells, allowed: a larger Mesh size, and sides that do not come very "
                     "close to each other.");
  CoarseMesh mesh = {triangles.points, triangles.triangles, {}};
  std::map<unsigned int, unsigned int> next;
  for (const auto &[start, end] : triangles.boundary)
    next[start] = end;
  for (const CoarseMesh::Edge &chord : chords.edges)
    for (unsigned int v = chord.start; v != chord.end; v = next[v])
    {
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

Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides,
                               const double mesh_size,
                               const std::string &where)
{
  check_outline(sides, bounded_by(sides).diameter(), where);
  // With shorter chords the cells next to arcs are less bent.
  double step = 0.25 * numbers::PI;
  for (unsigned int attempt = 0; attempt < 10; ++attempt, step *= 0.7)
    if (const auto mesh = mesh_outline(sides, mesh_size, step, where))
      return make_body(sides, *mesh);
  throw InputError(where +
                   ": no mesh was found for this shape, allowed: arcs that do not come very "
                   "close to other sides or meet them at very small angles.");
}
} // namespace Signorini
