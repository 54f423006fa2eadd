// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>

#include <optional>
#include <string>

namespace Signorini
{
/** How the dual problem of one level was solved; the defaults hold where nothing touches. */
struct DualSolve
{
  /** Sweeps of projected SOR, or linear solves of the active set method. */
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
