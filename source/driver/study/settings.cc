// SPDX-License-Identifier: LGPL-2.1-or-later
// Contradictions between parameters and scene, found before the first level.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/driver/study/settings.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/scene/trace_norms.h>

#include <string>

namespace Signorini {
namespace {
/** @throws InputError which states the option that was found and the others that are allowed, if a
 * setting is @p wrong. */
template <typename Option>
void refuse_if(const bool wrong, const Given<Option> &found, const std::string &context,
               const std::string &allowed) {
  if (wrong)
    throw error_at(found, "found '", to_text(found.value), "' ", context, ", allowed ", allowed,
                   ".");
}

/** Refuses multigrid for meshes that are not nested, for Q2, and where a matrix
 * is to be written. @throws InputError */
template <typename Option>
void check_multigrid(const Given<Option> &solver, const std::string &allowed,
                     const Parameters &parameters) {
  if (solver != Option::multigrid)
    return;
  refuse_if(parameters.discretization.strategy == Strategy::hp, solver, "with Strategy 'hp'",
            "with it: " + allowed);
  refuse_if(parameters.discretization.element == Element::q2, solver, "with Element 'Q2'",
            "with it: " + allowed);
  refuse_if(parameters.output.compliance, solver, "with Compliance = true, which writes a matrix",
            "with it: " + allowed);
}

/** Refuses settings that friction cannot have. @throws InputError */
template <int dim>
void check_tangential_part(const Parameters &parameters, const Scene<dim> &scene) {
  const Given<CaseSequence> &sequence = parameters.load_cases.sequence;
  refuse_if(!scene.contact_law.has_tangential_part() && sequence == CaseSequence::steps &&
              !parameters.contact.law.is_given,
            sequence, "without friction, where cases have no history", "there: independent");
  if (!scene.contact_law.has_tangential_part())
    return;
  const DiscretizationParameters &given = parameters.discretization;
  const Given<ContactSolver> &contact = parameters.solver.contact_solver;
  refuse_if(contact == ContactSolver::multigrid, contact, "with friction",
            "with it: automatic, psor, active set");
  if (given.strategy == Strategy::hp)
    return;
  refuse_if(dim == 3 && (scene.is_held_by_contact || !scene.plates.empty()), parameters.contact.law,
            "with Dimension = 3 and plates, or a body that contact alone holds",
            "with them: none, or bodies that other sides hold");
  refuse_if(given.element == Element::q2, given.element, "with friction",
            dim == 2 ? "with it: Q1, Q1 B-bar" : "with it: Q1");
}
} // namespace

template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene) {
  const Given<ContactSolver> &contact = parameters.solver.contact_solver;
  const Given<LinearSolver> &linear = parameters.solver.linear_solver;
  check_multigrid(linear, "automatic, condensed", parameters);
  check_multigrid(contact, "automatic, psor, active set", parameters);
  check_tangential_part(parameters, scene);
  const bool by_cycles = contact == ContactSolver::multigrid;
  const std::string revolved = "with Plane state '" + to_text(PlaneState::axisymmetric) + "'";
  refuse_if(scene.geometry.axisymmetric && by_cycles, contact, revolved,
            "with it: automatic, psor, active set");
  const std::string no_norms = dim == 2 ? revolved : "with contact on a side that is no rectangle";
  refuse_if(!has_trace_norms(scene) && parameters.output.inf_sup_constant == Choice::yes,
            parameters.output.inf_sup_constant, no_norms, "with it: automatic, false");
  if (!has_trace_norms(scene) && parameters.output.lemmas)
    throw error_at(parameters.output.lemmas, "found 'true' ", no_norms,
                   ", allowed with it: false.");
  refuse_if(parameters.discretization.strategy == Strategy::hp &&
              parameters.output.inf_sup_constant == Choice::yes,
            parameters.output.inf_sup_constant, "with Strategy 'hp'", "with it: automatic, false");
  refuse_if(dim == 3 && linear == LinearSolver::amesos_klu, linear, "in 3-D",
            "there: automatic, condensed, amesos_mumps, multigrid");
  refuse_if(by_cycles && linear != LinearSolver::multigrid && linear != LinearSolver::automatic,
            linear, "with Contact solver 'multigrid'", "with it: automatic, multigrid");
  refuse_if(by_cycles && !scene.load_cases.empty(), contact, "with load cases",
            "with them: psor, active set");
}

std::optional<ForeignField> read_foreign_field(const Parameters &parameters,
                                               const Scene<2> &scene) {
  constexpr std::size_t max_file_size = std::size_t(1) << 32;
  const VerifyParameters &given = parameters.verify;
  if (given.file.value.empty())
    return {};
  if (scene.geometry.axisymmetric)
    throw error_at(given.file, "found ", quote(given.file),
                   " with a body of revolution, allowed: plane bodies, which have a bound.");
  const std::string name = shorten_path(given.file),
                    text = read_whole_file(given.file, given.file.where() + ": ",
                                           "file of a displacement", max_file_size);
  return ForeignField(read_vtu(text, name, given.field), scene.geometry, given.factor,
                      given.tolerance);
}

INSTANTIATE_FUNCTION(check_settings);
} // namespace Signorini
