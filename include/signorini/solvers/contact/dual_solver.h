// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <memory>

namespace Signorini {
/** The options of the solution of the dual problem. */
struct DualSolverOptions : public IterationOptions {
  ContactSolver method = ContactSolver::active_set;
  /** Whether C may be singular: then QPResult::unique is determined. */
  bool may_be_singular = false;
};

/**
 * Solves the dual problem over P in K by the chosen method. Where columns of C cost linear solves,
 * the active set method works on a growing set of patches: with P = 0 elsewhere; then those with
 * W > 0 join, until there are none. Only their columns are computed. Where it fails, because C is
 * singular (patches finer than the mesh: many pressures give the same displacement) or because it
 * does not end, projected SOR finds one of the solutions, and QPResult::active_set_failure is set.
 * Its sweeps are limited to seconds there.
 *
 * @param start a pressure to start from; empty: none. A growing set begins with the patches that
 * press in it or in Balances::P, and their neighbours; if nothing presses, with those with F < 0.
 */
QPResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C,
                            const dealii::Vector<double> &F, const AdmissibleSet &K,
                            const dealii::Vector<double> &start, const DualSolverOptions &options,
                            const Balances &balances = {});

/**
 * Solves the dual problem by the primal-dual active set method, i.e. the semi-smooth Newton method
 * for P = projection of P - W/diag C onto K. Each unknown is inside of its interval (active, in
 * contact) or at one of its ends. With the active set A and the ends e_I of the others,
 *
 *     C_AA P_A + B_A z = F_A - C_AI e_I,   P_I = e_I,   K z - Bᵀ P = b.
 *
 * It ends when a set predicts itself, or when the residual is at the level of rounding (where P and
 * W vanish together on many patches, the sets could differ for ever).
 *
 * Where K moves (Coulomb's friction), the ends of P_t are ±(s - f P_n), so that with a slipping
 * patch the column of its P_n is that of C minus ±f times that of its P_t, and C_AA gets a factor
 * LU. When a set comes back there, or after many sets, follow_solutions() gives the next one.
 *
 * Where a set leaves a motion free, the body moves along it until the first slipping patch stops,
 * and that patch sticks in the next set.
 *
 * When a set comes back, or a set that predicts itself cannot carry the loads, a primal active set
 * method ends the search. It begins with an admissible pressure in balance, and solves on the
 * patches that press. Where one would leave its interval, the step ends there, and the patch leaves
 * the set; else the patch with the largest penetration joins. The energy falls in every step, so no
 * set comes back (J. Nocedal, S. Wright: Numerical Optimization, 2006, section 16.5). A set may
 * leave bodies free, whose position would be arbitrary: patches that are to carry them would join
 * and leave again for ever. Weak springs hold them there; where these matter in the end, they are
 * fixed anew where the bodies have gone (a proximal iteration).
 *
 * With discs (friction in space, without balances) slip turns, which Newton's method finds
 * quadratically. There it begins with ten sweeps of projected SOR. Steps are shortened where that
 * decreases the residual and the whole step does not. Where four steps in a row do not decrease it,
 * more sweeps of the best P so far follow, ten more each time, and Newton's method goes on from
 * there: for Tresca's law sweeps converge in any case. With Coulomb's law it may also go on from a
 * random P (a fixed sequence of numbers).
 *
 * @param start a pressure that gives the first states, or with discs begins the sweeps; empty:
 * every unknown is active, or P = 0.
 */
QPResult solve_by_active_set(const BoundConstrainedQP &qp, const dealii::Vector<double> &start,
                             const IterationOptions &options);

/**
 * How the linear system of the states of P depends on Coulomb's coefficient: with λ f in the place
 * of f it is singular for the real λ that are reciprocal eigenvalues of its slipping part.
 */
struct Regularity {
  /** The smallest of these λ > 0; none if there is none. */
  std::optional<double> critical_factor;
  /** Whether the determinant has the sign that it has for λ = 0. Otherwise P is one of at least two
   * solutions: the degrees of all add up to one. */
  bool keeps_sign = true;
  /** The spectral radius of the slipping part: the rate of convergence of Tresca's problems with s
   * = f |P_n| of the one before, near P. */
  double fixed_point_rate = 0.;
};

/** Computes the regularity of a solution P, by the eigenvalues of a matrix as large as there are
 * slipping patches. @return nothing without friction, for a set that does not move, and where the
 * states without friction leave a motion free. */
std::optional<Regularity> examine_regularity(const BoundConstrainedQP &qp,
                                             const dealii::Vector<double> &P);
} // namespace Signorini
