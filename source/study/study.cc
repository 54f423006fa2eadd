// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested levels, coarsest to finest, each started from the one before.

#include <signorini/base/exceptions.h>
#include <signorini/base/stage_timer.h>
#include <signorini/output/answer_output.h>
#include <signorini/output/tables.h>
#include <signorini/postprocess/locking.h>
#include <signorini/stiffness_inverse/library_threads.h>
#include <signorini/study/study.h>

#include "memory_limit.h"
#include "results_writer.h"
#include "scene_summary.h"
#include "settings_check.h"

namespace Signorini
{
namespace
{
/** What the levels of a study have in common. */
template <int dim>
struct StudyContext
{
  const Parameters &parameters;
  const Scene<dim> &scene;
  /** Null if it is not known. */
  std::unique_ptr<const ExactPressure> exact_pressure;
  MPI_Comm communicator;
  const Judge &judge;

  /** Whether no finer level follows. */
  bool is_last(const LevelRecord &record) const
  {
    return record.sizes.level == parameters.discretization.finest_level ||
           judge.reaches_target(record);
  }
};

/** Everything about one level; the level's large objects live no longer than this call. */
template <int dim>
LevelRecord run_level(const StudyContext<dim> &context,
                      const unsigned int level,
                      const Progress &progress,
                      ResultsWriter &writer,
                      PatchPressure &pressure)
{
  const Parameters &parameters = context.parameters;
  progress("mesh");
  const Discretization<dim> discretization(parameters, context.scene, level, context.communicator);
  LevelSolution<dim> solution =
    solve_level(parameters,
                context.scene,
                discretization,
                parameters.solver.warm_start ? pressure : PatchPressure(),
                progress);
  progress("errors");
  add_errors(parameters, context.scene, discretization, context.exact_pressure.get(), solution);
  const bool last = context.is_last(solution.record);
  if (last && discretization.space.strain_operator() == StrainOperator::symmetric_gradient)
    solution.record.locking_number = locking_number(discretization.mesh, *context.scene.material);
  progress("output");
  {
    const StageTimer timer(solution.record.times.output);
    writer.write_fields(discretization, context.scene, solution, last);
  }
  solution.record.resources = measure_resources();
  pressure = {discretization.surface.patches(), solution.P};
  return solution.record;
}

/** What a user reads after the last level. */
void print_end(const std::vector<LevelRecord> &levels,
               const Judge &judge,
               const StudyVerdict &verdict,
               const StudyReport &report)
{
  if (!levels.empty())
  {
    const std::string errors = error_table(levels);
    report.screen << "\n" << errors << (errors.empty() ? "" : "\n");
    print_answer(report.screen, levels, report.directory);
    report.screen << "\n";
  }
  print_verdict(levels, judge, verdict, report.screen);
}
} // namespace

template <int dim>
StudyResult run_study(const Parameters &parameters,
                      const Scene<dim> &scene,
                      MPI_Comm communicator,
                      const StudyReport &report)
{
  const DiscretizationParameters &given = parameters.discretization;
  const Judge judge({parameters.solver.tolerance,
                     parameters.solver.tolerated_error,
                     parameters.discretization.target_error});
  const LibraryThreads one_thread_in_libraries(1);
  const MemoryLimit<dim> memory(parameters, scene, communicator);
  check_settings(parameters, scene, communicator);
  StudyContext<dim> context = {parameters, scene, nullptr, communicator, judge};
  const bool errors = parameters.output.errors;
  if (errors && scene.has_exact_pressure())
    context.exact_pressure = std::make_unique<const ExactPressure>(scene);
  ResultsWriter writer(parameters, judge, scene.description, report.directory, communicator);
  StudyResult result;
  print_scene(parameters, scene, report.screen);
  print_scene_warnings(scene, report.screen);
  report.screen << screen_legend() << "\n" << screen_header() << std::endl;
  try
  {
    for (unsigned int level = given.coarsest_level; level <= given.finest_level; ++level)
    {
      const Progress progress = [&](const std::string &stage) {
        report.progress("level " + std::to_string(level) + ": " + stage);
      };
      memory.check(level);
      const LevelRecord record = run_level(context, level, progress, writer, result.pressure);
      report.progress("");
      report.screen << screen_row(record, result.levels.empty() ? nullptr : &result.levels.back())
                    << std::endl;
      print_warnings(record, judge, report.screen);
      result.levels.push_back(record);
      const bool last = context.is_last(record);
      result.verdict = last ? judge.verdict(result.levels) : judge.unfinished(result.levels);
      writer.write_tables(result.levels, result.verdict);
      if (last)
      {
        writer.write_answer(result.levels, result.verdict);
        break;
      }
    }
  }
  catch (const ComputationError &error)
  {
    result.verdict = judge.failed(result.levels, error.what());
    writer.write_failure(result.levels, result.verdict);
  }
  catch (const InputError &error)
  {
    writer.abandon(result.levels, error.what());
    throw;
  }
  print_end(result.levels, judge, result.verdict, report);
  return result;
}

template StudyResult run_study(const Parameters &, const Scene<2> &, MPI_Comm, const StudyReport &);
} // namespace Signorini
