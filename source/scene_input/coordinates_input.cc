// SPDX-License-Identifier: LGPL-2.1-or-later
// Coordinates, and the sizes of bodies that can be computed with.

#include "coordinates_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The distance of the body from the origin. */
double distance_from_origin(const Geometry<2> &geometry)
{
  double distance = 0.;
  for (const Side<2> &side : geometry.sides)
    distance = std::max(distance, side.start().norm());
  return distance;
}
double distance_from_origin(const Geometry<3> &geometry)
{
  return std::max(geometry.lower.norm(), geometry.upper.norm());
}

/** The length of the shortest side, in space of the shortest edge. */
double shortest_side(const Geometry<2> &geometry)
{
  double shortest = geometry.diameter();
  for (const Side<2> &side : geometry.sides)
    shortest = std::min(shortest, side.length());
  return shortest;
}
double shortest_side(const Geometry<3> &geometry)
{
  return geometry.shortest_extent();
}
} // namespace

std::vector<double> read_coordinates(const std::string &text,
                                     const unsigned int n,
                                     const Entry &entry)
{
  std::vector<double> numbers;
  if (!read_numbers(text, numbers) || numbers.size() != n)
    throw InputError(
      entry.where() + ": found " + quote(text) + ", allowed: " +
      (n == 2 ? "two numbers separated by a comma." : "three numbers separated by commas."));
  return numbers;
}

template <int dim>
void check_coordinates(const std::vector<dealii::Point<dim>> &points, const std::string &where)
{
  for (const dealii::Point<dim> &x : points)
    for (unsigned int d = 0; d < dim; ++d)
      if (!(std::abs(x[d]) <= largest_magnitude))
        throw InputError(where + ": found the coordinate " + number_text(x[d]) +
                         ", allowed: coordinates up to " + number_text(largest_magnitude) +
                         "; take other units.");
}

template <int dim>
void check_size(const Geometry<dim> &geometry, const std::string &where)
{
  const double size = geometry.diameter();
  const double distance = distance_from_origin(geometry), shortest = shortest_side(geometry);
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

template void check_coordinates(const std::vector<dealii::Point<2>> &, const std::string &);
template void check_coordinates(const std::vector<dealii::Point<3>> &, const std::string &);
template void check_size(const Geometry<2> &, const std::string &);
template void check_size(const Geometry<3> &, const std::string &);
} // namespace Signorini
