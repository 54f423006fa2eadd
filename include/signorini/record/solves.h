// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/parameters/options.h>

#include <optional>
#include <string>

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
} // namespace Signorini
