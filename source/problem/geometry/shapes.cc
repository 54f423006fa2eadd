// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega: rectangles, boxes, convex polygons, rings and discs with named sides, and their coarse
// meshes.

#include <signorini/problem/geometry/outline.h>
#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Signorini {
using numbers::PI;

namespace {
constexpr types::manifold_id circle = 0, interior = 1;

/** Returns the steps of a grid from one position to another that has the @p lines among its own:
 * between two of these they are equal, and close to the n-th part of the whole. */
std::vector<double> steps_with_lines(const double from, const double to, const unsigned int n,
                                     std::vector<double> lines) {
  // A line that is given twice, or that lies on a side, is one line.
  const double same = 1e-10 * (to - from);
  lines.push_back(to);
  std::sort(lines.begin(), lines.end());
  std::vector<double> steps;
  double last = from;
  for (const double line : lines) {
    const double length = line - last;
    if (length <= same || (line < to && to - line <= same) || line > to)
      continue;
    const auto parts = std::max(1L, std::lround(n * length / (to - from)));
    steps.insert(steps.end(), parts, length / static_cast<double>(parts));
    last = line;
  }
  return steps;
}

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
  // SphericalManifold takes the angle from its cosine, which loses the digits of small cells.
  triangulation.set_manifold(circle, PolarManifold<2>(centre));
  TransfiniteInterpolationManifold<2> transfinite;
  transfinite.initialize(triangulation);
  triangulation.set_manifold(interior, transfinite);
}
} // namespace

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
  std::array<unsigned int, 2> division = {{1, 1}};
  const double size[] = {(upper_right[0] - lower_left[0]) / cells[0],
                         (upper_right[1] - lower_left[1]) / cells[1]};
  const unsigned int longer = size[0] > size[1] ? 0 : 1;
  division[longer] = static_cast<unsigned int>(std::lround(size[longer] / size[1 - longer]));
  geometry.division = division[longer];
  geometry.make_guided_mesh = [=](Triangulation<2> &triangulation, const unsigned int level,
                                  const MeshGuides<2> &guides) {
    auto lines = guides.lines;
    for (const auto &[side, point] : guides.vertices) {
      const unsigned int along = side < 2 ? 1 : 0;
      lines[along].push_back(point[along]);
    }
    std::vector<std::vector<double>> steps;
    for (unsigned int d = 0; d < 2; ++d)
      steps.push_back(steps_with_lines(lower_left[d], upper_right[d],
                                       (cells[d] * division[d]) << level, lines[d]));
    GridGenerator::subdivided_hyper_rectangle(triangulation, steps, lower_left, upper_right, true);
    return 0U;
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
    const unsigned int d = i / 2, side = i % 2;
    // The corners run round the outward normal.
    const unsigned int first = (d + 2 - side) % 3, second = (d + 1 + side) % 3;
    FaceCorners corners;
    for (unsigned int v = 0; v < 4; ++v) {
      corners[v][d] = side == 0 ? lower[d] : upper[d];
      corners[v][first] = v % 2 == 0 ? lower[first] : upper[first];
      corners[v][second] = v < 2 ? lower[second] : upper[second];
    }
    const Tensor<1, 3> normal = (side == 0 ? -1. : 1.) * Point<3>::unit_vector(d);
    geometry.sides.emplace_back(names[i],
                                SurfacePart(Surface::plane(corners[0], normal), {corners}));
  }
  geometry.make_coarse_mesh = [=](Triangulation<3> &triangulation) {
    GridGenerator::subdivided_hyper_rectangle(triangulation, cells, lower, upper, true);
  };
  return geometry;
}

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

} // namespace Signorini
