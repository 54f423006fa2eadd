// SPDX-License-Identifier: LGPL-2.1-or-later
// Answers of graded meshes without an exact solution: they lie in what nested levels guarantee, are
// found where the first mesh misses the contact, and are not claimed where unknowns run out.

#include <deal.II/base/mpi.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace
{
StudyResult<2> solve_file(const std::string &name, const std::vector<std::string> &overrides)
{
  std::ostream silence(nullptr);
  const Parameters parameters =
    read_parameters(SOURCE_DIR "/../../../prm/" + name + ".prm", overrides);
  return run_study(parameters,
                   make_scene<2>(parameters),
                   MPI_COMM_WORLD,
                   {silence, "", [](const std::string &) {}});
}

void check_agreement(Checks &checks, const std::string &name)
{
  // Brackets belong to the finest level of a study.
  const StudyResult<2> coarse_result = solve_file(name, levels(5, 5));
  const StudyResult<2> fine_result = solve_file(name, levels(6, 6));
  const StudyResult<2> graded_result = solve_file(name, graded("1e-5"));
  checks.that(name + ", both are certified",
              fine_result.verdict.outcome == Outcome::certified &&
                graded_result.verdict.outcome == Outcome::accuracy_estimated);
  const LevelRecord &coarse = coarse_result.levels.back(), &fine = fine_result.levels.back();
  const LevelRecord &last = graded_result.levels.back();
  const double J = last.certificate.energy;
  checks.that(name + ", energy in the bracket of level 5",
              J >= coarse.bound->energy_lower.value() && J <= coarse.bound->energy_upper.value());
  checks.that(name + ", energy in the bracket of level 6",
              J >= fine.bound->energy_lower.value() && J <= fine.bound->energy_upper.value());
  const auto force = [](const LevelRecord &level) { return level.contact.normal_force; };
  for (const LevelRecord *level : {&coarse, &fine})
    checks.near(name + ", contact force, level " + std::to_string(level->sizes.level),
                force(*level),
                force(last),
                level->bound->force_error.value());
  const auto peak = [](const LevelRecord &level) { return level.answer.peak_pressure->value; };
  // Levels 5 and 6 differ by more than level 6 is wrong.
  checks.near(
    name + ", peak pressure", peak(fine), peak(last), std::abs(peak(fine) - peak(coarse)));
  checks.near(
    name + ", length of contact", last.contact.length, fine.contact.length, 2. * fine.sizes.H);
  // |J(u_h) - J(u)| <= (|||u - u_h|||^2 + contact part)/2: digits are twice those of the error.
  const LevelRecord &before = *(graded_result.levels.end() - 2);
  const double strain_energy = std::pow(last.estimate->energy / last.estimate->relative, 2);
  checks.near(name + ", energy of the last two steps",
              before.certificate.energy,
              J,
              strain_energy * std::pow(before.estimate->relative, 2));
}

/** The tip of a parabola touches between the nodes of the first mesh: half of the zone is
 * (0.002/20)^{1/2} = 0.01 wide, if the body were rigid. */
void check_missed_contact(Checks &checks)
{
  const std::string scene =
    "subsection Geometry\n set Upper right = 4, 1\n set Cells = 4, 1\n end\n"
    "subsection Boundary\n set Contact = bottom\n set Displacement = top: 0; -0.002\n end\n"
    "subsection Contact\n set Gap = 20*(x-1.23)^2\n end\n";
  std::vector<double> forces;
  for (const std::string level : {"0", "1", "2"})
  {
    std::vector<std::string> overrides = graded("1e-4");
    overrides.push_back("Discretization/Coarsest level=" + level);
    const StudyResult<2> result = solve(scene, overrides);
    const LevelRecord &first = result.levels.front(), &last = result.levels.back();
    const std::string name = "Tip, from level " + level;
    checks.that(name + ": missed at first, and no error is claimed",
                first.contact.normal_force == 0. && !first.estimate);
    checks.that(name + ": found and resolved",
                result.verdict.outcome == Outcome::accuracy_estimated);
    const std::vector<ContactZone> &zones = last.answer.zones;
    checks.that(name + ": one zone", zones.size() == 1);
    checks.near(name + ": its middle",
                0.5 * (zones.at(0).start.place.point[0] + zones.at(0).end.place.point[0]),
                1.23,
                1e-4);
    checks.between(name + ": its length", last.contact.length, 1e-3, 0.02);
    forces.push_back(last.contact.normal_force);
  }
  for (const double force : forces)
    checks.near("Tip, the same force from all levels", force, forces[0], 1e-4 * forces[0]);
}

void check_too_few_unknowns(Checks &checks)
{
  std::vector<std::string> overrides = graded("1e-6");
  overrides.emplace_back("Discretization/Maximum unknowns=3000");
  const StudyResult<2> result = solve(named_scene("B1"), overrides);
  checks.that("3000 unknowns: not resolved, but solved",
              result.verdict.outcome == Outcome::not_resolved && result.verdict.equations_hold());
  checks.that("3000 unknowns: no step has more", result.levels.back().sizes.dofs <= 3000);
  const std::string &reason = result.verdict.reason;
  checks.that("3000 unknowns: one sentence names the parameter",
              reason.find("raise Maximum unknowns, ") != std::string::npos &&
                reason.find(". ") == std::string::npos && reason.find('\n') == std::string::npos);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_agreement(checks, "block_on_parabola");
  check_agreement(checks, "pressed_plate");
  check_missed_contact(checks);
  check_too_few_unknowns(checks);
  return checks.exit_code();
}
