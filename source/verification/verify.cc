// SPDX-License-Identifier: LGPL-2.1-or-later
// A level against its exact solution, and the constant of Lemma 1.

#include <signorini/base/columns.h>
#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/trace_norms.h>
#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/errors.h>
#include <signorini/verification/norms/inf_sup.h>
#include <signorini/verification/norms/lemma_numbers.h>
#include <signorini/verification/verify.h>

#include <memory>

namespace Signorini {
namespace {
/** Returns whether the constant of Lemma 1 is computed on a level of this size. Unless the user
 * sets it, it belongs to the errors against an exact solution on nested meshes: it needs a
 * factorisation of its own, a third of a level, and in 3-D more than the rest of the level from
 * some thousand unknowns on. */
template <int dim>
bool wants_inf_sup(const Parameters &parameters, const LevelSolution<dim> &solution) {
  const Choice choice = parameters.output.inf_sup_constant;
  const bool has_factors = solution.record.dual.method != ContactSolver::multigrid &&
                           parameters.solver.linear_solver != LinearSolver::multigrid;
  return choice == Choice::yes ||
         (choice == Choice::automatic && has_factors && has_trace_norms(solution.scene) &&
          solution.scene.exact_displacement != nullptr &&
          parameters.discretization.strategy != Strategy::hp &&
          solution.contact.U.size() <= (dim == 2 ? 100000U : 5000U));
}
} // namespace

template <int dim>
void add_inf_sup(const Parameters &parameters, const Discretization<dim> &discretization,
                 const Progress &progress, LevelSolution<dim> &solution) {
  LevelRecord &record = solution.record;
  if (record.tangential || !wants_inf_sup<dim>(parameters, solution))
    return;
  const StageTimer timer(record.times.postprocess);
  progress("inf-sup constant");
  const InfSup beta =
    measure_inf_sup(discretization.space, discretization.multipliers, discretization.condensed_D,
                    dual_gram_matrix(discretization.surface), parameters.solver.linear_solver);
  record.inf_sup = beta.both;
  record.inf_sup_first = beta.first;
  record.inf_sup_opposite = beta.opposite;
}

template <int dim>
void add_errors(const Parameters &parameters, const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure, LevelSolution<dim> &solution) {
  if (!parameters.output.errors)
    return;
  const unsigned int n_points = discretization.n_points + 1;
  const MultiplierSpace<dim> &multipliers = discretization.multipliers;
  const ContactSolution &contact = solution.contact;
  const Scene<dim> &scene = solution.scene;
  const Pressure &P = contact.P.normal();
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.errors);
  if (scene.exact_displacement != nullptr)
    record.displacement_errors =
      compute_displacement_errors(DisplacedBody(discretization.space, scene, contact.U), n_points);
  if (scene.has_exact_pressure()) {
    record.pressure_errors = compute_pressure_errors(multipliers, P, n_points);
    if constexpr (dim == 2)
      record.endpoint_error = contact_end_error(multipliers, scene, P);
  }
  if constexpr (dim == 2)
    if (record.tangential && scene.contacts.front().exact_tangential != nullptr)
      record.tangential->l2_error =
        compute_pressure_errors(multipliers, contact.P.tangential()[0], n_points,
                                &ContactCondition<2>::exact_tangential)
          .l2;
  if (pressure != nullptr)
    record.dual_norm_errors = pressure->errors(multipliers, P);
  if constexpr (dim == 2)
    if (parameters.output.lemmas && scene.exact_displacement != nullptr && pressure != nullptr)
      record.lemmas =
        compute_lemma_numbers(discretization, scene, *pressure, parameters.solver.linear_solver);
}

template <int dim>
Verify<dim> make_verify(const Parameters &parameters, const Scene<dim> &scene) {
  // The norms of the trace space are those of patches of one length.
  const bool has_dual_norms = parameters.output.errors && scene.has_exact_pressure() &&
                              has_trace_norms(scene) &&
                              parameters.discretization.strategy != Strategy::hp;
  return [&parameters, &scene, has_dual_norms, pressure = std::shared_ptr<ExactPressure<dim>>()](
           const Discretization<dim> &discretization, const Progress &progress,
           LevelSolution<dim> &solution) mutable {
    add_inf_sup(parameters, discretization, progress, solution);
    progress("errors");
    if (has_dual_norms && pressure == nullptr)
      pressure = std::make_shared<ExactPressure<dim>>(scene);
    add_errors(parameters, discretization, pressure.get(), solution);
  };
}

INSTANTIATE_FUNCTION(add_inf_sup);
INSTANTIATE_FUNCTION(add_errors);
INSTANTIATE_FUNCTION(make_verify);
} // namespace Signorini
