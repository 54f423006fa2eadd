// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega: rectangles and convex polygons with named sides, and their coarse meshes.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** Returns the outward normal of a side that has the body on its left. */
Tensor<1, 2> normal_to_the_right(const Point<2> &start, const Point<2> &end)
{
  const Tensor<1, 2> tangent = (end - start) / start.distance(end);
  return Tensor<1, 2>({tangent[1], -tangent[0]});
}

/** Makes one coarse cell of a quadrilateral, in deal.II's lexicographic order of vertices. */
void make_quadrilateral(const std::vector<Point<2>> &corners, Triangulation<2> &triangulation)
{
  CellData<2> cell;
  cell.vertices = {0, 1, 3, 2};
  triangulation.create_triangulation(corners, {cell}, SubCellData());
}

/** Makes one coarse cell per corner: corner, middle of the next side, centroid, middle of the last.
 */
void make_fan(const std::vector<Point<2>> &corners, Triangulation<2> &triangulation)
{
  const unsigned int n = corners.size();
  std::vector<Point<2>> points = corners;
  Point<2> centroid;
  for (unsigned int i = 0; i < n; ++i)
  {
    points.push_back(corners[i] + 0.5 * (corners[(i + 1) % n] - corners[i]));
    centroid += corners[i] / n;
  }
  points.push_back(centroid);
  std::vector<CellData<2>> cells(n);
  for (unsigned int i = 0; i < n; ++i)
    cells[i].vertices = {i, n + i, n + (i + n - 1) % n, 2 * n};
  triangulation.create_triangulation(points, cells, SubCellData());
}

/** Returns the steps between n + 1 equidistant positions, of which the nearest one has moved to
 * each of the @p lines; where it is taken, a position is added. */
std::vector<double> steps_with_lines(const double from,
                                     const double to,
                                     const unsigned int n,
                                     const std::vector<double> &lines)
{
  const double h = (to - from) / n;
  std::vector<double> positions;
  for (unsigned int i = 0; i <= n; ++i)
    positions.push_back(i == n ? to : from + i * h);
  std::vector<bool> taken(positions.size(), false);
  taken.front() = taken.back() = true;
  std::vector<double> added;
  for (const double line : lines)
  {
    if (!(line > from && line < to))
      continue;
    const auto i = static_cast<std::size_t>(std::lround((line - from) / h));
    if (taken[i])
      added.push_back(line);
    else
    {
      positions[i] = line;
      taken[i] = true;
    }
  }
  positions.insert(positions.end(), added.begin(), added.end());
  std::sort(positions.begin(), positions.end());
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    // A line that is given twice, or that lies on a side, is one line.
    if (positions[i + 1] - positions[i] > 1e-10 * (to - from))
      steps.push_back(positions[i + 1] - positions[i]);
  return steps;
}

/** Returns whether a face lies on a segment or an arc, from end to end. */
template <typename Face>
bool lies_on_piece(const Face &face, const Curve &piece, const double margin)
{
  const double length = piece.length();
  for (unsigned int v = 0; v < 2; ++v)
  {
    const double s = piece.arc_length(face->vertex(v));
    if (piece.point(s).distance(face->vertex(v)) > margin || s < -margin || s > length + margin)
      return false;
  }
  return true;
}

/** Returns whether a face lies on one piece of a side, from end to end. */
template <typename Face>
bool lies_on(const Face &face, const Side<2> &side)
{
  const double margin = 1e-8 * side.length();
  for (const unsigned int k : side.pieces_near(face->vertex(0), margin))
    if (lies_on_piece(face, side.piece(k), margin))
      return true;
  return false;
}

/** Returns the number of the side that a face lies on, or sides.size(). */
template <typename Face>
unsigned int find_side_of(const Face &face, const std::vector<Side<2>> &sides)
{
  unsigned int i = 0;
  while (i < sides.size() && !lies_on(face, sides[i]))
    ++i;
  return i;
}
} // namespace

bool ends_inside_a_face(const std::vector<Side<2>> &sides, const Triangulation<2> &triangulation)
{
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && find_side_of(face, sides) == sides.size())
      return true;
  return false;
}

void number_boundary(const std::vector<Side<2>> &sides, Triangulation<2> &triangulation)
{
  if (ends_inside_a_face(sides, triangulation))
    throw InputError("a side of this scene ends inside a face of the mesh, allowed: a finer mesh.");
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(find_side_of(face, sides));
}

template <int dim>
Point<dim> Geometry<dim>::inner_point() const
{
  if (inside)
    return *inside;
  Point<dim> mean;
  for (const Side<dim> &side : sides)
    mean += side.centre() / static_cast<double>(sides.size());
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

Geometry<2> make_rectangle(const Point<2> &lower_left,
                           const Point<2> &upper_right,
                           const std::vector<unsigned int> &cells)
{
  using P = Point<2>;
  const P lower_right(upper_right[0], lower_left[1]);
  const P upper_left(lower_left[0], upper_right[1]);
  Geometry<2> geometry;
  geometry.n_coarse_cells = double(cells[0]) * double(cells[1]);
  geometry.lower = lower_left;
  geometry.upper = upper_right;
  // The arc length of every side grows with its coordinate; the order is that of colorize = true.
  geometry.sides = {{"left", Curve(lower_left, upper_left, P(-1., 0.))},
                    {"right", Curve(lower_right, upper_right, P(1., 0.))},
                    {"bottom", Curve(lower_left, lower_right, P(0., -1.))},
                    {"top", Curve(upper_left, upper_right, P(0., 1.))}};
  geometry.make_coarse_mesh = [=](Triangulation<2> &triangulation) {
    GridGenerator::subdivided_hyper_rectangle(triangulation, cells, lower_left, upper_right, true);
  };
  geometry.make_mesh_with_lines = [=](Triangulation<2> &triangulation,
                                      const unsigned int level,
                                      const std::array<std::vector<double>, 2> &lines) {
    std::vector<std::vector<double>> steps;
    for (unsigned int d = 0; d < 2; ++d)
      steps.push_back(steps_with_lines(lower_left[d], upper_right[d], cells[d] << level, lines[d]));
    GridGenerator::subdivided_hyper_rectangle(triangulation, steps, lower_left, upper_right, true);
  };
  return geometry;
}

Geometry<2> make_polygon(const std::vector<Point<2>> &vertices)
{
  const std::size_t n = vertices.size();
  Geometry<2> geometry;
  geometry.n_coarse_cells = n == 4 ? 1. : static_cast<double>(n);
  geometry.lower = geometry.upper = vertices[0];
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point<2> &next = vertices[(i + 1) % n];
    geometry.sides.emplace_back("side" + std::to_string(i),
                                Curve(vertices[i], next, normal_to_the_right(vertices[i], next)));
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.lower[d] = std::min(geometry.lower[d], next[d]);
      geometry.upper[d] = std::max(geometry.upper[d], next[d]);
    }
  }
  geometry.make_coarse_mesh = [vertices, sides = geometry.sides](Triangulation<2> &triangulation) {
    if (vertices.size() == 4)
      make_quadrilateral(vertices, triangulation);
    else
      make_fan(vertices, triangulation);
    number_boundary(sides, triangulation);
  };
  return geometry;
}

Geometry<3> make_box(const Point<3> &lower,
                     const Point<3> &upper,
                     const std::vector<unsigned int> &cells)
{
  const char *const names[] = {"left", "right", "front", "back", "bottom", "top"};
  Geometry<3> geometry;
  geometry.n_coarse_cells = double(cells[0]) * double(cells[1]) * double(cells[2]);
  geometry.lower = lower;
  geometry.upper = upper;
  // The order is that of colorize = true.
  for (unsigned int i = 0; i < 6; ++i)
  {
    const unsigned int d = i / 2, first = (d + 1) % 3, second = (d + 2) % 3;
    const auto edge = [&](const unsigned int e) {
      return (upper[e] - lower[e]) * Point<3>::unit_vector(e);
    };
    Point<3> corner = lower;
    corner[d] = i % 2 == 0 ? lower[d] : upper[d];
    const double sign = i % 2 == 0 ? -1. : 1.;
    geometry.sides.emplace_back(
      names[i], Rectangle(corner, edge(first), edge(second), sign * Point<3>::unit_vector(d)));
  }
  geometry.make_coarse_mesh = [=](Triangulation<3> &triangulation) {
    GridGenerator::subdivided_hyper_rectangle(triangulation, cells, lower, upper, true);
  };
  return geometry;
}

template struct Geometry<2>;
template struct Geometry<3>;

// Omega with circular sides.

using numbers::PI;

namespace
{
constexpr types::manifold_id circle = 0, interior = 1;

/** Attaches manifolds: edges on the circle stay on it; the inside of the cells is interpolated
 * between their edges. */
void attach_manifolds(const std::vector<Side<2>> &sides,
                      const Point<2> &centre,
                      Triangulation<2> &triangulation)
{
  number_boundary(sides, triangulation);
  triangulation.reset_all_manifolds();
  triangulation.set_all_manifold_ids(interior);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && sides[face->boundary_id()].radius() > 0.)
      face->set_manifold_id(circle);
  triangulation.set_manifold(circle, SphericalManifold<2>(centre));
  TransfiniteInterpolationManifold<2> transfinite;
  transfinite.initialize(triangulation);
  triangulation.set_manifold(interior, transfinite);
}

Geometry<2> make_curved(const unsigned int n_coarse_cells,
                        const Point<2> &lower,
                        const Point<2> &upper)
{
  Geometry<2> geometry;
  geometry.curved = true;
  geometry.n_coarse_cells = n_coarse_cells;
  geometry.lower = lower;
  geometry.upper = upper;
  return geometry;
}
} // namespace

Geometry<2> make_ring(const double inner_radius, const double outer_radius, const Point<2> &centre)
{
  const Point<2> corner(outer_radius, outer_radius);
  Geometry<2> geometry = make_curved(8, Point<2>(centre - corner), centre + corner);
  geometry.star_shaped = false;
  geometry.inside = centre + Point<2>(0.5 * (inner_radius + outer_radius), 0.);
  // The order is that of colorize = true.
  geometry.sides = {{"inner", Curve::arc(centre, inner_radius, -PI, PI, Body::outside)},
                    {"outer", Curve::arc(centre, outer_radius, -PI, PI, Body::inside)}};
  geometry.make_coarse_mesh = [=](Triangulation<2> &triangulation) {
    GridGenerator::hyper_shell(
      triangulation, centre, inner_radius, outer_radius, 8, /*colorize=*/true);
  };
  return geometry;
}

Geometry<2> make_half_disc(const double radius, const Point<2> &centre)
{
  Geometry<2> geometry =
    make_curved(4, Point<2>(centre - Point<2>(radius, radius)), centre + Point<2>(radius, 0.));
  geometry.sides = {{"flat",
                     Curve(Point<2>(centre - Point<2>(radius, 0.)),
                           centre + Point<2>(radius, 0.),
                           Point<2>(0., 1.))},
                    {"arc", Curve::arc(centre, radius, -PI, 0., Body::inside)}};
  geometry.make_coarse_mesh = [=, sides = geometry.sides](Triangulation<2> &triangulation) {
    // deal.II's half disc lies to the right of the y-axis.
    GridGenerator::half_hyper_ball(triangulation, Point<2>(), radius);
    triangulation.reset_all_manifolds();
    GridTools::rotate(-0.5 * PI, triangulation);
    GridTools::shift(centre, triangulation);
    attach_manifolds(sides, centre, triangulation);
  };
  return geometry;
}

Geometry<2> make_disc(const double radius, const Point<2> &centre)
{
  const Point<2> corner(radius, radius);
  Geometry<2> geometry = make_curved(5, Point<2>(centre - corner), centre + corner);
  geometry.inside = centre;
  geometry.sides = {{"arc", Curve::arc(centre, radius, -PI, PI, Body::inside)}};
  geometry.make_coarse_mesh = [=, sides = geometry.sides](Triangulation<2> &triangulation) {
    GridGenerator::hyper_ball(triangulation, centre, radius);
    attach_manifolds(sides, centre, triangulation);
  };
  return geometry;
}

// Where lines cut segments and sides.

template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions)
{
  std::vector<KinkLine<dim>> lines;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions[d])
      lines.push_back({Point<dim>::unit_vector(d), position});
  return lines;
}

template <int dim>
Kinks<dim>::Kinks(std::vector<KinkLine<dim>> lines)
  : lines_(std::move(lines))
{
}

template <int dim>
void Kinks<dim>::add_ends_on(const Side<dim> &contact_side)
{
  static_assert(dim == 2, "in space a plane meets a side in a line, not in points");
  const std::vector<double> cuts = cut(contact_side, 0., contact_side.length());
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
    ends_.push_back(contact_side.point(cuts[i]));
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Point<dim> &a, const Point<dim> &b) const
{
  std::vector<double> cuts = {0., 1.};
  for (const KinkLine<dim> &line : lines_)
  {
    const double da = line.signed_distance(a), db = line.signed_distance(b);
    const double t = da / (da - db);
    if (t > tolerance && t < 1. - tolerance)
      cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Side<dim> &side, const double from, const double to) const
{
  const double margin = tolerance * (to - from);
  std::vector<double> cuts = {from, to};
  for (const KinkLine<dim> &line : lines_)
    for (const double s : side.crossings(line.normal, line.position, from + margin, to - margin))
      cuts.push_back(s);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
bool Kinks<dim>::touch(const Side<dim> &side, const double from, const double to) const
{
  const double margin = tolerance * (to - from);
  for (const KinkLine<dim> &line : lines_)
    for (const double end : {from, to})
      if (!side.crossings(line.normal, line.position, end - margin, end + margin).empty())
        return true;
  return false;
}

template std::vector<KinkLine<2>> lines_at<2>(const std::array<std::vector<double>, 2> &);
template class Kinks<2>;
// Planes do not cut sides in 3-D yet: none may be given.
template Kinks<3>::Kinks(std::vector<KinkLine<3>>);
} // namespace Signorini
