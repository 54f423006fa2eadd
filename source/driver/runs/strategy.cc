// SPDX-License-Identifier: LGPL-2.1-or-later
// The sequence of meshes of a run that states none.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/driver/runs/strategy.h>
#include <signorini/driver/sequence/sequence.h>

namespace Signorini {
namespace {
/** Returns why meshes are nested; empty where they may be graded. */
template <int dim>
std::string reason_for_nested(const Parameters &parameters, const Scene<dim> &scene) {
  if (dim == 3)
    return "bodies in space have no graded meshes";
  if (scene.exact_displacement != nullptr)
    return "an exact solution is given";
  const DiscretizationParameters &given = parameters.discretization;
  const SolverParameters &solver = parameters.solver;
  const OutputParameters &output = parameters.output;
  const std::pair<bool, const Entry &> needs[] = {
    {given.element.is_given, given.element},
    {given.patch_ratio.is_given, given.patch_ratio},
    {given.patches.is_given, given.patches},
    {parameters.geometry.distortion > 0., parameters.geometry.distortion},
    {solver.contact_solver == ContactSolver::multigrid, solver.contact_solver},
    {solver.linear_solver == LinearSolver::multigrid, solver.linear_solver},
    {solver.require_stability, solver.require_stability},
    {output.inf_sup_constant == Choice::yes, output.inf_sup_constant},
    {output.lemmas, output.lemmas}};
  for (const auto &[is_given, entry] : needs)
    if (is_given)
      return entry.name + " is given";
  return "";
}

/** Gives an entry a value, also in the echo. */
template <typename T>
void decide(Given<T> &entry, const T &value, const std::string &text, Parameters &parameters) {
  entry.value = value;
  set_in_echo(entry.name, text, parameters.echo);
}
} // namespace

template <int dim>
std::string decide_strategy(Parameters &parameters, const Scene<dim> &scene) {
  DiscretizationParameters &given = parameters.discretization;
  const bool has_levels = given.finest_level.is_given || given.coarsest_level.is_given;
  std::string sentence;
  if (given.strategy == Strategy::automatic) {
    const bool verifies = !parameters.verify.file.value.empty() && dim == 2;
    const std::string reason = verifies ? "" : reason_for_nested(parameters, scene);
    const Strategy strategy =
      reason.empty() && (verifies || !has_levels) ? Strategy::hp : Strategy::nested;
    if (verifies || !has_levels)
      sentence = to_text(strategy) + ", since " +
                 (verifies         ? parameters.verify.file.name + " is given"
                  : reason.empty() ? "neither levels nor an exact solution are given"
                                   : reason);
    decide(given.strategy, strategy, to_text(strategy), parameters);
  }
  if (given.strategy == Strategy::hp && !given.coarsest_level.is_given) {
    const unsigned int first = first_graded_level(scene.geometry.n_graded_cells());
    decide(given.coarsest_level, first, std::to_string(first), parameters);
  }
  return sentence;
}

void solve_all_nested_levels(Parameters &parameters) {
  DiscretizationParameters &given = parameters.discretization;
  decide(given.strategy, Strategy::nested, to_text(Strategy::nested), parameters);
  decide(given.target_error, 0., "0", parameters);
}

INSTANTIATE_FUNCTION(decide_strategy);
} // namespace Signorini
