// SPDX-License-Identifier: LGPL-2.1-or-later
// Polygons with arcs, fillets and holes, discs and rings: areas, lengths, and cells that are never
// folded.

#include <signorini/base/errors.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
using Point = dealii::Point<2>;

/** The body of a parameter file; the contact side is any, and so is the one that holds the body. */
Geometry<2> body(const std::vector<std::string> &entries,
                 const std::string &contact,
                 const std::string &clamped)
{
  std::vector<std::string> overrides = {"Boundary/Contact=" + contact,
                                        "Boundary/Clamped=" + clamped};
  for (const std::string &entry : entries)
    overrides.push_back("Geometry/" + entry);
  return make_scene<2>(parse_parameters("", "test", overrides)).geometry;
}

Geometry<2> polygon(const std::string &vertices,
                    const std::string &holes = "",
                    const std::string &mesh_size = "0")
{
  return body({"Shape=polygon", "Vertices=" + vertices, "Holes=" + holes, "Mesh size=" + mesh_size},
              "side0",
              "side1");
}

struct Expected
{
  double area;
  std::map<std::string, double> lengths;
};

/** Area and lengths by the mapped mesh and by the sides; int n ds = 0; positive Jacobians at all
 * levels; vertices of boundary faces on their sides. */
void check_body(Checks &checks,
                const std::string &name,
                const Geometry<2> &geometry,
                const Expected &expected)
{
  dealii::Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  double min_ratio = 1.;
  const dealii::FE_Nothing<2> no_functions;
  const dealii::QGaussLobatto<2> nodes(5);
  for (unsigned int level = 0; level < 4; ++level)
  {
    if (level > 0)
      mesh.refine_global(1);
    const dealii::MappingQ<2> mapping(2);
    dealii::FEValues<2> values(mapping, no_functions, nodes, dealii::update_jacobians);
    for (const auto &cell : mesh.active_cell_iterators())
    {
      values.reinit(cell);
      double smallest = INFINITY, largest = 0.;
      for (unsigned int q = 0; q < nodes.size(); ++q)
      {
        const double determinant = values.jacobian(q).determinant();
        smallest = std::min(smallest, determinant);
        largest = std::max(largest, determinant);
      }
      min_ratio = std::min(min_ratio, smallest / largest);
    }
  }
  checks.that(name + ": cells are not folded", min_ratio > 0.05);
  const dealii::MappingQ<2> mapping(5);
  const dealii::QGauss<2> gauss(6);
  const dealii::QGauss<1> face_gauss(6);
  dealii::FEValues<2> values(mapping, no_functions, gauss, dealii::update_JxW_values);
  dealii::FEFaceValues<2> face_values(mapping,
                                      no_functions,
                                      face_gauss,
                                      dealii::update_JxW_values | dealii::update_normal_vectors |
                                        dealii::update_quadrature_points);
  double area = 0., off = 0., turned = 0.;
  std::vector<double> lengths(geometry.sides.size(), 0.);
  dealii::Tensor<1, 2> sum;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    values.reinit(cell);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      area += values.JxW(q);
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        const Side<2> &side = geometry.sides.at(cell->face(f)->boundary_id());
        face_values.reinit(cell, f);
        for (unsigned int q = 0; q < face_gauss.size(); ++q)
        {
          const Point &x = face_values.quadrature_point(q);
          const double s = side.arc_length(x);
          lengths[cell->face(f)->boundary_id()] += face_values.JxW(q);
          sum += face_values.JxW(q) * face_values.normal_vector(q);
          off = std::max(off, side.point(s).distance(x));
          turned = std::max(turned, (side.normal(s) - face_values.normal_vector(q)).norm());
        }
      }
  }
  const double size = geometry.diameter();
  checks.near(name + ": area", area, expected.area, 1e-8 * expected.area);
  checks.near(name + ": faces are on their sides", off, 0., 1e-8 * size);
  checks.near(name + ": with their normals", turned, 0., 1e-5);
  checks.near(name + ": the normal has the mean zero", sum.norm(), 0., 1e-10 * size);
  for (const auto &[side, length] : expected.lengths)
  {
    const std::size_t i = geometry.find_side(side);
    checks.that(name + ": has the side " + side, i < geometry.sides.size());
    if (i == geometry.sides.size())
      continue;
    checks.near(name + ": length of " + side, geometry.sides[i].length(), length, 1e-12 * size);
    checks.near(name + ": faces of " + side, lengths[i], length, 1e-8 * size);
  }
  checks.that(name + ": the point inside", [&] {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->point_inside(geometry.inner_point()))
        return true;
    return false;
  }());
}

void test_straight(Checks &checks)
{
  const std::string l = "0,0; 2,0; 2,1; 1,1; 1,2; 0,2";
  const Geometry<2> geometry = polygon(l);
  check_body(checks, "L", geometry, {3., {{"side0", 2.}, {"side2", 1.}, {"side5", 2.}}});
  checks.that("L: straight", !geometry.curved);
  checks.that("L: box", geometry.lower == Point(0., 0.) && geometry.upper == Point(2., 2.));
  unsigned int n_reentrant = 0;
  for (const Corner &corner : corners(geometry))
    n_reentrant += std::abs(corner.angle - 1.5 * PI) < 1e-12 ? 1 : 0;
  checks.that("L: corners", corners(geometry).size() == 6 && n_reentrant == 1);
  check_body(checks,
             "L, clockwise",
             polygon("0,2; 1,2; 1,1; 2,1; 2,0; 0,0"),
             {3., {{"side0", 1.}, {"side4", 2.}, {"side5", 2.}}});
  check_body(checks, "divided side", polygon("0,0; 1,0; 3,0; 3,1; 0,1"), {3., {{"side1", 2.}}});
  const Geometry<2> fine = polygon(l, "", "0.25");
  checks.that("L: Mesh size", fine.n_coarse_cells > 3. * 3. * 16.);
  check_body(checks, "L, fine", fine, {3., {{"side0", 2.}}});
}

void test_curved(Checks &checks)
{
  check_body(
    checks,
    "L with a fillet",
    polygon("0,0; 3,0; 3,1; 1,1 fillet 0.5; 1,3; 0,3"),
    {5. + 0.25 * (1. - 0.25 * PI), {{"side2", 1.5}, {"fillet3", 0.25 * PI}, {"side3", 1.5}}});
  check_body(checks,
             "round corners",
             polygon("0,0 fillet 0.2; 1,0 fillet 0.01; 1,1 fillet 0.4; 0,1"),
             {1. - (0.04 + 1e-4 + 0.16) * (1. - 0.25 * PI),
              {{"fillet0", 0.1 * PI}, {"side0", 0.79}, {"fillet1", 0.005 * PI}}});
  check_body(checks,
             "half disc by arcs",
             polygon("-1,0; arc 0,0 ccw; 1,0"),
             {0.5 * PI, {{"side0", PI}, {"side1", 2.}}});
  check_body(checks,
             "half disc by arcs, clockwise",
             polygon("1,0; arc 0,0 cw; -1,0"),
             {0.5 * PI, {{"side0", PI}, {"side1", 2.}}});
  check_body(
    checks,
    "moon",
    polygon("0,-1; arc 0,0 ccw; 0,1; arc -1,0 cw"),
    {0.5 * PI - (0.25 * PI * 2. - 1.), {{"side0", PI}, {"side1", std::sqrt(2.) * PI / 2.}}});
}

void test_holes(Checks &checks)
{
  const Geometry<2> plate = polygon("-2,-1; 2,-1; 2,1; -2,1", "circle 0,0,0.5");
  check_body(checks, "plate", plate, {8. - 0.25 * PI, {{"hole0", PI}, {"side0", 4.}}});
  checks.that("plate: the hole is one closed side", plate.sides[4].is_closed());
  check_body(checks,
             "thin plate",
             polygon("-1,-0.55; 1,-0.55; 1,0.55; -1,0.55", "circle 0,0,0.5"),
             {2.2 - 0.25 * PI, {{"hole0", PI}}});
  check_body(checks,
             "three holes",
             polygon("0,0; 6,0; 6,2; 0,2",
                     "circle 1,1,0.3 | 2.5,0.5; 3.5,0.5; 3.5,1.5; 2.5,1.5 fillet 0.25 | "
                     "4.5,1; arc 5,1 cw; 5.5,1; arc 5,1 cw"),
             {12. - 0.09 * PI - (1. - 0.0625 * (1. - 0.25 * PI)) - 0.25 * PI,
              {{"hole0", 0.6 * PI}, {"hole1", 4. - 0.5 + 0.125 * PI}, {"hole2", PI}}});
  // Cells beside the gaps of 1e-6 are much longer than wide.
  const double radius = 0.499999;
  dealii::Triangulation<2> gaps;
  polygon("0,0; 1,0; 1,1; 0,1", "circle 0.5,0.5,0.499999").make_coarse_mesh(gaps);
  checks.near("four narrow gaps: area",
              dealii::GridTools::volume(gaps, dealii::MappingQ<2>(2)),
              1. - PI * radius * radius,
              1e-4);
}

void test_round(Checks &checks)
{
  const Geometry<2> disc = make_disc(0.5, Point(1., -2.));
  check_body(checks, "disc", disc, {0.25 * PI, {{"arc", PI}}});
  checks.that("disc: closed", disc.sides[0].is_closed() && corners(disc).empty());
  check_body(checks,
             "half disc",
             body({"Shape=half disc", "Centre=1,2", "Radius=2"}, "arc", "flat"),
             {2. * PI, {{"arc", 2. * PI}, {"flat", 4.}}});
  check_body(checks,
             "ring",
             body({"Shape=ring", "Centre=-1,0.5", "Radius=2", "Inner radius=1"}, "outer", "inner"),
             {3. * PI, {{"outer", 4. * PI}, {"inner", 2. * PI}}});
}
} // namespace

int main()
{
  Checks checks;
  test_straight(checks);
  test_curved(checks);
  test_holes(checks);
  test_round(checks);
  return checks.exit_code();
}
