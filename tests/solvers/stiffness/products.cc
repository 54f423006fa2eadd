// SPDX-License-Identifier: LGPL-2.1-or-later
// A x cell by cell against the assembled matrix, with every condition and kind of cell; the V-cycle
// is symmetric.

#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace {
/** |A x - y| / |A x| in the maximum norm, with y by the operator. */
template <int dim>
double distance_to_matrix(const HeldBody<dim> &body) {
  const LinearSystem<dim> system = assemble_linear_system(body.space, body.scene, 2);
  const DualVector x = body.random_vector(1);
  DualVector product(x), y(x);
  system.matrix.vmult(product, x);
  product *= system.unit;
  body.multigrid.vmult(y, x);
  y -= product;
  return y.linfty_norm() / product.linfty_norm();
}

template <int dim>
void check_body(Checks &checks, const std::string &name, const HeldBody<dim> &body) {
  checks.about(name);
  checks.near("A x", distance_to_matrix(body), 0., 1e-12);
  const DualVector a = body.random_vector(2), b = body.random_vector(3);
  DualVector V_a(a), V_b(b);
  body.multigrid.precondition(V_a, a);
  body.multigrid.precondition(V_b, b);
  const double size = std::sqrt((a * V_a) * (b * V_b));
  checks.near("V is symmetric", (V_a * b - V_b * a) / size, 0., 1e-5);
  checks.that("and positive", a * V_a > 0. && b * V_b > 0.);
  // Entries in constrained rows are not read, and zero in results.
  DualVector c(a), y(a), y_c(a);
  dealii::IndexSet constrained(a.size());
  for (const auto &line : body.space.constraints().get_lines())
    if (a.in_local_range(line.index))
      constrained.add_index(line.index);
  for (const auto row : constrained)
    c(row) = 7.;
  body.multigrid.vmult(y, a);
  body.multigrid.vmult(y_c, c);
  bool unread = distance(y, y_c) == 0., zero = true;
  body.multigrid.precondition(y_c, c);
  unread = unread && distance(V_a, y_c) == 0.;
  for (const auto row : constrained)
    zero = zero && V_a(row) == 0. && y(row) == 0.;
  checks.that("constrained rows", unread && zero);
}

const std::string held = "Boundary/Clamped = top\nBoundary/Contact = bottom\n",
                  polygon = "Geometry/Shape = polygon\nBoundary/Contact = side0\n",
                  pentagon = polygon + "Geometry/Vertices = 0,0; 2,0; 2.5,1; 1,2; -0.5,1\n",
                  distorted = held + "Geometry/Distortion = 0.2\n";

/** A body with its coarsest and its finest level. */
struct Given {
  std::string name, text;
  unsigned int coarsest, level;
};

void plane(Checks &checks) {
  std::vector<Given> bodies = {
    {"one level", held, 0, 1},
    {"rows of 8 cells", held, 3, 3},
    {"rows of 32 cells", held, 5, 5},
    {"20 by 3 blocks of 4 cells", held + "Geometry/Cells = 20, 3\n", 2, 2},
    {"6 blocks", held + "Geometry/Cells = 3, 2\n", 4, 4},
    {"prescribed displacements",
     "Boundary/Rollers = left\nBoundary/Contact = bottom\n"
     "Boundary/Displacement = top: 0.1*x; -0.1\n",
     4, 5},
    {"distorted", distorted, 2, 5},
    {"distorted last", distorted, 4, 4},
    {"held by contact alone", "Boundary/Contact = bottom\nLoad/Body force = 0; -1\n", 4, 4},
    {"varying modulus", held + "Material/Young's modulus = 1 + x^2 + sin(3*y)^2\n", 4, 4},
    {"modulus with a jump inside cells",
     held + "Material/Young's modulus = if(x<0.3, 1, 10)\nDiscretization/Kinks at x = 0.3\n", 4, 4},
    {"varying and distorted", distorted + "Material/Young's modulus = 1 + x*y\n", 3, 4},
    {"oblique roller", pentagon + "Boundary/Rollers = side1, side3\n", 2, 5},
    {"two oblique rollers that meet", pentagon + "Boundary/Rollers = side1, side2\n", 2, 4},
    {"oblique parallelogram",
     polygon + "Geometry/Vertices = 0,0; 2,0; 2.5,1; 0.5,1\nBoundary/Rollers = side1, side2\n", 0,
     5},
    {"disc on contact alone",
     "Geometry/Shape = disc\nGeometry/Radius = 1\nBoundary/Contact = arc\n"
     "Contact/Gap = 1 + y\nLoad/Body force = 0; -0.01\n",
     2, 4}};
  for (const std::string name : {"O1", "E1", "E2", "E3", "C4", "B1"})
    bodies.push_back({"scene " + name, named_scene(name), 2, 4});
  for (const Given &given : bodies)
    check_body<2>(checks, given.name,
                  HeldBody<2>(scene_of(given.text), given.coarsest, given.level));
  check_body<2>(checks, "B-bar",
                HeldBody<2>(scene_of(held + "Material/Poisson's ratio = 0.49\n"), 4, 4,
                            StrainOperator::mean_dilatation));
}

Scene<3> box(const std::vector<unsigned int> &cells) {
  Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.; }),
                   field([](const dealii::Point<3> &) { return Vector3(); }), {1., 2., 1.});
  scene.geometry = make_box({0., 0., 0.}, {1., 2., 1.}, cells);
  return scene;
}

void boxes(Checks &checks) {
  check_body<3>(checks, "box", HeldBody<3>(box({1, 1, 1}), 4, 4));
  check_body<3>(checks, "box of 12 blocks", HeldBody<3>(box({2, 3, 2}), 2, 2));
  Scene<3> distorted = box({1, 2, 1});
  distorted.geometry.distortion = 0.2;
  check_body<3>(checks, "distorted box", HeldBody<3>(distorted, 2, 3));
  Scene<3> varying = box({1, 1, 1});
  const Expression<3> E("1 + x + y^2*z", {}, "E"), nu("0.1 + 0.2*z", {}, "nu");
  varying.material = make_isotropic<3>(E, nu, PlaneState::strain);
  check_body<3>(checks, "varying moduli in a box", HeldBody<3>(varying, 3, 3));
  // Rollers whose normals are along no axis, and that meet at edges.
  Scene<3> oblique = box({1, 1, 1});
  const auto make_box_mesh = oblique.geometry.make_coarse_mesh;
  oblique.geometry.make_coarse_mesh = [make_box_mesh](dealii::Triangulation<3> &mesh) {
    make_box_mesh(mesh);
    dealii::GridTools::transform(
      [](const dealii::Point<3> &x) {
        return dealii::Point<3>(x[0] + 0.3 * x[1], x[1] - 0.2 * x[0] + 0.1 * x[2],
                                x[2] + 0.4 * x[0]);
      },
      mesh);
  };
  check_body<3>(checks, "oblique box", HeldBody<3>(oblique, 3, 3));
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {plane, boxes});
}
