// SPDX-License-Identifier: LGPL-2.1-or-later
// All load cases of a scene on one level.

#include <signorini/base/columns.h>
#include <signorini/driver/sequence/level_clock.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/postprocessing/load_cases/case_solver.h>

#include <chrono>

namespace Signorini {
std::vector<CaseResult> solve_load_cases(const Parameters &parameters, const Scene<2> &scene,
                                         LevelResult<2> &level, const CaseFields &use_fields,
                                         const Progress &progress) {
  double seconds = 0.;
  std::vector<CaseResult> results;
  {
    const StageTimer timer(seconds);
    progress("load cases");
    const SolverParameters &given = parameters.solver;
    CaseSolver solver(*level.discretization, scene, level.solution.contact,
                      {{given.tolerance, given.maximum_iterations, given.relaxation},
                       given.contact_solver,
                       is_unstable(*level.discretization)},
                      parameters.load_cases.sequence == CaseSequence::steps);
    const auto since_start = [start = std::chrono::steady_clock::now()] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const std::size_t n = scene.load_cases.size(), every = std::max<std::size_t>(1, n / 20);
    for (const LoadCase &load_case : scene.load_cases) {
      results.push_back(solver.solve(load_case));
      results.back().number = results.size();
      results.back().level = level.discretization->mesh.level();
      const bool is_wanted = level.is_last && results.back().escape.empty();
      if (is_wanted && (load_case.has_fields || !scene.report_places.empty())) {
        const Displacement U = solver.displacement();
        results.back().reports = solver.report(U);
        if (load_case.has_fields)
          use_fields(results.size(),
                     with_plates_moved(scene_of_case(scene, load_case), results.back().plates), U,
                     solver.multiplier());
      }
      if (const std::size_t done = results.size(); done % every == 0)
        progress("load cases: " + std::to_string(done) + " of " + std::to_string(n) +
                 text_to_go(since_start() * (n - done) / done));
    }
  }
  LevelRecord &record = level.solution.record;
  record.load_cases = summarise(results, seconds);
  record.times.postprocess += seconds;
  level.solution.contact.inverse = nullptr;
  return results;
}
} // namespace Signorini
