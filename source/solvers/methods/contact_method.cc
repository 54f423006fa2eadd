// SPDX-License-Identifier: LGPL-2.1-or-later
// Which method finds contact.

#include <signorini/solvers/methods/contact_method.h>

#include <cmath>

#include "methods.h"

namespace Signorini
{
namespace
{
/** Unknowns from which V-cycles are faster than a factorisation. */
constexpr double min_unknowns_of_cycles(const unsigned int dim)
{
  return dim == 2 ? 1e5 : 5e3;
}

/** Whether nothing but the size speaks against V-cycles. */
template <int dim>
bool may_iterate(const Parameters &parameters, const Scene<dim> &scene, const unsigned int n_ranks)
{
  const DiscretizationParameters &discretization = parameters.discretization;
  const bool solver_fits = parameters.solver.linear_solver == LinearSolver::automatic ||
                           parameters.solver.linear_solver == LinearSolver::multigrid;
  return solver_fits && n_ranks == 1 && discretization.strategy == Strategy::nested &&
         discretization.element == Element::q1 && discretization.patch_ratio > 1 &&
         discretization.patches == 0 && !parameters.output.compliance && scene.load_cases.empty() &&
         scene.plates.empty() && !scene.is_held_by_contact;
}
} // namespace

Columns<DualSolve> DualSolve::columns()
{
  return {{"qp_iterations", &DualSolve::iterations},
          {"kkt", &DualSolve::kkt},
          {"qp_increment_iterations", &DualSolve::increment_iterations}};
}

double algebraic_error(const AdmissibleSet &K,
                       const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W,
                       const dealii::Vector<double> &diagonal)
{
  constexpr double diagonal_over_eigenvalue = 6.;
  double energy = 0.;
  for (unsigned int k = 0; k < P.size(); ++k)
    if (diagonal[k] > 0.)
      energy += diagonal[k] * std::pow(K.residual(k, P[k], W[k] / diagonal[k]), 2);
  return std::sqrt(diagonal_over_eigenvalue * energy);
}

template <int dim>
SolverChoice choose_solvers(const Parameters &parameters,
                            const Scene<dim> &scene,
                            const unsigned int level,
                            const unsigned int n_ranks)
{
  const SolverParameters &solver = parameters.solver;
  SolverChoice choice = {solver.contact_solver, solver.linear_solver};
  const double n_unknowns = dim * scene.geometry.n_coarse_cells * std::pow(2., double(dim) * level);
  const bool many =
    n_unknowns >= min_unknowns_of_cycles(dim) || solver.linear_solver == LinearSolver::multigrid;
  if (choice.contact == ContactSolver::automatic)
    choice.contact = many && may_iterate(parameters, scene, n_ranks) ? ContactSolver::multigrid
                                                                     : ContactSolver::active_set;
  if (choice.is_by_cycles())
    choice.linear = LinearSolver::multigrid;
  return choice;
}

template <int dim>
std::unique_ptr<ContactMethod<dim>> make_contact_method(const Parameters &parameters,
                                                        const Scene<dim> &scene,
                                                        const SolverChoice &choice)
{
  if (choice.is_by_cycles())
    return make_cycle_method(parameters, scene);
  return make_dual_method(parameters, scene, choice);
}

template SolverChoice
choose_solvers(const Parameters &, const Scene<2> &, unsigned int, unsigned int);
template SolverChoice
choose_solvers(const Parameters &, const Scene<3> &, unsigned int, unsigned int);
template std::unique_ptr<ContactMethod<2>> make_contact_method(const Parameters &,
                                                               const Scene<2> &,
                                                               const SolverChoice &);
template std::unique_ptr<ContactMethod<3>> make_contact_method(const Parameters &,
                                                               const Scene<3> &,
                                                               const SolverChoice &);
} // namespace Signorini
