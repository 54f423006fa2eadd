// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape = polygon: texts with vertices, arcs, fillets and holes become loops of sides with the body
// on the left.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/outline.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input.h"

namespace Signorini {
namespace {
using numbers::PI;

/** The largest number of vertices: a longer list belongs into a mesh file. */
constexpr std::size_t max_vertices = 200;

struct PolygonArc {
  Point<2> centre;
  bool counter_clockwise;
};

/** A vertex of a loop, and the edge from there to the next one. */
struct PolygonVertex {
  Point<2> x;
  /** The radius that rounds the corner; 0: none. */
  double fillet;
  /** "vertex 3", as counted in the parameter file. */
  std::string name;
  std::string edge_name;
  /** The arc that the edge is; empty for a segment. */
  std::optional<PolygonArc> arc;
};
using PolygonLoop = std::vector<PolygonVertex>;

double cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return a * cross_product_2d(b);
}

/** Returns the edge from a to b, or from b to a. The centre of an arc is moved so that both are on
 * it to rounding. */
Curve edge_between(const PolygonVertex &a, const PolygonVertex &b, const bool forwards,
                   const std::string &where) {
  constexpr double allowed_difference = 1e-6;
  const Point<2> &start = forwards ? a.x : b.x, &end = forwards ? b.x : a.x;
  if (!a.arc)
    return {start, end};
  const double from = a.arc->centre.distance(a.x), to = a.arc->centre.distance(b.x);
  if (!(std::abs(from - to) <= allowed_difference * std::max(from, to)) || from == 0.)
    throw input_error(where, ": the centre of the arc from ", a.name, " to ", b.name,
                      " is at the distances ", from, " and ", to,
                      " from them, allowed: equal ones, to 1e-6.");
  const Tensor<1, 2> chord = b.x - a.x, off = a.arc->centre - (a.x + 0.5 * chord);
  return Curve::arc_between(start, end,
                            a.arc->centre - ((off * chord) / chord.norm_square()) * chord,
                            a.arc->counter_clockwise == forwards);
}

void refuse_equal_vertices(const PolygonLoop &loop, const std::string &where) {
  double size = 0.;
  for (const PolygonVertex &vertex : loop)
    size = std::max(size, vertex.x.distance(loop[0].x));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PolygonVertex &next = loop[(i + 1) % loop.size()];
    if (!(loop[i].x.distance(next.x) > 1e-9 * size))
      throw input_error(where, ": ", loop[i].name, " and ", next.name,
                        " are the same point, allowed: sides that have a length.");
  }
}

/** Returns the loop with an arc instead of each corner that has a fillet. */
PolygonLoop round_corners(const PolygonLoop &loop, const std::string &where) {
  constexpr double rounding = 1e-9;
  const std::size_t n = loop.size();
  double longest = 0.;
  std::vector<double> cuts(n, 0.);
  PolygonLoop rounded;
  for (std::size_t i = 0; i < n; ++i) {
    const PolygonVertex &vertex = loop[i], &before = loop[(i + n - 1) % n];
    rounded.push_back(vertex);
    if (vertex.fillet == 0.)
      continue;
    const Tensor<1, 2> to_last = before.x - vertex.x, to_next = loop[(i + 1) % n].x - vertex.x;
    const Tensor<1, 2> u = to_last / to_last.norm(), v = to_next / to_next.norm();
    const double half = 0.5 * std::atan2(std::abs(cross_product(u, v)), u * v);
    if (vertex.arc || before.arc || !(half > 1e-3 && half < 0.5 * PI - 1e-3))
      throw input_error(where, ": found a fillet at ", vertex.name,
                        ", where no corner of straight sides is, allowed: fillets between straight "
                        "sides that form a corner.");
    cuts[i] = vertex.fillet / std::tan(half);
    // The vector u points back: a corner to the left has v on the right of u.
    rounded.back().arc = {vertex.x + vertex.fillet / std::sin(half) * (u + v) / (u + v).norm(),
                          cross_product(u, v) < 0.};
    rounded.back().x = vertex.x + cuts[i] * u;
    rounded.back().edge_name = "fillet" + vertex.name.substr(vertex.name.find(' ') + 1);
    rounded.push_back(vertex);
    rounded.back().x = vertex.x + cuts[i] * v;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const PolygonVertex &next = loop[(i + 1) % n];
    const double length = loop[i].x.distance(next.x);
    longest = std::max(longest, length);
    const double taken = cuts[i] + cuts[(i + 1) % n];
    if (!(length - taken >= -rounding * length))
      throw input_error(where, ": the fillets at ", loop[i].name, " and ", next.name, " need ",
                        taken, " of a side of the length ", length, ", allowed: smaller radii.");
  }
  // Where two fillets take all of a side, nothing of it is left.
  PolygonLoop sides;
  for (std::size_t i = 0; i < rounded.size(); ++i)
    if (rounded[i].arc ||
        rounded[i].x.distance(rounded[(i + 1) % rounded.size()].x) > rounding * longest)
      sides.push_back(rounded[i]);
  return sides;
}

/**
 * Returns the sides of a loop in a row with the body on the left, which lies inside of the loop if
 * @p is_outer. Lists in the other direction are turned round; names keep the numbers of the list.
 * @throws InputError if an arc does not fit its ends or a fillet its edges.
 */
std::vector<Side<2>> sides_of(const PolygonLoop &given, const bool is_outer,
                              const std::string &where) {
  const PolygonLoop loop = round_corners(given, where);
  const std::size_t n = loop.size();
  double area = 0.;
  for (std::size_t i = 0; i < n; ++i) {
    const PolygonVertex &a = loop[i], &b = loop[(i + 1) % n];
    const Curve edge = edge_between(a, b, true, where);
    area += 0.5 * cross_product(a.x - loop[0].x, b.x - loop[0].x);
    const double R = edge.radius(), angle = a.arc ? edge.length() / R : 0.;
    area += (a.arc && a.arc->counter_clockwise ? 0.5 : -0.5) * R * R * (angle - std::sin(angle));
  }
  const bool forwards = (area > 0.) == is_outer;
  std::vector<Side<2>> sides;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t e = forwards ? i : (2 * n - 2 - i) % n;
    sides.emplace_back(loop[e].edge_name,
                       edge_between(loop[e], loop[(e + 1) % n], forwards, where));
  }
  return sides;
}

void check_number(const std::size_t n, const std::string &where) {
  if (n > max_vertices)
    throw input_error(where, ": found ", n, " vertices, allowed: at most ", max_vertices, ".");
}

/** Returns the arc of this radius between two vertices that turns by at most 180 degrees. */
PolygonArc arc_of_radius(const double radius, const bool counter_clockwise, const PolygonVertex &a,
                         const PolygonVertex &b, const Entry &entry) {
  constexpr double rounding = 1e-6;
  const Tensor<1, 2> half = 0.5 * (b.x - a.x);
  if (!(radius >= (1. - rounding) * half.norm()))
    throw error_at(entry, "found the radius ", radius, " for the arc from ", a.name, " to ", b.name,
                   ", allowed: at least half of their distance, ", half.norm(), ".");
  const double depth = std::sqrt(std::max(0., radius * radius - half.norm_square()));
  return {a.x + half + (counter_clockwise ? -depth : depth) / half.norm() * cross_product_2d(half),
          counter_clockwise};
}

/** Returns the arc from one vertex through a point to the next vertex. */
PolygonArc arc_through_point(const Point<2> &x, const PolygonVertex &a, const PolygonVertex &b,
                             const Entry &entry) {
  constexpr double least_sine = 1e-6;
  const Tensor<1, 2> u = x - a.x, v = b.x - a.x;
  const double product = cross_product(u, v);
  if (!(std::abs(product) > least_sine * u.norm() * v.norm() && x.distance(b.x) > 0.))
    throw error_at(entry, "found the point (", x, ") for the arc from ", a.name, " to ", b.name,
                   ", allowed: a point beside the line through both.");
  return {Curve::circumcentre(a.x, u, v), product > 0.};
}

/** Reads "arc cx,cy ccw", "arc radius r ccw" or "arc through x,y" between two vertices. */
PolygonArc read_arc(const std::string &text, const PolygonVertex &a, const PolygonVertex &b,
                    const Entry &entry) {
  const auto [parts, form] = Phrase(text, "arc|cw|ccw");
  const std::string middle = parts.size() > 1 ? parts[1].text : "";
  const bool counter_clockwise = form == "arc ccw";
  const bool is_directed = (counter_clockwise || form == "arc cw") && parts[2].text.empty();
  // Constants may have the names of these words.
  const auto behind = [&](const std::string &word) {
    return middle.compare(0, word.size(), word) == 0 ? trim(middle.substr(word.size())) : "";
  };
  const std::string radius_text = behind("radius "), point = behind("through ");
  double radius = 0.;
  if (form == "arc" && !point.empty())
    return arc_through_point(read_point<2>(point, entry), a, b, entry);
  if (!is_directed ||
      (!radius_text.empty() && !(read_number(entry, radius_text, radius) && radius > 0.)))
    throw error_at(entry, "found ", quote(text),
                   ", allowed: 'arc cx,cy ccw' (counter-clockwise) or 'arc cx,cy cw' about a "
                   "centre, 'arc radius r ccw' (or cw), or 'arc through x,y'.");
  return radius_text.empty() ? PolygonArc{read_point<2>(middle, entry), counter_clockwise}
                             : arc_of_radius(radius, counter_clockwise, a, b, entry);
}

/** Reads "x,y" or "x,y fillet r". */
PolygonVertex read_vertex(const std::string &text, const std::size_t number, const Entry &entry) {
  const auto [parts, form] = Phrase(text, "fillet");
  PolygonVertex vertex = {read_point<2>(parts[0].text, entry),
                          0.,
                          "vertex " + std::to_string(number),
                          "side" + std::to_string(number),
                          {}};
  if (form != "..." && (form != "... fillet" || !read_number(entry, parts[1].text, vertex.fillet) ||
                        !(vertex.fillet > 0.)))
    throw error_at(entry, "found ", quote(text),
                   ", allowed: 'x,y fillet r' with a positive radius r.");
  return vertex;
}

PolygonLoop read_loop(const std::string &text, const Entry &entry) {
  PolygonLoop loop;
  /** The texts of the arcs behind vertices. */
  std::map<std::size_t, std::string> arcs;
  const std::vector<std::string> parts = split_list(text, ';');
  check_number(parts.size(), entry.where());
  for (const std::string &part : parts)
    if (part.compare(0, 3, "arc") == 0) {
      if (loop.empty() || !arcs.emplace(loop.size() - 1, part).second)
        throw error_at(entry, "found ", quote(part),
                       " without a vertex before it, "
                       "allowed: one arc between two vertices, or after the last.");
    } else
      loop.push_back(read_vertex(part, loop.size(), entry));
  // The list may end with its first vertex again.
  if (loop.size() > 3 && arcs.count(loop.size() - 1) == 0 && loop.back().fillet == 0. &&
      loop.back().x == loop.front().x)
    loop.pop_back();
  const std::size_t n = loop.size();
  if (n < 2 || (n == 2 && arcs.empty()))
    throw error_at(entry, "found ", n, (n == 1 ? " vertex" : " vertices"),
                   ", allowed: three or more, x0,y0; x1,y1; ...");
  refuse_equal_vertices(loop, entry.where());
  for (const auto &[i, arc] : arcs)
    loop[i].arc = read_arc(arc, loop[i], loop[(i + 1) % n], entry);
  return loop;
}

/** Reads "circle cx,cy,r"; the circle runs clockwise. */
Curve read_circle(const std::string &text, const Entry &entry) {
  std::vector<double> numbers;
  const bool is_circle =
    read_numbers(entry, text.substr(6), numbers) && numbers.size() == 3 && numbers[2] > 0.;
  if (!is_circle)
    throw error_at(entry, "found ", quote(text),
                   ", allowed: 'circle cx,cy,r' with a positive radius r, and '|' between holes.");
  const Point<3> circle = read_point<3>(text.substr(6), entry);
  return Curve::arc({circle[0], circle[1]}, circle[2], PI, -PI, Body::outside);
}

void add_holes(const Given<std::string> &given, std::vector<Side<2>> &sides) {
  const std::vector<std::string> holes = split_list(given, '|');
  check_number(holes.size(), given.where());
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const std::string name = "hole" + std::to_string(k);
    if (holes[k].compare(0, 6, "circle") == 0) {
      sides.emplace_back(name, read_circle(holes[k], given));
      continue;
    }
    // A list of vertices begins with a number, which may be a constant.
    if (holes[k].find(';') == std::string::npos)
      throw error_at(given, "found ", quote(holes[k]),
                     ", allowed: 'circle cx,cy,r' or vertices 'x0,y0; x1,y1; ...'.");
    const std::vector<Side<2>> pieces = sides_of(read_loop(holes[k], given), false, given.where());
    sides.emplace_back(name, Curve::chain({pieces.begin(), pieces.end()}));
  }
}

/** Returns the vertices counter-clockwise, if they are those of a convex polygon of straight sides:
 * every corner turns left, by a visible angle, and all together turn once. */
std::optional<std::vector<Point<2>>> convex_polygon(const PolygonLoop &loop) {
  const std::size_t n = loop.size();
  std::vector<Point<2>> x;
  double turning = 0.;
  for (std::size_t i = 0; i < n; ++i) {
    const Tensor<1, 2> in = loop[(i + 1) % n].x - loop[i].x,
                       out = loop[(i + 2) % n].x - loop[(i + 1) % n].x;
    const double sine = cross_product(in, out);
    if (loop[i].arc || loop[i].fillet > 0. || !(sine > 1e-6 * in.norm() * out.norm()))
      return {};
    turning += std::atan2(sine, in * out);
    x.push_back(loop[i].x);
  }
  if (turning > 3. * PI)
    return {};
  return x;
}
} // namespace

Geometry<2> read_polygon(const GeometryParameters &given) {
  const PolygonLoop loop = read_loop(given.vertices, given.vertices);
  const bool has_holes = !trim(given.holes.value).empty();
  if (!has_holes && given.mesh_size == 0.)
    if (const auto vertices = convex_polygon(loop))
      return make_polygon(*vertices);
  std::vector<Side<2>> sides = sides_of(loop, true, given.vertices.where());
  check_size(bounded_by(sides), given.vertices.where());
  if (has_holes)
    add_holes(given.holes, sides);
  return make_outlined_body(sides, given.mesh_size,
                            has_holes ? given.holes.where() : given.vertices.where());
}
} // namespace Signorini
