// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/level/discretization.h>
#include <signorini/solvers/methods/contact_state.h>

namespace Signorini
{
/** Which solvers find contact on a level: what Contact solver = automatic stands for there. */
struct SolverChoice
{
  ContactSolver contact = ContactSolver::active_set;
  LinearSolver linear = LinearSolver::automatic;

  /** Whether contact is found by V-cycles, without F, C and a dual problem. */
  bool is_by_cycles() const
  {
    return contact == ContactSolver::multigrid;
  }
  /** Whether A is neither assembled nor factorised. */
  bool is_matrix_free() const
  {
    return linear == LinearSolver::multigrid;
  }
};

/**
 * The solvers of a level on one or several ranks. Contact solver = automatic is multigrid, with the
 * linear solver of that name, where
 *
 * - the linear solver is automatic or multigrid, there is one rank, and meshes are nested,
 * - there are no load cases, plates, bodies that contact alone holds, Output/Compliance, B-bar
 *   elements, or patches of a single face, for which V-cycles cannot be used or are slow,
 * - the level has at least 1e5 unknowns, in space 5000, or the linear solver is multigrid;
 *
 * else active set.
 */
template <int dim>
SolverChoice choose_solvers(const Parameters &parameters,
                            const Scene<dim> &scene,
                            unsigned int level,
                            unsigned int n_ranks);

/** Solves (5) on a level: A U - D P = f, P in K, W = D^T U - G in the dual cone of K at P. */
template <int dim>
class ContactMethod
{
public:
  virtual ~ContactMethod() = default;

  /** @throws InputError if contact cannot hold the body. @throws ComputationError. Collective. */
  virtual ContactState<dim> solve(const Discretization<dim> &discretization,
                                  const ContactStart &start,
                                  const Progress &progress) const = 0;
};

/**
 * The method of a choice: by the dual problem, with C from factors or column by column and P by
 * projected SOR, the active set method or MPRGP; or by V-cycles. Parameters and scene must outlive
 * it.
 */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_contact_method(const Parameters &parameters,
                                                        const Scene<dim> &scene,
                                                        const SolverChoice &choice);
/** D of some patches, and what unconstrained degrees of freedom see of it. */
struct CouplingPair
{
  const Coupling &D;
  const Coupling &condensed_D;
};

/**
 * Solves the dual problem of a level again on other patches, with its F there, from the pressure
 * @p start; motions begin at contact.q. Needs contact.dual. @return nothing if the solver fails.
 */
template <int dim>
std::optional<dealii::Vector<double>> solve_on_other_patches(const ContactState<dim> &contact,
                                                             const CouplingPair &patches,
                                                             const dealii::Vector<double> &F,
                                                             const dealii::Vector<double> &start);
} // namespace Signorini
