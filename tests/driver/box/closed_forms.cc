// SPDX-License-Identifier: LGPL-2.1-or-later
// Surface, D, G, A, f and C of a box of hexahedra, counted by hand.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/solvers/contact/compliance.h>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace
{
const auto nothing = field([](const dealii::Point<3> &) { return Vector3(); });

double sum(const dealii::Vector<double> &v)
{
  double s = 0.;
  for (const double x : v)
    s += x;
  return s;
}

/** Faces, patches and pieces of a bottom of 1 x 2. */
void surface(Checks &checks)
{
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {1., 2., 1.});
  for (const unsigned int ratio : {1U, 2U, 4U})
  {
    const Box box(scene, 2, ratio);
    const std::string name = "H = " + std::to_string(ratio) + " h: ";
    checks.near(name + "faces", box.surface.faces().size(), 16., 0.);
    checks.near(name + "patches", box.surface.patches().size(), 16. / (ratio * ratio), 0.);
    checks.near(name + "pieces", box.surface.pieces().size(), 16., 0.);
    checks.that(name + "stable unless H = h", box.surface.has_unstable_patch() == (ratio == 1));
    checks.near(
      name + "longest patch", box.surface.longest_patch(), ratio * std::sqrt(5.) / 4., 1e-14);
    checks.near(name + "area", sum(box.multipliers.integrals()), 2., 1e-14);
    Vector3 area;
    double moment = 0.;
    for (const Piece<3> &piece : box.surface.pieces())
      for (std::size_t q = 0; q < piece.on_mesh.size(); ++q)
      {
        area += piece.on_mesh.weights[q] * piece.on_mesh.normals[q];
        moment += piece.on_mesh.weights[q] * piece.on_mesh.points[q][1];
      }
    checks.near(name + "area vector", (area - Vector3({0., 0., -2.})).norm(), 0., 1e-14);
    checks.near(name + "first moment", moment, 2., 1e-14);
  }
}

/** 2 x 2 faces, one patch: int phi_j = h^2 times 1/4 at corners, 1/2 at edges, 1 in the middle. */
void coupling(Checks &checks)
{
  const Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing);
  const Box box(scene, 1, 2);
  std::vector<double> entries;
  for (const auto &entry : box.D.column(0))
    entries.push_back(entry.second);
  std::sort(entries.begin(), entries.end());
  const std::vector<double> expected = {
    -0.25, -0.125, -0.125, -0.125, -0.125, -0.0625, -0.0625, -0.0625, -0.0625};
  checks.near("D: entries", entries.size(), 9., 0.);
  double difference = 0.;
  for (std::size_t i = 0; i < std::min(entries.size(), expected.size()); ++i)
    difference = std::max(difference, std::abs(entries[i] - expected[i]));
  checks.near("D: values", difference, 0., 1e-15);
  const auto linear = field([](const auto &x) {
    return Vector3({7., x[0], 2. * x[0] - x[1] + 3.});
  });
  checks.near("D^T of a linear field",
              box.D.transpose_product(interpolate_at_nodes(box.space, *linear))[0],
              -(1. - 0.5 + 3.),
              1e-14);
}

/** G of g = x y^2 on patches of 1/2 x 1/2. */
void gap(Checks &checks)
{
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &x) { return x[0] * x[1] * x[1]; }), nothing);
  const Box box(scene, 2, 2);
  double difference = 0.;
  for (unsigned int k = 0; k < box.G.size(); ++k)
  {
    const dealii::Point<2> centre = box.surface.patches()[k].centre();
    const dealii::Point<3> x = box.surface.side(box.surface.patches()[k]).point(centre);
    const double int_x = 0.5 * x[0], int_yy = 0.5 * x[1] * x[1] + 0.125 / 12.;
    difference = std::max(difference, std::abs(box.G[k] - int_x * int_yy));
  }
  checks.near("G of x y^2", difference, 0., 1e-15);
  checks.near("G in all", sum(box.G), 1. / 6., 1e-15);
}

/** Energies of linear fields, rigid motions, resultants of the loads. */
void stiffness_and_loads(Checks &checks)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {1., 2., 0.5});
  scene.body_force = field([](const auto &x) { return Vector3({0., x[0], -2.}); });
  auto &right = scene.boundary[scene.geometry.find_side("right")];
  right.role = Role::traction;
  right.data = field([](const auto &x) { return Vector3({x[2], 0., 1.}); });
  const Box box(scene, 2, 2);
  const LinearSystem<3> system = assemble_linear_system(box.space, scene, 3);
  // Volume 1; int x = 1/2. The side has the area 1, int z = 1/4.
  checks.near("force", (system.applied.force - Vector3({0.25, 0.5, -1.})).norm(), 0., 1e-14);
  // Body: int (x × f) = int (-2 y - z x, 2 x, x^2); side x = 1: int (y, z^2 - 1, -y z).
  const Vector3 moment({-2. - 0.125 + 1., 1. + 1. / 12. - 1., 1. / 3. - 0.25});
  checks.near("moment", (system.applied.moment - moment).norm(), 0., 1e-14);

  const auto internal = [&](const FunctionPointer<3> &u) {
    return internal_forces(box.space, scene, interpolate_at_nodes(box.space, *u)).forces;
  };
  const auto motion = field([](const auto &x) {
    return Vector3({1. + x[1] - 2. * x[2], 3. - x[0] + x[2], 2. * x[0] - x[1]});
  });
  checks.near("rigid motions need no force", internal(motion).linfty_norm(), 0., 1e-14);
  const auto strained = field([](const auto &x) {
    return Vector3({x[0] + x[1], x[2], 3. * x[2]});
  });
  const Displacement U = interpolate_at_nodes(box.space, *strained);
  // eps = diag(1, 0, 3) + 1/2 off the diagonal twice: sigma:eps = lambda 16 + 2 mu (10 + 1).
  checks.near("energy of a linear field",
              U * box.space.dual(internal(strained)),
              16. * lambda + 22. * mu,
              1e-13);
  DistributedVector V = box.space.make_vector();
  const auto inverse = factorise(system.matrix, system.unit, LinearSolver::condensed);
  inverse->solve(V, system.f);
  DistributedVector residual(internal_forces(box.space, scene, box.space.complete(V)).forces);
  residual -= system.loads;
  checks.near("A^{-1} f balances the loads",
              box.space.condense(box.space.dual(residual)).linfty_norm(),
              0.,
              1e-13);
}

/** In confined compression the body is a rod of the length 1.5: 1^T C 1 = area length/modulus. */
void compliance(Checks &checks)
{
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {2., 1., 1.5});
  for (const unsigned int ratio : {1U, 2U, 4U})
  {
    const Box box(scene, 2, ratio);
    const LinearSystem<3> system = assemble_linear_system(box.space, scene, 3);
    double seconds = 0.;
    dealii::Vector<double> ones(box.multipliers.n_multipliers());
    ones = 1.;
    for (const LinearSolver solver : {LinearSolver::condensed, LinearSolver::amesos_klu})
    {
      const auto inverse =
        factorise(system.matrix, system.unit, solver, contact_unknowns(box.condensed_D));
      const auto C = make_compliance(*inverse, box.condensed_D, seconds);
      checks.near("C of a rod, H = " + std::to_string(ratio) +
                    (solver == LinearSolver::condensed ? " h, condensed" : " h, by columns"),
                  ones * C->apply(ones),
                  2. * 1.5 / confined_modulus,
                  1e-12);
    }
  }
}

/** What cannot be had in space is refused. */
void refusals(Checks &checks)
{
  const Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing);
  const Mesh<3> mesh(scene.geometry, 0, 2, MPI_COMM_WORLD);
  // Of four faces in a row the one that is left belongs to the last patch.
  const ContactSurface<3> wide(mesh, scene, Partition{3, 0});
  checks.near("H = 3 h: one patch", wide.patches().size(), 1., 0.);
  checks.throws<std::runtime_error>("patches aligned with nothing", "groups of faces", [&]() {
    const ContactSurface<3> refused(mesh, scene, Partition{2, 5});
  });
}

/** (x^2, y^2, z^2): the strains of pi^{2h} u_h - u_h have the mean zero in each cell and depend on
 * one coordinate each, with squares h^2/3; those of u_h have squares 4/3 - h^2/3 and the mean 1. */
void estimate(Checks &checks)
{
  const Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing);
  const Box box(scene, 2, 2);
  const VectorField squares([](const dealii::Point<3> &x) {
    return Vector3({x[0] * x[0], x[1] * x[1], x[2] * x[2]});
  });
  const double h = 0.25, square = (4. - h * h) / 3.;
  const double energy = std::sqrt(confined_modulus) * h;
  const double scale = std::sqrt(lambda * (3. * square + 6.) + 2. * mu * 3. * square);
  const ErrorEstimate found =
    estimate_error(box.space, scene, interpolate_at_nodes(box.space, squares));
  checks.near("estimate in the energy norm", found.energy, energy, 1e-13);
  checks.near("estimate, relative", found.relative, energy / scale, 1e-13);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  surface(checks);
  coupling(checks);
  gap(checks);
  stiffness_and_loads(checks);
  compliance(checks);
  refusals(checks);
  estimate(checks);
  return checks.exit_code();
}
