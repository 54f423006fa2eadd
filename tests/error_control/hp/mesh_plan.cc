// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes from plans: their sizes, degrees and lines.

#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/error_control/hp/next_plan.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

std::size_t n_cells(const GradedLevel &level) {
  return level.mesh().triangulation().n_active_cells();
}

MeshPlan graded(const Singularity &singularity, const double rise = 0.) {
  MeshPlan plan = uniform_plan(2, 2);
  plan.base_size = 0.25;
  plan.singularities = {singularity};
  plan.rise = rise;
  return plan;
}

/** At a corner every layer splits one cell: three cells more. At a vertex of the contact side two
 * cells are split, then two cells and their neighbours; inside of a face one or two, and the place
 * of 1/3 in its cell repeats with every other layer. */
void layers(Checks &checks) {
  const auto cells_of = [](const Singularity &singularity) {
    return static_cast<int>(n_cells(GradedLevel(square, graded(singularity))));
  };
  const auto on_side = [&](const double x, const unsigned int n) {
    return cells_of(end_of_contact({x, 0.}, 2, x, x, n));
  };
  for (unsigned int n = 1; n <= 10; ++n) {
    const GradedLevel level(square, graded(corner({0., 1.}, n)));
    checks.near("size at a corner", level.mesh().range_of_edges().first, 0.25 * std::pow(0.5, n),
                1e-15);
    checks.near("cells at a corner", n_cells(level), 16 + 3 * n, 0.);
    checks.near("cells per layer at a vertex of a side", on_side(0.5, n) - on_side(0.5, n - 1), 6,
                0.);
    if (n > 3)
      checks.near("as many cells per layer at a point of a face",
                  on_side(1. / 3., n + 2) - on_side(1. / 3., n),
                  on_side(1. / 3., n) - on_side(1. / 3., n - 2), 0.);
  }
}

/** Neighbours differ by one split and one degree; degrees fall from 2 + rise to 2. */
void degrees(Checks &checks) {
  for (const double n_layers : {1., 4., 9., 20.})
    for (const double rise : {0., 1.5, 4., 9.}) {
      MeshPlan plan = graded(corner({1., 1.}, n_layers), rise);
      plan.singularities.push_back(end_of_contact({0.3, 0.}, 2, 0.299, 0.3, n_layers / 2.));
      const GradedLevel level(square, plan);
      checks.about("layers " + std::to_string(static_cast<int>(n_layers)) + ", rise " +
                   std::to_string(rise));
      checks.that("graded", is_graded(level.space()));
      const auto found = degrees_of(level.space());
      const unsigned int most = std::min(9U, 2 + static_cast<unsigned int>(rise));
      checks.that("highest degree", *std::max_element(found.begin(), found.end()) == most);
      unsigned int at_singularity = 0;
      for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
        if (plan.singularities[0].touches(level.scene, cell))
          at_singularity = found[cell->active_cell_index()];
      if (n_layers > 2. * rise)
        checks.near("degree at the corner", at_singularity, 2., 0.);
    }
}

/** Demands split cells and raise degrees of cells and of their children; they are kept when other
 * cells are split. */
void demands(Checks &checks) {
  const GradedLevel uniform(square, uniform_plan(2, 2));
  MeshPlan plan = uniform_plan(2, 2);
  const Point<2> x(0.3, 0.3), y(0.8, 0.8);
  dealii::CellId at_x, at_y;
  for (const auto &cell : uniform.mesh().triangulation().active_cell_iterators()) {
    if (cell->point_inside(x))
      at_x = cell->id();
    if (cell->point_inside(y))
      at_y = cell->id();
  }
  plan.demands[at_x] = {true, 5};
  plan.demands[at_y] = {false, 4};
  const GradedLevel level(square, plan);
  checks.near("one cell is split", n_cells(level), 19., 0.);
  checks.that("demands: graded", is_graded(level.space()));
  const auto found = degrees_of(level.space());
  for (const auto &cell : level.mesh().triangulation().active_cell_iterators()) {
    const unsigned int degree = found[cell->active_cell_index()];
    if (cell->point_inside(x))
      checks.that("the children have the degree", degree == 5 && cell->diameter() < 0.2);
    if (cell->point_inside(y))
      checks.that("a cell has the degree", degree == 4 && cell->diameter() > 0.2);
  }
  MeshPlan next = plan;
  for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
    if (cell->point_inside(x))
      next.demands[cell->id()] = {true, 0};
  const GradedLevel finer(square, next);
  checks.near("a child is split", finer.mesh().range_of_edges().first, 0.0625, 1e-15);
  // The fourteen others have the degrees that their neighbours ask for.
  plan.demands[at_x].degree = 12;
  plan.max_element_degree = 6;
  const auto limited = degrees_of(GradedLevel(square, plan).space());
  checks.that("the largest degree", *std::max_element(limited.begin(), limited.end()) == 6);
}

/** Brackets that cover several faces, that meet two faces, and that belong to another side. */
void touching(Checks &checks) {
  const GradedLevel level(square, uniform_plan(3, 2));
  const auto count = [](const GradedLevel &on, const Singularity &singularity) {
    unsigned int n = 0;
    for (const auto &cell : on.mesh().triangulation().active_cell_iterators())
      n += singularity.touches(on.scene, cell) ? 1 : 0;
    return n;
  };
  checks.near("a corner touches one cell", count(level, corner({1., 0.}, 1.)), 1., 0.);
  const std::vector<Singularity> two = {corner({0., 0.}, 1.), corner({1., 0.}, 1.)};
  checks.that("the nearest one", nearest(two, {0.7, 0.1}) == &two[1] &&
                                   nearest(two, {0.2, 3.}) == &two[0] &&
                                   nearest({}, {0., 0.}) == nullptr);
  // 16 faces of pi/4 on the outer circle of E1.
  const GradedLevel ring("Scene/Name = E1\n", uniform_plan(1, 2));
  const unsigned int outer = ring.multipliers().surface().patches()[0].side;
  const double h = dealii::numbers::PI / 4.;
  for (const auto &[on, side, from, to, expected] :
       {std::tuple(&level, 2U, 0.3, 0.31, 1.), std::tuple(&level, 2U, 0.2, 0.6, 4.),
        std::tuple(&level, 0U, 0.3, 0.31, 1.), std::tuple(&ring, outer, 15.9 * h, 16.1 * h, 2.),
        std::tuple(&ring, outer, 16.1 * h, 16.2 * h, 1.)})
    checks.near("brackets", count(*on, end_of_contact({}, side, from, to, 1.)), expected, 0.);
}

/** Splits keep the shape of narrow cells: two lines that are close to each other belong to the mesh
 * where data of the body changes there, and only one of them where that of a side does. */
void lines(Checks &checks) {
  const auto n_lines = [](const std::string &parameter) {
    const Scene<2> scene =
      scene_of("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = 0\n"
               "Contact/Friction = tresca\n" +
               parameter + " abs(x - 0.3203125) < 0.00234375 ? 4.26667 : 0.001\n");
    return static_cast<int>(first_plan(scene, 3, 9).guides.lines[0].size());
  };
  checks.near("lines of a side", n_lines("Contact/Friction bound ="), 1, 0.);
  checks.near("lines of the body", n_lines("Contact/Friction bound = 1\nLoad/Body force = 0;"), 2,
              0.);
}

/** Returns the number of cells of the first mesh that are split for the data of a scene. */
std::size_t n_split(const Scene<2> &scene) {
  MeshPlan plan = uniform_plan(3, 2);
  resolve_hidden_data(scene, plan);
  return plan.demands.size();
}

std::size_t n_split_for(const std::string &modulus) {
  return n_split(scene_of(square + "Material/Young's modulus = " + modulus + " ? 100 : 1\n"));
}

/** No cell is split for moduli that no box shows; along a curve small cells help. A smooth force
 * hides nothing, also where hardly anything of it is left; one that is singular at a point asks for
 * layers there alone. A force on a small patch is seen, oblique ones too, and one that fills half
 * of the body needs no small cells along its edge. */
void hidden_data(Checks &checks) {
  const auto n_split_in = [](const std::string &file) {
    return n_split(make_scene<2>(read_parameters(SOURCE_DIR "/prm/" + file, {}), named_scenes()));
  };
  checks.near("splits of a smooth force", n_split_in("smooth_contact_two_ends.prm"), 0, 0.);
  checks.between("splits around a singular point", n_split_in("described_b1.prm"), 2, 24);
  const auto n_split_for_force = [](const std::string &force) {
    return n_split(scene_of(square + "Load/Body force = 0; " + force + "\n"));
  };
  checks.between("splits of a narrow smooth force",
                 n_split_for_force("exp(-150*((x - 0.4)^2 + (y - 0.5)^2))"), 0, 8);
  checks.between("splits around a patch",
                 n_split_for_force("abs(x+y-0.7)<0.002 && abs(x-y+0.1)<0.003 ? 1 : 0"), 6, 40);
  checks.near("splits along an edge", n_split_for_force("x + 1.3*y > 1.1 ? 1 : 0"), 0, 0.);
  checks.near("splits where no box shows the moduli", n_split_for("cos(6000*pi*x) < 0"), 0, 0.);
  checks.between("splits around a strip in which no box does",
                 n_split_for("cos(6000*pi*x) < 0 && x > 0.3"), 0, 600);
  checks.between("splits along a circle", n_split_for("(x - 0.4)^2 + (y - 0.5)^2 < 0.04"), 200,
                 800);
  checks.between("splits along many curves", n_split_for("sin(40*x*y) < 0"), 200, 800);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {layers, degrees, demands, touching, lines, hidden_data});
}
