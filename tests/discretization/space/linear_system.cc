// SPDX-License-Identifier: LGPL-2.1-or-later
// A, f and the essential conditions: resultants in closed form, symmetry, linear fields, rollers.

#include <signorini/base/errors.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** lambda = mu = 1 in plane strain. */
const std::string elastic = "subsection Material\nset Young's modulus = 2.5\n"
                            "set Poisson's ratio = 0.25\nend\n";

struct System {
  System(const std::string &text, const unsigned int level)
    : scene(scene_of(text))
    , mesh(scene.geometry, level, level, ranks_for(scene, level))
    , space(mesh, scene)
    , system(assemble_linear_system(space, scene, 3)) {}

  Displacement solve() const {
    Displacement U = space.zero();
    factorise(system.matrix, system.unit, LinearSolver::automatic)->solve(U, system.f);
    return space.complete(U);
  }

  Scene<2> scene;
  Mesh<2> mesh;
  DisplacementSpace<2> space;
  LinearSystem<2> system;
};

/** The resultant by quadrature, and the work of f_j on rigid motions. */
void check_resultant(Checks &checks, const std::string &name, const System &body,
                     const Point<2> &force, const double moment) {
  const DualVector loads = body.system.loads;
  const auto work = [&](const Field &field) { return loads * nodal_values(body.space, field); };
  const auto &applied = body.system.applied[0];
  checks.near(name,
              {applied.force[0], applied.force[1], applied.moment[0],
               work([](const Point<2> &) { return Point<2>(1., 0.); }),
               work([](const Point<2> &) { return Point<2>(0., 1.); }),
               work([](const Point<2> &x) { return Point<2>(-x[1], x[0]); })},
              {force[0], force[1], moment, force[0], force[1], moment}, 1e-13);
}

std::string loaded(const std::string &body_force, const std::string &traction,
                   const std::string &distortion, const std::string &kinks) {
  return "subsection Geometry\nset Upper right = 2, 1\nset Distortion = " + distortion +
         "\nend\nsubsection Boundary\nset Clamped = top\nset Contact = bottom\nset Traction = " +
         traction + "\nend\n" + entry("Load", "Body force", body_force) +
         "subsection Discretization\n" + kinks + "end\n";
}

void loads(Checks &checks) {
  // int f = (4, 1), int x f2 - y f1 = 4/3 - 2; int t = (1/2, 2) at x = 2 with moment 4 - 1/3.
  // On level 5 the force is evaluated in many cells at a time, and in several chunks of cells.
  for (const char *distortion : {"0", "0.3"})
    for (const unsigned int level : {2, 5})
      check_resultant(checks,
                      "polynomial data, distortion " + std::string(distortion) + ", level " +
                        std::to_string(level),
                      System(loaded("1 + x; x*y", "right: y; 2", distortion, ""), level),
                      Point<2>(4.5, 3.), 3.);
  // int (x - 0.7)_+ = 1.3^2/2, int x (x - 0.7)_+ = (8 - 0.343)/3 - 0.7 (4 - 0.49)/2; on the right
  // int (y - 1/3)_+ = 2/9 and int y (y - 1/3)_+ = 1/3 - 1/6 + 1/162 = 14/81.
  const double first = 7.657 / 3. - 0.35 * 3.51;
  for (const char *distortion : {"0", "0.3"})
    check_resultant(checks, "data with kinks, distortion " + std::string(distortion),
                    System(loaded("0; max(x - 0.7, 0)", "right: max(y - 1/3, 0); 0", distortion,
                                  "set Kinks at x = 0.7\nset Kinks at y = 0.33333333333333333\n"),
                           2),
                    Point<2>(2. / 9., 0.845), first - 14. / 81.);
  checks.throws<InputError>("loads without a value", "Load/Body force: found the value",
                            [] { System(loaded("sqrt(x - 0.1); 0", "", "0", ""), 2); });
  checks.throws<InputError>(
    "loads of the catalogue without a value", "the body force has the value nan at (", [] {
      OneLevel level(loaded("0; 0", "", "0", ""), 1);
      level.scene.body_force =
        std::make_shared<dealii::Functions::ConstantFunction<2>>(std::nan(""), 2);
      assemble_linear_system(level.space(), level.scene, 3);
    });
}

/** Loads on an arc and in curved cells are seen on the coarsest mesh: the resultant is that of the
 * formula, up to the distance of parabolas from the arc. */
void curved_loads(Checks &checks) {
  const double pi = std::acos(-1.), n_y = std::sqrt(1. - 0.09);
  struct Row {
    std::string traction, force;
    double expected, tolerance;
  };
  for (const Row &row :
       {Row{"-100*exp(-((x - 0.3)/0.001)^2)", "0", -0.1 * std::sqrt(pi) / n_y, 3e-3},
        Row{"abs(x - 0.3) < 0.001 && y > 0 ? -100 : 0", "0", -0.2 / n_y, 3e-3},
        Row{"(x - 0.3)^2 + 4*(y - 0.9539392)^2 < 1e-6 ? -100 : 0", "0",
            -0.2 / std::sqrt(0.91 + 4. * 0.09), 3e-3},
        Row{"0", "abs(x - 0.43) < 2e-3 && abs(y - 0.88) < 2e-3 ? -2000 : 0", -0.032, 3e-3},
        Row{"0", "(x - 0.43)^2 + (y - 0.8)^2 < 1e-6 ? -1e4 : 0", -0.01 * pi, 3e-3}}) {
    const System body("Geometry/Shape = polygon\n"
                      "Geometry/Vertices = -1,-1; 1,-1; 1,0; arc 0,0 ccw; -1,0\n"
                      "Boundary/Clamped = side0\nBoundary/Contact = side1\nContact/Gap = 1\n"
                      "Boundary/Traction = side2: 0; " +
                        row.traction + "\nLoad/Body force = 0; " + row.force + "\n",
                      0);
    checks.near("resultant of " + row.traction + " and " + row.force,
                body.system.applied.at(0).force[1] / row.expected, 1., row.tolerance);
  }
}

/** (A x, y) = (A y, x), (A x, x) > 0, and nothing but a diagonal in constrained rows. */
void matrix(Checks &checks) {
  const System body(loaded("0; 0", "", "0.3", "") + elastic, 3);
  const auto &A = body.system.matrix;
  const auto &constraints = body.space.constraints();
  RandomNumbers random(2);
  const DualVector x = random_rows(body.space, random), y = random_rows(body.space, random);
  DualVector Ax = x, Ay = x;
  A.vmult(Ax, x);
  A.vmult(Ay, y);
  const double xAx = Ax * x;
  checks.near("A is symmetric", Ax * y, Ay * x, 1e-13 * xAx);
  checks.that("A is positive", xAx > 0.);
  bool condensed = true;
  for (const auto i : body.space.locally_owned())
    for (auto entry = A.begin(i); entry != A.end(i); ++entry) {
      const bool constrained =
        constraints.is_constrained(i) || constraints.is_constrained(entry->column());
      const bool diagonal = entry->column() == i;
      condensed =
        condensed && (!constrained || (diagonal ? entry->value() > 0. : entry->value() == 0.));
    }
  checks.that("constrained rows and columns hold a diagonal only",
              dealii::Utilities::MPI::min(condensed ? 1 : 0, MPI_COMM_WORLD) == 1);
}

/** eps11 = 0.3, eps22 = -0.1, eps12 = 0 has sigma n = 0 on horizontal sides for lambda = mu. */
void linear_field(Checks &checks) {
  const Field exact = [](const Point<2> &x) {
    return Point<2>(0.05 + 0.3 * x[0] - 0.2 * x[1], -0.02 + 0.2 * x[0] - 0.1 * x[1]);
  };
  const std::string u = "0.05 + 0.3*x - 0.2*y; -0.02 + 0.2*x - 0.1*y";
  const System body("subsection Geometry\nset Distortion = 0.3\nset Cells = 2, 1\nend\n"
                    "subsection Boundary\nset Contact = bottom\nset Displacement = left: " +
                      u + " | right: " + u + " | top: " + u + "\nend\nContact/Gap = 1\n" + elastic,
                    3);
  checks.near("prescribed displacement reproduces a linear field",
              distance(body.solve(), nodal_values(body.space, exact)), 0., 1e-13);
}

/** max |(u - expected)_direction| over the nodes of a side. */
double largest_on_side(const System &body, const Displacement &U, const unsigned int side,
                       const dealii::Tensor<1, 2> &direction,
                       const dealii::Tensor<1, 2> &expected) {
  double largest = 0.;
  for (const auto &cell : body.space.dofs().active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (cell->is_locally_owned() && face->at_boundary() && face->boundary_id() == side)
        for (unsigned int v = 0; v < 2; ++v) {
          const Point<2> u(U[face->vertex_dof_index(v, 0)], U[face->vertex_dof_index(v, 1)]);
          largest = std::max(largest, std::abs((u - expected) * direction));
        }
  return largest;
}

void rollers(Checks &checks) {
  const auto text = [](const std::string &boundary) {
    return "subsection Geometry\nset Shape = polygon\nset Vertices = 0,0; 2,1; 1,3; -1,2.2\nend\n"
           "subsection Boundary\n" +
           boundary +
           "end\n"
           "Load/Body force = 1; -2\n" +
           elastic;
  };
  const System clamped(text("set Rollers = side0\nset Clamped = side2\nset Contact = side1\n"), 3);
  const Displacement U = clamped.solve();
  const auto n = clamped.scene.geometry.sides[0].normal(0.);
  const dealii::Tensor<1, 2> zero, tangent = Point<2>(-n[1], n[0]);
  checks.near("no motion normal to a roller", largest_on_side(clamped, U, 0, n, zero), 0., 1e-14);
  checks.that("rollers slide", largest_on_side(clamped, U, 0, tangent, zero) > 0.01);
  checks.near("clamped side",
              largest_on_side(clamped, U, 2, n, zero) +
                largest_on_side(clamped, U, 2, tangent, zero),
              0., 1e-15);

  // The corner is one of a single cell, or one that several cells share.
  const auto meeting = [&](const std::string &vertices, const unsigned int n,
                           const unsigned int i) {
    const auto side = [&](const unsigned int k) { return "side" + std::to_string((i + k) % n); };
    const System corner(
      "subsection Geometry\nset Shape = polygon\nset Vertices = " + vertices +
        "\nend\nLoad/Body force = 1; -2\nsubsection Boundary\nset Rollers = " + side(0) + " " +
        side(1) + "\nset Contact = " + side(2) + "\nend\n" + elastic,
      3);
    const Displacement V = corner.solve();
    for (const unsigned int k : {i, (i + 1) % n})
      checks.near(
        "two rollers that meet, " + vertices + ": " + side(0) + ", side " + std::to_string(k),
        largest_on_side(corner, V, k, corner.scene.geometry.sides[k].normal(0.), zero), 0., 1e-13);
  };
  meeting("0,0; 2,1; 1,3; -1,2.2", 4, 0);
  for (unsigned int i = 0; i < 5; ++i)
    meeting("0,0; 2,1; 1,3; 0,3; -1,2.2", 5, i);

  // A roller on a displaced side: the corner keeps the prescribed value.
  const System moved(text("set Rollers = side0\nset Displacement = side1: 0.2; 0.1\n"
                          "set Contact = side2\nend\nsubsection Contact\nset Gap = 1\n"),
                     3);
  const Displacement W = moved.solve();
  const Point<2> given(0.2, 0.1);
  checks.near("prescribed side beside a roller",
              largest_on_side(moved, W, 1, n, given) + largest_on_side(moved, W, 1, tangent, given),
              0., 1e-14);
  checks.near("roller beside a prescribed side", largest_on_side(moved, W, 0, n, zero), 0., 1e-14);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {loads, curved_loads, matrix, linear_field, rollers});
}
