// SPDX-License-Identifier: LGPL-2.1-or-later
// The graded run whose stress tells the errors of others.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/driver/sequence/sequence.h>

#include <exception>
#include <set>
#include <sstream>

namespace Signorini {
namespace {
/** Returns the parameters of the graded run: the scene's, and the usual ones of meshes. */
Parameters graded_parameters(const Parameters &given, const Scene<2> &scene,
                             const ReferenceTarget &target) {
  Parameters parameters = given;
  DiscretizationParameters &meshes = parameters.discretization = DiscretizationParameters();
  meshes.strategy.value = Strategy::hp;
  meshes.coarsest_level.value = first_graded_level(scene.geometry.n_graded_cells());
  meshes.target_error.value = target.error;
  meshes.maximum_unknowns.value = target.max_unknowns;
  parameters.solver = SolverParameters();
  parameters.output = OutputParameters();
  return parameters;
}

/** Returns the echo of parameters without the subsections that do not change u. */
std::string text_of_scene(const Parameters &given) {
  const std::set<std::string> others = {"subsection Discretization", "subsection Solver",
                                        "subsection Output", "subsection Verify"};
  std::istringstream lines(given.echo);
  std::string text;
  bool is_of_scene = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("subsection ", 0) == 0)
      is_of_scene = others.count(trim(line)) == 0;
    if (is_of_scene)
      text += line + "\n";
  }
  return text;
}
} // namespace

ReferenceRun run_reference(const Parameters &given, const Scene<2> &scene,
                           const ReferenceTarget &target, const Progress &progress) {
  const Parameters parameters = graded_parameters(given, scene, target);
  // No distortion of meshes, and no load case, changes u.
  Scene<2> undistorted = scene;
  undistorted.geometry.distortion = 0.;
  undistorted.load_cases.clear();
  Demands demands;
  demands.target_error = target.error;
  const Judge judge(demands);
  ReferenceRun run;
  try {
    const auto sequence =
      make_hp_sequence({parameters, undistorted, MPI_COMM_SELF, judge, {}, {}, true});
    for (bool is_last = false; !is_last;) {
      LevelResult<2> step = sequence->solve_next([&](const std::string &stage) {
        progress("graded " + sequence->name_of_next() + ", " + stage);
      });
      is_last = step.is_last;
      const auto &found = step.solution.reference;
      if (found && (!run.stress || found->stress_error < run.stress->stress_error))
        run.stress = found;
      if (step.solution.record.bound)
        run.missing = step.solution.record.bound->missing;
    }
  } catch (const InputError &error) {
    run.missing = error.what();
  } catch (const ComputationError &error) {
    run.missing = error.what();
  } catch (const std::exception &) {
    // The scene has its levels, whatever becomes of the run.
    run.missing = "a library ended the graded run";
  }
  return run;
}

const ReferenceRun &ReferenceRuns::find(const Parameters &given, const Scene<2> &scene,
                                        const ReferenceTarget &target, const Progress &progress) {
  // A run that has not been made is one that aims at nothing.
  Known &known = known_.try_emplace(text_of_scene(given), Known{{1., 0}, {}}).first->second;
  const bool is_enough =
    known.target.error <= target.error && known.target.max_unknowns >= target.max_unknowns;
  if (!is_enough)
    known = {target, run_reference(given, scene, target, progress)};
  return known.run;
}
} // namespace Signorini
