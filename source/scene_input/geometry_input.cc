// SPDX-License-Identifier: LGPL-2.1-or-later
// The subsection Geometry: bodies from parameters, checked before they are made.

#include "geometry_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <algorithm>
#include <cmath>

#include "mesh_file_input.h"
#include "polygon_input.h"

namespace Signorini
{
namespace
{
/** An entry says what belongs to another shape. */
void refuse_foreign_entries(const GeometryParameters &given)
{
  const Shape shape = given.shape;
  const bool is_round = shape == Shape::half_disc || shape == Shape::disc || shape == Shape::ring;
  const auto refuse = [&](const Entry &entry, const bool belongs, const std::string &owner) {
    if (entry.changed && !belongs)
      throw InputError(entry.where() + ": this entry belongs to Shape = " + owner +
                       ", found Shape = " + to_text(shape) + ".");
  };
  for (const Entry *entry :
       std::initializer_list<const Entry *>{&given.lower_left, &given.upper_right, &given.cells})
    refuse(*entry, shape == Shape::rectangle, "rectangle");
  for (const Entry *entry :
       std::initializer_list<const Entry *>{&given.vertices, &given.holes, &given.mesh_size})
    refuse(*entry, shape == Shape::polygon, "polygon");
  refuse(given.centre, is_round, "half disc, disc or ring");
  refuse(given.radius, is_round, "half disc, disc or ring");
  refuse(given.inner_radius, shape == Shape::ring, "ring");
  refuse(given.file, shape == Shape::file, "file");
  refuse(given.arcs, shape == Shape::file, "file");
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
  return make_rectangle({lower[0], lower[1]},
                        {upper[0], upper[1]},
                        {static_cast<unsigned int>(cells[0]), static_cast<unsigned int>(cells[1])});
}

Geometry<2> read_round_body(const GeometryParameters &given)
{
  const auto xy = two_numbers(given.centre, given.centre);
  const dealii::Point<2> centre(xy[0], xy[1]);
  check_coordinates({centre}, given.centre.where());
  if (given.shape == Shape::half_disc)
    return make_half_disc(given.radius, centre);
  if (given.shape == Shape::disc)
    return make_disc(given.radius, centre);
  if (!(given.inner_radius < given.radius * (1. - 1. / largest_slenderness)))
    throw InputError(given.inner_radius.where() + ": found " + number_text(given.inner_radius) +
                     ", allowed: less than Radius = " + number_text(given.radius) + ".");
  return make_ring(given.inner_radius, given.radius, centre);
}
} // namespace

std::vector<double> two_numbers(const std::string &text, const Entry &entry)
{
  std::vector<double> numbers;
  if (!read_numbers(text, numbers) || numbers.size() != 2)
    throw InputError(entry.where() + ": found " + quote(text) +
                     ", allowed: two numbers separated by a comma.");
  return numbers;
}

void check_coordinates(const std::vector<dealii::Point<2>> &points, const std::string &where)
{
  for (const dealii::Point<2> &x : points)
    for (unsigned int d = 0; d < 2; ++d)
      if (!(std::abs(x[d]) <= largest_magnitude))
        throw InputError(where + ": found the coordinate " + number_text(x[d]) +
                         ", allowed: coordinates up to " + number_text(largest_magnitude) +
                         "; take other units.");
}

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

Geometry<2> make_geometry(const GeometryParameters &given)
{
  refuse_foreign_entries(given);
  Geometry<2> geometry;
  switch (given.shape.value)
  {
  case Shape::rectangle:
    geometry = read_rectangle(given);
    check_size(geometry, given.upper_right.where());
    break;
  case Shape::polygon:
    geometry = read_polygon(given);
    check_size(geometry, given.vertices.where());
    break;
  case Shape::half_disc:
  case Shape::disc:
  case Shape::ring:
    geometry = read_round_body(given);
    check_size(geometry, given.radius.where());
    break;
  case Shape::file:
    geometry = read_mesh_file(given);
    check_size(geometry, given.file.where());
    break;
  }
  geometry.distortion = given.distortion;
  geometry.where_distortion = given.distortion.where();
  return geometry;
}
} // namespace Signorini
