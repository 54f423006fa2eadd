// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes: solve, find the ends of contact, estimate, plan the next mesh.

#include <signorini/base/columns.h>
#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/hp/contact_zone.h>
#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/error_control/hp/next_plan.h>
#include <signorini/error_control/hp/step_difference.h>

#include <cmath>
#include <sstream>

#include "load_case_study.h"
#include "study_internal.h"

namespace Signorini
{
namespace
{
/** A mesh with the solution on it. */
struct HpStep
{
  std::unique_ptr<const Discretization<2>> discretization;
  NodalVector U;
  dealii::Vector<double> P;
};

/** The mesh is graded to the places where data is singular, so that rules need not be. */
Scene<2> without_graded_rules(Scene<2> scene)
{
  scene.kinks = scene.kinks.without_ends();
  return scene;
}

void require_few(const DiscretizationParameters &given,
                 const double n_unknowns,
                 const std::string &text)
{
  const auto &max_unknowns = given.maximum_unknowns;
  if (n_unknowns > max_unknowns)
    throw InputError(max_unknowns.where() + ": found '" + std::to_string(max_unknowns.value) +
                     "', but the first mesh has " + text +
                     " unknowns, allowed: that many, or a smaller Coarsest level.");
}

/** The plan of the first mesh. @throws InputError where it is much too fine, which is found out
 * before it is made, and where the material hides between all points. */
MeshPlan make_first_plan(const Scene<2> &scene, const DiscretizationParameters &given)
{
  MeshPlan plan = first_plan(scene, given.coarsest_level, given.maximum_degree);
  // Every cell is of degree 2: by Euler's formula there are more than four nodes for each.
  const double fewest = 8. * scene.geometry.n_coarse_cells * std::pow(4., plan.base_level);
  require_few(given, fewest, "more than " + number_text(fewest));
  if (const std::optional<dealii::Point<2>> hidden = show_hidden_data(scene, plan))
  {
    std::ostringstream message;
    message << given.strategy.where() << ": the material changes within a layer at (" << *hidden
            << ") that is too thin for cells that are not aligned with it, allowed: lines of the "
               "mesh at both of its sides (Kinks at x, Kinks at y; in a polygon sides or a mesh "
               "file that follow it).";
    throw InputError(message.str());
  }
  return plan;
}

class HpSequence final : public Sequence<2>
{
public:
  explicit HpSequence(const StudyContext<2> &context)
    : context_(context)
    , scene_(without_graded_rules(context.scene))
    , plan_(make_first_plan(scene_, context.parameters.discretization))
    , next_(make_first_discretization())
  {
  }

  std::string name_of_next() const override
  {
    return "step " + std::to_string(n_steps_);
  }

  LevelRecord solve_next(const Progress &progress, ResultsWriter &writer) override
  {
    const Parameters &parameters = context_.parameters;
    const Discretization<2> &discretization = *next_;
    dealii::Vector<double> start;
    if (parameters.solver.warm_start && last_.discretization != nullptr)
      start =
        transfer_pressure(last_.discretization->multipliers, last_.P, discretization.multipliers);
    LevelSolution<2> solution =
      solve_level<2>({parameters, scene_, choose_solvers(parameters, scene_, 0, 1)},
                     discretization,
                     start,
                     progress);
    LevelRecord &record = solution.record;
    record.sizes.level = n_steps_;
    progress("estimate");
    const StepFindings findings = examine_step(solution);
    progress("errors");
    add_errors<2>(parameters, context_.scene, discretization, nullptr, solution);
    last_ = {std::move(next_), solution.U, solution.P};
    // Where the contact solver did not end, there is no solution to plan a mesh from.
    finished_ = !record.dual.converged || history_.stagnates() ||
                (context_.judge.reaches_target(record) && is_checked(record));
    if (!finished_)
      plan_next(findings);
    if (finished_)
      solve_load_cases(parameters, scene_, *last_.discretization, progress, writer, solution);
    progress("output");
    {
      const StageTimer timer(record.times.output);
      writer.write_fields(*last_.discretization, context_.scene, solution, finished_);
    }
    record.resources = measure_resources();
    ++n_steps_;
    return record;
  }

  bool is_finished() const override
  {
    return finished_;
  }

  PatchPressure<2> pressure() const override
  {
    return {last_.discretization->surface.patches(), last_.P};
  }

private:
  std::unique_ptr<const Discretization<2>> make_discretization() const
  {
    return std::make_unique<const Discretization<2>>(context_.parameters, scene_, plan_);
  }

  /** @throws InputError if the first mesh has too many unknowns. */
  std::unique_ptr<const Discretization<2>> make_first_discretization() const
  {
    auto first = make_discretization();
    const auto n_dofs = first->space.dofs().n_dofs();
    require_few(context_.parameters.discretization, n_dofs, std::to_string(n_dofs));
    return first;
  }

  /** Whether a second mesh agrees. Bodies that nothing deforms need none. */
  bool is_checked(const LevelRecord &record) const
  {
    return history_.n_steps() > 1 || record.estimate->relative == 0.;
  }

  /** The estimate of the error, and what the next mesh is made from. */
  StepFindings examine_step(LevelSolution<2> &solution)
  {
    const StageTimer timer(solution.record.times.postprocess);
    const Scene<2> &scene = scene_;
    const DisplacementSpace<2> &space = next_->space;
    const MultiplierSpace<2> &multipliers = next_->multipliers;
    StepFindings findings;
    findings.indicators = indicate(space, scene, solution.U);
    add_contact_misfit(space, multipliers, scene, solution.U, solution.P, findings.indicators);
    add_jump_misfit(space, scene, solution.U, findings.indicators);
    findings.brackets = contact_brackets(multipliers, solution.P);
    findings.unseen_contact = unseen_contact(space, multipliers, solution.U, solution.P);
    const double norm = energy_norm(space, scene, solution.U);
    const double scale = energy_scale(norm, total(findings.indicators), space, scene, solution.U);
    findings.target = context_.judge.target_error() * scale;
    if (!findings.unseen_contact.empty())
    {
      // The next mesh sees another problem.
      history_ = ErrorHistory();
      return findings;
    }
    std::optional<double> difference;
    if (last_.discretization != nullptr)
      difference =
        energy_distance({space, solution.U}, {last_.discretization->space, last_.U}, scene);
    // A solution that lies in the space leaves nothing but rounding.
    constexpr double rounding = 1e-12;
    findings.error = history_.add(total(findings.indicators), difference, plan_.aim);
    findings.error = std::max(findings.error, rounding * scale);
    // What does not fall while the mesh is refined has no limit: data contradict each other.
    constexpr double noticeable = 1e-3;
    if (history_.stagnates() && findings.error > noticeable * scale)
      findings.error = std::max(findings.error, scale);
    findings.error = std::hypot(findings.error, solution.algebraic_error);
    // Nothing has an error where nothing deforms the body: all that is left is rounding.
    constexpr double rounding_of_rigid_motions = 1e-7;
    if (norm < scale && findings.error <= rounding_of_rigid_motions * scale)
      findings.error = 0.;
    solution.record.estimate =
      ErrorEstimate{{}, findings.error, findings.error > 0. ? findings.error / scale : 0., {}, {}};
    return findings;
  }

  /** Makes the next mesh; if it has too many unknowns, the sequence is finished. */
  void plan_next(const StepFindings &findings)
  {
    const Discretization<2> &discretization = *last_.discretization;
    plan_ =
      next_plan(plan_, scene_, discretization.mesh, degrees_of(discretization.space), findings);
    next_ = make_discretization();
    finished_ = next_->space.dofs().n_dofs() > context_.parameters.discretization.maximum_unknowns;
  }

  StudyContext<2> context_;
  /** For everything but the errors against an exact solution. */
  Scene<2> scene_;
  MeshPlan plan_;
  ErrorHistory history_;
  /** The next mesh; empty while a step is examined. */
  std::unique_ptr<const Discretization<2>> next_;
  HpStep last_;
  unsigned int n_steps_ = 0;
  bool finished_ = false;
};
} // namespace

std::unique_ptr<Sequence<2>> make_hp_sequence(const StudyContext<2> &context)
{
  return std::make_unique<HpSequence>(context);
}

double target_error(const DiscretizationParameters &given)
{
  constexpr double usual = 1e-3;
  return given.strategy == Strategy::hp && given.target_error == 0. ? usual
                                                                    : given.target_error.value;
}
} // namespace Signorini
