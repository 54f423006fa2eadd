// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/level/discretization.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/kinematics/free_motions.h>
#include <signorini/solvers/kinematics/motion_modes.h>

#include <mpi.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** How contact on one level was found; the defaults hold where nothing touches. */
struct DualSolve
{
  /** The one that was asked for, never automatic. */
  ContactSolver method = ContactSolver::active_set;
  /** Sweeps of projected SOR, linear solves of the active set method, products of MPRGP, or
   * V-cycles.
   */
  unsigned int iterations = 0;
  /** Projected SOR: the sweep at which the increment alone was small enough. */
  std::optional<unsigned int> increment_iterations;
  double kkt = 0.;
  bool converged = true;
  /** Whether the pressure is the only one that solves the dual problem. */
  bool unique = true;
  /** Why the active set method failed where projected SOR answered instead; empty if the solver
   * that the user chose has answered. */
  std::optional<std::string> active_set_failure;
  /** Why MINRES answered instead of V-cycles with boundary problems. */
  std::optional<std::string> stalled;
  /** The level on which V-cycles were given up, and why; from there on factors answer. */
  std::optional<std::string> failure_of_cycles;
  /** Relative to the energy norm of U: the algebraic error at which V-cycles ended because the
   * error of the discretisation is larger; 0 where the tolerance counts. */
  double energy_tolerance = 0.;

  static Columns<DualSolve> columns();
};

/** The solves with the factors of A on one level. */
struct LinearSolves
{
  unsigned int solves = 0;
  /** The largest |b - A x| / |b|. */
  double residual = 0.;
  /** The relative error of U that is due to rounding, as far as it was estimated. */
  double rounding_error = 0.;
};

/** What a method starts from; all of it may be missing. */
struct ContactStart
{
  /** @param P a pressure on the patches of the level; empty: none. */
  explicit ContactStart(Pressure P = {})
    : P(std::move(P))
  {
  }

  Pressure P;
  /** Nodal values of a displacement; empty: none. Only V-cycles use it. */
  Displacement U;
  /** t of the level before, see ContactIterationOptions; zero: none. */
  double scale = 0.;
  /** The estimated error of the level before, relative in the energy norm; none: unknown. */
  std::optional<double> relative_error;
};

/** The dual problem: what a method that forms it knows beside its solution. */
struct DualData
{
  /** The body without contact, and its opening F, with plates and body where they have moved to. */
  FreeState free;
  /** F as it was before the motions moved: the right-hand side of the dual problem. */
  dealii::Vector<double> F;
  /** C P; empty if nothing touches. */
  dealii::Vector<double> C_P;
  /** Null if nothing touches. */
  std::shared_ptr<const ComplianceOperator> C;
  /** B, K and b of free motions; empty without. */
  FreeMotions motions;
};

/** What V-cycles know beside P and U. */
struct CycleData
{
  /** t, for the next level. */
  double scale = 0.;
  /** About the part of the duality gap that V-cycles leave in A U = f + D P (energy). */
  double energy_of_residual = 0.;
};

/** Contact on one level as a method has found it. Exactly one of dual and cycles is there. */
template <int dim>
struct ContactState
{
  Displacement U;
  Pressure P;
  /** How far motions have moved; empty without. */
  dealii::Vector<double> q;
  /** C_kk P_k, how far each multiplier opens its own patch; empty if nothing touches. */
  dealii::Vector<double> diagonal_P;
  /** See algebraic_error() (energy norm). */
  double algebraic_error = 0.;
  DualSolve report;
  LinearSolves linear;
  StageTimes times;
  /** The names of rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;

  /** A, where it was assembled, and f. */
  std::shared_ptr<const LinearSystem<dim>> system;
  /** A^{-1} by factors, or V-cycles that solve as exactly as estimates need it. */
  std::shared_ptr<const StiffnessInverse> inverse;
  MotionModes<dim> modes;
  std::optional<DualData> dual;
  std::optional<CycleData> cycles;
};

/** Called with what is being done, for the user to watch. */
using Progress = std::function<void(const std::string &)>;

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

/**
 * Refuses levels that cannot fit into memory before hours of work end in the kernel's out-of-memory
 * killer, which leaves no message. Compares a low estimate for a direct factorisation and for the
 * dense matrices on the contact boundary with the memory that this process may have: that of the
 * machine, or less where RLIMIT_AS or a control group says so. An iterative solver needs an
 * estimate of its own.
 */
template <int dim>
class MemoryLimit
{
public:
  /**
   * Judges the finest level; with a target error, where that is a limit that need not be reached,
   * the coarsest. Allocates no more than the coarse mesh, if that fits.
   * @throws InputError with the estimated need.
   */
  MemoryLimit(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);

  /** @throws ComputationError if the level does not fit. */
  void check(unsigned int level) const;

private:
  /** On level 0. */
  double n_coarse_cells_;
  double n_coarse_contact_faces_ = 0.;
  double n_contact_sides_;
  const DiscretizationParameters &given_;
  /** Whether the factor holds the dense Schur complement of the contact unknowns. */
  SolverChoice solvers_;
  bool condensed_;
  double available_;

  double n_cells(unsigned int level) const;
  double n_contact_faces(unsigned int level) const;
  double n_patches(unsigned int level) const;
  double needed(unsigned int level) const;
  /** "level 14 makes 1e9 cells and 16384 contact patches, which need more than 12 GiB". */
  std::string describe(unsigned int level) const;
  std::string describe_available() const;
};
} // namespace Signorini
