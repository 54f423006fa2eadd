// SPDX-License-Identifier: LGPL-2.1-or-later
// Level after level, until the sequence ends.

#include <signorini/base/errors.h>
#include <signorini/driver/study/study.h>
#include <signorini/results/files/answer_output.h>
#include <signorini/results/files/tables.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include "results_writer.h"
#include "scene_summary.h"
#include "settings_check.h"
#include "study_internal.h"

namespace Signorini
{
namespace
{
/** What a user reads after the last level, before the verdict. */
void print_end(const std::vector<LevelRecord> &levels, const StudyReport &report)
{
  if (levels.empty())
    return;
  const std::string errors = error_table(levels);
  report.screen << "\n" << errors << (errors.empty() ? "" : "\n");
  print_answer(report.screen, levels, report.directory);
  report.screen << "\n";
}
} // namespace

template <int dim>
StudyResult<dim> run_study(const Parameters &parameters,
                           const Scene<dim> &scene,
                           MPI_Comm communicator,
                           const StudyReport &report)
{
  const Judge judge({parameters.solver.tolerance,
                     parameters.solver.tolerated_error,
                     target_error(parameters.discretization),
                     parameters.discretization.target_error > 0.,
                     can_be_graded<dim>(dealii::Utilities::MPI::n_mpi_processes(communicator)),
                     dim == 2});
  const LibraryThreads one_thread_in_libraries(1);
  check_settings(parameters, scene, communicator);
  const std::unique_ptr<Sequence<dim>> sequence =
    make_sequence<dim>({parameters, scene, communicator, judge});
  ResultsWriter writer(parameters, judge, scene.description, report.directory, communicator);
  StudyResult<dim> result;
  print_scene(parameters,
              scene,
              choose_solvers(parameters,
                             scene,
                             parameters.discretization.finest_level,
                             dealii::Utilities::MPI::n_mpi_processes(communicator)),
              report.screen);
  const bool graded = parameters.discretization.strategy == Strategy::hp;
  report.screen << screen_legend(graded) << "\n" << screen_header(graded) << std::endl;
  try
  {
    for (bool last = false; !last;)
    {
      const Progress progress = [&](const std::string &stage) {
        report.progress(sequence->name_of_next() + ": " + stage);
      };
      const LevelRecord record = sequence->solve_next(progress, writer);
      report.progress("");
      report.screen << screen_row(record, result.levels.empty() ? nullptr : &result.levels.back())
                    << std::endl;
      print_warnings(record, judge, report.screen);
      result.levels.push_back(record);
      last = sequence->is_finished();
      result.verdict = last ? judge.verdict(result.levels) : judge.unfinished(result.levels);
      writer.write_tables(result.levels, result.verdict);
      if (last)
      {
        writer.write_answer(result.levels, result.verdict);
        const std::string missing = writer.write_pictures(result.levels);
        if (!missing.empty())
          report.screen << "Pictures: " << missing << "\n";
        result.pressure = sequence->pressure();
      }
    }
  }
  catch (const WritingError &error)
  {
    print_end(result.levels, report);
    writer.write_failure(result.levels, judge.failed(result.levels, error.what()));
    throw;
  }
  catch (const ComputationError &error)
  {
    result.verdict = judge.failed(result.levels, error.what());
    writer.write_failure(result.levels, result.verdict);
  }
  catch (const InputError &)
  {
    writer.abandon();
    throw;
  }
  print_end(result.levels, report);
  print_verdict(result.levels, judge, result.verdict, report.screen);
  return result;
}

template StudyResult<2>
run_study(const Parameters &, const Scene<2> &, MPI_Comm, const StudyReport &);
template StudyResult<3>
run_study(const Parameters &, const Scene<3> &, MPI_Comm, const StudyReport &);
} // namespace Signorini
