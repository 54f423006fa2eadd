// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega: rectangles and convex polygons with named sides, and their coarse meshes.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>
#include <signorini/scene/geometry.h>
#include <signorini/scene/magnitudes.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The outward normal of a side that has the body on its left. */
dealii::Tensor<1, 2> normal_to_the_right(const dealii::Point<2> &start, const dealii::Point<2> &end)
{
  const dealii::Tensor<1, 2> tangent = (end - start) / start.distance(end);
  return dealii::Tensor<1, 2>({tangent[1], -tangent[0]});
}

double cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

std::vector<double> numbers_of(const Parameters &parameters,
                               const std::string &path,
                               const std::string &text)
{
  std::vector<double> numbers;
  if (!read_numbers(text, numbers) || numbers.size() != 2)
    throw InputError(parameters.where(path) + ": found " + quote(text) +
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

Geometry<2> read_rectangle(const Parameters &parameters)
{
  const GeometryParameters &given = parameters.geometry;
  const auto lower = numbers_of(parameters, "Geometry/Lower left", given.lower_left);
  const auto upper = numbers_of(parameters, "Geometry/Upper right", given.upper_right);
  const auto cells = numbers_of(parameters, "Geometry/Cells", given.cells);
  for (const double n : cells)
    if (n < 1 || n > 10000 || n != std::floor(n))
      throw InputError(parameters.where("Geometry/Cells") + ": found " + quote(given.cells) +
                       ", allowed: two integers from 1 to 10000.");
  check_coordinates({{lower[0], lower[1]}}, parameters.where("Geometry/Lower left"));
  check_coordinates({{upper[0], upper[1]}}, parameters.where("Geometry/Upper right"));
  if (!(upper[0] > lower[0] && upper[1] > lower[1]))
    throw InputError(
      parameters.where("Geometry/Upper right") + ": found " + quote(given.upper_right) +
      ", allowed: a point to the right of and above Lower left = " + given.lower_left + ".");
  if (!given.vertices.empty())
    throw InputError(parameters.where("Geometry/Vertices") +
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

Geometry<2> read_polygon(const Parameters &parameters)
{
  const std::string where = parameters.where("Geometry/Vertices");
  for (const char *entry : {"Lower left", "Upper right", "Cells"})
    if (parameters.changed("Geometry/" + std::string(entry)))
      throw InputError(parameters.where("Geometry/" + std::string(entry)) +
                       ": this entry belongs to Shape = rectangle, found Shape = polygon.");
  std::vector<dealii::Point<2>> vertices;
  for (const std::string &part : split_list(parameters.geometry.vertices, ';'))
  {
    const auto xy = numbers_of(parameters, "Geometry/Vertices", part);
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

/** One coarse cell for a quadrilateral, in deal.II's lexicographic order of vertices. */
void make_quadrilateral(const std::vector<dealii::Point<2>> &corners,
                        dealii::Triangulation<2> &triangulation)
{
  dealii::CellData<2> cell;
  cell.vertices = {0, 1, 3, 2};
  triangulation.create_triangulation(corners, {cell}, dealii::SubCellData());
}

/** One coarse cell per corner: corner, middle of the next side, centroid, middle of the last. */
void make_fan(const std::vector<dealii::Point<2>> &corners, dealii::Triangulation<2> &triangulation)
{
  const unsigned int n = corners.size();
  std::vector<dealii::Point<2>> points = corners;
  dealii::Point<2> centroid;
  for (unsigned int i = 0; i < n; ++i)
  {
    points.push_back(corners[i] + 0.5 * (corners[(i + 1) % n] - corners[i]));
    centroid += corners[i] / n;
  }
  points.push_back(centroid);
  std::vector<dealii::CellData<2>> cells(n);
  for (unsigned int i = 0; i < n; ++i)
    cells[i].vertices = {i, n + i, n + (i + n - 1) % n, 2 * n};
  triangulation.create_triangulation(points, cells, dealii::SubCellData());
}

/** Whether a face lies on a side, from end to end. */
template <typename Face>
bool lies_on(const Face &face, const Side<2> &side)
{
  const double length = side.length(), margin = 1e-8 * length;
  for (unsigned int v = 0; v < 2; ++v)
  {
    const double s = side.arc_length(face->vertex(v));
    if (side.point(s).distance(face->vertex(v)) > margin || s < -margin || s > length + margin)
      return false;
  }
  return true;
}
} // namespace

void number_boundary(const std::vector<Side<2>> &sides, dealii::Triangulation<2> &triangulation)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      unsigned int i = 0;
      while (i < sides.size() && !lies_on(face, sides[i]))
        ++i;
      if (i == sides.size())
        throw InputError(
          "Discretization/Coarsest level: a side of this scene ends inside a face of "
          "the mesh, allowed: a finer coarsest level.");
      face->set_boundary_id(i);
    }
}

template <int dim>
dealii::Point<dim> Geometry<dim>::inner_point() const
{
  dealii::Point<dim> mean;
  for (const Side<dim> &side : sides)
    mean += side.point(0.5 * side.length()) / static_cast<double>(sides.size());
  return mean;
}

template <int dim>
double Geometry<dim>::shortest_extent() const
{
  double shortest = diameter();
  for (unsigned int d = 0; d < dim; ++d)
    shortest = std::min(shortest, upper[d] - lower[d]);
  return shortest;
}

template <int dim>
double Geometry<dim>::longest_extent() const
{
  double longest = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    longest = std::max(longest, upper[d] - lower[d]);
  return longest;
}

template <int dim>
std::size_t Geometry<dim>::find_side(const std::string &name) const
{
  std::size_t i = 0;
  while (i < sides.size() && sides[i].name() != name)
    ++i;
  return i;
}

template <int dim>
std::vector<std::string> Geometry<dim>::side_names() const
{
  std::vector<std::string> names;
  for (const Side<dim> &side : sides)
    names.push_back(side.name());
  return names;
}

Geometry<2> make_rectangle(const dealii::Point<2> &lower_left,
                           const dealii::Point<2> &upper_right,
                           const std::vector<unsigned int> &cells)
{
  using P = dealii::Point<2>;
  const P lower_right(upper_right[0], lower_left[1]);
  const P upper_left(lower_left[0], upper_right[1]);
  Geometry<2> geometry;
  geometry.n_coarse_cells = double(cells[0]) * double(cells[1]);
  geometry.lower = lower_left;
  geometry.upper = upper_right;
  // The arc length of every side grows with its coordinate; the order is that of colorize = true.
  geometry.sides = {{"left", lower_left, upper_left, P(-1., 0.)},
                    {"right", lower_right, upper_right, P(1., 0.)},
                    {"bottom", lower_left, lower_right, P(0., -1.)},
                    {"top", upper_left, upper_right, P(0., 1.)}};
  geometry.make_coarse_mesh = [=](dealii::Triangulation<2> &triangulation) {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, cells, lower_left, upper_right, true);
  };
  return geometry;
}

Geometry<2> make_polygon(const std::vector<dealii::Point<2>> &vertices)
{
  const std::size_t n = vertices.size();
  Geometry<2> geometry;
  geometry.n_coarse_cells = n == 4 ? 1. : static_cast<double>(n);
  geometry.lower = geometry.upper = vertices[0];
  for (std::size_t i = 0; i < n; ++i)
  {
    const dealii::Point<2> &next = vertices[(i + 1) % n];
    geometry.sides.emplace_back(
      "side" + std::to_string(i), vertices[i], next, normal_to_the_right(vertices[i], next));
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.lower[d] = std::min(geometry.lower[d], next[d]);
      geometry.upper[d] = std::max(geometry.upper[d], next[d]);
    }
  }
  geometry.make_coarse_mesh = [vertices,
                               sides = geometry.sides](dealii::Triangulation<2> &triangulation) {
    if (vertices.size() == 4)
      make_quadrilateral(vertices, triangulation);
    else
      make_fan(vertices, triangulation);
    number_boundary(sides, triangulation);
  };
  return geometry;
}

Geometry<2> make_geometry(const Parameters &parameters)
{
  const bool is_rectangle = parameters.geometry.shape == "rectangle";
  Geometry<2> geometry = is_rectangle ? read_rectangle(parameters) : read_polygon(parameters);
  check_size(geometry,
             parameters.where(is_rectangle ? "Geometry/Upper right" : "Geometry/Vertices"));
  geometry.distortion = parameters.geometry.distortion;
  geometry.where_distortion = parameters.where("Geometry/Distortion");
  return geometry;
}

template struct Geometry<2>;
} // namespace Signorini
