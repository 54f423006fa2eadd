// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces, moments, penetration, stresses and peaks of a compressed box, in closed form.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/postprocessing/quantities/answer.h>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace
{
const auto nothing = field([](const dealii::Point<3> &) { return Vector3(); });
/** u = (0, 0, -0.1 - 0.2 z). */
const auto compression = field([](const auto &x) { return Vector3({0., 0., -0.1 - 0.2 * x[2]}); });
constexpr double sigma = -0.2 * confined_modulus, sigma_across = -0.2 * lambda;

NodalForces forces_of(const Box &box, const Displacement &U, const Pressure &P)
{
  const LinearSystem<3> system = assemble_linear_system(box.space, box.scene, 3);
  return nodal_forces(box.space, box.scene, system.loads, box.D, U, P);
}

void near(Checks &checks,
          const std::string &name,
          const AnswerVector &found,
          const Vector3 &expected,
          const double tolerance)
{
  checks.near(name, (found - expected).norm(), 0., tolerance);
}

/** Uniform stress in a box of 1 x 2 x 1: every side carries sigma n times its area in its middle.
 */
void forces(Checks &checks)
{
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.1; }), compression, {1., 2., 1.});
  const Box box(scene, 2, 2);
  const Displacement U = interpolate_at_nodes(box.space, *compression);
  Pressure P(box.multipliers.n_multipliers());
  P.add(sigma);
  const Answer answer =
    compute_answer(box.space, scene, box.multipliers, forces_of(box, U, P), U, P);
  struct Expected
  {
    std::string side;
    Vector3 force;
    dealii::Point<3> middle;
  };
  const std::vector<Expected> all = {{"left", Vector3({-2. * sigma_across, 0., 0.}), {0., 1., 0.5}},
                                     {"right", Vector3({2. * sigma_across, 0., 0.}), {1., 1., 0.5}},
                                     {"front", Vector3({0., -sigma_across, 0.}), {0.5, 0., 0.5}},
                                     {"back", Vector3({0., sigma_across, 0.}), {0.5, 2., 0.5}},
                                     {"top", Vector3({0., 0., 2. * sigma}), {0.5, 1., 1.}}};
  checks.that("five sides hold the body", answer.reactions.size() == 5);
  for (const Expected &expected : all)
    for (const SideForce &found : answer.reactions)
      if (found.side == expected.side)
      {
        near(checks, found.side + ": force", found.resultant.force, expected.force, 1e-13);
        near(checks,
             found.side + ": moment",
             found.resultant.moment,
             moment_of(expected.middle, expected.force),
             1e-13);
        near(checks, found.side + ": acts in the middle", *found.through, expected.middle, 1e-12);
      }
  near(checks,
       "contact force",
       answer.contact_force.resultant.force,
       Vector3({0., 0., -2. * sigma}),
       1e-13);
  near(checks,
       "contact moment",
       answer.contact_force.resultant.moment,
       Vector3({-2. * sigma, sigma, 0.}),
       1e-13);
  checks.near(
    "contact force by side", answer.contact_by_side.at(0).resultant.force[2], -2. * sigma, 1e-13);
  checks.near("peak", answer.peak_pressure->value, -sigma, 1e-14);
  checks.near("largest penetration", answer.penetration->value, 0., 1e-15);
  checks.near("von Mises stress", answer.von_mises.value, 0.4 * mu, 1e-13);
  checks.that("no zones in space", answer.zones.empty() && answer.dimension == 3);
}

/** -p = 1 + x at a bottom of 1 x 2: the force 3 acts at x = (1/2 + 1/3)/(3/2), y = 1. */
void uneven_pressure(Checks &checks)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {1., 2., 1.});
  scene.boundary[scene.geometry.find_side("right")].role = Role::free;
  const Box box(scene, 3, 2);
  Pressure P(box.multipliers.n_multipliers());
  for (unsigned int tau = 0; tau < P.size(); ++tau)
    P[tau] = -1. - box.surface.patches()[tau].centre()[0];
  const auto found = contact_force(box.multipliers, scene.contact_sides(), P);
  // Means over patches of length 1/4 lose H²/12 of the linear part's moment.
  const double x_moment = 2. * (5. / 6. - 1. / 192.);
  near(checks, "force of 1 + x", found.resultant.force, Vector3({0., 0., 3.}), 1e-13);
  near(checks, "its moment", found.resultant.moment, Vector3({3., -x_moment, 0.}), 1e-13);
  near(checks, "its line of action", *found.through, Vector3({x_moment / 3., 1., 0.}), 1e-13);
  const auto peak = peak_pressure(box.multipliers, P);
  checks.near("peak of 1 + x", peak->value, 2., 1e-13);
  checks.near("at the edge", peak->place.point[0], 1., 1e-14);
  checks.near("mean of its patch", peak->mean, 1.875, 1e-14);
  checks.that("no pressure, no peak", !peak_pressure(box.multipliers, Pressure(P.size())));

  // A paraboloid: mean of (x - c)² over a patch of length H is (middle - c)² + H²/12. In the corner
  // between two rollers it goes on symmetrically.
  for (const dealii::Point<2> &c : {dealii::Point<2>(0.43, 0.9), dealii::Point<2>(0., 2.)})
  {
    for (unsigned int tau = 0; tau < P.size(); ++tau)
    {
      const dealii::Point<2> s = box.surface.patches()[tau].centre();
      P[tau] = -1. + 0.5 * (std::pow(s[0] - c[0], 2) + 1. / 192.) +
               0.1 * (std::pow(s[1] - c[1], 2) + 1. / 48.);
    }
    const auto top = peak_pressure(box.multipliers, P);
    checks.near("peak of a paraboloid", top->value, 1., 1e-13);
    near(checks, "its place", top->place.point, Vector3({c[0], c[1], 0.}), 1e-12);
  }
  Resultant<3> screw;
  screw.add(Vector3({0., 0., 2.}), {1., 0., 0.});
  screw.moment[2] += 5.;
  near(checks,
       "axis of a screw",
       *side_force("", screw, dealii::Point<3>(3., 4., 5.), 1.).through,
       Vector3({1., 0., 5.}),
       1e-14);
}

/** Two sides that hold all components and a roller share edges and corners. */
void held_sides(Checks &checks)
{
  for (const unsigned int level : {2U, 3U})
  {
    Scene<3> scene = make_box_scene(scalar([](const auto &) { return 1.; }), compression);
    auto &left = scene.boundary[scene.geometry.find_side("left")];
    left.role = Role::displacement;
    left.data = compression;
    const Box box(scene, level, 2);
    const Displacement U = interpolate_at_nodes(box.space, *compression);
    Pressure P(box.multipliers.n_multipliers());
    P.add(sigma);
    const auto found = reactions(box.space, scene, forces_of(box, U, P));
    const double h = std::ldexp(1., -static_cast<int>(level));
    const std::string name = "level " + std::to_string(level) + ": ";
    Vector3 sum({0., 0., -sigma});
    for (const SideForce &force : found)
    {
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += force.resultant.force[d];
      if (force.side == "top")
        near(checks, name + "top", force.resultant.force, Vector3({0., 0., sigma}), 0.2 * h);
      if (force.side == "front")
        near(checks,
             name + "a roller takes what acts along its normal",
             force.resultant.force,
             Vector3({0., -sigma_across, 0.}),
             1e-13);
    }
    checks.near(name + "all together", sum.norm(), 0., 1e-13);
  }
}

void penetration(Checks &checks)
{
  // u_n = -u_3 = 0.05 at the bottom: the deepest point is a sample between the nodes.
  const Scene<3> scene =
    make_box_scene(scalar([](const dealii::Point<3> &x) {
                     return 0.01 + std::pow(x[0] - 0.3125, 2) + std::pow(x[1] - 0.625, 2);
                   }),
                   nothing);
  const Box box(scene, 1, 2);
  const auto sinking = field([](const auto &x) { return Vector3({0., 0., -0.05 * (1. - x[2])}); });
  const auto found =
    max_penetration(box.space, box.multipliers, interpolate_at_nodes(box.space, *sinking));
  checks.near("penetration", found->value, 0.04 - std::pow(0.0625, 2), 1e-15);
  checks.that("its side", found->place.side == "bottom");
}

/** K/mu = 2 (1 + nu)/(3 (1 - 2 nu)). */
void locking(Checks &checks)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }), nothing, {1., 2., 1.});
  const Mesh<3> mesh(scene.geometry, 0, 2, MPI_COMM_WORLD);
  checks.near("nu = 0.3 does not lock", locking_number(mesh, *scene.material), 0., 0.);
  const Expression<3> E("7", {}, "E"), nu("0.49", {}, "nu");
  const auto material = make_isotropic<3>(E, nu, PlaneState::strain);
  checks.near("nu = 0.49: K/mu (h/l)²",
              locking_number(mesh, *material),
              2. * 1.49 / (3. * 0.02) / 16.,
              1e-10);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  forces(checks);
  uneven_pressure(checks);
  held_sides(checks);
  penetration(checks);
  locking(checks);
  return checks.exit_code();
}
