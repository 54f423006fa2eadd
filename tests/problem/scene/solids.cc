// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies in space: volumes and areas against closed forms, refined meshes against the rule written
// out, points inside, regions.

#include <signorini/problem/geometry/inside.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/geometry/solid.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "../../random_numbers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Mesh = dealii::Triangulation<3>;
using Vector = dealii::Tensor<1, 3>;
using dealii::Point;

/** Numbers of a mesh of trilinear cells. */
struct Numbers {
  double volume = 0., least_determinant = 1., off = 0., turned = 0.;
  std::map<std::string, double> areas;
  Vector normals;
};

Numbers measure_solid(const Geometry<3> &geometry, const Mesh &mesh) {
  using namespace dealii;
  const MappingQ1<3> mapping;
  const FE_Nothing<3> nothing;
  FEValues<3> corners(mapping, nothing, QTrapezoid<3>(), update_jacobians),
    cells(mapping, nothing, QGauss<3>(2), update_JxW_values);
  FEFaceValues<3> faces(mapping, nothing, QGauss<2>(2), update_JxW_values | update_normal_vectors);
  Numbers found;
  for (const auto &cell : mesh.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    cells.reinit(cell);
    corners.reinit(cell);
    double least = HUGE_VAL, sum = 0.;
    for (const unsigned int q : corners.quadrature_point_indices()) {
      least = std::min(least, corners.jacobian(q).determinant());
      sum += corners.jacobian(q).determinant() / 8.;
    }
    found.least_determinant = std::min(found.least_determinant, least / sum);
    for (const unsigned int q : cells.quadrature_point_indices())
      found.volume += cells.JxW(q);
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->at_boundary(f))
        continue;
      const Side<3> &side = geometry.sides.at(cell->face(f)->boundary_id());
      faces.reinit(cell, f);
      for (const unsigned int q : faces.quadrature_point_indices()) {
        found.areas[side.name()] += faces.JxW(q);
        found.normals += faces.JxW(q) * faces.normal_vector(q);
      }
      for (const unsigned int v : cell->face(f)->vertex_indices()) {
        const Point<3> &x = cell->face(f)->vertex(v);
        found.off = std::max(found.off, x.distance(side.project(x)));
        // The true normal, for rollers on curved sides.
        const Vector n = cell->face(f)->get_manifold().normal_vector(cell->face(f), x);
        if (side.surface().is_curved())
          found.turned = std::max(found.turned, (n - side.normal_at(x)).norm());
      }
    }
  }
  return found;
}

struct Shape3 {
  std::string name;
  Geometry<3> geometry;
  double volume;
  std::map<std::string, double> areas;
};

std::vector<Shape3> all_shapes() {
  const Point<3> c(0.3, -0.2, 0.7);
  const double R = 1.5, r = 1.1, L = 2.;
  const double disc = PI * R * R, ring = PI * (R * R - r * r), ball = 4. / 3. * PI * R * R * R;
  return {
    {"ball", make_ball(R, c), ball, {{"round", 4. * disc}}},
    {"half of a ball",
     make_ball(R, c, Sector::half),
     ball / 2.,
     {{"round", 2. * disc}, {"top", disc}}},
    {"quarter of a ball",
     make_ball(R, c, Sector::quarter),
     ball / 4.,
     {{"round", disc}, {"top", disc / 2.}, {"left", disc / 2.}}},
    {"octant",
     make_ball(R, c, Sector::octant),
     ball / 8.,
     {{"round", disc / 2.}, {"top", disc / 4.}, {"left", disc / 4.}, {"front", disc / 4.}}},
    {"cylinder",
     make_cylinder(0., R, L, c),
     disc * L,
     {{"round", 2. * PI * R * L}, {"bottom", disc}, {"top", disc}}},
    {"half of a lying cylinder",
     make_cylinder(0., R, L, c, Axis::y, Sector::half),
     disc * L / 2.,
     {{"round", PI * R * L}, {"front", disc / 2.}, {"back", disc / 2.}, {"top", 2. * R * L}}},
    {"quarter of a lying cylinder",
     make_cylinder(0., R, L, c, Axis::x, Sector::quarter),
     disc * L / 4.,
     {{"round", PI * R * L / 2.},
      {"left", disc / 4.},
      {"right", disc / 4.},
      {"front", R * L},
      {"top", R * L}}},
    {"tube",
     make_cylinder(r, R, L, c),
     ring * L,
     {{"outer", 2. * PI * R * L}, {"inner", 2. * PI * r * L}, {"bottom", ring}, {"top", ring}}},
    {"half of a tube",
     make_cylinder(r, R, L, c, Axis::z, Sector::half),
     ring * L / 2.,
     {{"outer", PI * R * L},
      {"inner", PI * r * L},
      {"bottom", ring / 2.},
      {"top", ring / 2.},
      {"left", 2. * (R - r) * L}}}};
}

void test_shapes(Checks &checks) {
  for (const Shape3 &shape : all_shapes()) {
    checks.about(shape.name);
    Mesh mesh;
    shape.geometry.make_coarse_mesh(mesh);
    checks.near("the number of coarse cells", mesh.n_active_cells(), shape.geometry.n_coarse_cells,
                0.);
    checks.near("the number of sides", shape.geometry.sides.size(), shape.areas.size(), 0.);
    std::vector<Numbers> found;
    for (unsigned int level = 0; level < 3; ++level) {
      if (level > 0)
        mesh.refine_global(1);
      found.push_back(measure_solid(shape.geometry, mesh));
      checks.that("cells are not folded", found.back().least_determinant > 0.2);
      checks.near("vertices are on their sides", found.back().off, 0., 1e-14);
      checks.near("with their normals", found.back().turned, 0., 1e-14);
      checks.near("the normal has the mean zero", found.back().normals.norm(), 0., 1e-12);
    }
    checks.between("the volume has order 2",
                   (found[1].volume - shape.volume) / (found[2].volume - shape.volume), 3.6, 4.4);
    for (const auto &[side, area] : shape.areas) {
      const double before = found[1].areas[side] - area, last = found[2].areas[side] - area;
      checks.that("the area of a side has order 2",
                  std::abs(last) < 1e-12 * area || (before / last > 3.6 && before / last < 4.4));
      checks.between("and of the coarse faces",
                     shape.geometry.sides.at(shape.geometry.find_side(side)).area() / area, 0.7,
                     1. + 1e-12);
    }
    checks.that("the box", shape.geometry.upper[0] <= 0.3 + 2. + 1e-14);
  }
  checks.about("");
}

/** The rule of refinement, written out for one refinement of one cell. */
void test_rule(Checks &checks) {
  // Vertices of a body between a ball and a cylinder about the same axis: edges on both.
  Solid lens;
  const auto add = [&](const double x, const double y) {
    lens.vertices.emplace_back(x, y, -std::sqrt(1. - x * x - y * y));
    lens.vertices.emplace_back(x, y, -0.4);
  };
  constexpr double R = 0.5, diagonal = 0.4;
  add(0., 0.), add(R, 0.), add(0., R), add(diagonal * 0.75, diagonal);
  lens.vertices[6] = Point<3>(0.3, 0.4, -std::sqrt(0.75));
  lens.vertices[7] = Point<3>(0.3, 0.4, -0.4);
  lens.cells = {{{0, 2, 4, 6, 1, 3, 5, 7}}};
  lens.faces = {{{{0, 4, 2, 6}}, 0}, {{{2, 6, 3, 7}}, 1}, {{{6, 4, 7, 5}}, 1},
                {{{1, 3, 5, 7}}, 2}, {{{0, 2, 1, 3}}, 3}, {{{4, 0, 5, 1}}, 4}};
  lens.sides = {{"ball", Surface::sphere({}, 1., Body::inside)},
                {"round", Surface::cylinder({}, Point<3>(0., 0., 1.), R, Body::inside)},
                {"top", Surface::plane(Point<3>(0., 0., -0.4), Point<3>(0., 0., 1.))},
                {"front", Surface::plane({}, Point<3>(0., -1., 0.))},
                {"left", Surface::plane({}, Point<3>(-1., 0., 0.))}};
  for (const auto &[name, geometry] : std::vector<std::pair<std::string, Geometry<3>>>{
         {"octant", make_ball(1., {}, Sector::octant)}, {"lens", make_geometry(lens)}}) {
    checks.about(name);
    Mesh mesh;
    geometry.make_coarse_mesh(mesh);
    mesh.refine_global(2);
    for (const auto &cell : mesh.cell_iterators_on_level(1)) {
      Vector middle;
      for (const unsigned int v : cell->vertex_indices())
        middle += cell->vertex(v) / 8.;
      for (const unsigned int l : cell->line_indices()) {
        const auto line = cell->line(l);
        Point<3> x(0.5 * (line->vertex(0) + line->vertex(1)));
        std::vector<Surface> surfaces;
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            for (unsigned int k = 0; k < 4; ++k)
              if (cell->face(f)->line(k)->index() == line->index())
                surfaces.push_back(geometry.sides[cell->face(f)->boundary_id()].surface());
        for (unsigned int round = 0; round < 200; ++round)
          for (const Surface &surface : surfaces)
            x = surface.project(x);
        checks.near("middles of edges", line->child(0)->vertex(1), x, 1e-14);
        middle -= line->child(0)->vertex(1) / 4.;
      }
      for (const unsigned int f : cell->face_indices()) {
        const auto face = cell->face(f);
        Vector mean;
        for (unsigned int k = 0; k < 4; ++k)
          mean += face->line(k)->child(0)->vertex(1) / 2. - face->vertex(k) / 4.;
        Point<3> x(mean);
        if (cell->at_boundary(f))
          x = geometry.sides[face->boundary_id()].project(x);
        checks.near("middles of faces", face->child(0)->vertex(3), x, 1e-14);
        middle += face->child(0)->vertex(3) / 2.;
      }
      checks.near("middles of cells", cell->child(0)->vertex(7) - Point<3>(), middle, 1e-14);
    }
  }
  checks.about("");
}

void test_distances(Checks &checks) {
  RandomNumbers random(11);
  const Geometry<3> ball = make_ball(1.), tube = make_cylinder(0.6, 1., 0.8),
                    box = make_box({-1., -1., -1.}, {1., 0.5, 1.}, {1, 1, 1}),
                    octant = make_ball(1., {}, Sector::octant);
  for (unsigned int i = 0; i < 100; ++i) {
    const Point<3> x(1.5 * random(), 1.5 * random(), 1.5 * random());
    checks.near("a ball", distance_from_body(ball, x), x.norm() - 1., 1e-9);
    const double rho = std::hypot(x[0], x[1]);
    const double across = std::max(0.6 - rho, rho - 1.), along = std::max(-x[2], x[2] - 0.8);
    checks.near("a tube", distance_from_body(tube, x),
                std::max(across, along) <= 0.
                  ? std::max(across, along)
                  : std::hypot(std::max(across, 0.), std::max(along, 0.)),
                1e-9);
    double inside = -HUGE_VAL, outside = 0.;
    for (unsigned int d = 0; d < 3; ++d) {
      const double beyond = std::max(-1. - x[d], x[d] - (d == 1 ? 0.5 : 1.));
      inside = std::max(inside, beyond);
      outside += std::pow(std::max(0., beyond), 2);
    }
    checks.near("a box", distance_from_body(box, x), inside <= 0. ? inside : std::sqrt(outside),
                1e-9);
    const bool is_in_octant = x[0] > 0. && x[1] > 0. && x[2] < 0. && x.norm() < 1.;
    checks.that("an octant", (distance_from_body(octant, x) < 0.) == is_in_octant);
  }
  for (const Geometry<3> *geometry : {&ball, &tube, &octant, &box})
    checks.that("the point inside", distance_from_body(*geometry, geometry->inner_point()) < 0.);
}

/** Cells of refined meshes have the region of their coarse cell, beyond its faces, too. */
void test_regions(Checks &checks) {
  const Geometry<3> shape = make_cylinder(0., 1., 1.);
  Mesh coarse;
  shape.make_coarse_mesh(coarse);
  Solid solid;
  solid.vertices = coarse.get_vertices();
  for (const auto &cell : coarse.active_cell_iterators()) {
    solid.cells.emplace_back();
    for (const unsigned int v : cell->vertex_indices())
      solid.cells.back()[v] = cell->vertex_index(v);
    solid.region_of_cell.push_back(cell->index() % 3);
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f)) {
        Solid::Face face = {{}, cell->face(f)->boundary_id()};
        for (const unsigned int v : {0, 1, 2, 3})
          face.vertices[v] = cell->face(f)->vertex_index(v);
        if (f % 2 == 0)
          std::swap(face.vertices[1], face.vertices[2]);
        solid.faces.push_back(face);
      }
  }
  solid.regions = {"a", "b", "c"};
  for (const Side<3> &side : shape.sides)
    solid.sides.emplace_back(side.name(), side.surface());
  const Geometry<3> geometry = make_geometry(solid);
  Mesh mesh;
  geometry.make_coarse_mesh(mesh);
  mesh.refine_global(3);
  for (const auto &cell : mesh.active_cell_iterators()) {
    auto root = cell->parent();
    while (root->level() > 0)
      root = root->parent();
    checks.near("regions", geometry.region_at(cell->center()), root->index() % 3, 0.);
  }
}

/** p4est sees the same mesh. */
void test_forest(Checks &checks) {
  const Geometry<3> geometry = make_ball(1., {}, Sector::half);
  Mesh mesh;
  dealii::parallel::distributed::Triangulation<3> forest(MPI_COMM_WORLD);
  for (Mesh *each : {&mesh, static_cast<Mesh *>(&forest)}) {
    geometry.make_coarse_mesh(*each);
    each->refine_global(2);
  }
  const Numbers alone = measure_solid(geometry, mesh), shared = measure_solid(geometry, forest);
  const auto sum = [](const double x) { return dealii::Utilities::MPI::sum(x, MPI_COMM_WORLD); };
  checks.near("the volume on ranks", sum(shared.volume), alone.volume, 1e-13);
  for (const auto &[side, area] : alone.areas)
    checks.near("the areas on ranks",
                sum(shared.areas.count(side) > 0 ? shared.areas.at(side) : 0.), area, 1e-13);
}
/** A ring of hexahedra whose square section turns by a number of right angles on its way round,
 * with cells that begin at different corners. */
Solid make_ring_of_cells(const unsigned int n_turns) {
  constexpr unsigned int n = 8;
  // The vertices of a section in the order of deal.II, and the same after a right angle.
  const std::array<unsigned int, 4> turned = {{1, 3, 0, 2}};
  Solid solid;
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int v = 0; v < 4; ++v) {
      const double phi = 2. * PI * k / n, psi = 0.25 * phi * n_turns;
      const double a = v % 2 == 0 ? -0.3 : 0.3, b = v < 2 ? -0.3 : 0.3;
      const double out = 2. + std::cos(psi) * a - std::sin(psi) * b;
      solid.vertices.emplace_back(out * std::cos(phi), out * std::sin(phi),
                                  std::sin(psi) * a + std::cos(psi) * b);
    }
  for (unsigned int k = 0; k < n; ++k) {
    std::array<unsigned int, 4> own = {{0, 1, 2, 3}}, next = own;
    for (unsigned int i = 0; k + 1 == n && i < n_turns; ++i)
      for (unsigned int &v : next)
        v = turned[v];
    std::array<unsigned int, 8> cell;
    for (unsigned int v = 0; v < 4; ++v) {
      // Along the ring from the higher section to the lower one, to the left of both.
      cell[v] = 4 * ((k + 1) % n) + next[v];
      cell[v + 4] = 4 * k + own[v];
    }
    // Some cells begin at the opposite corner of their first face.
    if (k % 3 == 1)
      cell = {{cell[3], cell[2], cell[1], cell[0], cell[7], cell[6], cell[5], cell[4]}};
    solid.cells.push_back(cell);
    constexpr unsigned int faces[][4] = {{0, 4, 2, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 6, 3, 7}};
    for (const auto &face : faces)
      solid.faces.push_back({{{cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]}}, 0});
  }
  solid.sides = {{"skin", Surface::faces()}};
  return solid;
}

/** Ranks share cells whose edges have the same directions: a ring that turns by a right angle has
 * none, as a band of Moebius. */
void test_directions_of_edges(Checks &checks) {
  for (const unsigned int n_turns : {0U, 1U, 2U, 4U}) {
    const Geometry<3> geometry = make_geometry(make_ring_of_cells(n_turns));
    checks.about("a ring with " + std::to_string(n_turns) + " turns");
    checks.that("ranks can share it", geometry.can_be_shared == (n_turns % 4 == 0));
    Mesh mesh;
    geometry.make_coarse_mesh(mesh);
    unsigned int n_reversed = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int l : cell->line_indices())
        n_reversed += cell->line_orientation(l) ? 0 : 1;
    checks.that("edges have one direction", (n_reversed == 0) == geometry.can_be_shared);
    checks.that("no cell is turned inside out",
                measure_solid(geometry, mesh).least_determinant > 0.);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv,
    {test_shapes, test_rule, test_distances, test_regions, test_forest, test_directions_of_edges});
}
