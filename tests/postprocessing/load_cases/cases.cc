// SPDX-License-Identifier: LGPL-2.1-or-later
// Load cases from one factorisation against runs of their own.

#include <signorini/postprocessing/load_cases/case_solver.h>

#include <iomanip>
#include <sstream>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** A block on two rollers: a plate on the left, a traction and its weight press it; the right side
 * is moved. All numbers are constants that a case changes. */
const std::string block =
  "subsection Constants\nset Values = T=0.02, w=0.03, u=0.01, X=0, Y=0, G=1\nend\n"
  "subsection Geometry\nset Upper right = 2, 1\nset Cells = 2, 1\nend\n"
  "subsection Boundary\nset Contact = bottom\nset Plates = left: 0, -1 turning\n"
  "set Traction = top: 0.5*T; -T\nset Displacement = right: -u; 0\nend\n"
  "subsection Load\nset Body force = 0; -w\nset Plate force = left: 0.08\n"
  "set Plate moment = left: -0.01\nend\n";
const std::string on_rollers =
  "subsection Contact\nset Foundation = circle 0.5+X,-0.5+Y radius 0.5 | circle 1.6+X,-0.52+Y "
  "radius 0.5\nend\n";
const std::string on_parabola = "subsection Contact\nset Gap = G*(0.01 + 0.1*(x-0.7)^2)\nend\n";

CaseSolver make_solver(const OneLevel &level, const LevelSolution<2> &solution)
{
  return CaseSolver(
    {level.space(),
     level.scene,
     level.multipliers(),
     level.discretization.D,
     level.discretization.condensed_D,
     *solution.inverse,
     solution.modes,
     level.discretization.n_points,
     [&level](const Scene<2> &scene) { return level.discretization.assemble_gap_of(scene); },
     {}});
}

std::string value_text(const double value)
{
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

/** The whole run of a case. */
LevelSolution<2> run_of_its_own(const std::string &text, const LoadCase &load_case)
{
  std::string changed = text;
  const auto change = [&changed](const std::string &from, const double number) {
    const auto at = changed.find(from);
    changed.replace(
      at, from.size(), from.substr(0, from.find_last_of("=:") + 1) + " " + value_text(number));
  };
  change("T=0.02", 0.02 * load_case.force);
  change("w=0.03", 0.03 * load_case.weight);
  change("u=0.01", 0.01 * load_case.travel);
  change("X=0", load_case.shift[0]);
  change("Y=0", load_case.shift[1]);
  change("G=1", load_case.gap);
  const auto replace = [&changed](const std::string &from, const double number) {
    const auto at = changed.find(from);
    changed.replace(at, from.size(), from.substr(0, from.rfind(' ') + 1) + value_text(number));
  };
  replace("force = left: 0.08", 0.08 * load_case.force);
  replace("moment = left: -0.01", -0.01 * load_case.force);
  return OneLevel(changed, 4).solve();
}

void compare(Checks &checks,
             const std::string &name,
             const std::string &text,
             const std::vector<LoadCase> &cases)
{
  OneLevel level(text, 4);
  level.scene.load_cases = cases;
  const LevelSolution<2> solution = level.solve();
  CaseSolver solver = make_solver(level, solution);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const std::string at = name + ", case " + std::to_string(i + 1);
    const CaseResult result = solver.solve(cases[i]);
    const LevelSolution<2> own = run_of_its_own(text, cases[i]);
    checks.near(at + ": P", distance(solver.pressure(), own.P), 0., 1e-9);
    checks.near(at + ": U", relative_distance(solver.displacement(), own.U), 0., 1e-9);
    const PlateMotion motion = own.record.motions.plates.at(0).motion;
    checks.near(at + ": travel", result.plates.at(0).travel, motion.travel, 1e-10);
    checks.near(at + ": rotation", result.plates.at(0).rotation, motion.rotation, 1e-10);
    checks.near(at + ": contact force",
                (result.contact.force - own.record.answer.contact_force.resultant.force).norm(),
                0.,
                1e-11);
    checks.near(at + ": peak",
                result.peak_pressure,
                own.record.answer.peak_pressure ? own.record.answer.peak_pressure->value : 0.,
                1e-8);
  }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  LoadCase all, pulled, moved;
  all.force = 1.7;
  all.weight = 0.4;
  all.travel = -2.;
  pulled.force = 0.1;
  pulled.weight = 0.;
  pulled.gap = 0.5;
  moved.shift = dealii::Tensor<1, 2>({0.05, 0.03});
  moved.force = 1.2;
  compare(checks, "rollers", block + on_rollers, {LoadCase(), all, moved});
  compare(checks, "parabola", block + on_parabola, {all, pulled});
  return checks.exit_code();
}
