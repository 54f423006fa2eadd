// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/progress.h>
#include <signorini/discretization/space/discretization.h>
#include <signorini/solvers/methods/contact_solution.h>
#include <signorini/solvers/methods/level_operators.h>
#include <signorini/solvers/methods/solver_choice.h>

#include <memory>
#include <optional>
#include <string>

namespace Signorini {
/** The start of a method. Each part may be missing. */
struct ContactStart {
  /** (P_n, P_t) on the patches of the level; empty: none. */
  dealii::Vector<double> P;
  /** Nodal values of a displacement; empty: none. Only V-cycles use it. */
  Displacement U;
  /** The scale t of the level before, see ContactIterationOptions; zero: none. */
  double scale = 0.;
};

/** Solves (5) on a level: A U - D P = f, P in K, W = Dᵀ U - G in the dual cone of K at P. */
template <int dim>
class ContactMethod {
public:
  virtual ~ContactMethod() = default;

  /** Makes the operators of a level, which must outlive them. Collective. @throws ComputationError
   * if a solver fails. */
  virtual LevelOperators<dim> make_operators(const Discretization<dim> &discretization,
                                             const Progress &progress) const = 0;
  /** Finds contact with the operators of the level. Collective. @throws InputError if contact
   * cannot hold the body. @throws ComputationError if a solver fails. */
  virtual ContactSolution solve(const Discretization<dim> &discretization,
                                const LevelOperators<dim> &operators, const ContactStart &start,
                                const Progress &progress) const = 0;
};

/**
 * Makes the chosen method. The dual method takes C from factors or column by column, and computes P
 * by projected SOR or the active set method; the other method uses V-cycles. Parameters and
 * scene must outlive the result.
 */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_contact_method(const Parameters &parameters,
                                                        const Scene<dim> &scene,
                                                        const SolverChoice &choice);

/** Returns the options of the dual problem of a level, see DualSolverOptions. */
DualSolverOptions dual_options(const SolverParameters &solver, bool may_be_singular);

/** The coupling D of some patches, and the same with constraints condensed. */
struct CouplingPair {
  const Coupling &D;
  const Coupling &condensed_D;
};

/**
 * Solves the dual problem of a level again on other patches, with its F there, from the pressure
 * @p start; motions begin at contact.q. @return nothing if the solver fails.
 * @param motions those of the dual problem of the level.
 */
template <int dim>
std::optional<dealii::Vector<double>>
solve_on_other_patches(const LevelOperators<dim> &operators, FreeMotions motions,
                       const dealii::Vector<double> &q, const CouplingPair &patches,
                       const dealii::Vector<double> &F, const dealii::Vector<double> &start);
} // namespace Signorini
