// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over the levels, until the sequence ends.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/base/text.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/driver/study/study.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/results/files/answer_output.h>
#include <signorini/results/files/tables.h>
#include <signorini/results/output/results_writer.h>
#include <signorini/results/output/screen.h>

#include <deal.II/base/mpi.h>

#include <mpi.h>

#include <algorithm>
#include <vector>

namespace Signorini
{
/**
 * Refuses settings that contradict the scene or the number of ranks: a linear solver that needs a
 * serial run, and a coarsest level with sides that end inside faces.
 * @throws InputError
 */
template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);

namespace
{
/** Prints the tables after the last level, before the verdict. */
void print_end(const std::vector<LevelRecord> &levels, const StudyReport &report)
{
  if (levels.empty())
    return;
  const std::string errors = error_table(levels);
  report.screen << "\n" << errors << (errors.empty() ? "" : "\n");
  print_answer(report.screen, levels, report.directory);
  report.screen << "\n";
}

/** Returns the target of refinement: Target error; with hp 1e-3 if none is given. */
double target_error(const DiscretizationParameters &given)
{
  constexpr double usual = 1e-3;
  return given.strategy == Strategy::hp && given.target_error == 0. ? usual
                                                                    : given.target_error.value;
}

template <int dim>
class Study
{
public:
  Study(const Parameters &parameters,
        const Scene<dim> &scene,
        MPI_Comm communicator,
        const StudyReport &report)
    : parameters_(parameters)
    , scene_(scene)
    , n_ranks_(Utilities::MPI::n_mpi_processes(communicator))
    , report_(report)
    , judge_({parameters.solver.tolerance,
              parameters.solver.tolerated_error,
              target_error(parameters.discretization),
              parameters.discretization.target_error > 0.,
              dim == 2 && n_ranks_ == 1,
              dim == 2})
    , sequence_(make_sequence<dim>({parameters, scene, communicator, judge_}))
    , writer_(parameters, judge_, scene.description, report.directory, communicator)
  {
  }

  StudyResult<dim> run()
  {
    print_scene(
      parameters_,
      scene_,
      choose_solvers(parameters_, scene_, parameters_.discretization.finest_level, n_ranks_),
      judge_,
      report_.screen);
    const bool graded = parameters_.discretization.strategy == Strategy::hp;
    report_.screen << screen_legend(graded) << "\n" << screen_header(graded) << std::endl;
    try
    {
      while (!solve_next())
      {
      }
    }
    catch (const WritingError &error)
    {
      print_end(result_.levels, report_);
      writer_.write_failure(result_.levels, judge_.failed(result_.levels, error.what()));
      throw;
    }
    catch (const ComputationError &error)
    {
      result_.verdict = judge_.failed(result_.levels, error.what());
      writer_.write_failure(result_.levels, result_.verdict);
    }
    catch (const InputError &)
    {
      writer_.abandon();
      throw;
    }
    print_end(result_.levels, report_);
    print_verdict(result_.levels, judge_, result_.verdict, report_.screen);
    return result_;
  }

private:
  /** Solves one level and writes it. Its large objects are released at the end of this call.
   * @return whether it is the last. */
  bool solve_next()
  {
    const Progress progress = [this, name = sequence_->name_of_next()](const std::string &stage) {
      report_.progress(name + ": " + stage);
    };
    LevelResult<dim> level = sequence_->solve_next(progress);
    LevelRecord &record = level.solution.record;
    if (level.is_last)
      solve_cases(level, progress);
    progress("output");
    {
      const StageTimer timer(record.times.output);
      writer_.write_fields(scene_, level);
    }
    record.resources = measure_resources();
    report_.progress("");
    std::vector<LevelRecord> &levels = result_.levels;
    report_.screen << screen_row(record, levels.empty() ? nullptr : &levels.back()) << std::endl;
    print_warnings(record, judge_, report_.screen);
    levels.push_back(record);
    result_.verdict = level.is_last ? judge_.verdict(levels) : judge_.unfinished(levels);
    writer_.write_tables(levels, result_.verdict);
    if (level.is_last)
    {
      writer_.write_answer(levels, result_.verdict);
      const std::string missing = writer_.write_pictures();
      if (!missing.empty())
        report_.screen << "Pictures: " << missing << "\n";
      result_.pressure = level.pressure();
    }
    return level.is_last;
  }

  void solve_cases(LevelResult<dim> &level, const Progress &progress)
  {
    if constexpr (dim == 2)
    {
      const Scene<2> &scene = sequence_->scene();
      if (scene.load_cases.empty())
        return;
      const auto write_fields = [&](const unsigned int number,
                                    const Scene<2> &scene_of_case,
                                    const Displacement &U,
                                    const Pressure &P) {
        writer_.write_case_fields(*level.discretization, scene_of_case, U, P, number);
      };
      writer_.write_cases(solve_load_cases(parameters_, scene, level, write_fields, progress));
    }
  }

  const Parameters &parameters_;
  const Scene<dim> &scene_;
  unsigned int n_ranks_;
  const StudyReport &report_;
  Judge judge_;
  std::unique_ptr<Sequence<dim>> sequence_;
  ResultsWriter writer_;
  StudyResult<dim> result_;
};
} // namespace

template <int dim>
StudyResult<dim> run_study(const Parameters &parameters,
                           const Scene<dim> &scene,
                           MPI_Comm communicator,
                           const StudyReport &report)
{
  const LibraryThreads one_thread_in_libraries(1);
  check_settings(parameters, scene, communicator);
  return Study<dim>(parameters, scene, communicator, report).run();
}

template StudyResult<2>
run_study(const Parameters &, const Scene<2> &, MPI_Comm, const StudyReport &);
template StudyResult<3>
run_study(const Parameters &, const Scene<3> &, MPI_Comm, const StudyReport &);

// Contradictions between parameters, scene and number of ranks, found before the first level.

namespace
{
/** @throws InputError which states the option that was found and the others that are allowed. */
template <typename Option>
void refuse(const Given<Option> &found, const std::string &context, const std::string &allowed)
{
  throw InputError(found.where() + ": found '" + to_text(found.value) + "' " + context +
                   ", allowed " + allowed + ".");
}

/** Refuses serial options on several ranks. @throws InputError */
template <typename Option>
void require_one_rank(const Given<Option> &given,
                      const std::vector<Option> &serial_options,
                      const unsigned int n_ranks)
{
  if (n_ranks == 1 || std::count(serial_options.begin(), serial_options.end(), given.value) == 0)
    return;
  std::vector<std::string> allowed = option_names(typeid(Option));
  for (const Option serial : serial_options)
    allowed.erase(std::find(allowed.begin(), allowed.end(), to_text(serial)));
  refuse(given, "on " + std::to_string(n_ranks) + " processes", "on several: " + join(allowed));
}

/** Returns "with NAME 'option'". */
template <typename Option>
std::string with(const std::string &name, const Given<Option> &option)
{
  return "with " + name + " '" + to_text(option.value) + "'";
}

/** Refuses V-cycles for contact with another linear solver, or with several loads.
 * @throws InputError */
template <int dim>
void check_contact_solver(const Parameters &parameters, const Scene<dim> &scene)
{
  const Given<ContactSolver> &solver = parameters.solver.contact_solver;
  const Given<LinearSolver> &linear = parameters.solver.linear_solver;
  if (solver != ContactSolver::multigrid)
    return;
  if (linear != LinearSolver::multigrid && linear != LinearSolver::automatic)
    refuse(linear, with("Contact solver", solver), "with it: automatic, multigrid");
  if (!scene.load_cases.empty())
    refuse(solver, "with load cases", "with them: psor, active set");
}

/** Refuses multigrid for meshes that are not nested, for Q2, and where a matrix is to be written.
 * @throws InputError */
template <typename Option>
void check_multigrid(const Given<Option> &solver,
                     const std::string &name,
                     const std::string &allowed,
                     const Parameters &parameters)
{
  const DiscretizationParameters &given = parameters.discretization;
  if (solver != Option::multigrid)
    return;
  if (given.strategy == Strategy::hp)
    refuse(solver, with("Strategy", given.strategy), "with it: " + allowed);
  if (given.element == Element::q2)
    refuse(solver, with("Element", given.element), "with it: " + allowed);
  if (parameters.output.compliance)
    throw InputError(parameters.output.compliance.where() + ": found 'true' " + with(name, solver) +
                     ", which assembles no matrix, allowed with it: false.");
}

/** Refuses a coarsest level on which sides end inside faces. Most scenes number their boundary on
 * level 0. @throws InputError */
void check_coarsest_level(const Given<unsigned int> &coarsest_level, const Geometry<2> &geometry)
{
  if (!geometry.number_after_refinement)
    return;
  Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  mesh.refine_global(coarsest_level);
  if (ends_inside_a_face(geometry.sides, mesh))
    throw InputError(coarsest_level.where() +
                     ": a side of this scene ends inside a face of the mesh, allowed: a finer "
                     "coarsest level.");
}
} // namespace

template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator)
{
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  require_one_rank(
    parameters.solver.linear_solver, {LinearSolver::condensed, LinearSolver::multigrid}, n_ranks);
  require_one_rank(parameters.solver.contact_solver, {ContactSolver::multigrid}, n_ranks);
  if (const auto &linear = parameters.solver.linear_solver;
      dim == 3 && linear == LinearSolver::amesos_klu)
    refuse(linear, "in 3-D", "there: automatic, condensed, amesos_mumps, multigrid");
  require_one_rank(parameters.discretization.strategy, {Strategy::hp}, n_ranks);
  check_contact_solver(parameters, scene);
  check_multigrid(
    parameters.solver.linear_solver, "Linear solver", "automatic, condensed", parameters);
  check_multigrid(
    parameters.solver.contact_solver, "Contact solver", "psor, active set, mprgp", parameters);
  if constexpr (dim == 2)
    check_coarsest_level(parameters.discretization.coarsest_level, scene.geometry);
}

template void check_settings(const Parameters &, const Scene<2> &, MPI_Comm);
template void check_settings(const Parameters &, const Scene<3> &, MPI_Comm);
} // namespace Signorini
