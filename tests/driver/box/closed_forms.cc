// SPDX-License-Identifier: LGPL-2.1-or-later
// A, f, C and the estimate of a box of hexahedra, counted by hand. The surface, D and G are those
// of exact solutions in tests/driver/study/space.cc.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/grid/grid_tools.h>

#include <array>
#include <cmath>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Energies of linear fields, rigid motions, resultants of the loads. */
void stiffness_and_loads(Checks &checks) {
  Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 0.5});
  scene.body_force = field([](const auto &x) { return Vector3({0., x[0], -2.}); });
  auto &right = scene.boundary[scene.geometry.find_side("right")];
  right.role = Role::traction;
  right.data = field([](const auto &x) { return Vector3({x[2], 0., 1.}); });
  const Box box(scene, 2, 2);
  const LinearSystem<3> system = assemble_linear_system(box.space, scene, 3);
  // Volume 1; int x = 1/2. The side has the area 1, int z = 1/4.
  checks.near("force", system.applied[0].force, Vector3({0.25, 0.5, -1.}), 2e-14);
  // Body: int (x × f) = int (-2 y - z x, 2 x, x^2); side x = 1: int (y, z^2 - 1, -y z).
  const Vector3 moment({-2. - 0.125 + 1., 1. + 1. / 12. - 1., 1. / 3. - 0.25});
  checks.near("moment", system.applied[0].moment, moment, 1e-14);

  const auto internal = [&](const FunctionPointer<3> &u) {
    return internal_forces(DisplacedBody(box.space, scene, interpolate_at_nodes(box.space, *u)))
      .forces;
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
  checks.near("energy of a linear field", U * internal(strained), 16. * lambda + 22. * mu, 1e-13);
}

/** In confined compression the body is a rod of the length 1.5: 1^T C 1 = area length/modulus. */
void compliance(Checks &checks) {
  const Scene<3> scene = make_box_scene(zero, nothing, {2., 1., 1.5});
  for (const unsigned int ratio : {1U, 2U, 4U}) {
    const Box box(scene, 2, ratio);
    const LinearSystem<3> system = assemble_linear_system(box.space, scene, 3);
    dealii::Vector<double> ones(box.multipliers.n_multipliers());
    ones = 1.;
    for (const LinearSolver solver : {LinearSolver::condensed, LinearSolver::amesos_klu}) {
      const auto inverse =
        factorise(system.matrix, system.unit, solver, contact_unknowns(box.condensed_D));
      const auto C = make_compliance(*inverse, box.condensed_D);
      checks.near("C of a rod", ones * C->apply(ones), 2. * 1.5 / confined_modulus, 1e-12);
    }
  }
}

/** (x^2, y^2, z^2): the strains of pi^{2h} u_h - u_h have the mean zero in each cell and depend on
 * one coordinate each, with squares h^2/3; those of u_h have squares 4/3 - h^2/3 and the mean 1. */
void estimate(Checks &checks) {
  const Scene<3> scene = make_box_scene(zero, nothing);
  const Box box(scene, 2, 2);
  const auto squares = field([](const auto &x) {
    return Vector3({x[0] * x[0], x[1] * x[1], x[2] * x[2]});
  });
  const double h = 0.25, square = (4. - h * h) / 3., energy = std::sqrt(confined_modulus) * h;
  const double scale = std::sqrt(lambda * (3. * square + 6.) + 2. * mu * 3. * square);
  const Displacement U = interpolate_at_nodes(box.space, *squares);
  const DisplacedBody body(box.space, scene, U);
  const ErrorEstimate found =
    estimate_error(body, {internal_forces(body).energy_norm, std::nullopt});
  checks.near("estimate in the energy norm, and relative", {found.energy, found.relative},
              {energy, energy / scale}, 1e-13);
}

/** On cells with oblique edges and one law, quadratic forms of the nodal values of parents replace
 * the integrals by points, which a law given as a function of x still takes. */
void forms_of_parents(Checks &checks) {
  const auto found = [](const std::string &modulus) {
    Scene<3> scene = make_box_scene(zero, nothing);
    const auto straight = scene.geometry.make_coarse_mesh;
    scene.geometry.make_coarse_mesh = [straight](dealii::Triangulation<3> &mesh) {
      straight(mesh);
      const auto shear = [](const dealii::Point<3> &x) {
        return dealii::Point<3>(x[0] + 0.4 * x[1] - 0.3 * x[2], 0.7 * x[1] + 0.2 * x[2],
                                1.3 * x[2] + 0.1 * x[0]);
      };
      dealii::GridTools::transform(shear, mesh);
    };
    for (BoundaryCondition<3> &condition : scene.boundary)
      condition = {};
    scene.material = make_isotropic<3>(Expression<3>(modulus, {}, "E"),
                                       Expression<3>("0.3", {}, "nu"), PlaneState::strain);
    const Mesh<3> mesh(scene.geometry, 0, 3, MPI_COMM_WORLD);
    const DisplacementSpace<3> space(mesh, scene, StrainOperator::symmetric_gradient, 1);
    const auto interpolated = [&](const double twist) {
      return interpolate_at_nodes(space, *field([twist](const auto &x) {
                                    return Vector3({std::exp(x[0]) + x[1] * x[2],
                                                    std::sin(2. * x[1] + x[2] - twist * x[0]),
                                                    x[0] * x[0] * x[2] + twist * x[1]});
                                  }));
    };
    const Displacement U = interpolated(0.);
    PressureCorrection correction;
    correction.z = interpolated(1.5);
    correction.z -= U;
    const ErrorEstimate estimate =
      estimate_error(DisplacedBody(space, scene, U), {1., std::nullopt}, correction, {});
    return std::array<double, 2>{*estimate.h1, *estimate.mesh};
  };
  const auto by_forms = found("1"), by_points = found("1 + 1e-30*x");
  for (const unsigned int norm : {0U, 1U})
    checks.near(norm == 0 ? "norm of order 1" : "energy", by_forms[norm], by_points[norm],
                1e-12 * by_points[norm]);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {stiffness_and_loads, compliance, estimate, forms_of_parents});
}
