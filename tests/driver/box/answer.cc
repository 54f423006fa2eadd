// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces, moments, penetration, stresses and peaks of a compressed box, in closed form.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/discretization/space/resultant.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/error_control/estimate/locking_number.h>
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/postprocessing/quantities/answer.h>

#include <map>

#include "box.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** u = (0, 0, -0.1 - 0.2 z). */
const auto compression = field([](const auto &x) { return Vector3({0., 0., -0.1 - 0.2 * x[2]}); });
constexpr double sigma = -0.2 * confined_modulus, sigma_across = -0.2 * lambda;

NodalForces forces_of(const Box &box, const Displacement &U, const Pressure &P) {
  const LinearSystem<3> system = assemble_linear_system(box.space, box.scene, 3);
  return nodal_forces(box.body(U, P), system.loads, box.D);
}

/** Uniform stress in a box of 1 x 2 x 1: every side carries sigma n times its area in its middle.
 */
void forces(Checks &checks) {
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &) { return 0.1; }), compression, {1., 2., 1.});
  const Box box(scene, 2, 2);
  const Displacement U = interpolate_at_nodes(box.space, *compression);
  const Pressure P = box.at_centres([](const auto &) { return sigma; });
  const Answer answer = compute_answer(box.body(U, P), forces_of(box, U, P));
  struct Expected {
    Vector3 force;
    dealii::Point<3> middle;
  };
  const std::map<std::string, Expected> all = {
    {"left", {Vector3({-2. * sigma_across, 0., 0.}), {0., 1., 0.5}}},
    {"right", {Vector3({2. * sigma_across, 0., 0.}), {1., 1., 0.5}}},
    {"front", {Vector3({0., -sigma_across, 0.}), {0.5, 0., 0.5}}},
    {"back", {Vector3({0., sigma_across, 0.}), {0.5, 2., 0.5}}},
    {"top", {Vector3({0., 0., 2. * sigma}), {0.5, 1., 1.}}},
    {"bottom", {Vector3({0., 0., -2. * sigma}), {0.5, 1., 0.}}}};
  checks.near("five sides hold the body", answer.reactions.size(), 5, 0.);
  std::vector<SideForce> found = answer.reactions;
  found.push_back(answer.contact_by_side.at(0));
  for (const SideForce &side : found) {
    const Expected &expected = all.at(side.side);
    checks.near(side.side + ": force", side.resultant.force, expected.force, 1e-13);
    checks.near(side.side + ": moment", side.resultant.moment,
                moment_of(expected.middle, expected.force), 1e-13);
    checks.near(side.side + ": acts in the middle", *side.through, expected.middle, 1e-12);
  }
  checks.near("contact force", answer.contact_force.resultant.force, all.at("bottom").force, 1e-13);
  checks.near("peak, penetration, von Mises stress",
              {answer.peak_pressure->value, answer.penetration->value, answer.von_mises.value},
              {-sigma, 0., 0.4 * mu}, 1e-13);
  checks.that("one zone in space, of the whole side",
              answer.zones.size() == 1 && answer.dimension == 3);
  checks.near("its area and force",
              {answer.zones[0].length, answer.zone_forces[0].resultant.force[2]},
              {2., all.at("bottom").force[2]}, 1e-13);
}

/** -p = 1 + x at a bottom of 1 x 2: the force 3 acts at x = (1/2 + 1/3)/(3/2), y = 1. */
void uneven_pressure(Checks &checks) {
  Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  scene.boundary[scene.geometry.find_side("right")].role = Role::free;
  const Box box(scene, 3, 2);
  const Pressure P = box.at_centres([](const auto &s) { return -1. - s[0]; });
  const auto found = contact_force(box.multipliers, {0}, P);
  // Means over patches of length 1/4 lose H²/12 of the linear part's moment.
  const double x_moment = 2. * (5. / 6. - 1. / 192.);
  checks.near("force of 1 + x", found.resultant.force, Vector3({0., 0., 3.}), 1e-13);
  checks.near("its moment", found.resultant.moment, Vector3({3., -x_moment, 0.}), 1e-13);
  checks.near("its line of action", *found.through, Vector3({x_moment / 3., 1., 0.}), 1e-13);
  const auto peak = peak_pressure(box.multipliers, P);
  checks.near("peak of 1 + x, at the edge, and the mean of its patch",
              {peak->value, peak->at.point[0], peak->mean}, {2., 1., 1.875}, 1e-13);
  checks.that("no pressure, no peak", !peak_pressure(box.multipliers, Pressure(P.size())));

  // A paraboloid: mean of (x - c)² over a patch of length H is (middle - c)² + H²/12. In the corner
  // between two rollers it goes on symmetrically.
  for (const dealii::Point<2> &c : {dealii::Point<2>(0.43, 0.9), dealii::Point<2>(0., 2.)}) {
    const auto top = peak_pressure(box.multipliers, box.at_centres([&](const auto &s) {
      return -1. + 0.5 * (std::pow(s[0] - c[0], 2) + 1. / 192.) +
             0.1 * (std::pow(s[1] - c[1], 2) + 1. / 48.);
    }));
    checks.near("peak of a paraboloid", top->value, 1., 1e-13);
    checks.near("its place", top->at.point, Vector3({c[0], c[1], 0.}), 1e-12);
  }
  Resultant<3> screw;
  screw.add(Vector3({0., 0., 2.}), {1., 0., 0.});
  screw.moment[2] += 5.;
  checks.near("axis of a screw", *side_force("", screw, dealii::Point<3>(3., 4., 5.), 1.).through,
              Vector3({1., 0., 5.}), 1e-14);
}

/** Two sides that hold all components and a roller share edges and corners. */
void held_sides(Checks &checks) {
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 1.; }), compression);
  auto &left = scene.boundary[scene.geometry.find_side("left")];
  left.role = Role::displacement;
  left.data = compression;
  const Box box(scene, 3, 2);
  Vector3 sum({0., 0., -sigma});
  for (const SideForce &side :
       reactions(box.space, scene,
                 forces_of(box, interpolate_at_nodes(box.space, *compression),
                           box.at_centres([](const auto &) { return sigma; })))) {
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] += side.resultant.force[d];
    if (side.side == "front")
      checks.near("a roller takes what acts along its normal", side.resultant.force,
                  Vector3({0., -sigma_across, 0.}), 1e-13);
  }
  checks.near("all together", sum.norm(), 0., 1e-13);
}

/** u_n = -u_3 = 0.05 at the bottom: the deepest point is a sample between the nodes. */
void penetration(Checks &checks) {
  const Scene<3> scene =
    make_box_scene(scalar([](const auto &x) {
                     return 0.01 + std::pow(x[0] - 0.3125, 2) + std::pow(x[1] - 0.625, 2);
                   }),
                   nothing);
  const Box box(scene, 1, 2);
  const auto sinking = field([](const auto &x) { return Vector3({0., 0., -0.05 * (1. - x[2])}); });
  const auto found =
    max_penetration({box.space, scene, interpolate_at_nodes(box.space, *sinking)}, box.surface);
  checks.near("penetration", found->value, 0.04 - std::pow(0.0625, 2), 1e-15);
  checks.that("its side", found->at.side == "bottom");
}

/** K/mu = 2 (1 + nu)/(3 (1 - 2 nu)), times (h/l)²; zero where it is small. */
void locking(Checks &checks) {
  const Scene<3> scene = make_box_scene(zero, nothing, {1., 2., 1.});
  const Mesh<3> mesh(scene.geometry, 0, 2, MPI_COMM_WORLD);
  const Expression<3> E("7", {}, "E"), nu("0.49", {}, "nu");
  Scene<3> soft = scene;
  soft.material = make_isotropic<3>(E, nu, PlaneState::strain);
  checks.near("locking numbers of nu = 0.3 and 0.49",
              {locking_number(mesh, scene), locking_number(mesh, soft)},
              {0., 2. * 1.49 / (3. * 0.02) / 16.}, 1e-10);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {forces, uneven_pressure, held_sides, penetration, locking});
}
