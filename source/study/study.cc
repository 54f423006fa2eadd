// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested levels, coarsest to finest, each started from the one before.

#include <signorini/base/exceptions.h>
#include <signorini/output/tables.h>
#include <signorini/postprocess/locking.h>
#include <signorini/stiffness_inverse/library_threads.h>
#include <signorini/study/study.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>
#include <sys/resource.h>

#include "memory_limit.h"
#include "results_writer.h"
#include "scene_summary.h"
#include "settings_check.h"

namespace Signorini
{
namespace
{
/** User and system seconds of this process. */
double cpu_seconds()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_memory_mb()
{
  dealii::Utilities::System::MemoryStats memory = {};
  dealii::Utilities::System::get_memory_stats(memory);
  return static_cast<double>(memory.VmHWM) / 1024.;
}

/** What the levels of a study have in common. */
template <int dim>
struct StudyContext
{
  const Parameters &parameters;
  const Scene<dim> &scene;
  /** Null if it is not known. */
  std::unique_ptr<const ExactPressure<dim>> exact_pressure;
  MPI_Comm communicator;
};

/** Whether no finer level follows. */
bool is_last(const DiscretizationParameters &given, const LevelRecord &record)
{
  return record.level == given.finest_level ||
         record.estimated_relative.value_or(1.) < given.target_error;
}

/** Everything about one level; the level's large objects live no longer than this call. */
template <int dim>
LevelRecord run_level(const StudyContext<dim> &context,
                      const unsigned int level,
                      const Progress &progress,
                      ResultsWriter &writer,
                      StartingPressure &pressure)
{
  const Parameters &parameters = context.parameters;
  progress("mesh");
  const Discretization<dim> discretization(parameters, context.scene, level, context.communicator);
  LevelSolution<dim> solution =
    solve_level(parameters,
                context.scene,
                discretization,
                parameters.solver.warm_start ? pressure : StartingPressure(),
                progress);
  progress("errors");
  add_errors(parameters, context.scene, discretization, context.exact_pressure.get(), solution);
  const bool last = is_last(parameters.discretization, solution.record);
  if (last && discretization.space.strain_operator() == StrainOperator::symmetric_gradient)
    solution.record.locking_number = locking_number(discretization.mesh, *context.scene.material);
  progress("output");
  StageClock clock;
  writer.write_fields(discretization, context.scene, solution, last);
  clock.add_to(solution.record.times.output);
  solution.record.cpu_total = cpu_seconds();
  solution.record.peak_memory_mb = peak_memory_mb();
  pressure = {discretization.multipliers.partition().patches, solution.P};
  return solution.record;
}

void print_warnings(const LevelRecord &record, const double tolerance, std::ostream &screen)
{
  if (record.unstable)
    screen << "Warning: on level " << record.level
           << " a contact patch is no longer than a face (H = h), which is not inf-sup stable: "
              "the pressure may oscillate. Take a patch ratio of 2 or more.\n";
  const std::string doubt = record.doubt(tolerance);
  if (!doubt.empty())
    screen << "Warning: level " << record.level << " is not certified: " << doubt << "\n";
}

/** Whether two refinements have left the estimated error where it was: the mesh does not resolve
 * the solution, and the estimate cannot know how far away it is. */
bool estimate_does_not_fall(const std::vector<LevelRecord> &levels)
{
  constexpr std::size_t n = 3;
  // Solutions in V^h have estimates that are nothing but rounding.
  const double negligible = std::max(1e-8, 100. * levels.back().rounding_error);
  const double slowest = std::pow(2., -0.1);
  if (levels.size() < n)
    return false;
  for (std::size_t k = levels.size() - n; k < levels.size(); ++k)
    if (!levels[k].estimated_relative || *levels[k].estimated_relative < negligible ||
        (k + n > levels.size() && *levels[k].estimated_h1 < slowest * *levels[k - 1].estimated_h1))
      return false;
  return true;
}

/** Why the finest level cannot be trusted although its equations are solved; empty if it can. */
std::string find_unresolved(const std::vector<LevelRecord> &levels)
{
  std::ostringstream text;
  const LevelRecord &finest = levels.back();
  if (!finest.unique)
    text
      << "Level " << finest.level
      << ": the contact pressure is not unique, because contact patches are finer than the mesh; "
         "take a Patch ratio of 2 or more, or fewer Patches.";
  else if (finest.locking_number.value_or(0.) > largest_locking_number)
    text << "The body is nearly incompressible, and bilinear elements lock on a mesh as coarse as "
            "level "
         << finest.level << ": K/mu (h/l)^2 = " << *finest.locking_number << ", allowed: at most "
         << largest_locking_number << "; set Discretization/Element = Q1 B-bar, or refine.";
  else if (estimate_does_not_fall(levels))
    text
      << "The estimated error does not fall from level to level, so that the mesh does not resolve "
         "the solution: refine, or take cells that are as wide as high (long cells are too stiff "
         "in bending).";
  return text.str();
}

/** Why the study cannot be trusted: a level's residuals, or what the finest level does not resolve.
 */
std::string find_failure(const std::vector<LevelRecord> &levels, const double tolerance)
{
  for (const LevelRecord &record : levels)
  {
    const std::string doubt = record.doubt(tolerance);
    if (!doubt.empty())
      return "Level " + std::to_string(record.level) + ": " + doubt;
  }
  return find_unresolved(levels);
}

/** What a ComputationError leaves behind. A full disk may not even take that: then the certificate
 * still says "unfinished". */
void write_failure(ResultsWriter &writer, const StudyResult &result)
{
  try
  {
    writer.write_failure(result.levels, result.failure);
  }
  catch (const ComputationError &)
  {
    // The first failure is the one to be told.
  }
}
} // namespace

template <int dim>
StudyResult run_study(const Parameters &parameters,
                      const Scene<dim> &scene,
                      MPI_Comm communicator,
                      const StudyReport &report)
{
  const DiscretizationParameters &given = parameters.discretization;
  const double tolerance = parameters.solver.tolerance;
  const LibraryThreads one_thread_in_libraries(1);
  const MemoryLimit<dim> memory(parameters, scene, communicator);
  check_settings(parameters, scene, communicator);
  StudyContext<dim> context = {parameters, scene, nullptr, communicator};
  const bool errors = parameters.output.errors;
  if (errors && scene.has_exact_pressure())
    context.exact_pressure = std::make_unique<const ExactPressure<dim>>(scene);
  // What can be wrong before the first level has been found: earlier results are not lost for it.
  ResultsWriter writer(parameters, report.directory, communicator);
  StudyResult result;
  print_scene(parameters, scene, report.screen);
  const ScreenTable table(errors && scene.exact_displacement != nullptr,
                          errors && scene.has_exact_pressure());
  report.screen << table.header() << std::endl;
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
      report.screen << table.row(record, result.levels.empty() ? nullptr : &result.levels.back())
                    << std::endl;
      print_warnings(record, tolerance, report.screen);
      result.levels.push_back(record);
      const bool last = is_last(given, record);
      if (last)
        result.failure = find_failure(result.levels, tolerance);
      if (result.failure.empty())
        writer.write_tables(result.levels, last);
      else
        writer.write_failure(result.levels, result.failure);
      if (last)
        break;
    }
  }
  catch (const ComputationError &error)
  {
    result.failure = error.what();
    write_failure(writer, result);
  }
  catch (const InputError &error)
  {
    writer.abandon(result.levels, error.what());
    throw;
  }
  result.certified = result.failure.empty();
  print_verdict(parameters, result.levels, result.certified, report.screen);
  return result;
}

template StudyResult run_study(const Parameters &, const Scene<2> &, MPI_Comm, const StudyReport &);
} // namespace Signorini
