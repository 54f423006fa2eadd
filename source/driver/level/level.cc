// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the mesh to the examined answer.

#include <signorini/driver/level/level.h>

#include "level_examination.h"

namespace Signorini
{
namespace
{
/** Factors, C and the system matrix take most of the memory: what nobody asks for later goes. */
template <int dim>
void release_unused(const LevelProblem<dim> &problem, LevelSolution<dim> &solution)
{
  const bool has_cases = !problem.scene.load_cases.empty();
  const bool writes_compliance = problem.parameters.output.compliance;
  if (solution.dual && !writes_compliance)
    solution.dual->C = nullptr;
  // C of several ranks is written column by column, each by a solve.
  if (!has_cases && !writes_compliance)
    solution.inverse = nullptr;
  if (!has_cases && !writes_compliance && !problem.parameters.output.lemmas)
    solution.system = nullptr;
}
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const LevelProblem<dim> &problem,
                               const Discretization<dim> &discretization,
                               const ContactStart &start,
                               const Progress &progress)
{
  const auto [parameters, scene, solvers] = problem;
  const auto method = make_contact_method(parameters, scene, solvers);
  LevelSolution<dim> solution;
  ContactState<dim> &contact = solution;
  contact = method->solve(discretization, start, progress);
  solution.scene = with_plates_moved(scene, contact.modes.plate_motions(scene.plates, contact.q));
  Examination found = examine(parameters, discretization, solution.scene, contact, progress);
  solution.record = std::move(found.record);
  solution.bound_fields = std::move(found.bound_fields);
  release_unused(problem, solution);
  return solution;
}

template LevelSolution<2> solve_level(const LevelProblem<2> &,
                                      const Discretization<2> &,
                                      const ContactStart &,
                                      const Progress &);
template LevelSolution<3> solve_level(const LevelProblem<3> &,
                                      const Discretization<3> &,
                                      const ContactStart &,
                                      const Progress &);
} // namespace Signorini
