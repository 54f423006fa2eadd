// SPDX-License-Identifier: LGPL-2.1-or-later
// Load cases from one factorisation against runs of their own.

#include <signorini/postprocessing/quantities/case_solver.h>

#include <iomanip>
#include <sstream>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/** A block: a plate on the left, a traction and its weight press it; the right side is moved. */
std::string block(const LoadCase &load_case) {
  std::ostringstream text;
  text << std::setprecision(17) << "Constants/Values = T=" << 0.02 * load_case.force
       << ", w=" << 0.03 * load_case.weight << ", u=" << 0.01 * load_case.travel
       << ", X=" << load_case.shift_x << ", Y=" << load_case.shift_y << ", G=" << load_case.gap
       << "\nLoad/Plate force = left: " << 0.08 * load_case.force
       << "\nLoad/Plate cross force = left: " << 0.04 * load_case.cross
       << "\nLoad/Plate moment = left: " << -0.01 * load_case.force
       << "\nLoad/Body force = 0; -w\nGeometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\n"
          "Boundary/Contact = bottom\nBoundary/Plates = left: 0, -1 turning\n"
          "Boundary/Traction = top: 0.5*T; -T\nBoundary/Displacement = right: -u; 0\n";
  return text.str();
}

CaseSolver<2> make_solver(const OneLevel &level, const LevelSolution<2> &solution) {
  return CaseSolver<2>(level.discretization, level.scene, *solution.operators, {});
}

void compare(Checks &checks, const std::string &name, const std::string &foundation,
             const std::vector<LoadCase> &cases) {
  OneLevel level(block(LoadCase()) + foundation, 4);
  level.scene.load_cases = cases;
  const LevelSolution<2> solution = level.solve();
  CaseSolver<2> solver = make_solver(level, solution);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string at = name + ", case " + std::to_string(i + 1);
    const CaseResult result = solver.solve(cases[i]);
    const LevelSolution<2> own = OneLevel(block(cases[i]) + foundation, 4).solve();
    checks.near(at + ": P", distance(solver.contact().P.normal(), own.contact.P.normal()), 0.,
                1e-9);
    checks.near(at + ": U", relative_distance(solver.contact().U, own.contact.U), 0., 1e-9);
    const PlateRecord &plate = own.record.motions.plates.at(0);
    const auto &force = own.record.answer.contact_force.resultant.force;
    const auto &peak = own.record.answer.peak_pressure;
    checks.near(at + ": numbers",
                {result.plates.at(0).travel, result.plates.at(0).drift[0],
                 result.plates.at(0).rotation[0], result.contact.force[0], result.contact.force[1]},
                {plate.travel, plate.drift[0], plate.rotation[0], force[0], force[1]}, 1e-10);
    NamedNumbers expected;
    for (const SideForce &reaction : own.record.answer.reactions)
      for (unsigned int d = 0; d < 2; ++d)
        expected.emplace_back(reaction.side + "_" + "xy"[d], reaction.resultant.force[d]);
    const NamedNumbers found = solver.reactions(own.contact.U);
    checks.that(at + ": reactions", found.size() == expected.size());
    for (std::size_t r = 0; r < found.size(); ++r)
      checks.near(at + ": " + expected[r].first + " as " + found[r].first, found[r].second,
                  expected[r].second, 1e-10);
    checks.near(at + ": peak", result.peak_pressure, peak ? peak->value : 0., 1e-8);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      LoadCase all, pulled, moved;
      all.force = 1.7;
      all.weight = 0.4;
      all.travel = -2.;
      all.cross = -0.7;
      pulled.force = 0.1;
      pulled.weight = 0.;
      pulled.gap = 0.5;
      pulled.cross = 1.3;
      moved.shift_x = 0.05;
      moved.shift_y = 0.03;
      moved.force = 1.2;
      compare(
        checks, "rollers",
        "Contact/Foundation = circle 0.5+X,-0.5+Y radius 0.5 | circle 1.6+X,-0.52+Y radius 0.5\n",
        {LoadCase(), all, moved});
      compare(checks, "parabola", "Contact/Gap = G*(0.01 + 0.1*(x-0.7)^2)\n", {all, pulled});
    }});
}
