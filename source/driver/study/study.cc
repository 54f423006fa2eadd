// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over the levels, until the sequence ends.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>
#include <signorini/base/text.h>
#include <signorini/driver/sequence/level_clock.h>
#include <signorini/driver/sequence/quantity_run.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/driver/study/settings.h>
#include <signorini/driver/study/study.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/results_writer.h>
#include <signorini/results/output/screen.h>
#include <signorini/results/output/tables.h>

#include <deal.II/base/mpi.h>

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <vector>

namespace Signorini {
namespace {
/** Prints the tables after the last level, before the verdict. */
void print_end(const std::vector<LevelRecord> &levels, const StudyReport &report) {
  if (levels.empty())
    return;
  const std::string errors = error_table(levels), distances = distance_table(levels);
  report.screen << "\n" << errors << (errors.empty() ? "" : "\n");
  report.screen << distances << (distances.empty() ? "" : "\n");
  print_answer(report.screen, levels, report.directory);
  report.screen << "\n";
}

/** Returns the target of refinement: Target error; with hp 1e-3 if none is given, and 1e-6 for the
 * verification of another displacement. */
double target_error(const Parameters &parameters) {
  const DiscretizationParameters &given = parameters.discretization;
  const double usual = parameters.verify.file.value.empty() ? 1e-3 : 1e-6;
  return given.strategy == Strategy::hp && given.target_error == 0. ? usual
                                                                    : given.target_error.value;
}

/** Returns which levels several ranks share, as a line of the screen; empty on a single rank. */
template <int dim>
std::string describe_ranks(const Parameters &parameters, const Scene<dim> &scene,
                           const unsigned int n_ranks) {
  const DiscretizationParameters &given = parameters.discretization;
  if (n_ranks == 1)
    return "";
  std::string shared = "each solves all levels alone";
  if (given.strategy != Strategy::hp)
    for (unsigned int level = given.finest_level + 1; level-- > given.coarsest_level;)
      if (is_shared(parameters, scene, choose_solvers(parameters, scene, level), level, n_ranks))
        shared = "they share the levels from " + std::to_string(level) + " on" +
                 (level > given.coarsest_level ? "; each solves those before alone" : "");
  return "Processes " + std::to_string(n_ranks) + ": " + shared + "\n\n";
}

/** Returns whether the stress of the last step is needed: for another program's displacement, or
 * for guaranteed means. */
template <int dim>
bool needs_stress(const Parameters &parameters, const Scene<dim> &scene) {
  return !parameters.verify.file.value.empty() ||
         std::any_of(scene.probes.begin(), scene.probes.end(),
                     [](const Probe<dim> &probe) { return probe.is_guaranteed; });
}

template <int dim>
class Study {
public:
  Study(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator,
        const StudyReport &report, const Verify<dim> &verify,
        const std::shared_ptr<ReferenceRuns> &references)
    : parameters_(parameters)
    , scene_(scene)
    , report_(report)
    , judge_(judge_of(parameters, scene))
    , communicator_(communicator)
    , sequence_(make_sequence<dim>({parameters, scene, communicator, judge_, verify, references,
                                    needs_stress(parameters, scene)}))
    , writer_(parameters, judge_, scene.description, report.directory, communicator) {}

  StudyResult<dim> run() {
    if constexpr (dim == 2)
      agree(communicator_, [&]() { foreign_ = read_foreign_field(parameters_, scene_); });
    print_scene(parameters_, scene_,
                choose_solvers(parameters_, scene_, parameters_.discretization.finest_level),
                judge_, report_.screen);
    report_.screen << describe_ranks(parameters_, scene_,
                                     Utilities::MPI::n_mpi_processes(communicator_));
    const bool graded = parameters_.discretization.strategy == Strategy::hp;
    report_.screen << screen_legend(graded) << "\n" << screen_header(graded) << std::endl;
    try {
      while (!solve_next()) {
      }
    } catch (const WritingError &error) {
      print_end(result_.levels, report_);
      writer_.write_failure(result_.levels, judge_.failed(result_.levels, error.what()));
      throw;
    } catch (const ComputationError &error) {
      result_.verdict = judge_.failed(result_.levels, error.what());
      writer_.write_failure(result_.levels, result_.verdict);
    } catch (const InputError &) {
      writer_.abandon();
      throw;
    }
    print_end(result_.levels, report_);
    if (certificate_)
      report_.screen << *certificate_ << "\n";
    print_verdict(result_.levels, judge_, result_.verdict, report_.screen);
    return result_;
  }

private:
  /** Solves one level and writes it. Its large objects are released at the end of this call.
   * @return whether it is the last. */
  bool solve_next() {
    const auto now = [] { return std::chrono::steady_clock::now().time_since_epoch(); };
    clock_.begin_level(now());
    const Progress progress = [&, name = sequence_->name_of_next()](const std::string &stage) {
      report_.progress(name + ": " + stage + text_to_go(clock_.begin_stage(stage, now())));
    };
    // A level that each rank solves alone may fail on one of them: then all stop.
    LevelResult<dim> level;
    agree(communicator_, [&]() { level = sequence_->solve_next(progress); });
    LevelRecord &record = level.solution.record;
    std::vector<CaseResult> cases = solve_cases(level, progress);
    add_means(level, progress);
    multiply_forces(scene_.geometry.thickness, record, cases);
    if (!cases.empty()) {
      cases_.insert(cases_.end(), cases.begin(), cases.end());
      writer_.write_cases(cases_);
    }
    progress("output");
    {
      const StageTimer timer(record.times.output);
      writer_.write_fields(level);
    }
    record.resources = measure_resources();
    report_.progress("");
    std::vector<LevelRecord> &levels = result_.levels;
    if (!level.why_again.empty()) {
      while (!levels.empty() && levels.back().sizes.level >= record.sizes.level)
        levels.pop_back();
      report_.screen << "Best step: " << level.why_again << "." << std::endl;
    } else {
      report_.screen << screen_row(record, levels.empty() ? nullptr : &levels.back()) << std::endl;
      print_warnings(record, judge_, report_.screen);
    }
    levels.push_back(record);
    add_errors(level.errors, levels);
    result_.verdict = level.is_last ? judge_.verdict(levels) : judge_.unfinished(levels);
    for (const std::string &why : {level.why_last, level.why_again})
      if (!why.empty())
        result_.verdict.accuracy += "; " + why;
    // In this order: a level with a row in convergence.csv has its answer, whenever the run ends.
    writer_.write_answer(levels, result_.verdict);
    writer_.write_tables(levels, result_.verdict);
    if (level.is_last) {
      verify_field(level, progress);
      const std::string missing = writer_.write_pictures();
      if (!missing.empty())
        report_.screen << "Pictures: " << missing << "\n";
      result_.pressure = level.pressure();
    }
    return level.is_last;
  }

  /** Gives all levels before the last one their errors. */
  void add_errors(const std::map<unsigned int, ErrorBound> &errors,
                  std::vector<LevelRecord> &levels) const {
    for (std::size_t i = 0; i + 1 < levels.size() && !errors.empty(); ++i) {
      levels[i].bound = errors.at(levels[i].sizes.level);
      multiply_forces(scene_.geometry.thickness, *levels[i].bound);
    }
  }

  /** Solves load cases on the last level, and the steps of a history on every nested one: each
   * level has a history of its own. */
  std::vector<CaseResult> solve_cases(LevelResult<dim> &level, const Progress &progress) {
    const Scene<dim> &scene = sequence_->scene();
    const bool on_every_level = parameters_.load_cases.sequence == CaseSequence::steps &&
                                parameters_.discretization.strategy != Strategy::hp;
    const auto write_fields = [&](const unsigned int number, const Solved<dim> &solved) {
      writer_.write_case_fields<dim>(solved, number);
    };
    if (scene.load_cases.empty() || !(level.is_last || on_every_level))
      return {};
    std::vector<CaseResult> found =
      solve_load_cases<dim>(parameters_, scene, level, write_fields, progress);
    if (!parameters_.output.compliance)
      level.solution.operators.reset();
    return found;
  }

  /** Adds the means that are wanted with guaranteed errors. */
  void add_means(LevelResult<dim> &level, const Progress &progress) {
    if constexpr (dim == 2)
      if (level.is_last)
        add_guaranteed_means(parameters_, sequence_->scene(), level, progress);
  }

  /** Compares the displacement of another program with the last level. */
  void verify_field(const LevelResult<dim> &level, const Progress &progress) {
    if constexpr (dim == 2) {
      if (!foreign_)
        return;
      // Nested levels have no stress of their own.
      ReferenceRun run = {level.solution.reference, ""};
      if (!run.stress)
        agree(communicator_,
              [&]() { run = run_reference(parameters_, scene_, ReferenceTarget(), progress); });
      if (!run.stress)
        throw ComputationError(
          shorten_path(parameters_.verify.file) +
          ": its error is not known, since the scene has no bound: " + run.missing);
      const Verification found = verify(*foreign_, level.solved(), *run.stress);
      const VerifiedField verified = {shorten_path(parameters_.verify.file), *foreign_, found,
                                      level.solution.scene, level.solution.record};
      writer_.write_verified(verified);
      std::ostringstream text;
      print_verified(text, verified);
      certificate_ = text.str();
      const double tolerated = parameters_.verify.tolerated_error;
      if (tolerated > 0. && !(verified.relative().upper() <= tolerated))
        result_.objection = verified.objection(tolerated);
    }
  }

  const Parameters &parameters_;
  const Scene<dim> &scene_;
  const StudyReport &report_;
  Judge judge_;
  MPI_Comm communicator_;
  std::unique_ptr<Sequence<dim>> sequence_;
  ResultsWriter writer_;
  LevelClock clock_;
  /** The displacement of another program, and what the screen says of it after the answer. */
  std::optional<ForeignField> foreign_;
  std::optional<std::string> certificate_;
  /** The load cases of all levels so far. */
  std::vector<CaseResult> cases_;
  StudyResult<dim> result_;
};
} // namespace

template <int dim>
Judge judge_of(const Parameters &parameters, const Scene<dim> &scene) {
  Demands demands;
  demands.tolerance = parameters.solver.tolerance;
  demands.tolerated_error = parameters.solver.tolerated_error;
  demands.target_error = target_error(parameters);
  demands.can_be_graded = dim == 2 && !scene.has_pairs();
  demands.has_b_bar = dim == 2;
  demands.target_is_given = parameters.discretization.target_error > 0.;
  return Judge(demands);
}

template <int dim>
StudyResult<dim> run_study(const Parameters &parameters, const Scene<dim> &scene,
                           MPI_Comm communicator, const StudyReport &report,
                           const Verify<dim> &verify,
                           const std::shared_ptr<ReferenceRuns> &references) {
  const LibraryThreads one_thread_in_libraries(1);
  check_settings(parameters, scene);
  return Study<dim>(parameters, scene, communicator, report, verify, references).run();
}

INSTANTIATE_FUNCTION(judge_of);
INSTANTIATE_FUNCTION(run_study);

} // namespace Signorini
