// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments and circles that the edges of a mesh stand for.

#include "edge_chain.h"

#include <signorini/base/errors.h>
#include <signorini/base/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::Point;
using Tensor = dealii::Tensor<1, 2>;

/** The share of the length by which nodes may lie off their segment. */
constexpr double segment_tolerance = 1e-8;

/** The share of an edge's length: an edge whose middle lies closer to its chord is straight. */
constexpr double smallest_rise = 1e-6;

/** The largest radius of an arc, in chords: a circle with a larger one is a line. */
constexpr double largest_radius = 1e6;

/** Returns the outward normal of an edge that has the body on its left. */
Tensor right_of(const Tensor &direction)
{
  return Tensor({direction[1], -direction[0]}) / direction.norm();
}

const Point<2> &position(const FileMesh &mesh, const unsigned int vertex)
{
  return mesh.vertices[vertex].position;
}

bool is_bent(const FileMesh &mesh, const FileMesh::Edge &edge)
{
  if (!edge.middle)
    return false;
  const Tensor chord = position(mesh, edge.end) - position(mesh, edge.start);
  const double rise =
    std::abs((edge.middle->position - position(mesh, edge.start)) * right_of(chord));
  return rise > smallest_rise * chord.norm();
}

/** Returns the angle from one point to another, seen from a centre, in (-pi, pi]. */
double angle_between(const Point<2> &centre, const Point<2> &from, const Point<2> &to)
{
  const Tensor a = from - centre, b = to - centre;
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
  const Tensor from_centre = position(mesh, chain[first].start) - circle.centre;
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
    dealii::SymmetricTensor<2, 2> matrix;
    Tensor residual;
    for (const Point<2> &x : points)
    {
      const Tensor direction = (x - centre) / centre.distance(x);
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
  const Tensor along = position(mesh, chain[first].end) - start;
  const Tensor t = along / along.norm(), n = right_of(along);
  std::size_t last = first + 1;
  for (; last < chain.size() && !is_bent(mesh, chain[last]); ++last)
  {
    const Tensor to_node = position(mesh, chain[last].start) - start;
    const Tensor to_end = position(mesh, chain[last].end) - start;
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
  const Tensor n = right_of(end - start);
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
  if (!is_closed && !(circle.radius < largest_radius * start.position.distance(end.position)))
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
} // namespace Signorini
