// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes: solve, find the ends of zones, estimate, plan the next mesh.

#include <signorini/base/columns.h>
#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/driver/sequence/sequence.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/error_control/hp/step_examination.h>
#include <signorini/postprocessing/fields/pressure_transfer.h>

#include <cmath>

namespace Signorini {
namespace {
/** A mesh with the solution on it. */
struct HpStep {
  std::shared_ptr<const Discretization<2>> discretization;
  Displacement U;
  Multiplier P;
};

/** Returns the scene with quadrature rules that are not graded: the mesh itself is graded to the
 * points where data is singular. */
Scene<2> without_graded_rules(Scene<2> scene) {
  scene.kinks = scene.kinks.without_ends();
  return scene;
}

void require_few(const DiscretizationParameters &given, const double n_unknowns,
                 const std::string &text) {
  const auto &max_unknowns = given.maximum_unknowns;
  if (n_unknowns > max_unknowns)
    throw input_error(max_unknowns.where(), ": found '", max_unknowns.value,
                      "', but the first mesh has ", text,
                      " unknowns, allowed: that many, or a smaller Coarsest level.");
}

/** Returns the plan of the first mesh. @throws InputError if the mesh has too many unknowns, which
 * is checked before it is made. */
MeshPlan make_first_plan(const Scene<2> &scene, const DiscretizationParameters &given) {
  MeshPlan plan = first_plan(scene, given.coarsest_level, given.maximum_degree);
  // Every cell is of degree 2: by Euler's formula there are more than four nodes for each.
  const double fewest = 8. * scene.geometry.n_graded_cells() * std::pow(4., plan.base_level);
  require_few(given, fewest, "more than " + number_text(fewest));
  resolve_hidden_data(scene, plan);
  return plan;
}

class HpSequence final : public Sequence<2> {
public:
  explicit HpSequence(const StudyContext<2> &context)
    : context_(context)
    , scene_(without_graded_rules(context.scene))
    , examination_(context.judge.demands.target_error)
    , plan_(make_first_plan(scene_, context.parameters.discretization))
    , next_(make_discretization()) {
    const auto n_dofs = next_->space.dofs().n_dofs();
    require_few(context.parameters.discretization, n_dofs, std::to_string(n_dofs));
  }

  std::string name_of_next() const override {
    return "step " + std::to_string(n_steps_);
  }

  const Scene<2> &scene() const override {
    return scene_;
  }

  LevelResult<2> solve_next(const Progress &progress) override {
    const Parameters &parameters = context_.parameters;
    LevelResult<2> result;
    result.discretization = next_;
    const Discretization<2> &discretization = *next_;
    const ContactStart start = start_for(discretization);
    LevelSolution<2> &solution = result.solution;
    const LevelProblem<2> problem = {parameters, scene_, choose_solvers(parameters, scene_, 0)};
    solution = solve_level(problem, discretization, start, progress);
    solution.record.sizes.level = n_steps_;
    progress("estimate");
    StepFindings findings = examine(discretization, solution);
    if (context_.verify)
      context_.verify(discretization, progress, solution);
    last_ = {next_, solution.contact.U, solution.contact.P};
    result.is_last = finish(discretization, progress, findings, solution);
    if (result.is_last && is_too_deep(findings))
      result.why_last = concatenate("cells at (", findings.deepest[0], ", ", findings.deepest[1],
                                    "), which cannot be split any more, leave about ",
                                    100. * findings.unsplit / findings.scale, " %");
    release_unused(problem, solution);
    ++n_steps_;
    return keep_best(std::move(result));
  }

private:
  /** Adds the bound where it may reach the target or the sequence ends. @return whether this step
   * is the last. */
  bool finish(const Discretization<2> &discretization, const Progress &progress,
              StepFindings &findings, LevelSolution<2> &solution) {
    const LevelRecord &record = solution.record;
    const Judge &judge = context_.judge;
    // Where the contact solver did not converge, there is no solution to plan a mesh from.
    const bool fails = !record.dual.converged || examination_.stagnates() ||
                       examination_.plates_penetrate(solution.scene);
    const bool may_suffice = !fails && judge.reaches_target(record);
    const bool asks_bound = may_suffice || (!fails && bound_may_suffice(discretization, solution));
    n_paths_ = record.dual.by_path ? n_paths_ + 1 : 0;
    const bool ends = !asks_bound && (fails || cannot_go_on(findings, false));
    if (!asks_bound && !ends)
      return false;
    add_other_solutions(discretization, solution);
    add_bound(context_.parameters, discretization, progress, solution, context_.keeps_stress);
    if (ends || (judge.reaches_target(record) &&
                 (is_guaranteed(record) || examination_.is_checked(findings))))
      return true;
    const bool has_bound = bound_of(record).has_value();
    lacks_bound_ = !has_bound;
    if (has_bound) {
      // Both are at least about the error; an estimate below the target leaves nothing to plan.
      findings.error =
        may_suffice ? *record.bound->absolute : std::min(findings.error, *record.bound->absolute);
      // Loads that stresses do not balance exactly count, too.
      AssertDimension(findings.indicators.size(), solution.bound_fields.oscillation.size());
      for (std::size_t cell = 0; cell < findings.indicators.size(); ++cell)
        findings.indicators[cell].oscillation = solution.bound_fields.oscillation[cell];
    }
    return cannot_go_on(findings, may_suffice && has_bound);
  }

  /** Returns whether there may be a guaranteed bound that reaches the target although the estimate
   * does not: after the first step estimates are 0.7 to 20 times the error, the bound 1.01 to 1.9
   * times. It costs less than a step, and the next step is the most expensive one. */
  bool bound_may_suffice(const Discretization<2> &discretization,
                         const LevelSolution<2> &solution) const {
    constexpr double worth_a_bound = 3.;
    const auto &estimate = solution.record.estimate;
    const Solved<2> solved = solution.on(discretization);
    return estimate && estimate->relative < worth_a_bound * context_.judge.demands.target_error &&
           context_.parameters.output.bound != WantedBound::none && !lacks_bound_ &&
           !solved.P.is_coupled() && objection_to_stress(solved).empty() &&
           gap_on_all_meshes(solved).empty();
  }

  /** Returns whether no further step is worth solving; else plans the next one. */
  bool cannot_go_on(const StepFindings &findings, const bool has_bound) {
    return is_too_deep(findings) || states_differ() || is_out_of_reach(findings.error, has_bound) ||
           takes_too_many(findings) || !plan_next(findings);
  }

  /** Keeps the step with the smallest bound. A step with a larger one ends the run if its estimate
   * says that the mesh is not the cause; otherwise the next steps may be better again.
   * @return the result; where the run ends on a larger bound, that of the best step again. */
  LevelResult<2> keep_best(LevelResult<2> result) {
    const LevelRecord &record = result.solution.record;
    if (!best_ || is_better(record, best_->solution.record)) {
      best_.reset();
      if (bound_of(record) && !result.is_last)
        best_ = result;
      return result;
    }
    const LevelRecord &best = best_->solution.record;
    const bool is_rounding =
      bound_exceeds_mesh(record) && record.estimate->relative <= best.estimate->relative;
    if (!result.is_last && !is_rounding)
      return result;
    const std::string name = "step " + std::to_string(record.sizes.level);
    best_->why_again = concatenate(
      "the answer is that of step ", best.sizes.level, ", because ", name,
      bound_of(record) ? concatenate(" has the larger bound ", 100. * *bound_of(record), " %")
                       : " has no such bound",
      is_rounding ? " although its estimate fell: rounding, or data that no mesh resolves" : "");
    best_->is_last = true;
    return *best_;
  }

  /** Returns whether a step has the better bound: a guaranteed one before an estimated one. */
  static bool is_better(const LevelRecord &step, const LevelRecord &best) {
    if (!bound_of(step) || is_guaranteed(step) != is_guaranteed(best))
      return is_guaranteed(step);
    return *bound_of(step) <= *bound_of(best);
  }

  std::shared_ptr<const Discretization<2>> make_discretization() const {
    return std::make_shared<const Discretization<2>>(context_.parameters, scene_, plan_);
  }

  /** Returns whether the error is not half of that two steps before, since a bound has
   * missed the target: the rest is rounding, or data that no mesh resolves. The first steps see
   * more and more of the scene. */
  bool is_out_of_reach(const double error, const bool has_bound) {
    constexpr std::size_t n_compared = 2, patience = 4;
    if (has_bound || !missed_.empty())
      missed_.push_back(error);
    return n_steps_ > patience && missed_.size() > n_compared &&
           error > 0.5 * missed_[missed_.size() - 1 - n_compared];
  }

  /** Returns whether a finer mesh did not lessen the estimate although its dual problem is solved,
   * where only paths have found the states for some steps: with a very large coefficient of
   * friction patches stick and slip by turns, on each mesh others. Each path costs the cube of
   * their number. */
  bool states_differ() const {
    constexpr unsigned int patience = 3;
    return n_paths_ >= patience && !examination_.falls();
  }

  /** Returns whether cells that cannot be split leave more than the target, and most of the error:
   * next to a corner with a small exponent λ, n splits leave a share of 2^{-nλ}. */
  static bool is_too_deep(const StepFindings &findings) {
    constexpr double most = 4.;
    return findings.has_estimate() && findings.unsplit > findings.target &&
           findings.error < most * findings.unsplit;
  }

  /** Returns whether jumps of the moduli in cells need more unknowns for the target than there may
   * be. The first step is the first that sees the zones of contact. */
  bool takes_too_many(const StepFindings &findings) const {
    constexpr double unknowns_per_cell = 8.;
    return n_steps_ > 0 && findings.has_estimate() &&
           unknowns_per_cell * findings.jumps.n_cells_for(findings.target) >
             context_.parameters.discretization.maximum_unknowns;
  }

  /** Returns whether the mesh of the next step has few enough unknowns. The compliance is dense:
   * thousands of contact unknowns cost more than all others. */
  bool next_is_affordable() const {
    constexpr unsigned int few = 1000, others_per_contact_unknown = 50;
    const unsigned int most = context_.parameters.discretization.maximum_unknowns;
    return next_->space.dofs().n_dofs() <= most &&
           next_->K.size() <= std::max(few, most / others_per_contact_unknown);
  }

  /** Returns the start from the step before. */
  ContactStart start_for(const Discretization<2> &discretization) const {
    ContactStart start;
    if (!context_.parameters.solver.warm_start || last_.discretization == nullptr)
      return start;
    const MultiplierSpace<2> &from = last_.discretization->multipliers;
    const MultiplierSpace<2> &to = discretization.multipliers;
    dealii::Vector<double> shares;
    for (const Pressure &share : last_.P.shares())
      shares = transfer_pressure(from, share, to, {-1., 1.});
    start.P = Multiplier::from_shares(transfer_pressure(from, last_.P.normal(), to), shares,
                                      discretization.K)
                .values();
    return start;
  }

  /** Adds the estimate of the error to the record. */
  StepFindings examine(const Discretization<2> &discretization, LevelSolution<2> &solution) {
    const StageTimer timer(solution.record.times.postprocess);
    std::optional<DisplacedBody<2>> before;
    if (last_.discretization != nullptr)
      before.emplace(last_.discretization->space, scene_, last_.U);
    StepFindings findings =
      examination_.examine(solution.on(discretization), solution.scale, before, plan_.aim);
    if (findings.has_estimate())
      solution.record.estimate = ErrorEstimate{
        {}, findings.error, findings.error > 0. ? findings.error / findings.scale : 0., {}, {}};
    return findings;
  }

  /** Makes the next mesh. @return whether it has few enough unknowns, and whether meshes still
   * change: a plan adds shares of a degree or a layer, which may sum up to one in a later step. */
  bool plan_next(const StepFindings &findings) {
    constexpr unsigned int patience = 4;
    const Discretization<2> &discretization = *last_.discretization;
    const std::vector<unsigned int> degrees = degrees_of(discretization.space);
    plan_ = next_plan(plan_, scene_, discretization.mesh, degrees, findings);
    next_ = make_discretization();
    const bool is_same =
      degrees_of(next_->space) == degrees && cells_of(next_->mesh) == cells_of(discretization.mesh);
    n_equal_steps_ = is_same ? n_equal_steps_ + 1 : 0;
    return n_equal_steps_ < patience && next_is_affordable();
  }

  static std::vector<CellId> cells_of(const Mesh<2> &mesh) {
    std::vector<CellId> cells;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      cells.push_back(cell->id());
    return cells;
  }

  StudyContext<2> context_;
  Scene<2> scene_;
  StepExamination examination_;
  MeshPlan plan_;
  /** The mesh of the step that is solved next. */
  std::shared_ptr<const Discretization<2>> next_;
  HpStep last_;
  /** The result of the step with the smallest bound, none of which has reached the target. */
  std::optional<LevelResult<2>> best_;
  /** The errors of the steps since a bound has missed the target. */
  std::vector<double> missed_;
  /** Whether there was no bound where one was asked. */
  bool lacks_bound_ = false;
  /** The number of steps, of the last ones on equal meshes, and of the last ones by paths. */
  unsigned int n_steps_ = 0, n_equal_steps_ = 0, n_paths_ = 0;
};
} // namespace

unsigned int first_graded_level(const double n_graded_cells) {
  constexpr double n_enough = 24.;
  unsigned int level = 0;
  for (double n_cells = n_graded_cells; n_cells < n_enough; n_cells *= 4.)
    ++level;
  return level;
}

std::unique_ptr<Sequence<2>> make_hp_sequence(const StudyContext<2> &context) {
  return std::make_unique<HpSequence>(context);
}
} // namespace Signorini
