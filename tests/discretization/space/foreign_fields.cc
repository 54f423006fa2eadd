// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements of other programs on the body: cells, sides, arcs, and everything that is refused.

#include <signorini/discretization/space/foreign_field.h>
#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <functional>

#include "tests.h"

using namespace Signorini;

namespace {
Tensor<1, 2> affine(const Point<2> &x) {
  return Tensor<1, 2>({0.1 + 0.2 * x[0] - 0.3 * x[1], -0.4 + 0.5 * x[0] + 0.6 * x[1]});
}

void set_values(VtuMesh &mesh) {
  mesh.name = "a.vtu";
  mesh.n_components = 3;
  mesh.values.clear();
  for (const Point<3> &x : mesh.points) {
    const Tensor<1, 2> v = affine(Point<2>(x[0], x[1]));
    mesh.values.insert(mesh.values.end(), {v[0], v[1], 0.});
  }
}

/** Returns the unit square in four quadrilaterals, points row by row. */
VtuMesh square() {
  VtuMesh mesh;
  for (const double y : {0., 0.5, 1.})
    for (const double x : {0., 0.5, 1.})
      mesh.points.emplace_back(x, y, 0.);
  for (const unsigned int i : {0, 1, 3, 4})
    mesh.cells.push_back({9, {i, i + 1, i + 4, i + 3}});
  set_values(mesh);
  return mesh;
}

const Geometry<2> unit_square = make_rectangle(Point<2>(0., 0.), Point<2>(1., 1.), {1, 1});

ForeignField on_square(const VtuMesh &mesh) {
  return {mesh, unit_square, 1., 1e-5};
}

double area_of(const ForeignField &field) {
  const QGauss<2> rule(10);
  double area = 0.;
  for (const ForeignCell &cell : field.cells())
    for (unsigned int q = 0; q < rule.size(); ++q)
      area += rule.weight(q) * cell.at(rule.point(q)[0], rule.point(q)[1]).determinant;
  return area;
}

/** Affine displacements have their values and gradients on all cells, and cells cover the body. */
void check_affine(Checks &checks, const ForeignField &field, const double area) {
  for (const ForeignCell &cell : field.cells())
    for (const double s : {0.1, 0.7})
      for (const double t : {0.2, 0.6}) {
        const ForeignCell::Values at = cell.at(s, t);
        checks.near("value", at.v, affine(at.x), 1e-14);
        checks.near("gradient", at.gradient, Tensor<2, 2>({{0.2, -0.3}, {0.5, 0.6}}), 1e-13);
      }
  checks.near("area", area_of(field), area, 1e-13);
  double length = 0.;
  for (const ForeignEdge &edge : field.edges()) {
    length += edge.to - edge.from;
    const double s = 0.3 * edge.from + 0.7 * edge.to;
    checks.near("value on a side", field.on_edge(edge, s),
                affine(unit_square.sides[edge.side].point(s)), 1e-14);
  }
  checks.near("length of the boundary", length, 4., 1e-13);
}

void test_elements(Checks &checks) {
  checks.about("quadrilaterals");
  check_affine(checks, on_square(square()), 1.);
  checks.about("clockwise");
  VtuMesh mesh = square();
  for (VtuMesh::Cell &cell : mesh.cells)
    std::swap(cell.points[1], cell.points[3]);
  check_affine(checks, on_square(mesh), 1.);
  checks.about("pixels, and lines beside them");
  mesh = square();
  for (VtuMesh::Cell &cell : mesh.cells) {
    cell.type = 8;
    std::swap(cell.points[2], cell.points[3]);
  }
  mesh.cells.push_back({3, {0, 1}});
  mesh.cells.push_back({1, {0}});
  check_affine(checks, on_square(mesh), 1.);
  checks.about("triangles, one of them turned");
  mesh = square();
  mesh.cells = {};
  for (const unsigned int i : {0, 1, 3, 4}) {
    mesh.cells.push_back({5, {i, i + 1, i + 4}});
    mesh.cells.push_back({69, {i, i + 3, i + 4}});
  }
  check_affine(checks, on_square(mesh), 1.);
  checks.about("points of their own for each cell");
  VtuMesh parted = square();
  parted.points.clear();
  for (VtuMesh::Cell &cell : parted.cells)
    for (unsigned int &point : cell.points) {
      parted.points.push_back(square().points[point]);
      point = static_cast<unsigned int>(parted.points.size() - 1);
    }
  set_values(parted);
  check_affine(checks, on_square(parted), 1.);
  checks.near("nodes", on_square(parted).n_nodes(), 9., 0.);
  checks.about("six decimals");
  mesh = square();
  mesh.points[1][1] = 4e-6;
  mesh.points[8][0] = 1. - 4e-6;
  checks.near("area", area_of(on_square(mesh)), 1., 1e-13);
  checks.near("motion", on_square(mesh).largest_motion(), 4e-6, 1e-12);
}

/** Elements of degree two: a field of degree two has its values. */
void test_degree_two(Checks &checks) {
  const auto quadratic = [](const Point<2> &x) { return Tensor<1, 2>({x[0] * x[1], x[0] * x[0]}); };
  for (const auto &[type, n, order] :
       {std::tuple<unsigned int, unsigned int, std::vector<unsigned int>>{22, 6, {}},
        {69, 6, {}},
        {23, 8, {}},
        {28, 9, {}},
        {70, 9, {}},
        {70, 8, {}}}) {
    VtuMesh mesh;
    const bool is_triangle = n == 6;
    mesh.points = {{0, 0, 0},   {1, 0, 0},   {1, 1, 0},   {0, 1, 0},    {0.5, 0, 0},
                   {1, 0.5, 0}, {0.5, 1, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}};
    std::vector<unsigned int> whole(n);
    for (unsigned int i = 0; i < n; ++i)
      whole[i] = i;
    mesh.cells = {{type, whole}};
    if (is_triangle)
      mesh.cells = {{type, {0, 1, 2, 4, 5, 8}}, {type, {0, 2, 3, 8, 6, 7}}};
    set_values(mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const Tensor<1, 2> v = quadratic(Point<2>(mesh.points[i][0], mesh.points[i][1]));
      mesh.values[3 * i] = v[0];
      mesh.values[3 * i + 1] = v[1];
    }
    const ForeignField field = on_square(mesh);
    for (const ForeignCell &cell : field.cells()) {
      const ForeignCell::Values at = cell.at(0.3, 0.6);
      checks.near("value of degree two", at.v, quadratic(at.x), 1e-14);
      checks.near("its gradient", at.gradient,
                  Tensor<2, 2>({{at.x[1], at.x[0]}, {2. * at.x[0], 0.}}), 1e-13);
    }
    checks.near("area", area_of(field), 1., 1e-13);
  }
}

/** A disc of four triangles or quadrilaterals at its rim has the area of the circle, and the maps
 * are continuous: their derivatives are those of differences. */
void test_arcs(Checks &checks) {
  const Geometry<2> disc = make_disc(1.);
  for (const bool is_triangle : {true, false}) {
    VtuMesh mesh;
    mesh.points.emplace_back(0., 0., 0.);
    constexpr unsigned int n = 8;
    for (unsigned int k = 0; k < n; ++k) {
      const double angle = 0.3 + 2. * numbers::PI * k / n;
      mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.);
    }
    for (unsigned int k = 0; k < n; ++k) {
      if (is_triangle)
        mesh.cells.push_back({5, {1 + k, 1 + (k + 1) % n, 0}});
      else if (k % 2 == 0)
        mesh.cells.push_back({9, {0, 1 + k, 2 + k, 1 + (k + 2) % n}});
    }
    set_values(mesh);
    const ForeignField field(mesh, disc, 1., 1e-5);
    checks.near("area of a disc", area_of(field), numbers::PI, 1e-9);
    constexpr double step = 1e-6;
    for (const ForeignCell &cell : field.cells()) {
      const ForeignCell::Values at = cell.at(0.3, 0.6);
      const Tensor<1, 2> ds =
                           (cell.at(0.3 + step, 0.6).x - cell.at(0.3 - step, 0.6).x) / (2. * step),
                         dt =
                           (cell.at(0.3, 0.6 + step).x - cell.at(0.3, 0.6 - step).x) / (2. * step);
      checks.near("derivatives of the map", at.jacobian,
                  Tensor<2, 2>({{ds[0], dt[0]}, {ds[1], dt[1]}}), 1e-8);
    }
    for (const ForeignEdge &edge : field.edges())
      checks.near("the edge lies on the circle",
                  field.cells()[edge.cell]
                    .at(edge.number == 0 ? 0.3 : 1., edge.number == 0 ? 0. : 0.3)
                    .x.norm(),
                  1., 1e-13);
  }
}

void test_refusals(Checks &checks) {
  const auto refuse = [&](const std::function<void(VtuMesh &)> &change,
                          const std::string &message) {
    VtuMesh mesh = square();
    change(mesh);
    checks.refuses("a.vtu: " + message, [&]() { on_square(mesh); });
  };
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells[1] = {12, {0, 1, 2, 3, 4, 5, 6, 7}};
    },
    "cell 1 at (0, 0) has VTK's type 12 with 8 points, allowed: triangles and quadrilaterals of "
    "degree 1 and 2 "
    "(of hexahedra one layer thick: CalculiX writes plane elements with OUTPUT=2D).");
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells[0] = {34, {0, 1, 2, 3, 4, 5, 6}};
    },
    "cell 0 at (0, 0) has VTK's type 34 with 7 points, allowed: triangles and quadrilaterals of "
    "degree 1 and 2.");
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells = {{3, {0, 1}}};
    },
    "the file has no triangles or quadrilaterals.");
  refuse([](VtuMesh &mesh) { mesh.values[12] = NAN; },
         "point 4 at (0.5, 0.5, 0) or its displacement is not finite, allowed: numbers.");
  refuse([](VtuMesh &mesh) { mesh.values[14] = 0.1; },
         "the displacement across the plane reaches 0.1, allowed: zero.");
  refuse([](VtuMesh &mesh) { mesh.points[4][2] = 0.01; },
         "points lie at z = 0 and at z = 0.01, allowed: a mesh in a plane.");
  refuse(
    [](VtuMesh &mesh) {
      for (Point<3> &x : mesh.points)
        x *= 1000.;
    },
    "the mesh lies between (0, 0) and (1000, 1000), the body between (0, 0) and (1, 1), a ratio of "
    "1000, allowed: the "
    "same body with coordinates in the same unit.");
  refuse(
    [](VtuMesh &mesh) {
      for (Point<3> &x : mesh.points)
        x[0] += 2.;
    },
    "the mesh lies between (2, 0) and (3, 1), the body between (0, 0) and (1, 1), allowed: the "
    "same body at the same "
    "position.");
  refuse(
    [](VtuMesh &mesh) { mesh.points[4] = Point<3>(1.2, 0.5, 0.); },
    "cell 1 is turned inside out at (1.025, 0.375), allowed: cells with positive determinants.");
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells.push_back({5, {0, 1, 4}});
    },
    "the cells at the edge from (0, 0) to (0.5, 0) lie on one another, allowed: cells beside each "
    "other.");
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells.insert(mesh.cells.end(), {{5, {1, 4, 8}}, {5, {1, 4, 6}}});
    },
    "the edge from (0.5, 0) to (0.5, 0.5) belongs to 4 cells, allowed: two at most.");
  const std::string
    inside = " belongs to one cell only and its ends are on no side of the body, but ",
    gap = " away: a hanging node, a gap, a corner that is left out or another body, allowed: cells "
          "that "
          "cover the body, with boundary points 1.41421e-05 from it (Verify/Tolerance).";
  refuse([](VtuMesh &mesh) { mesh.cells.pop_back(); },
         "the edge from (1, 0.5) to (0.5, 0.5)" + inside + "0.5" + gap);
  refuse([](VtuMesh &mesh) { mesh.points[1][1] = 0.01; },
         "the edge from (0, 0) to (0.5, 0.01)" + inside + "0.01" + gap);
  refuse(
    [](VtuMesh &mesh) {
      mesh.cells[0] = {5, {1, 4, 3}};
    },
    "the edge from (0, 0.5) to (0.5, 0)" + inside + "0.5" + gap);
  refuse(
    [](VtuMesh &mesh) {
      mesh.points.push_back(mesh.points[4]);
      mesh.values.insert(mesh.values.end(), {0., 0., 0.});
      mesh.cells[3].points[0] = 9;
    },
    "the field jumps at (0.5, 0.5) from (0.05, 0.15) to (0, 0), allowed: continuous "
    "displacements.");
  refuse(
    [](VtuMesh &mesh) { mesh.cells[0].points[1] = 0; },
    "cell 0 at (0, 0) has two points at one position, allowed: cells that are no points or lines.");
}
} // namespace

int main() {
  return run_tests({test_elements, test_degree_two, test_arcs, test_refusals});
}
