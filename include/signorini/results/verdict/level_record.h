// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/quantities/answer.h>
#include <signorini/postprocessing/quantities/case_solver.h>
#include <signorini/postprocessing/quantities/friction.h>
#include <signorini/postprocessing/quantities/plate_record.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/results/verdict/exact_errors.h>
#include <signorini/solvers/methods/contact_solution.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** The sizes of the problem of one level. */
struct LevelSizes {
  unsigned int level = 0;
  unsigned long long cells = 0;
  unsigned long long dofs = 0;
  unsigned int multipliers = 0;
  /** The longest edge (length). */
  double h = 0.;
  /** The longest patch (length). */
  double H = 0.;
  /** Whether a patch is no longer than a face (H = h). */
  bool unstable = false;
  /** The highest degree of an element. */
  unsigned int max_degree = 1;
  /** The shortest edge (length). */
  double min_h = 0.;

  /** The sequence that the mesh belongs to. */
  Strategy strategy = Strategy::nested;

  /** Returns whether the mesh is a step of a sequence of graded meshes. There h alone does not show
   * how fine a mesh is, and errors have no orders in h. */
  bool is_graded() const {
    return strategy == Strategy::hp;
  }
  /** Returns the word for the mesh on the screen. */
  const char *word() const {
    return is_graded() ? "step" : "level";
  }

  static Columns<LevelSizes> columns();
};

/** The free motions, and how far they have moved. */
struct MotionRecord {
  std::vector<PlateRecord> plates;
  /** Rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;

  /** Returns the columns of the first plate; vectors in space have none. */
  static Columns<MotionRecord> columns();
};

/** The summary of the load cases of a level. */
struct CaseSummary {
  unsigned int n_cases = 0;
  /** The number of cases in which nothing stops the body. */
  unsigned int n_escapes = 0;
  /** The first case whose dual problem was not solved, from 1; 0: none. */
  unsigned int first_failure = 0;
  /** The largest KKT residual of a case with a solution. */
  double max_kkt = 0.;
  /** The largest estimated relative error of a case, and its number, from 1; 0: none. */
  double max_estimate = 0.;
  unsigned int worst = 0;
  /** The wall seconds of all cases. */
  double seconds = 0.;
};

CaseSummary summarise(const std::vector<CaseResult> &cases, double seconds);

/** The results of a level: one row of convergence.csv. Results that the scene does not have, or
 * that the user does not want, are empty. */
struct LevelRecord {
  LevelSizes sizes;
  LinearSolves linear;
  DualSolve dual;
  ContactSummary contact;
  Answer answer;
  /** Friction, if the scene has it. */
  std::optional<TangentialSummary> tangential;
  MotionRecord motions;
  Certificate certificate;
  std::optional<ErrorEstimate> estimate;
  /** The bound of the error, if it is wanted. */
  std::optional<ErrorBound> bound;
  /** The constant of Lemma 1. */
  std::optional<double> inf_sup;
  /** With pairs, those of the sides named first and of their opposites. */
  std::optional<double> inf_sup_first, inf_sup_opposite;
  /** The locking number, see locking_number(); on the finest level only. */
  std::optional<double> locking_number;

  std::optional<DisplacementErrors> displacement_errors;
  std::optional<PressureErrors> pressure_errors;
  std::optional<DualNormErrors> dual_norm_errors;
  /** The error of the ends of contact, see contact_end_error() (length). */
  std::optional<double> endpoint_error;
  std::optional<LemmaNumbers> lemmas;
  /** The summary of the load cases, on the finest level if there are any. */
  std::optional<CaseSummary> load_cases;

  StageTimes times;
  Resources resources;
};

/** Multiplies forces, moments, work and energies of a level and of load cases, which are computed
 * per unit of thickness, by the thickness. Norms stay those of the plane. */
void multiply_forces(double thickness, LevelRecord &record, std::vector<CaseResult> &cases);
/** The same for the energies and the force of a bound. */
void multiply_forces(double thickness, ErrorBound &bound);
/** The same for the forces and moments that drive plates. */
template <int dim>
void multiply_forces(double thickness, std::vector<Plate<dim>> &plates);

/**
 * Returns the names of the columns on whose positions in convergence.csv programs rely. Other
 * columns follow in the order of the record's members. A release adds their names here.
 */
const std::vector<std::string> &columns_with_fixed_places();

/** Returns all columns of a record, in the order of convergence.csv. */
const Columns<LevelRecord> &level_columns();

/** Returns the value of one column; empty if it is not computed. @throws std::invalid_argument if
 * there is no such column. */
std::optional<double> value(const LevelRecord &record, const std::string &column);
} // namespace Signorini
