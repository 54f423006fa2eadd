// SPDX-License-Identifier: LGPL-2.1-or-later
// From vertices, arcs and fillets to sides.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/outline.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "input.h"

namespace Signorini
{
struct PolygonVertex
{
  Point<2> x;
  /** The radius that rounds the corner; 0: none. */
  double fillet;
  /** The number in the list of the parameter file. */
  unsigned int number;
};

struct PolygonArc
{
  Point<2> centre;
  bool counter_clockwise;
};

struct PolygonEdge
{
  /** The arc; empty for a segment. */
  std::optional<PolygonArc> arc;
  /** The number in the list of the parameter file. */
  unsigned int number;
};

/** A loop of vertices; edge i joins vertex i with the next. */
struct PolygonLoop
{
  std::vector<PolygonVertex> vertices;
  std::vector<PolygonEdge> edges;
};

/**
 * Returns the sides of a loop in a row with the body on the left, which lies inside of the loop if
 * @p is_outer. Lists in the other direction are turned round; names keep the numbers of the list.
 * @throws InputError if an arc does not fit its ends or a fillet its edges.
 */
std::vector<Side<2>> sides_of(const PolygonLoop &loop, bool is_outer, const std::string &where);

namespace
{
using numbers::PI;
using Vector2 = Tensor<1, 2>;

double cross_product(const Vector2 &a, const Vector2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** An arc between two points, in angles. */
struct Sweep
{
  Point<2> centre;
  double radius, first, last;
};

std::string vertex_name(const PolygonVertex &vertex)
{
  return "vertex " + std::to_string(vertex.number);
}

/** Returns the arc from a to b whose centre is moved so that both are on it to rounding. */
Sweep sweep_of(const PolygonArc &arc,
               const PolygonVertex &a,
               const PolygonVertex &b,
               const std::string &where)
{
  constexpr double allowed_difference = 1e-6;
  const double from = arc.centre.distance(a.x), to = arc.centre.distance(b.x);
  if (!(std::abs(from - to) <= allowed_difference * std::max(from, to)) || from == 0.)
    throw InputError(where + ": the centre of the arc from " + vertex_name(a) + " to " +
                     vertex_name(b) + " is at the distances " + number_text(from) + " and " +
                     number_text(to) + " from them, allowed: equal ones, to 1e-6.");
  const Vector2 chord = b.x - a.x;
  const Point<2> middle = a.x + 0.5 * chord;
  const Point<2> centre =
    arc.centre - (((arc.centre - middle) * chord) / chord.norm_square()) * chord;
  const auto angle = [&](const Point<2> &x) {
    return std::atan2(x[1] - centre[1], x[0] - centre[0]);
  };
  double sweep = angle(b.x) - angle(a.x);
  if (arc.counter_clockwise && sweep <= 0.)
    sweep += 2. * PI;
  if (!arc.counter_clockwise && sweep >= 0.)
    sweep -= 2. * PI;
  return {centre, centre.distance(a.x), angle(a.x), angle(a.x) + sweep};
}

Curve curve_of(const Sweep &sweep)
{
  return Curve::arc(sweep.centre,
                    sweep.radius,
                    sweep.first,
                    sweep.last,
                    sweep.last > sweep.first ? Body::inside : Body::outside);
}

void refuse_equal_vertices(const PolygonLoop &loop, const std::string &where)
{
  const std::size_t n = loop.vertices.size();
  double size = 0.;
  for (const PolygonVertex &vertex : loop.vertices)
    size = std::max(size, vertex.x.distance(loop.vertices[0].x));
  for (std::size_t i = 0; i < n; ++i)
    if (!(loop.vertices[i].x.distance(loop.vertices[(i + 1) % n].x) > 1e-9 * size))
      throw InputError(where + ": " + vertex_name(loop.vertices[i]) + " and " +
                       vertex_name(loop.vertices[(i + 1) % n]) +
                       " are the same point, allowed: sides that have a length.");
}

/** Returns the area of a loop, positive if it runs counter-clockwise. */
double signed_area_of(const PolygonLoop &loop, const std::string &where)
{
  const std::size_t n = loop.vertices.size();
  double area = 0.;
  for (std::size_t i = 0; i < n; ++i)
  {
    const PolygonVertex &a = loop.vertices[i], &b = loop.vertices[(i + 1) % n];
    area += 0.5 * cross_product(a.x - loop.vertices[0].x, b.x - loop.vertices[0].x);
    if (loop.edges[i].arc)
    {
      const Sweep sweep = sweep_of(*loop.edges[i].arc, a, b, where);
      const double angle = sweep.last - sweep.first;
      area += 0.5 * sweep.radius * sweep.radius * (angle - std::sin(angle));
    }
  }
  return area;
}

PolygonLoop turned_round(const PolygonLoop &loop)
{
  const std::size_t n = loop.vertices.size();
  PolygonLoop turned;
  for (std::size_t i = 0; i < n; ++i)
  {
    turned.vertices.push_back(loop.vertices[n - 1 - i]);
    turned.edges.push_back(loop.edges[(2 * n - 2 - i) % n]);
    if (auto &arc = turned.edges.back().arc)
      arc->counter_clockwise = !arc->counter_clockwise;
  }
  return turned;
}

/** The arc of a fillet, and the points where it touches the edges before and behind a vertex. */
struct Fillet
{
  /** The length that it takes from both edges. */
  double cut = 0.;
  std::optional<Sweep> arc;
};

Fillet fillet_at(const PolygonLoop &loop, const std::size_t i, const std::string &where)
{
  const std::size_t n = loop.vertices.size(), before = (i + n - 1) % n;
  const PolygonVertex &vertex = loop.vertices[i];
  if (vertex.fillet == 0.)
    return {};
  if (loop.edges[i].arc || loop.edges[before].arc)
    throw InputError(where + ": found a fillet at " + vertex_name(vertex) +
                     ", where an arc begins or ends, allowed: fillets between straight sides.");
  const Vector2 to_last = loop.vertices[before].x - vertex.x,
                to_next = loop.vertices[(i + 1) % n].x - vertex.x;
  const Vector2 u = to_last / to_last.norm(), v = to_next / to_next.norm();
  const double half = 0.5 * std::atan2(std::abs(cross_product(u, v)), u * v);
  if (!(half > 1e-3 && half < 0.5 * PI - 1e-3))
    throw InputError(where + ": found a fillet at " + vertex_name(vertex) +
                     ", where the sides do not form a corner, allowed: fillets at corners.");
  const Vector2 bisector = (u + v) / (u + v).norm();
  Fillet fillet;
  fillet.cut = vertex.fillet / std::tan(half);
  const Point<2> centre = vertex.x + vertex.fillet / std::sin(half) * bisector;
  const Point<2> first = vertex.x + fillet.cut * u;
  const double start = std::atan2(first[1] - centre[1], first[0] - centre[0]);
  // The vector u points back: a corner to the left has v on the right of u.
  const double turn = cross_product(u, v) < 0. ? 1. : -1.;
  fillet.arc = {centre, vertex.fillet, start, start + turn * (PI - 2. * half)};
  return fillet;
}

Curve edge_between(const Point<2> &start, const Point<2> &end)
{
  const Vector2 tangent = (end - start) / start.distance(end);
  return Curve(start, end, Vector2({tangent[1], -tangent[0]}));
}

std::vector<Side<2>> sides_in_a_row(const PolygonLoop &loop, const std::string &where)
{
  const std::size_t n = loop.vertices.size();
  std::vector<Fillet> fillets;
  for (std::size_t i = 0; i < n; ++i)
    fillets.push_back(fillet_at(loop, i, where));
  std::vector<Side<2>> sides;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    const PolygonVertex &a = loop.vertices[i], &b = loop.vertices[next];
    const std::string name = "side" + std::to_string(loop.edges[i].number);
    if (loop.edges[i].arc)
      sides.emplace_back(name, curve_of(sweep_of(*loop.edges[i].arc, a, b, where)));
    else
    {
      const Vector2 along = b.x - a.x;
      const double length = along.norm(), rest = length - fillets[i].cut - fillets[next].cut;
      if (!(rest > 1e-6 * length))
        throw InputError(where + ": the fillets at " + vertex_name(a) + " and " + vertex_name(b) +
                         " need " + number_text(length - rest) + " of a side of the length " +
                         number_text(length) + ", allowed: smaller radii.");
      sides.emplace_back(name,
                         edge_between(a.x + fillets[i].cut / length * along,
                                      b.x - fillets[next].cut / length * along));
    }
    if (fillets[next].arc)
      sides.emplace_back("fillet" + std::to_string(b.number), curve_of(*fillets[next].arc));
  }
  return sides;
}
} // namespace

std::vector<Side<2>> sides_of(const PolygonLoop &loop,
                              const bool is_outer,
                              const std::string &where)
{
  refuse_equal_vertices(loop, where);
  const bool is_counter_clockwise = signed_area_of(loop, where) > 0.;
  return sides_in_a_row(is_counter_clockwise == is_outer ? loop : turned_round(loop), where);
}

// Shape = polygon: vertices, arcs, fillets and holes become loops of sides with the body on the
// left.

namespace
{
/** The largest number of vertices: a longer list belongs into a mesh file. */
constexpr std::size_t max_vertices = 200;

void check_number(const std::size_t n, const std::string &where)
{
  if (n > max_vertices)
    throw InputError(where + ": found " + std::to_string(n) + " vertices, allowed: at most " +
                     std::to_string(max_vertices) + ".");
}

/** Reads "arc cx,cy ccw". */
PolygonArc read_arc(const std::string &text, const Entry &entry)
{
  std::string rest = trim(text.substr(3));
  const std::size_t blank = rest.find_last_of(" \t");
  const std::string direction = blank == std::string::npos ? "" : rest.substr(blank + 1);
  if (direction != "cw" && direction != "ccw")
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: 'arc cx,cy ccw' (counter-clockwise) or 'arc cx,cy cw'.");
  const auto xy = read_coordinates(trim(rest.substr(0, blank)), 2, entry);
  return {Point<2>(xy[0], xy[1]), direction == "ccw"};
}

/** Reads "x,y" or "x,y fillet r". */
PolygonVertex read_vertex(const std::string &text, const unsigned int number, const Entry &entry)
{
  const std::size_t word = text.find("fillet");
  const auto xy = read_coordinates(trim(text.substr(0, word)), 2, entry);
  PolygonVertex vertex = {Point<2>(xy[0], xy[1]), 0., number};
  if (word != std::string::npos &&
      (!read_number(trim(text.substr(word + 6)), vertex.fillet) || !(vertex.fillet > 0.)))
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: 'x,y fillet r' with a positive radius r.");
  return vertex;
}

PolygonLoop read_loop(const std::string &text, const Entry &entry)
{
  PolygonLoop loop;
  const std::vector<std::string> parts = split_list(text, ';');
  check_number(parts.size(), entry.where());
  for (const std::string &part : parts)
    if (part.compare(0, 3, "arc") == 0)
    {
      if (loop.edges.empty() || loop.edges.back().arc)
        throw InputError(entry.where() + ": found " + quote(part) +
                         " without a vertex before it, "
                         "allowed: one arc between two vertices, or after the last.");
      loop.edges.back().arc = read_arc(part, entry);
    }
    else
    {
      const auto number = static_cast<unsigned int>(loop.vertices.size());
      loop.vertices.push_back(read_vertex(part, number, entry));
      loop.edges.push_back({{}, number});
    }
  std::vector<Point<2>> points;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
  {
    points.push_back(loop.vertices[i].x);
    if (loop.edges[i].arc)
      points.push_back(loop.edges[i].arc->centre);
  }
  check_coordinates<2>(points, entry.where());
  const bool is_tiny = std::all_of(points.begin(), points.end(), [](const auto &x) {
    return std::abs(x[0]) < min_magnitude && std::abs(x[1]) < min_magnitude;
  });
  const std::size_t n = loop.vertices.size();
  if (is_tiny && n > 2)
    throw InputError(entry.where() + ": found coordinates that are all below " +
                     number_text(min_magnitude) +
                     ", allowed: the corners of a polygon; take other units.");
  if (n < 2 || (n == 2 && !loop.edges[0].arc && !loop.edges[1].arc))
    throw InputError(entry.where() + ": found " + std::to_string(n) +
                     (n == 1 ? " vertex" : " vertices") +
                     ", allowed: three or more, x0,y0; x1,y1; ...");
  return loop;
}

/** Reads "circle cx,cy,r"; the circle runs clockwise. */
Curve read_circle(const std::string &text, const Entry &entry)
{
  std::vector<double> numbers;
  if (!read_numbers(text.substr(6), numbers) || numbers.size() != 3 || !(numbers[2] > 0.))
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: 'circle cx,cy,r' with a positive radius r.");
  const Point<2> centre(numbers[0], numbers[1]);
  check_coordinates<2>({centre, Point<2>(numbers[2], 0.)}, entry.where());
  return Curve::arc(centre, numbers[2], numbers::PI, -numbers::PI, Body::outside);
}

void add_holes(const Given<std::string> &given, std::vector<Side<2>> &sides)
{
  if (trim(given.value).empty())
    return;
  const std::vector<std::string> holes = split_list(given, '|');
  check_number(holes.size(), given.where());
  for (std::size_t k = 0; k < holes.size(); ++k)
  {
    const std::string name = "hole" + std::to_string(k);
    if (holes[k].compare(0, 6, "circle") == 0)
    {
      sides.emplace_back(name, read_circle(holes[k], given));
      continue;
    }
    if (!holes[k].empty() && std::isalpha(static_cast<unsigned char>(holes[k][0])) != 0)
      throw InputError(given.where() + ": found " + quote(holes[k]) +
                       ", allowed: 'circle cx,cy,r' or vertices 'x0,y0; x1,y1; ...'.");
    std::vector<Curve> pieces;
    for (const Side<2> &side : sides_of(read_loop(holes[k], given), false, given.where()))
      pieces.push_back(side);
    sides.emplace_back(name, Curve::chain(pieces));
  }
}

/** Returns the vertices counter-clockwise, if they are those of a convex polygon of straight sides:
 * every corner turns left, by a visible angle, and all together turn once. */
std::optional<std::vector<Point<2>>> convex_polygon(const PolygonLoop &loop)
{
  const std::size_t n = loop.vertices.size();
  std::vector<Point<2>> x;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (loop.edges[i].arc || loop.vertices[i].fillet > 0.)
      return {};
    x.push_back(loop.vertices[i].x);
  }
  double turning = 0.;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Tensor<1, 2> in = x[(i + 1) % n] - x[i], out = x[(i + 2) % n] - x[(i + 1) % n];
    const double sine = in[0] * out[1] - in[1] * out[0];
    if (!(sine > 1e-6 * in.norm() * out.norm()))
      return {};
    turning += std::atan2(sine, in * out);
  }
  if (turning > 3. * numbers::PI)
    return {};
  return x;
}
} // namespace

Geometry<2> read_polygon(const GeometryParameters &given)
{
  const PolygonLoop loop = read_loop(given.vertices, given.vertices);
  const bool has_holes = !trim(given.holes.value).empty();
  if (!has_holes && given.mesh_size == 0.)
    if (const auto vertices = convex_polygon(loop))
      return make_polygon(*vertices);
  Geometry<2> outline;
  outline.sides = sides_of(loop, true, given.vertices.where());
  outline.lower = outline.upper = outline.sides[0].start();
  for (const Side<2> &side : outline.sides)
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double x = side.point(i / 8. * side.length())[d];
        outline.lower[d] = std::min(outline.lower[d], x);
        outline.upper[d] = std::max(outline.upper[d], x);
      }
  check_size(outline, given.vertices.where());
  add_holes(given.holes, outline.sides);
  return make_outlined_body(
    outline.sides, given.mesh_size, has_holes ? given.holes.where() : given.vertices.where());
}
} // namespace Signorini
