// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega with circular sides.

#include <signorini/scene/geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace Signorini
{
using dealii::numbers::PI;
using Point = dealii::Point<2>;

namespace
{
constexpr dealii::types::manifold_id circle = 0, interior = 1;

/** Edges on the circle stay on it; the inside of the cells is interpolated between their edges. */
void attach_manifolds(const std::vector<Side<2>> &sides,
                      const Point &centre,
                      dealii::Triangulation<2> &triangulation)
{
  number_boundary(sides, triangulation);
  triangulation.reset_all_manifolds();
  triangulation.set_all_manifold_ids(interior);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && sides[face->boundary_id()].radius() > 0.)
      face->set_manifold_id(circle);
  triangulation.set_manifold(circle, dealii::SphericalManifold<2>(centre));
  dealii::TransfiniteInterpolationManifold<2> transfinite;
  transfinite.initialize(triangulation);
  triangulation.set_manifold(interior, transfinite);
}

Geometry<2> make_curved(const unsigned int n_coarse_cells, const Point &lower, const Point &upper)
{
  Geometry<2> geometry;
  geometry.curved = true;
  geometry.n_coarse_cells = n_coarse_cells;
  geometry.lower = lower;
  geometry.upper = upper;
  return geometry;
}
} // namespace

Geometry<2> make_ring(const double inner_radius, const double outer_radius, const Point &centre)
{
  const Point corner(outer_radius, outer_radius);
  Geometry<2> geometry = make_curved(8, Point(centre - corner), centre + corner);
  geometry.star_shaped = false;
  geometry.inside = centre + Point(0.5 * (inner_radius + outer_radius), 0.);
  // The order is that of colorize = true.
  geometry.sides = {{"inner", Curve::arc(centre, inner_radius, -PI, PI, Body::outside)},
                    {"outer", Curve::arc(centre, outer_radius, -PI, PI, Body::inside)}};
  geometry.make_coarse_mesh = [=](dealii::Triangulation<2> &triangulation) {
    dealii::GridGenerator::hyper_shell(
      triangulation, centre, inner_radius, outer_radius, 8, /*colorize=*/true);
  };
  return geometry;
}

Geometry<2> make_half_disc(const double radius, const Point &centre)
{
  Geometry<2> geometry =
    make_curved(4, Point(centre - Point(radius, radius)), centre + Point(radius, 0.));
  geometry.sides = {
    {"flat", Curve(Point(centre - Point(radius, 0.)), centre + Point(radius, 0.), Point(0., 1.))},
    {"arc", Curve::arc(centre, radius, -PI, 0., Body::inside)}};
  geometry.make_coarse_mesh = [=, sides = geometry.sides](dealii::Triangulation<2> &triangulation) {
    // It lies to the right of the y-axis.
    dealii::GridGenerator::half_hyper_ball(triangulation, Point(), radius);
    triangulation.reset_all_manifolds();
    dealii::GridTools::rotate(-0.5 * PI, triangulation);
    dealii::GridTools::shift(centre, triangulation);
    attach_manifolds(sides, centre, triangulation);
  };
  return geometry;
}

Geometry<2> make_disc(const double radius, const Point &centre)
{
  const Point corner(radius, radius);
  Geometry<2> geometry = make_curved(5, Point(centre - corner), centre + corner);
  geometry.inside = centre;
  geometry.sides = {{"arc", Curve::arc(centre, radius, -PI, PI, Body::inside)}};
  geometry.make_coarse_mesh = [=, sides = geometry.sides](dealii::Triangulation<2> &triangulation) {
    dealii::GridGenerator::hyper_ball(triangulation, centre, radius);
    attach_manifolds(sides, centre, triangulation);
  };
  return geometry;
}
} // namespace Signorini
