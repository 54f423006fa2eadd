// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/discretization.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/free_motions.h>
#include <signorini/solvers/contact/motion_modes.h>

#include <mpi.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** The summary of the contact solver on one level. The defaults hold where nothing touches. */
struct DualSolve {
  /** The method that solved the problem, never automatic. */
  ContactSolver method = ContactSolver::active_set;
  /** The number of sweeps of projected SOR, linear solves of the active set method, or V-cycles. */
  unsigned int iterations = 0;
  /** The sweep of projected SOR at which the increment alone was small enough. */
  std::optional<unsigned int> increment_iterations;
  double kkt = 0.;
  bool converged = true;
  /** Whether Newton's method did not find the states with Coulomb's law, see QPResult. */
  bool by_path = false;
  /** Whether the pressure is the only one that solves the dual problem. */
  bool unique = true;
  /** The reason why the active set method failed and projected SOR took its place; empty if the
   * chosen solver was used. */
  std::optional<std::string> active_set_failure;
  /** The reason why MINRES took the place of V-cycles with boundary problems. */
  std::optional<std::string> stalled;
  /** The level on which V-cycles failed, and why; this level and later ones are solved with
   * factors. */
  std::optional<std::string> failure_of_cycles;

  static Columns<DualSolve> columns();
};

/** The solves with the factors of A on one level. */
struct LinearSolves {
  unsigned int solves = 0;
  /** The largest relative residual |b - A x| / |b|. */
  double residual = 0.;
  /** The relative error of U that is due to rounding, as far as it was estimated. */
  double rounding_error = 0.;
};

/** The start of a method. Each part may be missing. */
struct ContactStart {
  /** (P_n, P_t) on the patches of the level; empty: none. */
  dealii::Vector<double> P;
  /** Nodal values of a displacement; empty: none. Only V-cycles use it. */
  Displacement U;
  /** The scale t of the level before, see ContactIterationOptions; zero: none. */
  double scale = 0.;
};

/** The data of the dual problem, stored by a method that forms it. */
struct DualData {
  /** The body without contact, and its opening F, after the free motions. */
  FreeState free;
  /** F before the free motions: the right-hand side of the dual problem. */
  dealii::Vector<double> F;
  /** The product C P; empty if nothing touches. */
  dealii::Vector<double> C_P;
  /** The compliance; null if nothing touches. */
  std::shared_ptr<const ComplianceOperator> C;
  /** B, K and b of the free motions; empty if there are none. */
  FreeMotions motions;
};

/** The results of V-cycles beside P and U. */
struct CycleData {
  /** The scale t, for the next level. */
  double scale = 0.;
  /** The estimated part of the duality gap that the residual of A U = f + D P leaves (energy). */
  double energy_of_residual = 0.;
};

/** Contact on one level, made by a method once for all who read it. Exactly one of dual and cycles
 * is set. */
template <int dim>
struct ContactSolution {
  Displacement U;
  Multiplier P;
  /** The gap residual Dᵀ U - G: W_n ≤ 0 is the mean opening of a patch times its measure, and W_t
   * its slip (length^dim). */
  dealii::Vector<double> W;
  /** The coordinates q of the free motions; empty if there are none. */
  dealii::Vector<double> q;
  /** The products C_kk P_k, how far each multiplier opens its own patch; empty if nothing touches.
   */
  dealii::Vector<double> diagonal_P;
  /** The algebraic error in the energy norm, see algebraic_error(). */
  double algebraic_error = 0.;
  DualSolve report;
  LinearSolves linear;
  StageTimes times;
  /** The names of rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;

  /** The matrix A, where it is assembled, and f. */
  std::shared_ptr<const LinearSystem<dim>> system;
  /** A⁻¹ by factors, or by V-cycles with a tolerance that suffices for estimates. */
  std::shared_ptr<const StiffnessInverse> inverse;
  MotionModes<dim> modes;
  std::optional<DualData> dual;
  std::optional<CycleData> cycles;
};

/** A callback that gets the name of the current stage, for the user to watch. */
using Progress = std::function<void(const std::string &)>;

/** The solvers of a level, after Contact solver = automatic is resolved. */
struct SolverChoice {
  ContactSolver contact = ContactSolver::active_set;
  LinearSolver linear = LinearSolver::automatic;

  /** Returns whether V-cycles find contact, without F, C and a dual problem. */
  bool is_by_cycles() const {
    return contact == ContactSolver::multigrid;
  }
  /** Returns whether A is neither assembled nor factorised. */
  bool is_matrix_free() const {
    return linear == LinearSolver::multigrid;
  }
};

/**
 * Chooses the solvers of a level. Contact solver = automatic is multigrid, with the linear solver
 * of that name, where
 *
 * - the linear solver is automatic or multigrid, and meshes are nested,
 * - there are no load cases, plates, bodies that contact alone holds, Output/Compliance, B-bar
 *   elements, or patches of a single face, for which V-cycles cannot be used or are slow,
 * - the level has at least 1e5 unknowns (in 3-D 5000), or the linear solver is multigrid;
 *
 * else active set.
 */
template <int dim>
SolverChoice choose_solvers(const Parameters &parameters, const Scene<dim> &scene,
                            unsigned int level);

/** Returns whether several ranks share a level with these solvers; else every rank solves it alone.
 * V-cycles and amesos_mumps are there for shared levels of one body without friction, plates and
 * load cases, where every rank gets at least eight subtrees of 4^dim cells. A bound needs the whole
 * body.
 */
template <int dim>
bool is_shared(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &solvers,
               unsigned int level, unsigned int n_ranks);

/** Solves (5) on a level: A U - D P = f, P in K, W = Dᵀ U - G in the dual cone of K at P. */
template <int dim>
class ContactMethod {
public:
  virtual ~ContactMethod() = default;

  /** Finds contact. Collective. @throws InputError if contact cannot hold the body.
   * @throws ComputationError if a solver fails. */
  virtual ContactSolution<dim> solve(const Discretization<dim> &discretization,
                                     const ContactStart &start, const Progress &progress) const = 0;
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
/** The coupling D of some patches, and the same with constraints condensed. */
struct CouplingPair {
  const Coupling &D;
  const Coupling &condensed_D;
};

/**
 * Solves the dual problem of a level again on other patches, with its F there, from the pressure
 * @p start; motions begin at contact.q. Needs contact.dual. @return nothing if the solver fails.
 */
template <int dim>
std::optional<dealii::Vector<double>> solve_on_other_patches(const ContactSolution<dim> &contact,
                                                             const CouplingPair &patches,
                                                             const dealii::Vector<double> &F,
                                                             const dealii::Vector<double> &start);

/**
 * Refuses levels that cannot fit into memory before hours of work end in the kernel's out-of-memory
 * killer, which leaves no message. Compares a low estimate for a direct factorisation and for the
 * dense matrices on the contact boundary with the memory that this process may have: that of the
 * machine, or less where RLIMIT_AS or a control group limits it. The ranks on a machine share it,
 * and each has its part of a shared level. V-cycles are held against an estimate without a factor.
 */
template <int dim>
class MemoryLimit {
public:
  /**
   * Checks the finest level. With a target error the finest level need not be reached, so the
   * coarsest is checked. Allocates no more than the coarse mesh, if that fits.
   * @throws InputError with the estimated need.
   */
  MemoryLimit(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);

  /** Returns the size of the level that is checked, a low estimate of what it needs, and what there
   * is: "level 6 has 4096 cells and 32 patches, which need more than 0.1 GiB of 23 GiB". */
  std::string forecast() const {
    return describe(judged_) + " of " + describe_available();
  }
  /** Returns about how many unknowns that level has. */
  double n_unknowns() const {
    return dim * n_nodes(judged_);
  }
  /** Checks that a level fits. @throws ComputationError if it does not. */
  void check(unsigned int level) const;

private:
  /** The numbers of cells and of contact faces on level 0. */
  double n_coarse_cells_;
  double n_coarse_contact_faces_ = 0.;
  double n_given_patches_;
  /** The unknowns of a patch. */
  double n_components_;
  const Parameters &parameters_;
  const Scene<dim> &scene_;
  unsigned int n_ranks_;
  /** The level that is checked first. */
  unsigned int judged_;
  /** The solvers, and whether the factor holds the dense Schur complement of the contact unknowns.
   */
  SolverChoice solvers_;
  bool condensed_;
  double available_;

  double n_cells(unsigned int level) const;
  /** Returns about how many nodes a level has: those of 2^dim cells of degree one for every cell of
   * degree two. */
  double n_nodes(unsigned int level) const;
  double n_contact_faces(unsigned int level) const;
  double n_patches(unsigned int level) const;
  double needed(unsigned int level) const;
  /** Returns "level 14 has 1e9 cells and 16384 patches, which need more than 12 GiB". */
  std::string describe(unsigned int level) const;
  std::string describe_available() const;
};
} // namespace Signorini
