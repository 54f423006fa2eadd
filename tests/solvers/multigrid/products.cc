// SPDX-License-Identifier: LGPL-2.1-or-later
// A x cell by cell against the assembled matrix, with every condition and kind of cell; the V-cycle
// is symmetric.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace
{
/** |A x - y| / |A x| in the maximum norm, with y by the operator. */
template <int dim>
double distance_to_matrix(const HeldBody<dim> &body)
{
  const LinearSystem<dim> system = assemble_linear_system(body.space, body.scene, 2);
  const dealii::Vector<double> x = body.random_vector(1);
  DistributedVector x_distributed = body.space.make_vector(), product = x_distributed;
  for (unsigned int i = 0; i < x.size(); ++i)
    x_distributed(i) = x[i];
  system.matrix.vmult(product, x_distributed);
  product *= system.unit;
  dealii::Vector<double> y(x.size());
  body.multigrid.vmult(y, x);
  double largest = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
    largest = std::max(largest, std::abs(y[i] - product(i)));
  return largest / product.linfty_norm();
}

template <int dim>
void check_body(Checks &checks, const std::string &name, const HeldBody<dim> &body)
{
  checks.near(name + ": A x", distance_to_matrix(body), 0., 1e-12);
  const dealii::Vector<double> a = body.random_vector(2), b = body.random_vector(3);
  dealii::Vector<double> V_a(a), V_b(b);
  body.multigrid.precondition(V_a, a);
  body.multigrid.precondition(V_b, b);
  const double size = std::sqrt((a * V_a) * (b * V_b));
  checks.near(name + ": V is symmetric", (V_a * b - V_b * a) / size, 0., 1e-5);
  checks.that(name + ": and positive", a * V_a > 0. && b * V_b > 0.);
  // Entries in constrained rows are not read, and zero in results.
  dealii::Vector<double> c(a), y(a), y_c(a);
  for (const auto &line : body.space.constraints().get_lines())
    c[line.index] = 7.;
  body.multigrid.vmult(y, a);
  body.multigrid.vmult(y_c, c);
  bool unread = distance(y, y_c) == 0., zero = true;
  body.multigrid.precondition(y_c, c);
  unread = unread && distance(V_a, y_c) == 0.;
  for (const auto &line : body.space.constraints().get_lines())
    zero = zero && V_a[line.index] == 0. && y[line.index] == 0.;
  checks.that(name + ": constrained rows", unread && zero);
}

void check_plane(Checks &checks,
                 const std::string &name,
                 const std::string &text,
                 const unsigned int coarsest_level,
                 const unsigned int level,
                 const StrainOperator strain = StrainOperator::symmetric_gradient)
{
  check_body<2>(
    checks,
    name,
    HeldBody<2>(make_scene<2>(parse_parameters(text, "test")), coarsest_level, level, strain));
}

const std::string held = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

std::string polygon(const std::string &vertices, const std::string &rollers)
{
  return "subsection Geometry\nset Shape = polygon\nset Vertices = " + vertices +
         "\nend\nsubsection Boundary\nset Rollers = " + rollers + "\nset Contact = side0\nend\n";
}

void rectangles(Checks &checks)
{
  check_plane(checks, "one level", held, 0, 1);
  check_plane(checks, "rows of 8 cells", held, 3, 3);
  check_plane(checks, "rows of 32 cells", held, 5, 5);
  check_plane(
    checks, "20 by 3 blocks of 4 cells", held + entry("Geometry", "Cells", "20, 3"), 2, 2);
  check_plane(checks, "6 blocks", held + entry("Geometry", "Cells", "3, 2"), 4, 4);
  check_plane(checks,
              "prescribed displacements",
              "subsection Boundary\nset Rollers = left\nset Contact = bottom\n"
              "set Displacement = top: 0.1*x; -0.1\nend\n",
              4,
              5);
  check_plane(checks, "distorted", held + entry("Geometry", "Distortion", "0.2"), 2, 5);
  check_plane(checks, "distorted last", held + entry("Geometry", "Distortion", "0.2"), 4, 4);
  check_plane(checks,
              "B-bar",
              held + entry("Material", "Poisson's ratio", "0.49"),
              4,
              4,
              StrainOperator::mean_dilatation);
  check_plane(checks,
              "held by contact alone",
              "subsection Boundary\nset Contact = bottom\nend\n" +
                entry("Load", "Body force", "0; -1"),
              4,
              4);
  check_plane(checks,
              "varying modulus",
              held + entry("Material", "Young's modulus", "1 + x^2 + sin(3*y)^2"),
              4,
              4);
  check_plane(checks,
              "modulus with a jump inside cells",
              held + entry("Material", "Young's modulus", "if(x<0.3, 1, 10)") +
                entry("Discretization", "Kinks at x", "0.3"),
              4,
              4);
  check_plane(checks,
              "varying and distorted",
              held + entry("Material", "Young's modulus", "1 + x*y") +
                entry("Geometry", "Distortion", "0.2"),
              3,
              4);
  check_plane(checks, "orthotropic", named_scene("O1"), 4, 4);
}

void other_shapes(Checks &checks)
{
  const std::string pentagon = "0,0; 2,0; 2.5,1; 1,2; -0.5,1";
  check_plane(checks, "oblique roller", polygon(pentagon, "side1, side3"), 2, 5);
  check_plane(checks, "two oblique rollers that meet", polygon(pentagon, "side1, side2"), 2, 4);
  check_plane(
    checks, "oblique parallelogram", polygon("0,0; 2,0; 2.5,1; 0.5,1", "side1, side2"), 0, 5);
  for (const char *const name : {"E1", "E2", "E3", "C4", "B1"})
    check_plane(checks, std::string("scene ") + name, named_scene(name), 2, 4);
  check_plane(checks,
              "disc on contact alone",
              "subsection Geometry\nset Shape = disc\nset Radius = 1\nend\n"
              "subsection Boundary\nset Contact = arc\nend\n"
              "subsection Contact\nset Gap = 1 + y\nend\n" +
                entry("Load", "Body force", "0; -0.01"),
              2,
              4);
}

Scene<3> box(const std::vector<unsigned int> &cells)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const dealii::Point<3> &) { return Vector3(); }),
                                  {1., 2., 1.});
  scene.geometry = make_box({0., 0., 0.}, {1., 2., 1.}, cells);
  return scene;
}

void boxes(Checks &checks)
{
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
        return dealii::Point<3>(
          x[0] + 0.3 * x[1], x[1] - 0.2 * x[0] + 0.1 * x[2], x[2] + 0.4 * x[0]);
      },
      mesh);
  };
  check_body<3>(checks, "oblique box", HeldBody<3>(oblique, 3, 3));
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  rectangles(checks);
  other_shapes(checks);
  boxes(checks);
  return checks.exit_code();
}
