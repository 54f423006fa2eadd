// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega between closed loops of segments and arcs.

#include <signorini/base/exceptions.h>
#include <signorini/scene/outline.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "outline_mesh.h"

namespace Signorini
{
namespace
{
/** The box around the sides. */
std::array<dealii::Point<2>, 2> box_around(const std::vector<Side<2>> &sides)
{
  std::array<dealii::Point<2>, 2> box = {{sides[0].start(), sides[0].start()}};
  const auto include = [&box](const dealii::Point<2> &x) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      box[0][d] = std::min(box[0][d], x[d]);
      box[1][d] = std::max(box[1][d], x[d]);
    }
  };
  for (const Side<2> &side : sides)
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
    {
      const Curve &piece = side.piece(k);
      include(piece.start());
      include(piece.end());
      for (unsigned int d = 0; d < 2 && piece.radius() > 0.; ++d)
        for (const double sign : {-1., 1.})
        {
          // The point of the circle that is farthest in this direction, if it is on the arc.
          const dealii::Point<2> x =
            piece.centre_of_circle() + sign * piece.radius() * dealii::Point<2>::unit_vector(d);
          const double s = piece.arc_length(x);
          if (s > 0. && s < piece.length())
            include(x);
        }
    }
  return box;
}

OutlineMesh make_mesh(const std::vector<Side<2>> &sides,
                      const std::vector<Loop> &loops,
                      const double mesh_size,
                      const std::string &where)
{
  // With shorter chords the cells next to arcs are less bent.
  double step = 0.25 * dealii::numbers::PI;
  for (unsigned int attempt = 0; attempt < 10; ++attempt, step *= 0.7)
    if (auto mesh = mesh_outline(sides, loops, mesh_size, step, most_coarse_cells, where))
      return *mesh;
  throw InputError(where +
                   ": no mesh was found for this shape, allowed: arcs that do not come very "
                   "close to other sides or meet them at very small angles.");
}

/** The centre of the largest triangle: every third vertex behind the middles of its edges. */
dealii::Point<2> point_inside(const OutlineMesh &mesh)
{
  double largest = 0.;
  dealii::Point<2> inside;
  for (const dealii::CellData<2> &cell : mesh.cells)
  {
    const dealii::Tensor<1, 2> a =
      mesh.vertices[cell.vertices[3]] - mesh.vertices[cell.vertices[0]];
    const dealii::Tensor<1, 2> b =
      mesh.vertices[cell.vertices[2]] - mesh.vertices[cell.vertices[1]];
    const double area = 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);
    // Of equal ones the first, whatever rounding makes of them.
    if (area > (1. + 1e-9) * largest)
    {
      largest = area;
      inside = mesh.vertices[cell.vertices[3]];
    }
  }
  return inside;
}

void make_triangulation(const OutlineMesh &mesh, dealii::Triangulation<2> &triangulation)
{
  triangulation.create_triangulation(mesh.vertices, mesh.cells, mesh.lines);
  for (std::size_t k = 0; k < mesh.circles.size(); ++k)
    triangulation.set_manifold(k, dealii::SphericalManifold<2>(mesh.circles[k]));
  for (std::size_t k = 0; k < mesh.curved_cells.size(); ++k)
    triangulation.set_manifold(mesh.circles.size() + k, mesh.curved_cells[k]);
}
} // namespace

Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides,
                               const double mesh_size,
                               const std::string &where)
{
  Geometry<2> geometry;
  geometry.sides = sides;
  const auto [lower, upper] = box_around(sides);
  geometry.lower = lower;
  geometry.upper = upper;
  const std::vector<Loop> loops = find_loops(sides, geometry.diameter(), where);
  check_outline(sides, loops, geometry.diameter(), where);
  const auto mesh = std::make_shared<const OutlineMesh>(make_mesh(sides, loops, mesh_size, where));
  geometry.n_coarse_cells = static_cast<double>(mesh->cells.size());
  geometry.curved = !mesh->circles.empty();
  geometry.star_shaped = false;
  geometry.inside = point_inside(*mesh);
  geometry.make_coarse_mesh = [mesh](dealii::Triangulation<2> &triangulation) {
    make_triangulation(*mesh, triangulation);
  };
  return geometry;
}
} // namespace Signorini
