// SPDX-License-Identifier: LGPL-2.1-or-later
// Constant strain under full contact of a box of hexahedra: exact, and certified. pi^{2h} in space.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <deal.II/base/quadrature_lib.h>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace
{
void patch_test(Checks &checks,
                const unsigned int ratio,
                const double distortion,
                const unsigned int degree = 1)
{
  // u = (0, 0, -0.1 - 0.2 z): sigma_33 = -0.2 (lambda + 2 mu), and u.n = 0.1 at the bottom.
  const auto u = field([](const auto &x) { return Vector3({0., 0., -0.1 - 0.2 * x[2]}); });
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.1; }), u, {1., 2., 1.});
  scene.geometry.distortion = distortion;
  const Box box(scene, degree == 1 ? 2 : 1, ratio, degree);
  const LinearSystem<3> system = assemble_linear_system(box.space, scene, 3);
  const auto inverse = factorise(
    system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(box.condensed_D));
  const FreeState free = solve_free_state(*inverse, box.space, system.f, box.D, box.G);
  double seconds = 0.;
  const auto C = make_compliance(*inverse, box.condensed_D, seconds);
  const QPResult dual = solve_dual_problem(C, free.F, {}, {});
  const Pressure P(dual.P);
  const Displacement U = recover_displacement(*inverse, box.space, box.condensed_D, P, system.f);

  const std::string name = "H = " + std::to_string(ratio) + " h" +
                           (distortion > 0. ? ", distorted" : "") +
                           (degree > 1 ? ", degree " + std::to_string(degree) : "") + ": ";
  Displacement difference = interpolate_at_nodes(box.space, *u);
  difference -= U;
  checks.near(name + "displacement", difference.linfty_norm(), 0., 1e-13);
  double pressure_error = 0.;
  for (const double p : P)
    pressure_error = std::max(pressure_error, std::abs(p + 0.2 * confined_modulus));
  checks.near(name + "pressure", pressure_error, 0., 1e-12);
  const ContactSummary contact = summarise_contact(box.multipliers, P);
  checks.near(name + "contact force", contact.normal_force, 0.4 * confined_modulus, 1e-12);
  checks.near(name + "contact area", contact.length, 2., 1e-13);
  ContactState<3> found;
  found.U = U;
  found.P = P;
  found.diagonal_P = C->diagonal_times(P);
  found.system = {std::shared_ptr<void>(), &system};
  found.dual.emplace();
  found.dual->free = free;
  found.dual->C_P = C->apply(P);
  const Certificate certificate =
    certify(box.space,
            scene,
            box.multipliers,
            {found, box.D, box.G, nodal_forces(box.space, scene, system.loads, box.D, U, P)});
  for (const double residual : {certificate.stationarity,
                                certificate.penetration,
                                certificate.sign,
                                certificate.complementarity,
                                certificate.duality_gap,
                                certificate.force_balance,
                                certificate.moment_balance})
    checks.near(name + "certificate", residual, 0., 1e-11);
  // Volume 2, eps_33 = -0.2; the loads and the work of the gap vanish or cancel.
  checks.near(name + "energy", certificate.energy, 0.5 * 2. * 0.04 * confined_modulus, 1e-12);
}

/** pi^{2h} reproduces triquadratic functions, in values and gradients; degree four those of degree
 * four. */
void interpolation(Checks &checks)
{
  const auto nothing = field([](const dealii::Point<3> &) { return Vector3(); });
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {1., 2., 1.});
  const Box box(scene, 2, 2);
  for (const unsigned int generations : {1U, 2U})
  {
    const double k = 2. * generations;
    const auto power = [&](const double x) { return std::pow(x, k); };
    const auto u = field([&](const auto &x) {
      return Vector3({power(x[0]) * power(x[1]) * power(x[2]), power(x[1]) + x[2], x[0] * x[1]});
    });
    const Displacement U = interpolate_at_nodes(box.space, *u);
    const dealii::QGauss<3> gauss(2);
    PatchInterpolation<3> interpolate(box.space, gauss, generations);
    dealii::FEValues<3> values(box.mesh.mapping(),
                               box.space.element(),
                               gauss,
                               dealii::update_quadrature_points | dealii::update_inverse_jacobians);
    double value_error = 0., gradient_error = 0.;
    for (const auto &cell : box.space.dofs().active_cell_iterators())
    {
      values.reinit(cell);
      const FieldValues<3> &found = interpolate.evaluate(U, cell, values);
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const dealii::Point<3> x = values.quadrature_point(q);
        for (unsigned int d = 0; d < 3; ++d)
          value_error = std::max(value_error, std::abs(found.values[q][d] - u->value(x, d)));
        const double d_dx = k * std::pow(x[0], k - 1.) * power(x[1]) * power(x[2]);
        gradient_error = std::max({gradient_error,
                                   std::abs(found.gradients[q][0][0] - d_dx),
                                   std::abs(found.gradients[q][1][2] - 1.),
                                   std::abs(found.gradients[q][2][0] - x[1])});
      }
    }
    const std::string name = "degree " + std::to_string(2 * generations);
    checks.near(name + ": values", value_error, 0., 1e-13);
    checks.near(name + ": gradients", gradient_error, 0., 1e-12);
  }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  patch_test(checks, 1, 0.);
  patch_test(checks, 2, 0.);
  patch_test(checks, 2, 0.2);
  patch_test(checks, 4, 0.);
  patch_test(checks, 1, 0., 2);
  patch_test(checks, 2, 0., 3);
  interpolation(checks);
  return checks.exit_code();
}
