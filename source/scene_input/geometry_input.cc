// SPDX-License-Identifier: LGPL-2.1-or-later
// The subsection Geometry: rectangles and convex polygons, checked before they are made.

#include "geometry_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** All cells of the coarse mesh meet in one vertex; methods that work star by star take the cube of
 * their number. */
constexpr std::size_t most_vertices = 200;

double cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

std::vector<double> two_numbers(const std::string &text, const Entry &entry)
{
  std::vector<double> numbers;
  if (!read_numbers(text, numbers) || numbers.size() != 2)
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: two numbers separated by a comma.");
  return numbers;
}

/** Beyond, squares of lengths would overflow before the size of the body could be judged. */
void check_coordinates(const std::vector<dealii::Point<2>> &points, const std::string &where)
{
  for (const dealii::Point<2> &x : points)
    for (unsigned int d = 0; d < 2; ++d)
      if (!(std::abs(x[d]) <= largest_magnitude))
        throw InputError(where + ": found the coordinate " + number_text(x[d]) +
                         ", allowed: coordinates up to " + number_text(largest_magnitude) +
                         "; take other units.");
}

Geometry<2> read_rectangle(const GeometryParameters &given)
{
  const auto lower = two_numbers(given.lower_left, given.lower_left);
  const auto upper = two_numbers(given.upper_right, given.upper_right);
  const auto cells = two_numbers(given.cells, given.cells);
  for (const double n : cells)
    if (n < 1 || n > 10000 || n != std::floor(n))
      throw InputError(given.cells.where() + ": found " + quote(given.cells) +
                       ", allowed: two integers from 1 to 10000.");
  check_coordinates({{lower[0], lower[1]}}, given.lower_left.where());
  check_coordinates({{upper[0], upper[1]}}, given.upper_right.where());
  if (!(upper[0] > lower[0] && upper[1] > lower[1]))
    throw InputError(
      given.upper_right.where() + ": found " + quote(given.upper_right) +
      ", allowed: a point to the right of and above Lower left = " + given.lower_left.value + ".");
  if (!given.vertices.value.empty())
    throw InputError(given.vertices.where() +
                     ": vertices belong to Shape = polygon, found Shape = rectangle.");
  return make_rectangle({lower[0], lower[1]},
                        {upper[0], upper[1]},
                        {static_cast<unsigned int>(cells[0]), static_cast<unsigned int>(cells[1])});
}

/** Every corner turns left, by a visible angle, and all together turn once. */
void check_convexity(const std::vector<dealii::Point<2>> &vertices, const std::string &where)
{
  const std::size_t n = vertices.size();
  if (n < 3)
    throw InputError(where + ": found " + std::to_string(n) + (n == 1 ? " vertex" : " vertices") +
                     ", allowed: three or more, x0,y0; x1,y1; ...");
  double turning = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const dealii::Tensor<1, 2> in = vertices[(i + 1) % n] - vertices[i];
    const dealii::Tensor<1, 2> out = vertices[(i + 2) % n] - vertices[(i + 1) % n];
    if (!(cross(in, out) > 1e-6 * in.norm() * out.norm()))
      throw InputError(where + ": the polygon does not turn left at vertex " +
                       std::to_string((i + 1) % n) +
                       "; allowed: the corners of a convex polygon, counter-clockwise.");
    turning += std::atan2(cross(in, out), in * out);
  }
  if (turning > 3 * dealii::numbers::PI)
    throw InputError(where + ": the polygon crosses itself; allowed: the corners of a convex "
                             "polygon, counter-clockwise.");
}

Geometry<2> read_polygon(const GeometryParameters &given)
{
  const std::string where = given.vertices.where();
  for (const Given<std::string> *entry : {&given.lower_left, &given.upper_right, &given.cells})
    if (entry->changed)
      throw InputError(entry->where() +
                       ": this entry belongs to Shape = rectangle, found Shape = polygon.");
  std::vector<dealii::Point<2>> vertices;
  const std::vector<std::string> parts = split_list(given.vertices, ';');
  if (parts.size() > most_vertices)
    throw InputError(where + ": found " + std::to_string(parts.size()) +
                     " vertices, allowed: at most " + std::to_string(most_vertices) + ".");
  for (const std::string &part : parts)
  {
    const auto xy = two_numbers(part, given.vertices);
    vertices.emplace_back(xy[0], xy[1]);
  }
  check_coordinates(vertices, where);
  const bool is_tiny = std::all_of(vertices.begin(), vertices.end(), [](const auto &x) {
    return std::abs(x[0]) < smallest_magnitude && std::abs(x[1]) < smallest_magnitude;
  });
  if (is_tiny && vertices.size() > 2)
    throw InputError(where + ": found coordinates that are all below " +
                     number_text(smallest_magnitude) +
                     ", allowed: the corners of a convex polygon; take other units.");
  check_convexity(vertices, where);
  return make_polygon(vertices);
}

/** Whether the body can be computed with at all; @p where is the parameter that made it. */
void check_size(const Geometry<2> &geometry, const std::string &where)
{
  const double size = geometry.diameter();
  double distance = 0., shortest = size;
  for (const Side<2> &side : geometry.sides)
  {
    distance = std::max(distance, side.start().norm());
    shortest = std::min(shortest, side.length());
  }
  if (!(size >= smallest_magnitude && size <= largest_magnitude))
    throw InputError(where + ": found a body of the size " + number_text(size) +
                     ", allowed: sizes from " + number_text(smallest_magnitude) + " to " +
                     number_text(largest_magnitude) + "; take other units.");
  if (!(distance <= largest_distance * size))
    throw InputError(where + ": found a body of the size " + number_text(size) +
                     " at the distance " + number_text(distance) +
                     " from the origin, allowed: at most " + number_text(largest_distance) +
                     " times its size; put the origin near the body.");
  if (!(shortest * largest_slenderness >= size))
    throw InputError(where + ": found a side of the length " + number_text(shortest) +
                     " on a body of the size " + number_text(size) +
                     ", allowed: sides of at least " + number_text(1. / largest_slenderness) +
                     " of the size.");
}
} // namespace

Geometry<2> make_geometry(const GeometryParameters &given)
{
  const bool is_rectangle = given.shape == Shape::rectangle;
  Geometry<2> geometry = is_rectangle ? read_rectangle(given) : read_polygon(given);
  check_size(geometry, is_rectangle ? given.upper_right.where() : given.vertices.where());
  geometry.distortion = given.distortion;
  geometry.where_distortion = given.distortion.where();
  return geometry;
}
} // namespace Signorini
