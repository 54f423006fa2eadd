// SPDX-License-Identifier: LGPL-2.1-or-later
// From vertices, arcs and fillets to sides.

#include "polygon_loop.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::numbers::PI;
using Vector2 = dealii::Tensor<1, 2>;

double cross_product(const Vector2 &a, const Vector2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** An arc between two points, in angles. */
struct Sweep
{
  dealii::Point<2> centre;
  double radius, first, last;
};

std::string vertex_name(const PolygonVertex &vertex)
{
  return "vertex " + std::to_string(vertex.number);
}

/** The arc from a to b whose centre is moved so that both are on it to rounding. */
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
  const dealii::Point<2> middle = a.x + 0.5 * chord;
  const dealii::Point<2> centre =
    arc.centre - (((arc.centre - middle) * chord) / chord.norm_square()) * chord;
  const auto angle = [&](const dealii::Point<2> &x) {
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

/** Positive for a loop that runs counter-clockwise. */
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

/** Where a fillet touches the edges before and behind a vertex, and its arc. */
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
  const dealii::Point<2> centre = vertex.x + vertex.fillet / std::sin(half) * bisector;
  const dealii::Point<2> first = vertex.x + fillet.cut * u;
  const double start = std::atan2(first[1] - centre[1], first[0] - centre[0]);
  // u points back: a corner to the left has v on the right of u.
  const double turn = cross_product(u, v) < 0. ? 1. : -1.;
  fillet.arc = {centre, vertex.fillet, start, start + turn * (PI - 2. * half)};
  return fillet;
}

Curve edge_between(const dealii::Point<2> &start, const dealii::Point<2> &end)
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
} // namespace Signorini
