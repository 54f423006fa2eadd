// SPDX-License-Identifier: LGPL-2.1-or-later
// The subsection Geometry: bodies from parameters, checked before they are made.

#include "geometry_input.h"

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/magnitudes.h>

#include <algorithm>
#include <cmath>

#include "coordinates_input.h"
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
    refuse(*entry, shape == Shape::rectangle || shape == Shape::box, "rectangle or box");
  for (const Entry *entry :
       std::initializer_list<const Entry *>{&given.vertices, &given.holes, &given.mesh_size})
    refuse(*entry, shape == Shape::polygon, "polygon");
  refuse(given.centre, is_round, "half disc, disc or ring");
  refuse(given.radius, is_round, "half disc, disc or ring");
  refuse(given.inner_radius, shape == Shape::ring, "ring");
  refuse(given.file, shape == Shape::file, "file");
  refuse(given.arcs, shape == Shape::file, "file");
}

/** Opposite corners and coarse cells of a rectangle or a box. */
template <int dim>
struct Block
{
  dealii::Point<dim> lower, upper;
  std::vector<unsigned int> cells;
};

/** A point; what is not given is that of the unit square or cube. */
template <int dim>
dealii::Point<dim> read_corner(const Given<std::string> &given, const double by_default)
{
  const std::vector<double> numbers = given.changed ? read_coordinates(given.value, dim, given)
                                                    : std::vector<double>(dim, by_default);
  dealii::Point<dim> corner;
  std::copy(numbers.begin(), numbers.end(), corner.begin_raw());
  check_coordinates<dim>({corner}, given.where());
  return corner;
}

template <int dim>
Block<dim> read_block(const GeometryParameters &given)
{
  Block<dim> block;
  const std::vector<double> cells = given.cells.changed
                                      ? read_coordinates(given.cells, dim, given.cells)
                                      : std::vector<double>(dim, 1.);
  for (const double n : cells)
  {
    if (n < 1 || n > 10000 || n != std::floor(n))
      throw InputError(given.cells.where() + ": found " + quote(given.cells) +
                       ", allowed: " + (dim == 2 ? "two" : "three") + " integers from 1 to 10000.");
    block.cells.push_back(static_cast<unsigned int>(n));
  }
  block.lower = read_corner<dim>(given.lower_left, 0.);
  block.upper = read_corner<dim>(given.upper_right, 1.);
  for (unsigned int d = 0; d < dim; ++d)
    if (!(block.upper[d] > block.lower[d]))
      throw InputError(given.upper_right.where() + ": found " + quote(given.upper_right) +
                       ", allowed: a point to the right of and above " +
                       (dim == 2 ? "" : "and behind ") + "Lower left = " + given.lower_left.value +
                       ".");
  return block;
}

Geometry<2> read_round_body(const GeometryParameters &given)
{
  const auto xy = read_coordinates(given.centre, 2, given.centre);
  const dealii::Point<2> centre(xy[0], xy[1]);
  check_coordinates<2>({centre}, given.centre.where());
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

template <>
Geometry<3> make_geometry(const GeometryParameters &given)
{
  if (given.shape != Shape::box && given.shape.changed)
    throw InputError(given.shape.where() + ": found '" + to_text(given.shape.value) +
                     "' with Dimension = 3, allowed: " + to_text(Shape::box) + ".");
  GeometryParameters of_box = given;
  of_box.shape.value = Shape::box;
  refuse_foreign_entries(of_box);
  const Block<3> block = read_block<3>(given);
  Geometry<3> geometry = make_box(block.lower, block.upper, block.cells);
  check_size(geometry, given.upper_right.where());
  geometry.distortion = given.distortion;
  geometry.where_distortion = given.distortion.where();
  return geometry;
}

template <>
Geometry<2> make_geometry(const GeometryParameters &given)
{
  refuse_foreign_entries(given);
  Geometry<2> geometry;
  switch (given.shape.value)
  {
  case Shape::rectangle:
  {
    const Block<2> block = read_block<2>(given);
    geometry = make_rectangle(block.lower, block.upper, block.cells);
    check_size(geometry, given.upper_right.where());
    break;
  }
  case Shape::box:
    throw InputError(given.shape.where() +
                     ": found 'box' with Dimension = 2, allowed: Dimension = 3, or another shape.");
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
