// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes by nested refinement: counts, lengths, distortion, boundary ids.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <tuple>

#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;

Geometry<2> distorted(Geometry<2> geometry, const double distortion) {
  geometry.distortion = distortion;
  return geometry;
}

Geometry<2> regular_polygon(const unsigned int n) {
  std::vector<Point> corners;
  for (unsigned int i = 0; i < n; ++i)
    corners.emplace_back(std::cos(2. * M_PI * i / n), std::sin(2. * M_PI * i / n));
  return make_polygon(corners);
}

double area(const Mesh<2> &mesh) {
  double sum = 0.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    sum += cell->measure();
  return sum;
}

/** The smallest cross product of two edges at a corner over the measure of its cell. */
double worst_corner(const Mesh<2> &mesh) {
  double worst = 1.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    for (const unsigned int v : {0, 1, 2, 3}) {
      const unsigned int order[] = {0, 1, 3, 2};
      const auto corner = [&](const unsigned int i) { return cell->vertex(order[i % 4]); };
      const dealii::Tensor<1, 2> in = corner(v + 1) - corner(v),
                                 out = corner(v + 2) - corner(v + 1);
      worst = std::min(worst, (in[0] * out[1] - in[1] * out[0]) / cell->measure());
    }
  return worst;
}

/** Whether the children's new vertices are the middles of edges and the mean of corners. */
bool is_nested(const dealii::Triangulation<2> &mesh, const unsigned int parent_level) {
  for (const auto &parent : mesh.cell_iterators_on_level(parent_level)) {
    const auto middle = [&](const unsigned int a, const unsigned int b) {
      return parent->vertex(a) + 0.5 * (parent->vertex(b) - parent->vertex(a));
    };
    const Point centre = middle(0, 3) + 0.5 * (middle(1, 2) - middle(0, 3));
    const std::vector<Point> expected = {parent->vertex(0), middle(0, 1), parent->vertex(1),
                                         middle(0, 2),      centre,       middle(1, 3),
                                         parent->vertex(2), middle(2, 3), parent->vertex(3)};
    for (unsigned int c = 0; c < 4; ++c)
      for (unsigned int v = 0; v < 4; ++v) {
        const unsigned int at = (c / 2 + v / 2) * 3 + c % 2 + v % 2;
        if (parent->child(c)->vertex(v).distance(expected[at]) > 1e-14)
          return false;
      }
  }
  return true;
}

/** Sixteen cells for each of the coarse mesh. */
void test_counts(Checks &checks) {
  const double a3 = 0.75 * std::sqrt(3.), a8 = 4. * std::sqrt(0.5);
  struct Row {
    std::string name;
    Geometry<2> geometry;
    unsigned int coarse_cells;
    double area;
  };
  for (const Row &row : std::vector<Row>{
         {"rectangle", make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1}), 2, 3.},
         {"quadrilateral",
          make_polygon({Point(0., 0.), Point(3., 0.), Point(2., 2.), Point(0., 1.)}), 1, 4.},
         {"triangle", regular_polygon(3), 3, a3},
         {"octagon", regular_polygon(8), 8, a8}}) {
    checks.about(row.name);
    const Mesh<2> mesh(row.geometry, 1, 2, MPI_COMM_WORLD);
    checks.near("cells", mesh.triangulation().n_global_active_cells(), 16 * row.coarse_cells, 0);
    checks.near("area", area(mesh), row.area, 1e-13);
    checks.that("convex cells", worst_corner(mesh) > 0.);
    checks.that("nested", mesh.level() == 2 && mesh.has_parents() &&
                            is_nested(mesh.triangulation(), 0) &&
                            is_nested(mesh.triangulation(), 1));
    if (row.coarse_cells < 3)
      checks.near("h is the longest edge", mesh.longest_edge(),
                  row.coarse_cells == 1 ? 0.75 : 0.375, 1e-15);
  }
  checks.about("");
  const Mesh<2> coarse(make_rectangle(Point(0., 0.), Point(1., 1.), {3, 2}), 0, 0, MPI_COMM_WORLD);
  checks.that("level 0 has no parents",
              !coarse.has_parents() && coarse.triangulation().n_global_active_cells() == 6);
}

void test_distortion(Checks &checks) {
  const Geometry<2> square = make_rectangle(Point(0., 0.), Point(1., 1.), {1, 1});
  const double share = 0.2;
  const Mesh<2> plain(square, 2, 2, MPI_COMM_WORLD);
  const Mesh<2> once(distorted(square, share), 2, 2, MPI_COMM_WORLD);
  const Mesh<2> again(distorted(square, share), 2, 2, MPI_COMM_WORLD);
  const auto &reference = plain.triangulation().get_vertices();
  const auto &moved = once.triangulation().get_vertices();
  double checksum = 0.;
  for (std::size_t v = 0; v < reference.size(); ++v) {
    const Point &x = reference[v];
    const bool boundary = std::min({x[0], 1. - x[0], x[1], 1. - x[1]}) < 1e-12;
    checks.near(boundary ? "distortion keeps the boundary" : "and moves vertices by its share of h",
                x.distance(moved[v]), boundary ? 0. : 0.25 * share, boundary ? 0. : 1e-14);
    checks.that("distortion is the same every time",
                moved[v] == again.triangulation().get_vertices()[v]);
    checksum += std::sin(1. + v) * (moved[v][0] + 2. * moved[v][1]);
  }
  const auto over_ranks = dealii::Utilities::MPI::min_max_avg(checksum, MPI_COMM_WORLD);
  checks.near("distortion is the same on every rank", over_ranks.max - over_ranks.min, 0., 0.);
  checks.near("distortion keeps the area", area(once), 1., 1e-14);
  checks.that("the distorted level has no parents", !once.has_parents());

  const Mesh<2> fine(distorted(square, share), 2, 4, MPI_COMM_WORLD);
  checks.that("finer levels have parents", fine.has_parents());
  checks.that("finer levels are nested in the distorted one",
              is_nested(fine.triangulation(), 2) && is_nested(fine.triangulation(), 3));
  checks.that("the distorted one is not nested", !is_nested(fine.triangulation(), 1));
  const auto &finer = fine.triangulation().get_vertices();
  for (std::size_t v = 0; v < moved.size(); ++v)
    checks.that("finer levels keep the coarse vertices", moved[v] == finer[v]);
  const Mesh<2> strong(distorted(square, 0.3), 5, 5, MPI_COMM_WORLD);
  checks.that("strongly distorted cells stay convex", worst_corner(strong) > 0.);
  checks.throws<InputError>("cells that are not convex are refused",
                            "the distortion of the mesh: found 0.45, with which the cell at (",
                            [&] { Mesh<2>(distorted(square, 0.45), 5, 5, MPI_COMM_WORLD); });
}

/** Cells at circles follow them where interior vertices have moved: areas are those of the bodies,
 * to the order h^4 of parabolas on nested meshes, to rounding with degree ten on graded ones. */
void distorted_round_bodies(Checks &checks) {
  const auto splits_left = [](const auto &cell, const unsigned int n_splits) {
    return cell->center()[0] < -0.5 && n_splits < 2;
  };
  for (const auto &[name, body, exact] : std::vector<std::tuple<std::string, Geometry<2>, double>>{
         {"half disc", make_half_disc(1.), 0.5 * M_PI},
         {"disc", make_disc(1.), M_PI},
         {"ring", make_ring(0.5, 1.), 0.75 * M_PI}})
    for (const unsigned int level : {0, 1, 2}) {
      checks.about(name + ", vertices of level " + std::to_string(level) + " moved");
      const Geometry<2> moved = distorted(body, 0.2);
      const Mesh<2> nested(moved, level, 3, MPI_COMM_WORLD),
        graded(moved, level, {}, splits_left, 10);
      checks.near("nested: area",
                  dealii::GridTools::volume(nested.triangulation(), nested.mapping()), exact,
                  2e-5 * exact);
      checks.near("graded: area",
                  dealii::GridTools::volume(graded.triangulation(), graded.mapping()), exact,
                  1e-9 * exact);
    }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_counts, test_distortion, distorted_round_bodies});
}
