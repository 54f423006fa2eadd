// SPDX-License-Identifier: LGPL-2.1-or-later
// All load cases of a scene on one level.

#include <signorini/base/columns.h>
#include <signorini/base/instantiate.h>
#include <signorini/driver/sequence/level_clock.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/error_control/estimate/contact_part.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/error_control/hp/step_examination.h>
#include <signorini/postprocessing/quantities/case_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <tuple>

namespace Signorini {
namespace {
/** Returns the estimated relative error of a case, at least the largest penetration over the
 * largest displacement and at most 1, which it is where a graded mesh has missed the contact;
 * nothing where there is no T^{2h}. */
template <int dim>
std::optional<double> error_of_case(const Parameters &parameters, const Solved<dim> &solved,
                                    const LevelOperators<dim> &operators) {
  const auto &[space, U] = std::tie(solved.space, solved.U);
  const bool is_graded = parameters.discretization.strategy == Strategy::hp;
  if (!is_graded && !space.mesh().has_parents())
    return {};
  const auto energy = [&]() {
    // Cell matrices of high degrees cost more than all the rest of a case.
    if constexpr (dim == 2)
      if (is_graded)
        return energy_distance(solved, {solved.space, solved.scene, solved.space.zero()});
    return internal_forces(solved).energy_norm;
  };
  const EnergyScale scale = {energy(), norm_of_rigid_motion(solved)};
  double error = 1.;
  if (!is_graded) {
    OtherErrors others;
    others.contact = contact_part(solved);
    error = estimate_error(solved, scale, correct_pressure(solved, operators), others).relative;
  } else if constexpr (dim == 2) {
    const StepFindings found = StepExamination(1.).examine(solved, scale, {}, 1.);
    if (found.has_estimate())
      error = found.error > 0. ? found.error / found.scale : 0.;
  }
  constexpr double smallest_motion = 1e-6;
  const auto deepest = max_penetration(solved, solved.surface());
  const double depth = deepest ? deepest->value : 0.;
  const double penetration = Utilities::MPI::max(depth, space.mesh().communicator()) /
                             std::max(U.linfty_norm(), smallest_motion * space.mesh().size());
  return std::min(1., std::max(error, penetration));
}
} // namespace

template <int dim>
std::vector<CaseResult> solve_load_cases(const Parameters &parameters, const Scene<dim> &scene,
                                         LevelResult<dim> &level, const CaseFields<dim> &use_fields,
                                         const Progress &progress) {
  double seconds = 0.;
  std::vector<CaseResult> results;
  {
    const StageTimer timer(seconds);
    progress("load cases");
    const bool are_steps = parameters.load_cases.sequence == CaseSequence::steps;
    const LevelOperators<dim> &operators = *level.solution.operators;
    CaseSolver<dim> solver(*level.discretization, scene, operators,
                           dual_options(parameters.solver, is_unstable(*level.discretization)),
                           are_steps);
    const auto edges =
      scene.probes.empty() ? std::vector<SingularEdge<dim>>() : singular_edges(scene);
    const auto since_start = [start = std::chrono::steady_clock::now()] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const std::size_t n = scene.load_cases.size(), every = std::max<std::size_t>(1, n / 20);
    for (const LoadCase &load_case : scene.load_cases) {
      results.push_back(solver.solve(load_case));
      CaseResult &result = results.back();
      result.number = results.size();
      result.level = level.discretization->mesh.level();
      if (level.is_last && result.escape.empty()) {
        ContactSolution contact = solver.contact();
        contact.algebraic_error = level.solution.contact.algebraic_error;
        Scene<dim> moved =
          with_plates_moved(scene_of_case(scene, load_case), solver.plate_motions());
        const Solved<dim> solved(*level.discretization, moved, contact);
        result.reactions = solver.reactions(contact.U);
        result.reports = report_on_probes<dim>(solved, edges);
        if (load_case.has_fields)
          use_fields(result.number, solved);
        // Sticking points follow the foundation from the slip of the steps before.
        if (are_steps)
          moved.contact_law = {};
        result.estimate = error_of_case(parameters, solved, operators);
      }
      if (const std::size_t done = results.size(); done % every == 0)
        progress("load cases: " + std::to_string(done) + " of " + std::to_string(n) +
                 text_to_go(since_start() * (n - done) / done));
    }
  }
  LevelRecord &record = level.solution.record;
  record.load_cases = summarise(results, seconds);
  record.times.postprocess += seconds;
  return results;
}

INSTANTIATE_FUNCTION(solve_load_cases);
} // namespace Signorini
