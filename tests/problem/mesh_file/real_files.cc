// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that Gmsh has written: sides, lengths, areas and refined meshes of a bracket, a plate with
// a hole and a half disc.

#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/mesh_file/file_geometry.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
const std::string files = TEST_FILES, parts = PARTS;

Geometry<2> read(const std::string &file, const std::vector<std::string> &arcs = {})
{
  const std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return make_geometry(read_gmsh(text.str(), file), arcs, "arcs");
}

/** Area, length of the boundary, and int n ds, with the parabolas of the cells. */
struct Measures
{
  double area = 0., length = 0.;
  dealii::Tensor<1, 2> normals;
  double smallest_determinant = 1e300;
};

Measures measure(const Geometry<2> &geometry, const unsigned int level)
{
  const Mesh<2> mesh(geometry, 0, level, MPI_COMM_SELF);
  const dealii::FE_Nothing<2> nothing;
  dealii::FEValues<2> cells(mesh.mapping(),
                            nothing,
                            dealii::QGaussLobatto<2>(4),
                            dealii::update_JxW_values | dealii::update_jacobians);
  dealii::FEFaceValues<2> faces(mesh.mapping(),
                                nothing,
                                dealii::QGauss<1>(4),
                                dealii::update_JxW_values | dealii::update_normal_vectors);
  Measures found;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
  {
    cells.reinit(cell);
    for (const unsigned int q : cells.quadrature_point_indices())
    {
      found.area += cells.JxW(q);
      found.smallest_determinant =
        std::min(found.smallest_determinant, cells.jacobian(q).determinant());
    }
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
      {
        faces.reinit(cell, f);
        for (const unsigned int q : faces.quadrature_point_indices())
        {
          found.length += faces.JxW(q);
          found.normals += faces.JxW(q) * faces.normal_vector(q);
        }
      }
  }
  return found;
}

double length_of(const Geometry<2> &geometry, const std::string &side)
{
  return geometry.sides[geometry.find_side(side)].length();
}

std::string names_of(const Geometry<2> &geometry)
{
  std::string names;
  for (const std::string &name : geometry.side_names())
    names += (names.empty() ? "" : " ") + name;
  return names;
}

/** Every boundary vertex lies on its side after refinement. */
double distance_from_sides(const Geometry<2> &geometry, const unsigned int level)
{
  const Mesh<2> mesh(geometry, 0, level, MPI_COMM_SELF);
  double largest = 0.;
  for (const auto &face : mesh.triangulation().active_face_iterators())
    if (face->at_boundary())
      for (unsigned int v = 0; v < 2; ++v)
      {
        const Side<2> &side = geometry.sides[face->boundary_id()];
        largest =
          std::max(largest, side.point(side.arc_length(face->vertex(v))).distance(face->vertex(v)));
      }
  return largest;
}

void check_body(Checks &checks,
                const std::string &name,
                const Geometry<2> &geometry,
                const double area,
                const double length)
{
  double sides = 0.;
  for (const Side<2> &side : geometry.sides)
    sides += side.length();
  const double size = geometry.diameter();
  checks.near(name + ": the sides have the length of the boundary", sides, length, 1e-9 * size);
  const Measures coarse = measure(geometry, 1), fine = measure(geometry, 2);
  checks.that(name + ": int n ds vanishes", fine.normals.norm() < 1e-12 * size);
  checks.that(name + ": no cell is turned inside out",
              coarse.smallest_determinant > 0. && fine.smallest_determinant > 0. &&
                measure(geometry, 3).smallest_determinant > 0.);
  checks.that(name + ": refined meshes stay on the sides",
              distance_from_sides(geometry, 3) < 1e-13 * size);
  if (!geometry.curved)
  {
    checks.near(name + ": area", fine.area, area, 1e-9 * size * size);
    return;
  }
  // Parabolas on arcs: order four.
  checks.near(name + ": area", fine.area, area, 2e-5 * area);
  checks.between(name + ": the error of the area falls like h^4",
                 std::log2((coarse.area - area) / (fine.area - area)),
                 3.8,
                 4.2);
  checks.between(name + ": that of the length, too",
                 std::log2((coarse.length - length) / (fine.length - length)),
                 3.8,
                 4.2);
}

void check_bracket(Checks &checks)
{
  const double corner = 400. * (1. - PI / 4.), area = 80. * 20. + 20. * 60. + corner;
  const double length = 80. + 20. + 40. + 10. * PI + 40. + 20. + 80.;
  const std::string all = "back fillet foot rest.1 rest.2 tip top";
  const Geometry<2> bracket = read(parts + "bracket.msh");
  checks.that("bracket: names", names_of(bracket) == all);
  checks.near("bracket: the fillet is an arc", length_of(bracket, "fillet"), 10. * PI, 1e-9);
  checks.near("bracket: the foot is a segment", length_of(bracket, "foot"), 80., 1e-12);
  checks.that("bracket: the foot is flat",
              bracket.sides[bracket.find_side("foot")].is_flat() &&
                !bracket.sides[bracket.find_side("fillet")].is_flat());
  checks.near("bracket: the normal of the foot",
              bracket.sides[bracket.find_side("foot")].normal(1.)[1],
              -1.,
              1e-14);
  // Parts of a name are counted from left to right: the upper one begins at (20, 40).
  checks.near("bracket: rest.1", bracket.sides[bracket.find_side("rest.1")].start()[1], 40., 1e-9);
  checks.near("bracket: rest.2", bracket.sides[bracket.find_side("rest.2")].start()[0], 80., 1e-9);
  check_body(checks, "bracket", bracket, area, length);
  const Geometry<2> serendipity = read(files + "bracket_2_v2.msh");
  check_body(checks, "bracket with 8 nodes, version 2.2", serendipity, area, length);
  for (const std::string version : {"", "_v4"})
  {
    const std::string name = version.empty() ? "bracket, version 2.2" : "bracket, version 4.1";
    const Geometry<2> first_order = read(files + "bracket_1" + version + ".msh");
    checks.that(name + ": without arcs it has no curved cells", !first_order.curved);
    const Curve &fillet = first_order.sides[first_order.find_side("fillet")];
    checks.that(name + ": then the fillet has several pieces", fillet.n_pieces() > 2);
    const Geometry<2> with_arc = read(files + "bracket_1" + version + ".msh", {"fillet"});
    checks.that(name + ": names", names_of(with_arc) == all);
    check_body(checks, name + " with an arc", with_arc, area, length);
  }
}

void check_plate(Checks &checks)
{
  const double radius = 0.2, area = 2. - PI * radius * radius, length = 6. + 2. * PI * radius;
  const Geometry<2> plate = read(parts + "plate_with_hole.msh");
  checks.that("plate: names", names_of(plate) == "bottom hole left right top");
  const Side<2> &hole = plate.sides[plate.find_side("hole")];
  checks.that("plate: the hole is closed", hole.is_closed());
  checks.near("plate: the hole is a circle", hole.length(), 2. * PI * radius, 1e-12);
  const dealii::Tensor<1, 2> outwards = dealii::Point<2>(1., 0.5) - hole.point(0.3);
  checks.near("plate: normals of the hole", hole.normal(0.3) * outwards, radius, 1e-12);
  checks.that("plate: four corners", corners(plate).size() == 4);
  check_body(checks, "plate", plate, area, length);
  check_body(checks,
             "plate with a declared circle",
             read(files + "plate_with_hole_1.msh", {"hole"}),
             area,
             length);
  const Geometry<2> facets = read(files + "plate_with_hole_1.msh");
  const Side<2> &polygon = facets.sides[facets.find_side("hole")];
  const unsigned int n = polygon.n_pieces();
  checks.that("plate with facets: the hole is a closed polygon", polygon.is_closed() && n >= 8);
  check_body(checks,
             "plate with facets",
             facets,
             2. - 0.5 * n * radius * radius * std::sin(2. * PI / n),
             6. + 2. * n * radius * std::sin(PI / n));
}

void check_half_disc(Checks &checks)
{
  const Geometry<2> disc = read(parts + "half_disc.msh");
  checks.that("half disc: names", names_of(disc) == "arc flat");
  checks.that("half disc: the arc is one piece", disc.sides[disc.find_side("arc")].n_pieces() == 1);
  checks.near("half disc: the box around it", disc.lower[1], -1., 1e-14);
  check_body(checks, "half disc", disc, PI / 2., PI + 2.);
  check_body(checks,
             "half disc with a declared arc",
             read(files + "half_disc_1.msh", {"arc"}),
             PI / 2.,
             PI + 2.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_bracket(checks);
  check_plate(checks);
  check_half_disc(checks);
  return checks.exit_code();
}
