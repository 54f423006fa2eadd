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

Geometry<2> make_ring(const double inner_radius, const double outer_radius)
{
  Geometry<2> geometry;
  geometry.curved = true;
  geometry.n_coarse_cells = 8.;
  geometry.lower = Point(-outer_radius, -outer_radius);
  geometry.upper = Point(outer_radius, outer_radius);
  // The order is that of colorize = true.
  geometry.sides = {{"inner", Curve::arc(Point(), inner_radius, -PI, PI, Body::outside)},
                    {"outer", Curve::arc(Point(), outer_radius, -PI, PI, Body::inside)}};
  geometry.make_coarse_mesh = [=](dealii::Triangulation<2> &triangulation) {
    dealii::GridGenerator::hyper_shell(
      triangulation, Point(), inner_radius, outer_radius, 8, /*colorize=*/true);
  };
  return geometry;
}

Geometry<2> make_half_disc(const double radius)
{
  Geometry<2> geometry;
  geometry.curved = true;
  geometry.n_coarse_cells = 4.;
  geometry.lower = Point(-radius, -radius);
  geometry.upper = Point(radius, 0.);
  geometry.sides = {{"flat", Curve(Point(-radius, 0.), Point(radius, 0.), Point(0., 1.))},
                    {"arc", Curve::arc(Point(), radius, -PI, 0., Body::inside)}};
  geometry.make_coarse_mesh = [=, sides = geometry.sides](dealii::Triangulation<2> &triangulation) {
    constexpr dealii::types::manifold_id circle = 0, interior = 1;
    // It lies to the right of the y-axis.
    dealii::GridGenerator::half_hyper_ball(triangulation, Point(), radius);
    triangulation.reset_all_manifolds();
    dealii::GridTools::rotate(-0.5 * PI, triangulation);
    number_boundary(sides, triangulation);
    triangulation.set_all_manifold_ids(interior);
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == 1)
        face->set_manifold_id(circle);
    triangulation.set_manifold(circle, dealii::SphericalManifold<2>());
    dealii::TransfiniteInterpolationManifold<2> transfinite;
    transfinite.initialize(triangulation);
    triangulation.set_manifold(interior, transfinite);
  };
  return geometry;
}
} // namespace Signorini
