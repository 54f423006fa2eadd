// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/discretization.h>
#include <signorini/postprocessing/quantities/friction.h>
#include <signorini/postprocessing/quantities/plate_record.h>
#include <signorini/postprocessing/quantities/probe_report.h>
#include <signorini/postprocessing/quantities/side_forces.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/methods/contact_solution.h>
#include <signorini/solvers/methods/level_operators.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** The state of contact in one load case. */
struct CaseResult {
  LoadCase load_case;
  /** The number of the case, from 1, and that of the level. */
  unsigned int number = 0;
  unsigned int level = 0;
  /** The reason why there is no solution ("it tips over"); empty if there is one. Only then the
   * other members are set. */
  std::string escape;
  /** The contact force on the body (force, moment about the origin; per thickness). */
  SideForce::Total contact;
  /** The largest pressure, positive in compression (force/area). */
  double peak_pressure = 0.;
  /** The length of all contact zones together (length), in space the area that presses. */
  double zone_length = 0.;
  unsigned int n_zones = 0;
  /** The number of multipliers that press. */
  unsigned int active = 0;
  /** The plates and their motions, without forces. */
  std::vector<PlateRecord> plates;
  /** Friction, if the scene has it; in steps its dissipation is that since the beginning. */
  std::optional<TangentialSummary> tangential;
  /** The estimated relative error in the energy norm, where it is wanted. */
  std::optional<double> estimate;
  /** The forces of clamped, prescribed and roller sides on the body, "left_x", ... (force per
   * thickness). */
  std::vector<std::pair<std::string, double>> reactions;
  /** The probes of Output/Report. */
  std::vector<ProbeReport> reports;
  unsigned int iterations = 0;
  double kkt = 0.;
  bool converged = false;
};

/**
 * Solves load cases with one factorisation. The displacement without contact is linear in the
 * loads: U_0 = Σ_i a_i U_i with one U_i for forces, weight and travel each. So a case needs
 *
 *     F = G - Σ_i a_i Dᵀ U_i,   b = Σ_i a_i b_i,
 *
 * the same C, B and K as all others, and one dual problem, which starts from the pressure of the
 * case before: O(m²) operations.
 *
 * With friction, cases may be steps of a history. All that friction remembers is the slip Σ W_t
 * since the beginning, m numbers that are added to G_t: stick means that the slip does not change.
 */
template <int dim>
class CaseSolver {
public:
  /**
   * Solves once for each kind of load that the scene has. Collective.
   * @param discretization, scene, operators those of the level; they must outlive the object.
   * @param are_steps whether each case goes on from the slip of the one before.
   */
  CaseSolver(const Discretization<dim> &discretization, const Scene<dim> &scene,
             const LevelOperators<dim> &operators, const DualSolverOptions &options,
             bool are_steps = false);
  CaseSolver(const CaseSolver &) = delete;
  CaseSolver &operator=(const CaseSolver &) = delete;

  /** Solves a case. Collective. */
  CaseResult solve(const LoadCase &load_case);

  /** Returns U, P and q of the last case, U by one more solve. Collective. */
  ContactSolution contact() const;
  /** Returns the motions of the plates in the last case. */
  std::vector<PlateMotion<dim>> plate_motions() const;
  /** Returns the reactions of the last case, whose displacement is given. */
  std::vector<std::pair<std::string, double>> reactions(const Displacement &U) const;

private:
  /** The response to one kind of load. */
  struct LoadResponse {
    /** The factor of these loads. */
    double LoadCase::*factor;
    Displacement U;
    /** The closing Dᵀ U. */
    dealii::Vector<double> closing;
    /** The work on the free motions. */
    MotionWork work;
    /** The loads f_i. */
    DualVector loads;
  };

  LoadResponse respond(const CaseFactor &factor) const;
  /** Returns G. */
  dealii::Vector<double> gap_of(const LoadCase &load_case) const;
  /** Summarises friction, and remembers the slip of a step. */
  TangentialSummary finish_step(const dealii::Vector<double> &F);
  /** Returns the loads of a case. */
  DualVector loads_of(const LoadCase &load_case) const;
  /** Returns whether the loads of a case drive a motion that contact does not resist. */
  bool slides(const LoadCase &load_case) const;
  /**
   * Solves for P and q.
   * @return the part of the result that does not depend on the multipliers.
   */
  CaseResult solve_dual(const LoadCase &load_case);

  const Discretization<dim> &discretization_;
  const Scene<dim> &scene_;
  const LevelOperators<dim> &operators_;
  DualSolverOptions options_;
  bool are_steps_;
  FullMatrix<double> B_;
  dealii::Vector<double> G_;
  std::vector<LoadResponse> responses_;
  ReactionFunctionals<dim> reactions_;
  LoadCase last_;
  Multiplier P_;
  dealii::Vector<double> q_;
  /** The slip and the dissipation since the beginning; zero where cases are no steps. */
  dealii::Vector<double> slip_;
  double dissipation_ = 0.;
};
} // namespace Signorini
