// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested levels from the coarsest to the finest. Each starts from the solution on the one before.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/driver/sequence/level_errors.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/error_control/estimate/locking_number.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>
#include <signorini/solvers/methods/memory_limit.h>

#include <chrono>

namespace Signorini {
namespace {
template <int dim>
class NestedSequence final : public Sequence<dim> {
public:
  explicit NestedSequence(const StudyContext<dim> &context)
    : context_(context)
    , memory_(context.parameters, context.scene, context.communicator)
    , errors_(context)
    , next_level_(context.parameters.discretization.coarsest_level) {}

  std::string name_of_next() const override {
    return "level " + std::to_string(next_level_);
  }

  const Scene<dim> &scene() const override {
    return context_.scene;
  }

  LevelResult<dim> solve_next(const Progress &progress) override {
    const Parameters &parameters = context_.parameters;
    memory_.check(next_level_);
    progress("mesh");
    LevelResult<dim> result;
    result.discretization = std::make_shared<const Discretization<dim>>(
      parameters, context_.scene, next_level_,
      is_shared(parameters, context_.scene, solvers_of(next_level_), next_level_,
                Utilities::MPI::n_mpi_processes(context_.communicator))
        ? context_.communicator
        : MPI_COMM_SELF);
    const Discretization<dim> &discretization = *result.discretization;
    result.solution = solve(discretization, start_for(discretization), progress);
    LevelRecord &record = result.solution.record;
    if (context_.verify)
      context_.verify(discretization, progress, result.solution);
    result.is_last = next_level_ == parameters.discretization.finest_level ||
                     !record.dual.converged || context_.judge.reaches_target(record);
    const bool may_lock = parameters.discretization.element == Element::q1;
    if (result.is_last && may_lock)
      record.locking_number = locking_number(discretization.mesh, context_.scene);
    if (!result.is_last)
      keep_for_next(result);
    else if (knows_errors_)
      result.errors = errors_.all();
    ++next_level_;
    return result;
  }

private:
  SolverChoice solvers_of(const unsigned int level) const {
    const SolverParameters &solver = context_.parameters.solver;
    if (failure_of_cycles_)
      return {solver.contact_solver == ContactSolver::psor ? ContactSolver::psor
                                                           : ContactSolver::active_set,
              solver.linear_solver};
    return choose_solvers(context_.parameters, context_.scene, level);
  }

  /** Solves the level by V-cycles or by factors. Where V-cycles were chosen automatically and do
   * not converge, factors are used on this level and on all that follow, and their records state
   * the failure. */
  LevelSolution<dim> solve(const Discretization<dim> &discretization, const ContactStart &start,
                           const Progress &progress) {
    LevelProblem<dim> problem = {context_.parameters, context_.scene, solvers_of(next_level_)};
    const auto solve_with_choice = [&]() {
      LevelSolution<dim> solution = solve_level(problem, discretization, start, progress);
      errors_.add(discretization, solution);
      if (may_stop(solution.record))
        add_errors(discretization, progress, solution);
      release_unused(problem, solution);
      solution.record.dual.failure_of_cycles = failure_of_cycles_;
      return solution;
    };
    const SolverParameters &solver = context_.parameters.solver;
    const bool by_cycles = problem.solvers.is_by_cycles();
    if (by_cycles
          ? solver.contact_solver != ContactSolver::automatic
          : solver.linear_solver != LinearSolver::automatic || !problem.solvers.is_matrix_free())
      return solve_with_choice();
    try {
      LevelSolution<dim> solution = solve_with_choice();
      if (solution.record.dual.converged || !by_cycles)
        return solution;
      failure_of_cycles_ = name_of_next() + " did not end within " +
                           std::to_string(solution.record.dual.iterations) + " V-cycles";
    } catch (const ComputationError &error) {
      // The linear systems of the estimate may fail to converge, too.
      failure_of_cycles_ = name_of_next() + ": " + error.what();
    }
    problem.solvers = solvers_of(next_level_);
    return solve_with_choice();
  }

  /** Returns whether the study may stop at a level: at the finest one, or where the estimate
   * reaches the target. */
  bool may_stop(const LevelRecord &record) const {
    return next_level_ == context_.parameters.discretization.finest_level ||
           context_.judge.reaches_target(record);
  }

  /** Adds the error of a level from the stress of a graded run; where that does not tell it, the
   * bound by a stress on a mesh over that of the level. */
  void add_errors(const Discretization<dim> &discretization, const Progress &progress,
                  LevelSolution<dim> &solution) {
    add_other_solutions(discretization, solution);
    LevelRecord &record = solution.record;
    // The graded run has times of its own, which a StageTimer would leave out.
    const auto start = std::chrono::steady_clock::now();
    knows_errors_ = errors_.know_last(record, progress);
    record.times.bound +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (knows_errors_) {
      record.bound = errors_.all().at(next_level_);
      solution.reference = errors_.stress();
    } else
      add_bound(context_.parameters, discretization, progress, solution);
  }

  /** Returns the start from the solution on the level before. */
  ContactStart start_for(const Discretization<dim> &discretization) {
    ContactStart start;
    if (!context_.parameters.solver.warm_start || pressure_.patches.empty())
      return start;
    const std::vector<Patch<dim>> &patches = discretization.surface.patches();
    dealii::Vector<double> shares;
    for (const Pressure &share : shares_)
      shares = join(shares, transfer_pressure<dim>({pressure_.patches, share}, patches));
    start.P =
      Multiplier::from_shares(transfer_pressure<dim>(pressure_, patches), shares, discretization.K)
        .values();
    start.scale = scale_;
    if (coarse_ != nullptr)
      start.U = carry_over(coarse_->space, coarse_U_, discretization.space);
    coarse_.reset();
    coarse_U_ = Displacement();
    return start;
  }

  void keep_for_next(const LevelResult<dim> &result) {
    const ContactSolution &contact = result.solution.contact;
    pressure_ = result.pressure();
    shares_ = contact.P.shares();
    const auto *const cycles = std::get_if<CycleData>(&contact.data);
    scale_ = cycles != nullptr ? cycles->scale : 0.;
    if (solvers_of(result.discretization->mesh.level() + 1).is_by_cycles()) {
      coarse_ = result.discretization;
      coarse_U_ = contact.U;
    }
  }

  StudyContext<dim> context_;
  /** The failure of V-cycles on an earlier level. It stands first because solvers_of() reads it. */
  std::optional<std::string> failure_of_cycles_;
  MemoryLimit<dim> memory_;
  LevelErrors<dim> errors_;
  bool knows_errors_ = false;
  unsigned int next_level_;
  PatchPressure<dim> pressure_;
  /** The shares of P_t of the same patches by components; none without friction. */
  std::vector<Pressure> shares_;
  /** The last level and its displacement, if V-cycles find contact on the next one; else null. */
  std::shared_ptr<const Discretization<dim>> coarse_;
  Displacement coarse_U_;
  /** The scale of the last level, see ContactStart. */
  double scale_ = 0.;
};
} // namespace

template <int dim>
std::unique_ptr<Sequence<dim>> make_nested_sequence(const StudyContext<dim> &context) {
  return std::make_unique<NestedSequence<dim>>(context);
}

INSTANTIATE_FUNCTION(make_nested_sequence);
} // namespace Signorini
