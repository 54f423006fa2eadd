// SPDX-License-Identifier: LGPL-2.1-or-later
// D_{j tau} = int_tau phi_j.n: hand-computed entries, moments of constant and linear fields on
// sides in every direction, and the coupling seen from the free degrees of freedom.

#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/discretization/space/trace_values.h>

#include <map>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::Tensor;

namespace {
const std::string square = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

std::string pentagon(const std::string &boundary) {
  return "subsection Geometry\nset Shape = polygon\n"
         "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\nsubsection Boundary\n" +
         boundary + "end\n";
}

std::string patches(const std::string &number) {
  return entry("Discretization", "Patches", number);
}

/** Column tau as (x, component) -> D on the bottom of the unit square. */
std::map<std::pair<double, unsigned int>, double> column_by_position(const OneLevel &level,
                                                                     const unsigned int tau) {
  std::map<dealii::types::global_dof_index, std::pair<double, unsigned int>> positions;
  for (const auto &cell : level.space().dofs().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
        positions[cell->vertex_dof_index(v, d)] = {cell->vertex(v)[0], d};
  std::map<std::pair<double, unsigned int>, double> column;
  for (const auto &entry : level.discretization.D.column(tau))
    column[positions.at(entry.first)] = entry.second;
  return column;
}

void check_column(Checks &checks, const std::string &name, const OneLevel &level,
                  const unsigned int tau, const std::map<double, double> &expected) {
  checks.about(name);
  const auto column = column_by_position(level, tau);
  double largest = 0.;
  for (const auto &node : expected) {
    const auto found = column.find({node.first, 1});
    largest = std::max(largest, found == column.end() ? 1. : std::abs(found->second - node.second));
  }
  checks.that("only normal components of its own nodes", column.size() == expected.size());
  checks.near("entries", largest, 0., 1e-15);
}

/** n = (0, -1): D is minus the integral of a hat function. */
void hand_computed(Checks &checks) {
  const OneLevel nested(square, 1);
  checks.that("H = 2h: one patch", nested.discretization.D.n_columns() == 1);
  check_column(checks, "H = 2h", nested, 0, {{0., -0.25}, {0.5, -0.5}, {1., -0.25}});
  const OneLevel equal(square + "Discretization/Patch ratio = 1\n", 1);
  check_column(checks, "H = h", equal, 1, {{0.5, -0.25}, {1., -0.25}});
  // Three patches on two faces: on [0, 1/3] the hats are 1 - 2x and 2x.
  const OneLevel thirds(square + patches("3"), 1);
  check_column(checks, "[0, 1/3]", thirds, 0, {{0., -2. / 9.}, {0.5, -1. / 9.}});
  check_column(checks, "[1/3, 2/3]", thirds, 1,
               {{0., -1. / 36.}, {0.5, -10. / 36.}, {1., -1. / 36.}});
  check_column(checks, "[2/3, 1]", thirds, 2, {{0.5, -1. / 9.}, {1., -2. / 9.}});
}

/** int_tau u.n for a constant and a linear u: the mid-point rule is exact for both. And u.n itself.
 */
void moments(Checks &checks, const std::string &name, const OneLevel &level) {
  const Tensor<2, 2> slope({{0.3, -0.7}, {1.1, 0.4}});
  const Tensor<1, 2> constant = Point<2>(0.8, -0.6);
  const Field fields[] = {[&](const Point<2> &) { return constant; },
                          [&](const Point<2> &x) { return constant + slope * x; }};
  const char *const names[] = {": constant field", ": linear field"};
  for (unsigned int k = 0; k < 2; ++k) {
    const Displacement U = nodal_values(level.space(), fields[k]);
    const auto DtU = level.discretization.D.transpose_product(U);
    double largest = 0.;
    for (unsigned int tau = 0; tau < DtU.size(); ++tau) {
      const Patch<2> &patch = level.discretization.surface.patches()[tau];
      const Side<2> &side = level.discretization.surface.side(patch);
      const double expected =
        fields[k](side.point(patch.centre())) * side.normal(0.) * patch.measure;
      largest = std::max(largest, std::abs(DtU[tau] - expected));
    }
    checks.near(name + names[k], largest, 0., 1e-14);
    TraceValues<2> traces(level.space());
    double off = 0.;
    for (const Piece<2> &piece : level.discretization.surface.pieces()) {
      const auto &face = level.discretization.surface.faces()[piece.face];
      const auto u = traces.displacement(level.discretization.surface, piece, piece.on_mesh, U);
      const Tensor<1, 2> n = level.scene.geometry.sides[face.side].normal(0.);
      for (std::size_t q = 0; q < u.size(); ++q)
        off = std::max(off, std::abs(u[q] * n - fields[k](piece.on_mesh.points[q]) * n));
    }
    checks.near(name + names[k] + ", u.n", off, 0., 1e-14);
  }
}

void all_sides(Checks &checks) {
  const std::string sides = "set Clamped = side3\nset Contact = side0 side1 side2 side4\n";
  const OneLevel nested(pentagon(sides), 2);
  checks.that("pentagon: 4 sides of 8 faces, H = 2h", nested.discretization.D.n_columns() == 16);
  moments(checks, "pentagon, H = 2h", nested);
  moments(checks, "pentagon, H = 3h",
          OneLevel(pentagon(sides) + "Discretization/Patch ratio = 3\n", 2));
  for (const char *n : {"3", "5", "7"})
    moments(checks, "pentagon, patches " + std::string(n),
            OneLevel(pentagon(sides) + patches(n), 2));
  moments(checks, "distorted square",
          OneLevel(square + "Geometry/Distortion = 0.3\n" + patches("5"), 3));
}

/** D^T T = (T^T D)^T for U = T U_free, where U_free is arbitrary and k = 0. */
void condensed(Checks &checks, const std::string &name, const OneLevel &level) {
  checks.about(name);
  const auto &space = level.space();
  RandomNumbers random(5);
  Displacement U_free = random_rows(space, random);
  space.constraints().set_zero(U_free.entries());
  const Displacement U = space.complete(U_free);
  const Coupling &condensed_D = level.discretization.condensed_D;
  checks.near(
    "D^T T U = (T^T D)^T U",
    distance(level.discretization.D.transpose_product(U), condensed_D.transpose_product(U_free)),
    0., 1e-15);
  bool free = true;
  for (unsigned int tau = 0; tau < condensed_D.n_columns(); ++tau)
    for (const auto &entry : condensed_D.column(tau))
      free = free && !space.constraints().is_constrained(entry.first);
  checks.that("free degrees of freedom only", free);
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      hand_computed(checks);
      all_sides(checks);
      condensed(checks, "clamped", OneLevel(square, 3));
      condensed(
        checks, "oblique roller beside contact",
        OneLevel(pentagon("set Rollers = side1\nset Clamped = side3\nset Contact = side0 side2\n"),
                 2));
    }});
}
