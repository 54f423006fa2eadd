// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes from plans: their sizes, degrees and lines.

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

std::size_t n_cells(const GradedLevel &level)
{
  return level.mesh().triangulation().n_active_cells();
}

double smallest(const GradedLevel &level)
{
  return level.mesh().shortest_edge();
}

MeshPlan graded(const Singularity &singularity, const double rise = 0.)
{
  MeshPlan plan = uniform_plan(2, 2);
  plan.base_size = 0.25;
  plan.singularities = {singularity};
  plan.rise = rise;
  return plan;
}

/** At a corner every layer splits one cell: three cells more. At a vertex of the contact side two
 * cells are split, then two cells and their neighbours; inside of a face one or two. */
void layers(Checks &checks)
{
  std::vector<std::size_t> at_corner, at_vertex, inside;
  for (unsigned int n = 0; n <= 12; ++n)
  {
    const GradedLevel corners(square, graded(corner({0., 1.}, n)));
    at_corner.push_back(n_cells(corners));
    checks.near("size of the cells at a corner, layers = " + std::to_string(n),
                smallest(corners),
                0.25 * std::pow(0.5, n),
                1e-15);
    at_vertex.push_back(
      n_cells(GradedLevel(square, graded(end_of_contact({0.5, 0.}, 2, 0.5, 0.5, n)))));
    const double x = 1. / 3.;
    inside.push_back(n_cells(GradedLevel(square, graded(end_of_contact({x, 0.}, 2, x, x, n)))));
  }
  for (unsigned int n = 1; n <= 12; ++n)
  {
    checks.near("cells per layer at a corner", at_corner[n] - at_corner[n - 1], 3., 0.);
    // Two cells; the neighbours of neighbours follow from the second layer on.
    checks.near("cells per layer at a vertex of a side", at_vertex[n] - at_vertex[n - 1], 6., 0.);
  }
  // The place of 1/3 in its cell repeats with every other layer.
  for (unsigned int n = 4; n <= 10; ++n)
    checks.that("as many cells per layer at a point of a face",
                inside[n + 2] - inside[n] == inside[n] - inside[n - 2]);
}

/** Neighbours differ by one split and one degree; degrees fall from 2 + rise to 2. */
void degrees(Checks &checks)
{
  for (const double n_layers : {1., 4., 9., 20.})
    for (const double rise : {0., 1.5, 4., 9.})
    {
      MeshPlan plan = graded(corner({1., 1.}, n_layers), rise);
      plan.singularities.push_back(end_of_contact({0.3, 0.}, 2, 0.299, 0.3, n_layers / 2.));
      const GradedLevel level(square, plan);
      const std::string name =
        "layers " + std::to_string(static_cast<int>(n_layers)) + ", rise " + std::to_string(rise);
      checks.that(name + ": graded", is_graded(level.space()));
      const auto found = degrees_of(level.space());
      const unsigned int most = std::min(9U, 2 + static_cast<unsigned int>(rise));
      checks.that(name + ": highest degree", *std::max_element(found.begin(), found.end()) == most);
      unsigned int at_singularity = 0;
      for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
        if (plan.singularities[0].touches(level.scene, cell))
          at_singularity = found[cell->active_cell_index()];
      if (n_layers > 2. * rise)
        checks.near(name + ": degree at the corner", at_singularity, 2., 0.);
    }
}

/** Demands split cells and raise degrees of cells and of their children; they are kept when other
 * cells are split. */
void demands(Checks &checks)
{
  const GradedLevel uniform(square, uniform_plan(2, 2));
  MeshPlan plan = uniform_plan(2, 2);
  const Point<2> x(0.3, 0.3), y(0.8, 0.8);
  dealii::CellId at_x, at_y;
  for (const auto &cell : uniform.mesh().triangulation().active_cell_iterators())
  {
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
  for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
  {
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
  checks.near("a child is split", smallest(finer), 0.0625, 1e-15);
  // The fourteen others have the degrees that their neighbours ask for.
  plan.demands[at_x].degree = 12;
  plan.max_element_degree = 6;
  const auto limited = degrees_of(GradedLevel(square, plan).space());
  checks.that("the largest degree", *std::max_element(limited.begin(), limited.end()) == 6);
}

/** Brackets that cover several faces, that meet two faces, and that belong to another side. */
void touching(Checks &checks)
{
  const GradedLevel level(square, uniform_plan(3, 2));
  const auto count = [&](const Singularity &singularity) {
    unsigned int n = 0;
    for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
      n += singularity.touches(level.scene, cell) ? 1 : 0;
    return n;
  };
  checks.near("a corner touches one cell", count(corner({1., 0.}, 1.)), 1., 0.);
  checks.near("a bracket in a face", count(end_of_contact({}, 2, 0.3, 0.31, 1.)), 1., 0.);
  checks.near("a bracket over four faces", count(end_of_contact({}, 2, 0.2, 0.6, 1.)), 4., 0.);
  checks.near("a bracket of another side", count(end_of_contact({}, 0, 0.3, 0.31, 1.)), 1., 0.);
  const std::vector<Singularity> two = {corner({0., 0.}, 1.), corner({1., 0.}, 1.)};
  checks.that("the nearest one",
              nearest(two, {0.7, 0.1}) == &two[1] && nearest(two, {0.2, 3.}) == &two[0] &&
                nearest({}, {0., 0.}) == nullptr);

  // 16 faces of pi/4 on the outer circle of E1.
  const GradedLevel ring(entry("Scene", "Name", "E1"), uniform_plan(1, 2));
  const unsigned int side = ring.multipliers().surface().patches()[0].side;
  const double h = dealii::numbers::PI / 4., length = 16. * h;
  const auto on_ring = [&](const double from, const double to) {
    unsigned int n = 0;
    for (const auto &cell : ring.mesh().triangulation().active_cell_iterators())
      n += end_of_contact({}, side, from, to, 1.).touches(ring.scene, cell) ? 1 : 0;
    return n;
  };
  checks.near("circle: around the start", on_ring(length - 0.1 * h, length + 0.1 * h), 2., 0.);
  checks.near("circle: beyond the start", on_ring(length + 0.1 * h, length + 0.2 * h), 1., 0.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  layers(checks);
  degrees(checks);
  demands(checks);
  touching(checks);
  return checks.exit_code();
}
