// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/free_motions.h>

#include <optional>
#include <string>
#include <variant>
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
  /** The reason why the active set method failed and projected SOR replaced it; empty if the
   * chosen solver was used. */
  std::optional<std::string> active_set_failure;
  /** The reason why MINRES replaced V-cycles with boundary problems. */
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

/** The results of the dual method beside P and U. */
struct DualData {
  /** The body without contact, and its opening F, after the free motions. */
  FreeState free;
  /** F before the free motions: the right-hand side of the dual problem. */
  dealii::Vector<double> F;
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

/** Contact on one level, or in one load case of it. */
struct ContactSolution {
  Displacement U;
  Multiplier P;
  /** The gap residual Dᵀ U - G: W_n ≤ 0 is the mean opening of a patch times its measure, and W_t
   * its slip (length^dim). */
  dealii::Vector<double> W;
  /** The coordinates q of the free motions; empty if there are none. */
  dealii::Vector<double> q;
  /** The product C P, of the dual method, and the products C_kk P_k, how far each multiplier opens
   * its own patch; empty if nothing touches. */
  dealii::Vector<double> C_P, diagonal_P;
  /** The algebraic error in the energy norm, see algebraic_error(). */
  double algebraic_error = 0.;
  DualSolve report;
  LinearSolves linear;
  StageTimes times;
  /** The names of rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;
  /** The further results of the method. */
  std::variant<DualData, CycleData> data;

  /** Returns whether contact was needed to find U. */
  bool touches() const {
    return diagonal_P.size() > 0;
  }
  /** Returns the results of the dual method; null after V-cycles. */
  const DualData *dual() const {
    return std::get_if<DualData>(&data);
  }
};
} // namespace Signorini
