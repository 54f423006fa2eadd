// SPDX-License-Identifier: LGPL-2.1-or-later
// The subsection Geometry: bodies from parameters and mesh files, checked before they are made.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/mesh_file/file_geometry.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "input.h"

namespace Signorini {
std::vector<double> read_coordinates(const std::string &text, const unsigned int n,
                                     const Entry &entry) {
  std::vector<double> numbers;
  if (!read_numbers(entry, text, numbers) || numbers.size() != n)
    throw error_at(
      entry, "found ", quote(text), ", allowed: ",
      (n == 2 ? "two numbers separated by a comma." : "three numbers separated by commas."));
  return numbers;
}

template <int dim>
Point<dim> read_point(const std::string &text, const Entry &entry) {
  const std::vector<double> numbers = read_coordinates(trim(text), dim, entry);
  Point<dim> x;
  for (unsigned int d = 0; d < dim; ++d) {
    x[d] = numbers[d];
    if (!(std::abs(x[d]) <= max_magnitude))
      throw error_at(entry, "found the coordinate ", x[d], ", allowed: coordinates up to ",
                     max_magnitude, "; take other units.");
  }
  return x;
}

template <int dim>
void check_size(const Geometry<dim> &geometry, const std::string &where) {
  const double size = geometry.diameter();
  const double distance = std::min(geometry.lower.norm(), geometry.upper.norm());
  double shortest = dim == 2 ? size : geometry.shortest_extent();
  if constexpr (dim == 2)
    for (const Side<2> &side : geometry.sides)
      shortest = std::min(shortest, side.length());
  if (!(size >= min_magnitude && size <= max_magnitude))
    throw input_error(where, ": found a body of the size ", size, ", allowed: sizes from ",
                      min_magnitude, " to ", max_magnitude, "; take other units.");
  if (!(distance <= max_distance * size))
    throw input_error(where, ": found a body of the size ", size, " at the distance ", distance,
                      " from the origin, allowed: at most ", max_distance,
                      " times its size; put the origin near the body.");
  if (!(shortest * max_slenderness >= size))
    throw input_error(where, ": found a side of the length ", shortest, " on a body of the size ",
                      size, ", allowed: sides of at least ", 1. / max_slenderness, " of the size.");
}

INSTANTIATE_FUNCTION(read_point);
INSTANTIATE_FUNCTION(check_size);

namespace {
/** The largest size of a mesh file in bytes: some millions of cells. */
constexpr std::size_t max_mesh_file_size = 500000000;
} // namespace

std::string read_mesh_file(const GeometryParameters &given, const unsigned int dim) {
  const std::filesystem::path path(given.file.value);
  const std::string allowed =
    ", allowed: a file that Gmsh reads (.msh, .geo, .step, .brep, .unv, ...).";
  std::string ending = boost::to_lower_copy(path.extension().string());
  ending.erase(0, 1);
  if (given.file.value.empty())
    throw error_at(given.file, "found ''", allowed);
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw error_at(given.file, "found ", quote(given.file),
                   ", which is neither in the folder of the parameter file",
                   given.folder.empty() ? "" : " (" + shorten_path(given.folder) + ")",
                   " nor in the working folder", allowed);
  std::string content =
    read_whole_file(path.string(), given.file.where() + ": ", "mesh file", max_mesh_file_size);
  if (is_gmsh_text(content))
    return content;
  if (content.empty() || !is_gmsh_ending(ending))
    throw error_at(given.file, "found ", quote(given.file),
                   content.empty() ? ", which is empty" : "", allowed);
  return convert_with_gmsh(content, ending, dim, given.mesh_size, given.file.where() + ": ");
}

namespace {
bool is_one_of(const Shape shape, const std::initializer_list<Shape> shapes) {
  return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

/** Refuses entries that belong to another shape. */
void refuse_other_shapes(const GeometryParameters &given, const Shape shape) {
  const bool is_solid = is_one_of(shape, {Shape::ball, Shape::cylinder, Shape::tube});
  const bool is_round = is_solid || is_one_of(shape, {Shape::half_disc, Shape::disc, Shape::ring});
  const auto refuse = [found = "Shape = " + to_text(shape)](
                        const bool belong, const std::vector<const Entry *> &entries,
                        const std::string &owner) {
    refuse_foreign_entries(belong, entries, "Shape = " + owner, found);
  };
  refuse(shape == Shape::rectangle || shape == Shape::box,
         {&given.lower_left, &given.upper_right, &given.cells}, "rectangle or box");
  refuse(shape == Shape::polygon, {&given.vertices, &given.holes}, "polygon");
  refuse(is_round, {&given.centre, &given.radius}, "half disc, disc, ring, ball, cylinder or tube");
  refuse(is_one_of(shape, {Shape::ring, Shape::tube}), {&given.inner_radius}, "ring or tube");
  refuse(is_one_of(shape, {Shape::cylinder, Shape::tube}), {&given.length, &given.axis},
         "cylinder or tube");
  refuse(is_solid, {&given.sector}, "ball, cylinder or tube");
  refuse(shape == Shape::polygon || shape == Shape::file, {&given.mesh_size}, "polygon or file");
  refuse(shape == Shape::file, {&given.file, &given.arcs, &given.surfaces}, "file");
}

/** Opposite corners and coarse cells of a rectangle or a box. */
template <int dim>
struct Block {
  Point<dim> lower, upper;
  std::vector<unsigned int> cells;
};

template <int dim>
Block<dim> read_block(const GeometryParameters &given) {
  Block<dim> block;
  const std::vector<double> cells = given.cells.changed
                                      ? read_coordinates(given.cells, dim, given.cells)
                                      : std::vector<double>(dim, 1.);
  for (const double n : cells) {
    if (n < 1 || n > 10000 || n != std::floor(n))
      throw error_at(given.cells, "found ", quote(given.cells),
                     ", allowed: ", (dim == 2 ? "two" : "three"), " integers from 1 to 10000.");
    block.cells.push_back(static_cast<unsigned int>(n));
  }
  // A corner that is not given is that of the unit square or cube.
  if (given.lower_left.changed)
    block.lower = read_point<dim>(given.lower_left, given.lower_left);
  for (unsigned int d = 0; d < dim; ++d)
    block.upper[d] = 1.;
  if (given.upper_right.changed)
    block.upper = read_point<dim>(given.upper_right, given.upper_right);
  for (unsigned int d = 0; d < dim; ++d)
    if (!(block.upper[d] > block.lower[d]))
      throw error_at(given.upper_right, "found ", quote(given.upper_right),
                     ", allowed: a point to the right of and above ",
                     (dim == 2 ? "" : "and behind "), "Lower left = ", given.lower_left.value, ".");
  return block;
}

void check_inner_radius(const GeometryParameters &given) {
  if (!(given.inner_radius < given.radius * (1. - 1. / max_slenderness)))
    throw error_at(given.inner_radius, "found ", given.inner_radius,
                   ", allowed: less than Radius = ", given.radius, ".");
}

Geometry<2> read_round_body(const GeometryParameters &given) {
  const Point<2> centre = read_point<2>(given.centre, given.centre);
  if (given.shape == Shape::half_disc)
    return make_half_disc(given.radius, centre);
  if (given.shape == Shape::disc)
    return make_disc(given.radius, centre);
  check_inner_radius(given);
  return make_ring(given.inner_radius, given.radius, centre);
}

Geometry<3> read_round_solid(const GeometryParameters &given) {
  const Point<3> centre =
    given.centre.changed ? read_point<3>(given.centre, given.centre) : Point<3>();
  if (given.shape == Shape::ball)
    return make_ball(given.radius, centre, given.sector);
  if (given.sector == Sector::octant)
    throw error_at(given.sector, "found 'octant' with Shape = ", to_text(given.shape.value),
                   ", allowed: ", to_text(Sector::whole), ", ", to_text(Sector::half), ", ",
                   to_text(Sector::quarter), ".");
  const bool is_tube = given.shape == Shape::tube;
  if (is_tube)
    check_inner_radius(given);
  return make_cylinder(is_tube ? given.inner_radius.value : 0., given.radius, given.length, centre,
                       given.axis, given.sector);
}

/** Reads the mesh of Shape = file. */
template <int dim>
FileMesh<dim> read_mesh(const GeometryParameters &given) {
  if (given.distortion.changed)
    throw error_at(given.distortion, "meshes from files are not distorted, found Shape = file.");
  return read_gmsh<dim>(
    given.mesh.empty() ? read_mesh_file(given, dim) : given.mesh,
    given.file.where() + ": " +
      shorten_path(std::filesystem::path(given.file.value).filename().string()));
}

/** Reads "hole: cylinder | lid: plane". */
SurfaceKinds read_surface_kinds(const Given<std::string> &given) {
  constexpr std::array<Surface::Kind, 4> all = {Surface::Kind::plane, Surface::Kind::sphere,
                                                Surface::Kind::cylinder, Surface::Kind::faces};
  SurfaceKinds kinds;
  for (const std::string &part : split_list(given.value, '|')) {
    const auto colon = std::min(part.find(':'), part.size());
    const std::string word = trim(part.substr(std::min(colon + 1, part.size())));
    const auto kind = std::find_if(
      all.begin(), all.end(), [&](const Surface::Kind one) { return Surface::name(one) == word; });
    if (kind == all.end())
      throw error_at(given, "found ", quote(part),
                     ", allowed: the name of a side, ':' and plane, sphere, cylinder or faces.");
    kinds.emplace_back(trim(part.substr(0, colon)), *kind);
  }
  return kinds;
}

/** Returns a body that is checked, with its distortion. @param made_by the entry to blame. */
template <int dim>
Geometry<dim> finished(Geometry<dim> geometry, const Entry &made_by,
                       const GeometryParameters &given) {
  check_size(geometry, made_by.where());
  geometry.distortion = given.distortion;
  geometry.where_distortion = given.distortion.where();
  return geometry;
}

/** Reads the body of Shape = file. */
Geometry<3> read_solid(const GeometryParameters &given) {
  SolidBody body =
    make_solid(read_mesh<3>(given), read_surface_kinds(given.surfaces), given.surfaces.where());
  Geometry<3> geometry = make_geometry(std::move(body.solid));
  geometry.note = body.note;
  return geometry;
}
} // namespace

template <>
Geometry<3> make_geometry(const GeometryParameters &given) {
  const Shape shape = given.shape.changed ? given.shape.value : Shape::box;
  refuse_other_shapes(given, shape);
  Geometry<3> geometry;
  const Entry *made_by = &given.radius;
  switch (shape) {
  case Shape::box: {
    const Block<3> block = read_block<3>(given);
    geometry = make_box(block.lower, block.upper, block.cells);
    made_by = &given.upper_right;
    break;
  }
  case Shape::ball:
  case Shape::cylinder:
  case Shape::tube:
    geometry = read_round_solid(given);
    break;
  case Shape::file:
    geometry = read_solid(given);
    made_by = &given.file;
    break;
  default:
    throw error_at(given.shape, "found '", to_text(shape),
                   "' with Dimension = 3, allowed: ", to_text(Shape::box), ", ",
                   to_text(Shape::ball), ", ", to_text(Shape::cylinder), ", ", to_text(Shape::tube),
                   ", ", to_text(Shape::file), ".");
  }
  return finished(std::move(geometry), *made_by, given);
}

Geometry<2> make_geometry_of_bodies(const Parameters &parameters) {
  const std::vector<std::string> names = split_words(parameters.geometry.bodies);
  AssertDimension(names.size(), parameters.bodies.size());
  std::vector<Geometry<2>> bodies;
  for (std::size_t k = 0; k < names.size(); ++k) {
    GeometryParameters body = parameters.bodies[k];
    const auto shares_file = [&](const GeometryParameters &other) {
      return other.shape == Shape::file && other.file.value == body.file.value;
    };
    if (std::count_if(parameters.bodies.begin(), parameters.bodies.end(), shares_file) > 1)
      body.part = names[k];
    bodies.push_back(make_geometry<2>(body));
    if (bodies.back().number_after_refinement)
      throw error_at(parameters.geometry.bodies, "a side of the body '", names[k],
                     "' ends inside a face of its coarse mesh, allowed with several bodies: a mesh "
                     "with nodes there.");
  }
  return names.empty() ? make_geometry<2>(parameters.geometry) : unite(names, bodies);
}

template <>
Geometry<2> make_geometry(const GeometryParameters &given) {
  refuse_other_shapes(given, given.shape);
  refuse_foreign_entries(false, {&given.surfaces}, "Dimension = 3", "Dimension = 2");
  Geometry<2> geometry;
  const Entry *made_by = nullptr;
  switch (given.shape.value) {
  case Shape::rectangle: {
    const Block<2> block = read_block<2>(given);
    geometry = make_rectangle(block.lower, block.upper, block.cells);
    made_by = &given.upper_right;
    break;
  }
  case Shape::box:
  case Shape::ball:
  case Shape::cylinder:
  case Shape::tube:
    throw error_at(given.shape, "found '", to_text(given.shape.value),
                   "' with Dimension = 2, allowed: Dimension = 3, or another shape.");
  case Shape::polygon:
    geometry = read_polygon(given);
    made_by = &given.vertices;
    break;
  case Shape::half_disc:
  case Shape::disc:
  case Shape::ring:
    geometry = read_round_body(given);
    made_by = &given.radius;
    break;
  case Shape::file: {
    FileMesh<2> mesh = read_mesh<2>(given);
    if (!given.part.empty())
      keep_part(mesh, given.part, split_words(given.bodies));
    geometry = make_geometry(std::move(mesh), split_words(given.arcs), given.arcs.where());
    made_by = &given.file;
    break;
  }
  }
  return finished(std::move(geometry), *made_by, given);
}
} // namespace Signorini
