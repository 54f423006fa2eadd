// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid motions in space that sides on planes, cylinders and spheres leave free.

#include <signorini/problem/scene/free_motion.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <cmath>

#include "tests.h"

using namespace Signorini;

namespace {
using Point3 = dealii::Point<3>;

/** A cylinder of radius 2 about the z-axis through (1, 0, 0), from z = 0 to 4: the sides round and
 * floor. */
Scene<3> make_cylinder() {
  std::vector<FaceCorners> around, below;
  const auto at = [](const unsigned int k, const double z) {
    const double angle = k * std::acos(0.);
    return Point3(1. + 2. * std::cos(angle), 2. * std::sin(angle), z);
  };
  for (unsigned int k = 0; k < 4; ++k)
    around.push_back({{at(k, 0.), at(k + 1, 0.), at(k, 4.), at(k + 1, 4.)}});
  below.push_back({{at(0, 0.), at(3, 0.), at(1, 0.), at(2, 0.)}});
  Scene<3> scene;
  scene.geometry.lower = Point3(-1., -2., 0.);
  scene.geometry.upper = Point3(3., 2., 4.);
  scene.geometry.sides = {
    {"round",
     SurfacePart(Surface::cylinder(Point3(1., 0., 1.), Point3(0., 0., 3.), 2., Body::inside),
                 around)},
    {"floor", SurfacePart(Surface::plane(Point3(), Point3(0., 0., -1.)), below)}};
  scene.boundary.resize(2);
  return scene;
}

std::vector<std::string> names_of(const std::vector<RigidMotion<3>> &motions) {
  std::vector<std::string> names;
  for (const RigidMotion<3> &motion : motions)
    names.push_back(motion.name());
  return names;
}

const std::string along_axis = "the translation along (0, 0, 1)",
                  about_axis = "the rotation about the line through (1, 0, 2) along (0, 0, 1)";

void test_supports(Checks &checks) {
  Scene<3> scene = make_cylinder();
  checks.near("free: six motions", free_rigid_motions(scene).size(), 6, 0);
  scene.boundary[1].role = Role::roller;
  checks.that("on its floor",
              names_of(free_rigid_motions(scene)) ==
                std::vector<std::string>{"the translation along (1, 0, 0)",
                                         "the translation along (0, 1, 0)", about_axis});
  scene.boundary[0].role = Role::roller;
  checks.that("in a bore, on its floor",
              names_of(free_rigid_motions(scene)) == std::vector<std::string>{about_axis});
  scene.boundary[1].role = Role::free;
  checks.that("in a bore", names_of(free_rigid_motions(scene)) ==
                             std::vector<std::string>{along_axis, about_axis});
  scene.boundary[1].role = Role::clamped;
  checks.that("clamped", free_rigid_motions(scene).empty());
}

/** A plate on the floor that a moment turns, in a bore: one motion of both, no other. */
void test_plates(Checks &checks) {
  Scene<3> scene = make_cylinder();
  scene.boundary[0].role = Role::roller;
  scene.boundary[1].role = Role::displacement;
  Plate<3> plate;
  plate.side = 1;
  plate.direction = Point3(0., 0., -1.);
  plate.centre = Point3(1., 0., 0.);
  plate.turns = true;
  plate.moment = Point3(0., 0., 5.);
  scene.plates = {plate};
  checks.that("held", free_rigid_motions(scene).empty());
  const auto released = free_rigid_motions(scene, Plates::released);
  checks.that("released", names_of(released) == std::vector<std::string>{about_axis});
  const FreeMotionBasis<3> basis = free_motions(scene);
  // Nothing is in contact: that motion is neutral, and the plate turns about two axes alone.
  checks.near("neutral", basis.neutral.size(), 1, 0);
  checks.near("resisted", basis.resisted.size(), 2, 0);
  const PlateMotion<3> &motion = basis.neutral.at(0).plates.at(0);
  checks.near("its rotation", motion.rotation[2] * scene.geometry.diameter(), 1., 1e-12);
  checks.near("its work", basis.neutral[0].work_of_plates(scene.plates),
              5. / scene.geometry.diameter(), 1e-12);
}

/** The motion of a body that turns about a line and moves along it. */
void test_words(Checks &checks) {
  RigidMotion<3> motion;
  motion.bodies.push_back({"", {}, {}, Point3(1., 0., 0.), 2.});
  BodyMotion<3> &body = motion.bodies[0];
  // omega = 0.5 along y; the points with x = 1 and z = 4 do not move.
  body.rotation = Point3(0., 1., 0.);
  body.translation = Point3(-2., 0., 0.);
  checks.near("a point of the line", body.velocity(Point3(1., 7., 4.)).norm(), 0., 1e-14);
  checks.that("a rotation",
              motion.direction() == "about the line through (1, 0, 4) along (0, 1, 0)");
  body.translation[1] = 0.25;
  checks.that("a screw", motion.direction() == "about the line through (1, 0, 4) along (0, 1, 0) "
                                               "(by 3.14159 along it in each turn)");
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_supports, test_plates, test_words});
}
