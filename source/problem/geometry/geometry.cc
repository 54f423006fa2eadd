// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega: rectangles and convex polygons with named sides, and their coarse meshes.

#include <signorini/base/message.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/outline.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <tuple>

namespace Signorini {
namespace {
/** Returns the steps between n + 1 equidistant positions, of which the nearest one has moved to
 * each of the @p lines; where it is taken, a position is added. */
std::vector<double> steps_with_lines(const double from, const double to, const unsigned int n,
                                     const std::vector<double> &lines) {
  const double h = (to - from) / n;
  std::vector<double> positions;
  for (unsigned int i = 0; i <= n; ++i)
    positions.push_back(i == n ? to : from + i * h);
  std::vector<bool> taken(positions.size(), false);
  taken.front() = taken.back() = true;
  std::vector<double> added;
  for (const double line : lines) {
    if (!(line > from && line < to))
      continue;
    const auto i = static_cast<std::size_t>(std::lround((line - from) / h));
    if (taken[i])
      added.push_back(line);
    else {
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

/** Returns whether a face lies on one piece of a side, from end to end. */
template <typename Face>
bool lies_on(const Face &face, const Side<2> &side) {
  const double margin = 1e-8 * side.length();
  const auto has = [&](const Curve &piece, const Point<2> &x) {
    const double s = piece.arc_length(x);
    return piece.point(s).distance(x) <= margin && s >= -margin && s <= piece.length() + margin;
  };
  for (const unsigned int k : side.pieces_near(face->vertex(0), margin))
    if (has(side.piece(k), face->vertex(0)) && has(side.piece(k), face->vertex(1)))
      return true;
  return false;
}

/** Returns the number of the side that a face lies on, or sides.size(). */
template <typename Face>
unsigned int find_side_of(const Face &face, const std::vector<Side<2>> &sides) {
  unsigned int i = 0;
  while (i < sides.size() && !lies_on(face, sides[i]))
    ++i;
  return i;
}
} // namespace

bool ends_inside_a_face(const std::vector<Side<2>> &sides, const Triangulation<2> &triangulation) {
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && find_side_of(face, sides) == sides.size())
      return true;
  return false;
}

void number_boundary(const std::vector<Side<2>> &sides, Triangulation<2> &triangulation) {
  if (ends_inside_a_face(sides, triangulation))
    throw input_error("a side of this scene ends inside a face of the mesh, allowed: a finer mesh "
                      "(Coarsest level).");
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(find_side_of(face, sides));
}

template <int dim>
Point<dim> Geometry<dim>::inner_point() const {
  if (inside)
    return *inside;
  Point<dim> mean;
  for (const Side<dim> &side : sides)
    mean += side.centre() / static_cast<double>(sides.size());
  return mean;
}

template <int dim>
double Geometry<dim>::shortest_extent() const {
  const Tensor<1, dim> extents = upper - lower;
  return *std::min_element(extents.begin_raw(), extents.end_raw());
}

template <int dim>
double Geometry<dim>::longest_extent() const {
  const Tensor<1, dim> extents = upper - lower;
  return *std::max_element(extents.begin_raw(), extents.end_raw());
}

template <int dim>
bool Geometry<dim>::is_axis(const Side<dim> &side) const {
  if constexpr (dim == 2) {
    const double rounding = 1e-10 * diameter();
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
      if (std::max(side.piece(k).centre()[0], side.piece(k).end()[0]) > rounding)
        return false;
    return axisymmetric;
  } else
    return false;
}

template <int dim>
std::size_t Geometry<dim>::find_side(const std::string &name) const {
  std::size_t i = 0;
  while (i < sides.size() && sides[i].name() != name)
    ++i;
  return i;
}

template <int dim>
unsigned int Geometry<dim>::body_of_side(const unsigned int side) const {
  AssertIndexRange(side, sides.size());
  unsigned int body = 0;
  while (body + 1 < bodies.size() && bodies[body + 1].first_side <= side)
    ++body;
  return body;
}

template <int dim>
std::vector<std::string> Geometry<dim>::side_names() const {
  std::vector<std::string> names;
  for (const Side<dim> &side : sides)
    names.push_back(side.name());
  return names;
}

template <int dim>
std::vector<std::string> Geometry<dim>::described_sides() const {
  std::vector<std::string> texts;
  for (const Side<dim> &side : sides) {
    texts.push_back(side.name());
    if (std::isdigit(static_cast<unsigned char>(side.name()[0])) != 0)
      texts.back() += concatenate(" at (", side.centre(), ")");
  }
  return texts;
}

Geometry<2> bounded_by(std::vector<Side<2>> sides) {
  Geometry<2> geometry;
  BoundingBox<2> box = sides.at(0).box();
  for (const Side<2> &side : sides) {
    box.merge_with(side.box());
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
      geometry.curved = geometry.curved || !side.piece(k).is_flat();
  }
  std::tie(geometry.lower, geometry.upper) = box.get_boundary_points();
  geometry.sides = std::move(sides);
  return geometry;
}

Geometry<2> make_rectangle(const Point<2> &lower_left, const Point<2> &upper_right,
                           const std::vector<unsigned int> &cells) {
  AssertDimension(cells.size(), 2);
  using P = Point<2>;
  const P lower_right(upper_right[0], lower_left[1]);
  const P upper_left(lower_left[0], upper_right[1]);
  // The arc length of every side grows with its coordinate; the order is that of colorize = true.
  Geometry<2> geometry = bounded_by({{"left", Curve(lower_left, upper_left, P(-1., 0.))},
                                     {"right", Curve(lower_right, upper_right, P(1., 0.))},
                                     {"bottom", Curve(lower_left, lower_right, P(0., -1.))},
                                     {"top", Curve(upper_left, upper_right, P(0., 1.))}});
  geometry.n_coarse_cells = double(cells[0]) * double(cells[1]);
  geometry.make_coarse_mesh = [=](Triangulation<2> &triangulation) {
    GridGenerator::subdivided_hyper_rectangle(triangulation, cells, lower_left, upper_right, true);
  };
  geometry.make_mesh_with_lines = [=](Triangulation<2> &triangulation, const unsigned int level,
                                      const std::array<std::vector<double>, 2> &lines) {
    std::vector<std::vector<double>> steps;
    for (unsigned int d = 0; d < 2; ++d)
      steps.push_back(steps_with_lines(lower_left[d], upper_right[d], cells[d] << level, lines[d]));
    GridGenerator::subdivided_hyper_rectangle(triangulation, steps, lower_left, upper_right, true);
  };
  return geometry;
}

Geometry<2> make_polygon(const std::vector<Point<2>> &vertices) {
  const auto n = static_cast<unsigned int>(vertices.size());
  Assert(n > 2, ExcMessage("A polygon has three vertices at least."));
  std::vector<Side<2>> sides;
  for (unsigned int i = 0; i < n; ++i)
    sides.emplace_back("side" + std::to_string(i), Curve(vertices[i], vertices[(i + 1) % n]));
  CoarseMesh mesh = {vertices, {{}}, {}};
  for (unsigned int i = 0; i < n; ++i) {
    mesh.cells[0].push_back(i);
    mesh.edges.push_back({i, (i + 1) % n, i, &sides[i]});
  }
  Geometry<2> geometry = make_body(sides, n == 4 ? mesh : split_cells(mesh));
  geometry.star_shaped = true;
  geometry.inside.reset();
  return geometry;
}

Geometry<3> make_box(const Point<3> &lower, const Point<3> &upper,
                     const std::vector<unsigned int> &cells) {
  AssertDimension(cells.size(), 3);
  const char *const names[] = {"left", "right", "front", "back", "bottom", "top"};
  Geometry<3> geometry;
  geometry.n_coarse_cells = double(cells[0]) * double(cells[1]) * double(cells[2]);
  geometry.lower = lower;
  geometry.upper = upper;
  // The order is that of colorize = true.
  for (unsigned int i = 0; i < 6; ++i) {
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

namespace {
constexpr types::manifold_id circle = 0, interior = 1;

/** Attaches manifolds: edges on the circle stay on it; the inside of the cells is interpolated
 * between their edges. */
void attach_manifolds(const std::vector<Side<2>> &sides, const Point<2> &centre,
                      Triangulation<2> &triangulation) {
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
} // namespace

Geometry<2> make_ring(const double inner_radius, const double outer_radius,
                      const Point<2> &centre) {
  Assert(0. < inner_radius && inner_radius < outer_radius, ExcMessage("The radii are in order."));
  // The order is that of colorize = true.
  Geometry<2> geometry =
    bounded_by({{"inner", Curve::arc(centre, inner_radius, -PI, PI, Body::outside)},
                {"outer", Curve::arc(centre, outer_radius, -PI, PI, Body::inside)}});
  geometry.n_coarse_cells = 8.;
  geometry.star_shaped = false;
  geometry.inside = centre + Point<2>(0.5 * (inner_radius + outer_radius), 0.);
  geometry.make_coarse_mesh = [=](Triangulation<2> &triangulation) {
    GridGenerator::hyper_shell(triangulation, centre, inner_radius, outer_radius, 8,
                               /*colorize=*/true);
  };
  return geometry;
}

Geometry<2> make_half_disc(const double radius, const Point<2> &centre) {
  const Point<2> left(centre[0] - radius, centre[1]), right(centre[0] + radius, centre[1]);
  Geometry<2> geometry = bounded_by({{"flat", Curve(left, right, Point<2>(0., 1.))},
                                     {"arc", Curve::arc(centre, radius, -PI, 0., Body::inside)}});
  geometry.n_coarse_cells = 4.;
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

Geometry<2> make_disc(const double radius, const Point<2> &centre) {
  Geometry<2> geometry = bounded_by({{"arc", Curve::arc(centre, radius, -PI, PI, Body::inside)}});
  geometry.n_coarse_cells = 5.;
  geometry.inside = centre;
  geometry.make_coarse_mesh = [=, sides = geometry.sides](Triangulation<2> &triangulation) {
    GridGenerator::hyper_ball(triangulation, centre, radius);
    attach_manifolds(sides, centre, triangulation);
  };
  return geometry;
}

// Where lines cut segments and sides.

template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions) {
  std::vector<KinkLine<dim>> lines;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions[d])
      lines.push_back({Point<dim>::unit_vector(d), position});
  return lines;
}

template <int dim>
Kinks<dim>::Kinks(std::vector<KinkLine<dim>> lines, std::vector<Point<dim>> breaks, BoxTree boxes)
  : lines_(std::move(lines))
  , breaks_(std::move(breaks))
  , boxes_(std::make_shared<BoxTree>(std::move(boxes))) {}

template <int dim>
void Kinks<dim>::add_ends_on(const Side<dim> &contact_side) {
  static_assert(dim == 2, "in space a plane meets a side in a line, not in points");
  for (const double s : separate_crossings(contact_side))
    ends_.push_back(contact_side.point(s));
}

template <int dim>
Kinks<dim> Kinks<dim>::without_ends() const {
  Kinks result = *this;
  result.ends_.clear();
  return result;
}

template <int dim>
Kinks<dim> Kinks<dim>::with_lines(const std::vector<KinkLine<dim>> &more) const {
  Kinks result = *this;
  result.lines_.insert(result.lines_.end(), more.begin(), more.end());
  return result;
}

template <int dim>
std::vector<double> Kinks<dim>::breaks_on(const Point<dim> &a, const Point<dim> &b) const {
  std::vector<double> positions;
  const Tensor<1, dim> edge = b - a;
  for (const Point<dim> &x : breaks_) {
    const double t = edge * (x - a) / edge.norm_square();
    if (t > tolerance && t < 1. - tolerance && (x - a - t * edge).norm() < tolerance * edge.norm())
      positions.push_back(t);
  }
  return positions;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Point<dim> &a, const Point<dim> &b) const {
  std::vector<double> cuts = breaks_on(a, b);
  cuts.insert(cuts.end(), {0., 1.});
  for (const KinkLine<dim> &line : lines_) {
    const double da = line.signed_distance(a), db = line.signed_distance(b);
    const double t = da / (da - db);
    if (t > tolerance && t < 1. - tolerance)
      cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::crossings(const Side<dim> &side, const double from,
                                          const double to) const {
  Assert(from <= to, ExcMessage("The part of a side ends behind its start."));
  const double margin = tolerance * (to - from);
  std::vector<double> cuts = {from, to};
  for (const KinkLine<dim> &line : lines_)
    for (const double s : side.crossings(line.normal, line.position, from + margin, to - margin))
      cuts.push_back(s);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Side<dim> &side, const double from,
                                    const double to) const {
  std::vector<double> cuts = crossings(side, from, to);
  const double margin = tolerance * (to - from);
  for (const Point<dim> &x : breaks_) {
    const double s = side.arc_length(x);
    if (s > from + margin && s < to - margin && side.point(s).distance(x) < margin)
      cuts.push_back(s);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::separate_crossings(const Side<dim> &side) const {
  const std::vector<double> cuts = crossings(side, 0., side.length());
  std::vector<double> separate;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
    if (separate.empty() || cuts[i] - separate.back() >= min_distance * side.length())
      separate.push_back(cuts[i]);
  return separate;
}

template <int dim>
bool Kinks<dim>::touch(const Side<dim> &side, const double from, const double to) const {
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
template Kinks<3>::Kinks(std::vector<KinkLine<3>>, std::vector<Point<3>>, BoxTree);
} // namespace Signorini
