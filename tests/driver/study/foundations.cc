// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole studies with rigid things: the digits of the gap by an expression, and the line contact of
// Hertz.

#include <signorini/problem/scene/foundation.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>

#include "contact_of.h"
#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string block = "subsection Geometry\nset Lower left = -1, 0\nset Cells = 2, 1\nend\n"
                          "subsection Boundary\nset Contact = bottom\n"
                          "set Displacement = top: 0; -0.05\nend\n";

/** The block on things, or on a gap. */
StudyResult<2> solve_on(const std::string &name, const std::string &value,
                        std::vector<std::string> overrides) {
  overrides.insert(overrides.begin(), "Contact/" + name + "=" + value);
  return solve(block, overrides);
}

void test_digits(Checks &checks) {
  struct Pair {
    std::string expression, obstacle;
  };
  for (const Pair &pair : std::vector<Pair>{
         {"x^2/4", "parabola 0,0 normal 0,2 curvature -0.5"},
         {"-0.0625", "plane -7,0.0625 normal 0,1"},
         {"min(0.125, 0.25)", "plane 0,-0.25 normal 0,1 | plane 0,-0.125 normal 0,3"}})
    for (const auto &overrides : {levels(2, 4), graded("1e-3")}) {
      const StudyResult<2> a = solve_on("Gap", pair.expression, overrides),
                           b = solve_on("Foundation", pair.obstacle, overrides);
      checks.near(pair.obstacle + ": levels", a.levels.size(), b.levels.size(), 0.);
      for (std::size_t i = 0; i < a.levels.size(); ++i)
        for (const char *column :
             {"energy", "kkt", "contact_force_n", "peak_pressure", "estimated_energy"})
          checks.that(pair.obstacle + ": the same digits",
                      value(a.levels[i], column) == value(b.levels.at(i), column));
    }
}

/** A disc of a hundredth of the block's size beside a large one, without kinks: graded meshes find
 * it, although gaps beside it are much larger than it. */
void test_small_disc(Checks &checks) {
  const std::string things = "circle 0.53,-0.03 radius 0.02 | circle -0.5,-1 radius 1";
  const StudyResult<2> result = solve_on("Foundation", things, graded("1e-3"));
  checks.that("a small disc, the accuracy is reached",
              result.verdict.outcome == Outcome::certified);
  checks.near("a small disc is found", result.levels.back().answer.zones.size(), 2, 0.);
  // H is a third of the small zone.
  checks.near("force with a small disc, against a nested level",
              last(result, "contact_force_n") /
                last(solve_on("Foundation", things, levels(7, 7)), "contact_force_n"),
              1., 0.01);
}

/** A square on its tip, held by nothing but a groove of two planes: each side of the groove carries
 * (∓W/2, W/2) of the weight W = 2. */
void test_groove(Checks &checks) {
  const StudyResult<2> result =
    solve("subsection Geometry\nset Shape = polygon\nset Vertices = 0,-1; 1,0; 0,1; -1,0\nend\n"
          "subsection Boundary\nset Contact = side0 side3\nend\n"
          "subsection Load\nset Body force = 0; -1\nend\n",
          levels(2, 4, {"Contact/Foundation=plane 0,-1 normal -1,1 | plane 0,-1 normal 3,3"}));
  checks.that("certified in a groove", result.verdict.outcome == Outcome::certified);
  for (unsigned int i = 0; i < 2; ++i)
    checks.near("forces in a groove",
                result.levels.back().answer.contact_by_side.at(i).resultant.force,
                dealii::Point<2>(i == 0 ? -1. : 1., 1.), 1e-9);
}

/** A rounded foot, which a plane dents in: without friction it exerts no force along itself,
 * however the foot is tilted; along the body's normals it does. Bounds of the energy on coarse
 * meshes contain those on fine ones. */
void test_foot(Checks &checks) {
  const std::string foot =
    "Geometry/Shape = polygon\n"
    "Geometry/Vertices = 0,0 fillet 0.5; 1,0 fillet 0.4; 1,1; 0,1\nBoundary/Clamped = side2\n"
    "Boundary/Contact = fillet0 side0 fillet1\nContact/Foundation = plane 0,0.15 normal 0,1\n";
  for (const std::string direction : {"foundation", "body"}) {
    checks.about("foot, direction of the " + direction);
    std::vector<std::array<double, 2>> brackets;
    for (std::vector<std::string> overrides : {levels(2, 2), levels(3, 3), graded("1e-2")}) {
      overrides.push_back("Contact/Direction=" + direction);
      const StudyResult<2> result = solve(foot, overrides);
      const auto force = result.levels.back().answer.contact_force.resultant.force;
      checks.that("no force along the plane",
                  (std::abs(force[0]) <= 1e-12 * force[1]) == (direction == "foundation"));
      checks.between("the force is ∫ p", force[1] / last(result, "contact_force_n"),
                     direction == "foundation" ? 1. - 1e-4 : 0.8,
                     direction == "foundation" ? 1. + 1e-4 : 0.99);
      brackets.push_back({{last(result, "energy_lower"), last(result, "energy_upper")}});
      for (const auto &[lower, upper] : brackets)
        checks.that("brackets have numbers in common",
                    lower <= brackets.back()[1] && brackets.back()[0] <= upper);
    }
  }
}

/** A half disc whose flat side is pressed and pushed along an oblique plane, and the same turned by
 * 0.3 about the origin: the same digits but for rounding. The zone is not in the middle of the arc,
 * and the normals in it are not those of the plane. */
void test_turned(Checks &checks) {
  const auto press = [](const std::string &angle, const std::string &friction) {
    return solve("Constants/Values = a=" + angle +
                   ", c=cos(a), s=sin(a), C=cos(a+0.2), S=sin(a+0.2)\nGeometry/Shape = polygon\n"
                   "Geometry/Vertices = -c,-s; arc 0,0 ccw; c,s\n"
                   "Boundary/Displacement = side1: 0.02*s+0.01*c; -0.02*c+0.01*s\n"
                   "Boundary/Contact = side0\n"
                   "Contact/Foundation = plane S,-C normal -S,C\n" +
                   friction,
                 levels(2, 2, {"Output/VTU=none"}));
  };
  for (const std::string friction :
       {"", "Contact/Friction = tresca\nContact/Friction bound = 0.01\n",
        "Contact/Friction = coulomb\nContact/Friction coefficient = 0.2\n"}) {
    checks.about("turned, " + friction);
    const StudyResult<2> straight = press("0", friction), turned = press("0.3", friction);
    for (const char *column : {"energy", "contact_force_n", "peak_pressure", "contact_length"})
      checks.near(column, last(turned, column) / last(straight, column), 1., 1e-9);
    const auto force = straight.levels.back().answer.contact_force.resultant.force,
               other = turned.levels.back().answer.contact_force.resultant.force;
    const dealii::Point<2> m(std::sin(0.2), -std::cos(0.2));
    checks.near("the force turns", other[0], std::cos(0.3) * force[0] - std::sin(0.3) * force[1],
                1e-9 * std::abs(force[1]));
    const double along =
      std::abs(force[0] * m[1] - force[1] * m[0]) / last(straight, "contact_force_n");
    if (friction.empty())
      checks.near("no force along the plane", along, 0., 1e-12);
    else
      checks.between("friction", along, 0.01,
                     friction.find("coulomb") == std::string::npos ? 1. : 0.2 + 1e-9);
  }
}

/** A disc spring between plates, whose edges roll on these: stiff elastic bodies instead of the
 * plates give 4081 N. */
void test_disc_spring(Checks &checks) {
  const StudyResult<2> result =
    solve("Constants/Values = a=12.7, b=25, t=3, h=1.1, c=h/(b-a), L=sqrt(1+c^2)\n"
          "Geometry/Shape = polygon\nGeometry/Vertices = b-t*c/L, 0 fillet 0.3; b, t/L fillet 0.3; "
          "a+t*c/L, h+t/L fillet 0.3; a, h fillet 0.3\n"
          "Material/Young's modulus = 206000\nMaterial/Poisson's ratio = 0.3\n"
          "Material/Plane state = axisymmetric\nBoundary/Contact = fillet0 fillet2\n"
          "Contact/Foundation = plane 0,0.0261193 normal 0,1 | plane 0,4.06196-0.236 normal 0,-1\n",
          graded("1e-2"));
  checks.near("disc spring", result.levels.back().answer.contact_by_side.at(0).resultant.force[1],
              4081., 15.);
}

/** A roller in a groove of twice its radius, by Hertz: half the zone is b with b² = 4 F R_* /(pi
 * E*), the peak 2 F/(pi b); here E* = 8/3, 1/R_* = 1 - 1/2. The law holds up to (b/R)² = 0.014;
 * rollers on planes are in tests/driver/benchmarks. */
void test_hertz(Checks &checks) {
  const Parameters parameters = parse_parameters(named_scene("E3"), "test", graded("1e-3"));
  Scene<2> scene = make_scene<2>(parameters, named_scenes());
  scene.exact_displacement = scene.body_force = nullptr;
  scene.kinks = Kinks<2>();
  ContactCondition<2> &contact = contact_of(scene, "arc");
  contact.exact_pressure = nullptr;
  contact.foundation = std::make_shared<Foundation<2>>(
    std::vector<Obstacle<2>>{Obstacle<2>::circle({0., 1.}, 2., Body::inside)}, 20.);
  contact.gap = foundation_gap(scene.geometry.sides[contact.side], contact.foundation,
                               dealii::Point<2>(0., 0.01));
  const StudyResult<2> result = run(parameters, scene);
  const double F = last(result, "contact_force_n"), b = std::sqrt(4. * F * 2. / (PI * 8. / 3.));
  checks.between("Hertz, half width", b, 0.11, 0.12);
  checks.near("Hertz, zone", last(result, "contact_length") / (2. * b), 1., 0.01);
  checks.near("Hertz, peak", last(result, "peak_pressure") / (2. * F / (PI * b)), 1., 0.014);
  checks.that("Hertz, resolved", result.verdict.outcome == Outcome::certified);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_digits, test_small_disc, test_groove, test_foot, test_turned,
                    test_disc_spring, test_hertz});
}
