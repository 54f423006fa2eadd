// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape = polygon: vertices, arcs, fillets and holes become loops of sides with the body on the
// left.

#include "polygon_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>
#include <signorini/scene/outline.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "coordinates_input.h"
#include "polygon_loop.h"

namespace Signorini
{
namespace
{
/** A list of sides that is longer than this is a matter for a mesh file. */
constexpr std::size_t most_vertices = 200;

void check_number(const std::size_t n, const std::string &where)
{
  if (n > most_vertices)
    throw InputError(where + ": found " + std::to_string(n) + " vertices, allowed: at most " +
                     std::to_string(most_vertices) + ".");
}

/** "arc cx,cy ccw". */
PolygonArc read_arc(const std::string &text, const Entry &entry)
{
  std::string rest = trim(text.substr(3));
  const std::size_t blank = rest.find_last_of(" \t");
  const std::string direction = blank == std::string::npos ? "" : rest.substr(blank + 1);
  if (direction != "cw" && direction != "ccw")
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: 'arc cx,cy ccw' (counter-clockwise) or 'arc cx,cy cw'.");
  const auto xy = read_coordinates(trim(rest.substr(0, blank)), 2, entry);
  return {dealii::Point<2>(xy[0], xy[1]), direction == "ccw"};
}

/** "x,y" or "x,y fillet r". */
PolygonVertex read_vertex(const std::string &text, const unsigned int number, const Entry &entry)
{
  const std::size_t word = text.find("fillet");
  const auto xy = read_coordinates(trim(text.substr(0, word)), 2, entry);
  PolygonVertex vertex = {dealii::Point<2>(xy[0], xy[1]), 0., number};
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
  std::vector<dealii::Point<2>> points;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
  {
    points.push_back(loop.vertices[i].x);
    if (loop.edges[i].arc)
      points.push_back(loop.edges[i].arc->centre);
  }
  check_coordinates<2>(points, entry.where());
  const bool is_tiny = std::all_of(points.begin(), points.end(), [](const auto &x) {
    return std::abs(x[0]) < smallest_magnitude && std::abs(x[1]) < smallest_magnitude;
  });
  const std::size_t n = loop.vertices.size();
  if (is_tiny && n > 2)
    throw InputError(entry.where() + ": found coordinates that are all below " +
                     number_text(smallest_magnitude) +
                     ", allowed: the corners of a polygon; take other units.");
  if (n < 2 || (n == 2 && !loop.edges[0].arc && !loop.edges[1].arc))
    throw InputError(entry.where() + ": found " + std::to_string(n) +
                     (n == 1 ? " vertex" : " vertices") +
                     ", allowed: three or more, x0,y0; x1,y1; ...");
  return loop;
}

/** "circle cx,cy,r", clockwise. */
Curve read_circle(const std::string &text, const Entry &entry)
{
  std::vector<double> numbers;
  if (!read_numbers(text.substr(6), numbers) || numbers.size() != 3 || !(numbers[2] > 0.))
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: 'circle cx,cy,r' with a positive radius r.");
  const dealii::Point<2> centre(numbers[0], numbers[1]);
  check_coordinates<2>({centre, dealii::Point<2>(numbers[2], 0.)}, entry.where());
  return Curve::arc(centre, numbers[2], dealii::numbers::PI, -dealii::numbers::PI, Body::outside);
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

/** The vertices counter-clockwise, if they are those of a convex polygon of straight sides: every
 * corner turns left, by a visible angle, and all together turn once. */
std::optional<std::vector<dealii::Point<2>>> convex_polygon(const PolygonLoop &loop)
{
  const std::size_t n = loop.vertices.size();
  std::vector<dealii::Point<2>> x;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (loop.edges[i].arc || loop.vertices[i].fillet > 0.)
      return {};
    x.push_back(loop.vertices[i].x);
  }
  double turning = 0.;
  for (std::size_t i = 0; i < n; ++i)
  {
    const dealii::Tensor<1, 2> in = x[(i + 1) % n] - x[i], out = x[(i + 2) % n] - x[(i + 1) % n];
    const double sine = in[0] * out[1] - in[1] * out[0];
    if (!(sine > 1e-6 * in.norm() * out.norm()))
      return {};
    turning += std::atan2(sine, in * out);
  }
  if (turning > 3. * dealii::numbers::PI)
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
