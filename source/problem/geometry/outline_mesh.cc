// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles between chords of the sides, their vertices back on the sides, three cells from each.

#include "outline_mesh.h"

#include <signorini/base/errors.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "triangles.h"

namespace Signorini
{
namespace
{
constexpr unsigned int nowhere = static_cast<unsigned int>(-1);

/** A straight part of the polygon that is filled with triangles, from vertex to vertex. */
struct MeshChord
{
  unsigned int start, end;
  unsigned int side;
  const Curve *piece;
};

/** An edge of the boundary and where it lies. */
struct BoundaryEdge
{
  unsigned int start, end;
  const MeshChord *chord;

  bool is_curved() const
  {
    return chord->piece->radius() > 0.;
  }
};

struct Polygons
{
  std::vector<Point<2>> points;
  std::vector<MeshChord> chords;
};

Polygons chords_of(const std::vector<Side<2>> &sides,
                   const std::vector<Loop> &loops,
                   const double mesh_size,
                   const double step,
                   const std::size_t max_points)
{
  Polygons polygons;
  for (const Loop &loop : loops)
  {
    const auto first = static_cast<unsigned int>(polygons.points.size());
    for (std::size_t i = loop.first; i < loop.last; ++i)
      for (unsigned int k = 0; k < sides[i].n_pieces(); ++k)
      {
        const Curve &piece = sides[i].piece(k);
        const double by_angle = piece.radius() > 0. ? piece.length() / piece.radius() / step : 1.;
        const double by_size = mesh_size > 0. ? piece.length() / mesh_size : 1.;
        const double n = std::ceil(std::max({1., by_angle, by_size}) * (1. - 1e-10));
        for (double j = 0.; j < n && polygons.points.size() <= max_points; ++j)
        {
          const auto number = static_cast<unsigned int>(polygons.points.size());
          polygons.points.push_back(piece.point(j / n * piece.length()));
          polygons.chords.push_back({number, number + 1, static_cast<unsigned int>(i), &piece});
        }
      }
    polygons.chords.back().end = first;
  }
  return polygons;
}

/** Returns the number of triangles with edges of the mesh size, a lower bound: others are smaller.
 */
double min_triangles(const Polygons &polygons, const double mesh_size)
{
  double area = 0.;
  for (const MeshChord &chord : polygons.chords)
  {
    const Tensor<1, 2> a = polygons.points[chord.start] - polygons.points[0];
    const Tensor<1, 2> b = polygons.points[chord.end] - polygons.points[0];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return mesh_size > 0. ? area / (0.25 * std::sqrt(3.) * mesh_size * mesh_size) : 0.;
}

/** Finds the parts into which points on it have divided each chord; returns false if the boundary
 * is not that of the chords. */
bool find_edges(const Polygons &polygons,
                const Triangles &triangles,
                std::vector<BoundaryEdge> &edges)
{
  std::vector<unsigned int> next(triangles.points.size(), nowhere);
  for (const auto &edge : triangles.boundary)
    next[edge[0]] = edge[1];
  for (const MeshChord &chord : polygons.chords)
    for (unsigned int v = chord.start; v != chord.end; v = next[v])
    {
      if (next[v] == nowhere || edges.size() == triangles.boundary.size())
        return false;
      edges.push_back({v, next[v], &chord});
    }
  return edges.size() == triangles.boundary.size();
}

/** Makes quadrilaterals of triangles. */
class QuadrilateralMaker
{
public:
  QuadrilateralMaker(const Triangles &triangles, const std::vector<BoundaryEdge> &edges)
  {
    mesh_.vertices = triangles.points;
    for (const BoundaryEdge &edge : edges)
      if (edge.is_curved() && edge.start != edge.chord->start)
        put_on(*edge.chord->piece, edge.start);
    for (const BoundaryEdge &edge : edges)
      add_boundary_edge(edge);
    for (const auto &triangle : triangles.triangles)
      add_cells(triangle);
  }
  const OutlineMesh &mesh() const
  {
    return mesh_;
  }
  /** Returns whether the map of every cell is one to one, by a margin. */
  bool is_valid() const
  {
    return is_valid_;
  }

private:
  using Edge = std::pair<unsigned int, unsigned int>;
  /** The smallest ratio of two determinants of the map of a valid cell. */
  static constexpr double min_ratio = 0.1;

  static Edge sorted(const unsigned int a, const unsigned int b)
  {
    return {std::min(a, b), std::max(a, b)};
  }
  /** Moves a vertex onto a curve. Ends of chords are on their arcs already, points between them are
   * not. */
  void put_on(const Curve &piece, const unsigned int vertex)
  {
    mesh_.vertices[vertex] = piece.point(piece.arc_length(mesh_.vertices[vertex]));
  }

  types::manifold_id circle_manifold_id(const Curve &arc)
  {
    const auto known =
      std::find(mesh_.circles.begin(), mesh_.circles.end(), arc.centre_of_circle());
    const auto k = static_cast<types::manifold_id>(known - mesh_.circles.begin());
    if (known == mesh_.circles.end())
      mesh_.circles.push_back(arc.centre_of_circle());
    return k;
  }

  void add_boundary_edge(const BoundaryEdge &edge)
  {
    const Curve &piece = *edge.chord->piece;
    const Point<2> chord_middle =
      mesh_.vertices[edge.start] + 0.5 * (mesh_.vertices[edge.end] - mesh_.vertices[edge.start]);
    const auto middle = static_cast<unsigned int>(mesh_.vertices.size());
    mesh_.vertices.push_back(edge.is_curved() ? piece.point(piece.arc_length(chord_middle))
                                              : chord_middle);
    middles_[sorted(edge.start, edge.end)] = middle;
    CellData<1> line;
    line.boundary_id = edge.chord->side;
    if (edge.is_curved())
    {
      line.manifold_id = circle_manifold_id(piece);
      arcs_[sorted(edge.start, middle)] = &piece;
      arcs_[sorted(middle, edge.end)] = &piece;
    }
    line.vertices = {edge.start, middle};
    mesh_.lines.boundary_lines.push_back(line);
    line.vertices = {middle, edge.end};
    mesh_.lines.boundary_lines.push_back(line);
  }

  unsigned int middle_of(const unsigned int a, const unsigned int b)
  {
    const auto [entry, is_new] =
      middles_.emplace(sorted(a, b), static_cast<unsigned int>(mesh_.vertices.size()));
    if (is_new)
      mesh_.vertices.emplace_back(mesh_.vertices[a] +
                                  0.5 * (mesh_.vertices[b] - mesh_.vertices[a]));
    return entry->second;
  }

  void add_cells(const std::array<unsigned int, 3> &triangle)
  {
    std::array<unsigned int, 3> middles;
    Point<2> centre;
    for (unsigned int i = 0; i < 3; ++i)
    {
      middles[i] = middle_of(triangle[i], triangle[(i + 1) % 3]);
      centre += mesh_.vertices[middles[i]] / 3.;
    }
    const auto number = static_cast<unsigned int>(mesh_.vertices.size());
    mesh_.vertices.push_back(centre);
    for (unsigned int i = 0; i < 3; ++i)
    {
      CellData<2> cell;
      cell.vertices = {triangle[i], middles[i], middles[(i + 2) % 3], number};
      const ArcCell map = map_of(cell.vertices);
      is_valid_ = is_valid_ && map.is_valid(4, min_ratio);
      if (arc_between(cell.vertices[0], cell.vertices[1]) != nullptr ||
          arc_between(cell.vertices[0], cell.vertices[2]) != nullptr)
      {
        cell.manifold_id = mesh_.circles.size() + mesh_.curved_cells.size();
        mesh_.curved_cells.push_back(map);
      }
      mesh_.cells.push_back(cell);
    }
  }

  const Curve *arc_between(const unsigned int a, const unsigned int b) const
  {
    const auto found = arcs_.find(sorted(a, b));
    return found == arcs_.end() ? nullptr : found->second;
  }

  /** Returns the map of a cell, whose edges at vertex 0 may be arcs. */
  ArcCell map_of(const std::vector<unsigned int> &v) const
  {
    const auto x = [&](const unsigned int i) { return mesh_.vertices[v[i]]; };
    const auto centre = [&](const unsigned int i) {
      const Curve *const arc = arc_between(v[0], v[i]);
      return arc == nullptr ? std::optional<Point<2>>() : arc->centre_of_circle();
    };
    return {{{x(0), x(1), x(3), x(2)}}, {{centre(1), {}, {}, centre(2)}}};
  }

  OutlineMesh mesh_;
  std::map<Edge, unsigned int> middles_;
  std::map<Edge, const Curve *> arcs_;
  bool is_valid_ = true;
};
} // namespace

std::optional<OutlineMesh> mesh_outline(const std::vector<Side<2>> &sides,
                                        const std::vector<Loop> &loops,
                                        const double mesh_size,
                                        const double step,
                                        const std::size_t max_cells,
                                        const std::string &where)
{
  const Polygons polygons = chords_of(sides, loops, mesh_size, step, max_cells);
  std::vector<std::array<unsigned int, 2>> segments;
  for (const MeshChord &chord : polygons.chords)
    segments.push_back({chord.start, chord.end});
  Triangles triangles;
  triangles.too_many =
    polygons.points.size() > max_cells || 3. * min_triangles(polygons, mesh_size) > max_cells;
  if (!triangles.too_many)
    triangles = triangulate(polygons.points, segments, mesh_size, max_cells / 3);
  if (triangles.too_many)
    throw InputError(where + ": found more than " + std::to_string(max_cells) +
                     " coarse cells, allowed: a larger Mesh size, and sides that do not come very "
                     "close to each other.");
  std::vector<BoundaryEdge> edges;
  if (triangles.triangles.empty() || !find_edges(polygons, triangles, edges))
    return {};
  const QuadrilateralMaker maker(triangles, edges);
  if (!maker.is_valid())
    return {};
  return maker.mesh();
}
} // namespace Signorini
