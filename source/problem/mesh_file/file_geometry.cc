// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments and circles that the edges of a mesh stand for.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/curve.h>
#include <signorini/problem/mesh_file/file_geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "file_sides.h"

namespace Signorini
{
namespace
{
using dealii::Point;

/** The share of the length by which nodes may lie off their segment. */
constexpr double segment_tolerance = 1e-8;

/** The share of an edge's length: an edge whose middle lies closer to its chord is straight. */
constexpr double min_rise = 1e-6;

/** The largest radius of an arc, in chords: a circle with a larger one is a line. */
constexpr double max_radius = 1e6;

/** Returns the outward normal of an edge that has the body on its left. */
Tensor<1, 2> right_of(const Tensor<1, 2> &direction)
{
  return Tensor<1, 2>({direction[1], -direction[0]}) / direction.norm();
}

const Point<2> &position(const FileMesh &mesh, const unsigned int vertex)
{
  return mesh.vertices[vertex].position;
}

bool is_bent(const FileMesh &mesh, const FileMesh::Edge &edge)
{
  if (!edge.middle)
    return false;
  const Tensor<1, 2> chord = position(mesh, edge.end) - position(mesh, edge.start);
  const double rise =
    std::abs((edge.middle->position - position(mesh, edge.start)) * right_of(chord));
  return rise > min_rise * chord.norm();
}

/** Returns the angle from one point to another, seen from a centre, in (-pi, pi]. */
double angle_between(const Point<2> &centre, const Point<2> &from, const Point<2> &to)
{
  const Tensor<1, 2> a = from - centre, b = to - centre;
  return std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
}

/** Returns the arc along the edges [first, last) of a chain. */
Curve arc_along(const FileMesh &mesh,
                const std::vector<FileMesh::Edge> &chain,
                const std::size_t first,
                const std::size_t last,
                const FittedCircle &circle)
{
  double turn = 0.;
  for (std::size_t i = first; i < last; ++i)
    turn +=
      angle_between(circle.centre, position(mesh, chain[i].start), position(mesh, chain[i].end));
  const Tensor<1, 2> from_centre = position(mesh, chain[first].start) - circle.centre;
  const double angle = std::atan2(from_centre[1], from_centre[0]);
  // The body lies on the left.
  return Curve::arc(
    circle.centre, circle.radius, angle, angle + turn, turn > 0. ? Body::inside : Body::outside);
}

/** Returns the circle with the least squares of distances from points all around it (Gauss-Newton).
 */
FittedCircle fit_closed_circle(const std::vector<Point<2>> &points)
{
  Point<2> centre;
  for (const Point<2> &x : points)
    centre += x / static_cast<double>(points.size());
  double radius = 0.;
  for (unsigned int step = 0; step < 10; ++step)
  {
    radius = 0.;
    for (const Point<2> &x : points)
      radius += centre.distance(x) / static_cast<double>(points.size());
    SymmetricTensor<2, 2> matrix;
    Tensor<1, 2> residual;
    for (const Point<2> &x : points)
    {
      const Tensor<1, 2> direction = (x - centre) / centre.distance(x);
      for (unsigned int a = 0; a < 2; ++a)
      {
        residual[a] += direction[a] * (centre.distance(x) - radius);
        for (unsigned int b = a; b < 2; ++b)
          matrix[a][b] += direction[a] * direction[b];
      }
    }
    centre += invert(matrix) * residual;
  }
  return {centre, radius};
}

/** Returns the end of the longest segment from edge @p first on. */
std::size_t end_of_segment(const FileMesh &mesh,
                           const std::vector<FileMesh::Edge> &chain,
                           const std::size_t first)
{
  const Point<2> start = position(mesh, chain[first].start);
  // Directions from the start to a point that lies in all nodes' corridors.
  double lowest = -1., highest = 1.;
  const Tensor<1, 2> along = position(mesh, chain[first].end) - start;
  const Tensor<1, 2> t = along / along.norm(), n = right_of(along);
  std::size_t last = first + 1;
  for (; last < chain.size() && !is_bent(mesh, chain[last]); ++last)
  {
    const Tensor<1, 2> to_node = position(mesh, chain[last].start) - start;
    const Tensor<1, 2> to_end = position(mesh, chain[last].end) - start;
    const double length = to_end.norm(), slack = segment_tolerance * length / (to_node * t);
    lowest = std::max(lowest, (to_node * n) / (to_node * t) - slack);
    highest = std::min(highest, (to_node * n) / (to_node * t) + slack);
    const double slope = (to_end * n) / (to_end * t);
    if (!(to_end * t > to_node * t && slope >= lowest && slope <= highest))
      break;
  }
  return last;
}

/** Returns the circle of the edges [first, last). */
FittedCircle circle_of(const FileMesh &mesh,
                       const std::vector<FileMesh::Edge> &chain,
                       const std::size_t first,
                       const std::size_t last)
{
  std::vector<Point<2>> between;
  for (std::size_t i = first; i < last; ++i)
  {
    if (i > first)
      between.push_back(position(mesh, chain[i].start));
    if (chain[i].middle)
      between.push_back(chain[i].middle->position);
  }
  return fit_circle(
    position(mesh, chain[first].start), position(mesh, chain[last - 1].end), between);
}

/** Returns the end of the longest arc from edge @p first on, which is bent. */
std::size_t end_of_arc(const FileMesh &mesh,
                       const std::vector<FileMesh::Edge> &chain,
                       const std::size_t first)
{
  const FittedCircle circle = circle_of(mesh, chain, first, first + 1);
  const auto fits = [&](const Point<2> &x) {
    return std::abs(circle.distance(x)) <= arc_tolerance * circle.radius;
  };
  const auto turn = [&](const std::size_t i) {
    return angle_between(
      circle.centre, position(mesh, chain[i].start), position(mesh, chain[i].end));
  };
  std::size_t last = first + 1;
  while (last < chain.size() && is_bent(mesh, chain[last]) && fits(chain[last].middle->position) &&
         fits(position(mesh, chain[last].end)) && turn(last) * turn(first) > 0.)
    ++last;
  return last;
}
} // namespace

FittedCircle fit_circle(const Point<2> &start,
                        const Point<2> &end,
                        const std::vector<Point<2>> &between)
{
  double size = start.distance(end);
  for (const Point<2> &x : between)
    size = std::max(size, x.distance(start));
  if (start.distance(end) < 1e-12 * size)
  {
    std::vector<Point<2>> points = between;
    points.push_back(start);
    return fit_closed_circle(points);
  }
  // The centre is the middle of the chord and t times the normal n: |x|^2 - a^2 = 2 t n.x for all
  // points x, seen from there, where 2 a is the chord.
  const Point<2> middle = start + 0.5 * (end - start);
  const Tensor<1, 2> n = right_of(end - start);
  const double a_square = 0.25 * (end - start).norm_square();
  double numerator = 0., denominator = 0.;
  for (const Point<2> &x : between)
  {
    numerator += ((x - middle).norm_square() - a_square) * (n * (x - middle));
    denominator += 2. * (n * (x - middle)) * (n * (x - middle));
  }
  const double t = numerator / denominator;
  return {middle + t * n, std::sqrt(t * t + a_square)};
}

ChainPiece make_arc(const FileMesh &mesh,
                    const std::vector<FileMesh::Edge> &chain,
                    const std::string &where)
{
  const FileMesh::Vertex &start = mesh.vertices[chain.front().start];
  const FileMesh::Vertex &end = mesh.vertices[chain.back().end];
  const std::string allowed = ", allowed: edges that lie on one circle.";
  if (chain.size() == 1 && !chain[0].middle)
    throw InputError(where + " is one straight edge from node " + std::to_string(start.tag) +
                     " to node " + std::to_string(end.tag) + allowed);
  const FittedCircle circle = circle_of(mesh, chain, 0, chain.size());
  const bool is_closed = chain.front().start == chain.back().end;
  if (!is_closed && !(circle.radius < max_radius * start.position.distance(end.position)))
    throw InputError(where + " is straight from node " + std::to_string(start.tag) + " to node " +
                     std::to_string(end.tag) + allowed);
  const FileMesh::Vertex *farthest = &start;
  const auto consider = [&](const FileMesh::Vertex &node) {
    if (std::abs(circle.distance(node.position)) > std::abs(circle.distance(farthest->position)))
      farthest = &node;
  };
  for (const FileMesh::Edge &edge : chain)
  {
    consider(mesh.vertices[edge.start]);
    if (edge.middle)
      consider(*edge.middle);
  }
  const double distance = circle.distance(farthest->position);
  if (!(std::abs(distance) <= arc_tolerance * circle.radius))
    throw InputError(where + ": node " + std::to_string(farthest->tag) + " lies " +
                     number_text(std::abs(distance)) + (distance > 0. ? " outside" : " inside") +
                     " of the circle with the radius " + number_text(circle.radius) +
                     " through the others, allowed: nodes within " + number_text(arc_tolerance) +
                     " of the radius.");
  return {0, chain.size(), arc_along(mesh, chain, 0, chain.size(), circle), circle};
}

std::vector<ChainPiece> divide_chain(const FileMesh &mesh, const std::vector<FileMesh::Edge> &chain)
{
  std::vector<ChainPiece> pieces;
  for (std::size_t first = 0, last = 0; first < chain.size(); first = last)
  {
    if (is_bent(mesh, chain[first]))
    {
      last = end_of_arc(mesh, chain, first);
      const FittedCircle circle = circle_of(mesh, chain, first, last);
      pieces.push_back({first, last, arc_along(mesh, chain, first, last, circle), circle});
      continue;
    }
    last = end_of_segment(mesh, chain, first);
    const Point<2> &start = position(mesh, chain[first].start);
    const Point<2> &end = position(mesh, chain[last - 1].end);
    pieces.push_back({first, last, Curve(start, end, right_of(end - start)), {}});
  }
  return pieces;
}

void move_onto(const ChainPiece &piece, const std::vector<FileMesh::Edge> &chain, FileMesh &mesh)
{
  for (std::size_t i = piece.first; i + 1 < piece.last; ++i)
  {
    Point<2> &x = mesh.vertices[chain[i].end].position;
    x = piece.curve.point(piece.curve.arc_length(x));
  }
  if (piece.curve.is_closed())
  {
    Point<2> &x = mesh.vertices[chain[piece.first].start].position;
    x = piece.curve.start();
  }
}

// The body of a mesh file: sides, circles and the coarse mesh.

namespace
{
/** The arguments from which a triangulation is made. */
struct CoarseMesh
{
  std::vector<Point<2>> vertices;
  std::vector<CellData<2>> cells;
  SubCellData edges;
  /** The manifolds; manifolds[i] has the number i. */
  std::vector<std::shared_ptr<const Manifold<2>>> manifolds;

  void make(Triangulation<2> &triangulation) const
  {
    triangulation.create_triangulation(vertices, cells, edges);
    for (unsigned int i = 0; i < manifolds.size(); ++i)
      triangulation.set_manifold(i, *manifolds[i]);
  }
};

void add_edges(const FileSides &sides, CoarseMesh &coarse)
{
  for (const FileSides::Edge &edge : sides.edges)
  {
    CellData<1> data;
    data.vertices = {edge.edge.start, edge.edge.end};
    data.boundary_id = edge.side;
    if (edge.circle >= 0)
      data.manifold_id = static_cast<unsigned int>(edge.circle);
    coarse.edges.boundary_lines.push_back(data);
  }
  for (const Point<2> &centre : sides.centres)
    coarse.manifolds.push_back(std::make_shared<SphericalManifold<2>>(centre));
}

/** Adds the cells with an edge on a circle. */
void add_arc_cells(const FileMesh &mesh, const FileSides &sides, CoarseMesh &coarse)
{
  std::map<unsigned int, std::array<std::optional<Point<2>>, 4>> centres;
  for (const FileSides::Edge &edge : sides.edges)
    if (edge.circle >= 0)
      centres[edge.edge.cell][edge.edge.edge_of_cell] = sides.centres[edge.circle];
  for (const auto &[number, centres_of_edges] : centres)
  {
    const FileMesh::Cell &cell = mesh.cells[number];
    std::array<Point<2>, 4> corners;
    for (unsigned int i = 0; i < 4; ++i)
      corners[i] = mesh.vertices[cell.corners[i]].position;
    auto manifold = std::make_shared<ArcCell>(corners, centres_of_edges);
    if (!manifold->is_valid(10, 0.))
      throw InputError(mesh.file + ": the quadrilateral " + std::to_string(cell.tag) +
                       " is turned inside out by its edge on a circle, allowed: a finer mesh "
                       "there.");
    coarse.cells[number].manifold_id = coarse.manifolds.size();
    coarse.manifolds.push_back(std::move(manifold));
  }
}

/** Computes the box around the body. Arcs lie inside of the boxes around their circles, of which
 * the parts that the arc passes count. */
void set_box(const FileMesh &mesh, const FileSides &sides, Geometry<2> &geometry)
{
  geometry.lower = geometry.upper = mesh.vertices[0].position;
  const auto include = [&](const Point<2> &x) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.lower[d] = std::min(geometry.lower[d], x[d]);
      geometry.upper[d] = std::max(geometry.upper[d], x[d]);
    }
  };
  for (const FileMesh::Vertex &vertex : mesh.vertices)
    include(vertex.position);
  for (const FileSides::Edge &edge : sides.edges)
    if (edge.circle >= 0)
    {
      // The highest point of an arc in a direction is an end, or the point of the circle there.
      const Point<2> &centre = sides.centres[edge.circle];
      const Point<2> &start = mesh.vertices[edge.edge.start].position;
      const Point<2> &end = mesh.vertices[edge.edge.end].position;
      const Point<2> middle = start + 0.5 * (end - start);
      for (unsigned int d = 0; d < 2; ++d)
        for (const double sign : {-1., 1.})
        {
          Point<2> x = centre;
          x[d] += sign * centre.distance(start);
          const Tensor<1, 2> bisector = middle - centre;
          // At an end both are equal, but for rounding.
          if ((x - centre) * bisector > (1. + 1e-12) * bisector.norm_square())
            include(x);
        }
    }
}

/** Returns the centre of the cell that is nearest to a point: a point inside of the body. */
Point<2> centre_near(const FileMesh &mesh, const Point<2> &x)
{
  Point<2> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const FileMesh::Cell &cell : mesh.cells)
  {
    Point<2> centre;
    for (const unsigned int corner : cell.corners)
      centre += 0.25 * mesh.vertices[corner].position;
    if (centre.distance(x) < distance)
    {
      distance = centre.distance(x);
      nearest = centre;
    }
  }
  return nearest;
}
} // namespace

Geometry<2> make_geometry(const FileMesh &file_mesh,
                          const std::vector<std::string> &arcs,
                          const std::string &where)
{
  FileMesh mesh = file_mesh;
  const FileSides sides = find_sides(mesh, arcs, where);
  const auto coarse = std::make_shared<CoarseMesh>();
  for (const FileMesh::Vertex &vertex : mesh.vertices)
    coarse->vertices.push_back(vertex.position);
  for (const FileMesh::Cell &cell : mesh.cells)
  {
    CellData<2> data;
    data.vertices = {cell.corners[0], cell.corners[1], cell.corners[3], cell.corners[2]};
    coarse->cells.push_back(data);
  }
  add_edges(sides, *coarse);
  add_arc_cells(mesh, sides, *coarse);
  GridTools::consistently_order_cells(coarse->cells);
  Geometry<2> geometry;
  geometry.sides = sides.sides;
  geometry.n_coarse_cells = static_cast<double>(mesh.cells.size());
  geometry.curved = !sides.centres.empty();
  geometry.make_coarse_mesh = [coarse = std::shared_ptr<const CoarseMesh>(coarse)](
                                Triangulation<2> &triangulation) { coarse->make(triangulation); };
  set_box(mesh, sides, geometry);
  geometry.star_shaped = false;
  geometry.inside = centre_near(mesh, geometry.lower + 0.5 * (geometry.upper - geometry.lower));
  return geometry;
}
} // namespace Signorini
