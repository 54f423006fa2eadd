// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/recovery.h>
#include <signorini/solvers/kinematics/free_motions.h>
#include <signorini/solvers/kinematics/motion_modes.h>

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
} // namespace Signorini
