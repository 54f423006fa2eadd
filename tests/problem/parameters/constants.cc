// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers made of constants are the numbers that they stand for, in every kind of entry.

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include "contact_of.h"
#include "scene_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string constants = "Constants/Values = w=2, h=w/2, r=h/4, n=3\n";

Parameters parameters_of(const std::string &text) {
  return parse_parameters(parameter_file(text), "test", {});
}

void check_plain_numbers(Checks &checks) {
  const Parameters given = parameters_of(
    constants + "Geometry/Mesh size = r/2\nDiscretization/Coarsest level = n-3\n"
                "Discretization/Finest level = n\nDiscretization/Kinks at x = w/4, w*r\n"
                "Solver/Tolerance = 1/10^(2*n)\n");
  checks.near("number", given.geometry.mesh_size, 0.125, 0.);
  checks.near("integer", given.discretization.coarsest_level, 0., 0.);
  checks.near("integer", given.discretization.finest_level, 3., 0.);
  checks.near("list", given.discretization.kinks_at_x.value, std::vector<double>{0.5, 0.5}, 0.);
  checks.near("tolerance", given.solver.tolerance, 1e-6, 1e-21);
}

void check_scene(Checks &checks) {
  const Scene<2> scene = make_scene<2>(parameters_of(
    constants +
    "Geometry/Shape = polygon\n"
    "Geometry/Vertices = 0,0; w,0 fillet r; w,h; 0,h; 0,0;\n"
    "Geometry/Holes = circle w/2,h/2,r\nBoundary/Plates = side2: 0, -h\n"
    "Boundary/Contact = side0\nLoad/Plate force = side2: n*h\n"
    "Contact/Foundation = circle w/2,-n radius n\nLoad cases/Cases = force h, gap r\n"));
  const Geometry<2> &geometry = scene.geometry;
  checks.near("size", geometry.upper, dealii::Point<2>(2., 1.), 1e-15);
  checks.near("fillet", geometry.sides[geometry.find_side("fillet1")].radius(), 0.25, 1e-15);
  checks.near("hole", geometry.sides[geometry.find_side("hole0")].radius(), 0.25, 1e-15);
  checks.near("force", scene.plates.front().force, 3., 0.);
  checks.near("foundation", contact_of(scene, "side0").gap->value({1., 0.}), 0., 1e-14);
  checks.near("load case", scene.load_cases.front().gap, 0.25, 0.);
}

/** One separator may stand behind the last entry of a list. */
void check_ends_of_lists(Checks &checks) {
  const Parameters given = parse_parameters(
    parameter_file(
      "Constants/Values = w=2, h=1,\nGeometry/Shape = polygon\nGeometry/Vertices = 0,0; w,0; w,h; "
      "0,h;\n"
      "Geometry/Holes = circle w/2,h/2,h/4 |\nBoundary/Plates = side2: 0, -h |\n"
      "Boundary/Contact = side0\nBoundary/Traction = side1: 0; 0; |\nLoad/Plate force = side2: h "
      "|\n"
      "Contact/Foundation = plane 0,0 normal 0,1 |\nDiscretization/Kinks at x = h, h/2,\n"
      "Discretization/Kinks at y = 0.25,\nOutput/Report = side0 | hole0 |\n"
      "Load cases/Cases = force 1, gap 0 | force 2, |\n"),
    "test", {"w=3,"});
  const Scene<2> scene = make_scene<2>(given);
  checks.near("kinks", given.discretization.kinks_at_x.value, std::vector<double>{1., 0.5}, 0.);
  checks.near("kinks", given.discretization.kinks_at_y.value, std::vector<double>{0.25}, 0.);
  checks.near("width", scene.geometry.upper[0], 3., 1e-15);
  checks.near("sides, reports, cases",
              std::vector<double>{1. * scene.geometry.sides.size(), 1. * scene.probes.size(),
                                  1. * scene.load_cases.size()},
              std::vector<double>{5., 2., 2.}, 0.);
}

/** Fillets of half the width make a slot with round ends; of the sides between nothing is left. */
void check_round_ends(Checks &checks) {
  const Scene<2> scene = make_scene<2>(parameters_of(
    constants + "Geometry/Shape = polygon\nGeometry/Vertices = 0,0 fillet h/2; w,0 fillet h/2; "
                "w,h fillet h/2; 0,h fillet h/2\nBoundary/Clamped = side2\n"
                "Boundary/Contact = side0\n"));
  double length = 0.;
  for (const Side<2> &side : scene.geometry.sides)
    length += side.length();
  checks.near("sides", scene.geometry.sides.size(), 6., 0.);
  checks.near("length", length, 2. + dealii::numbers::PI, 1e-8);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_plain_numbers, check_scene, check_ends_of_lists, check_round_ends});
}
