// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/error_control/bound/error_bound.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/postprocessing/errors/errors.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/load_cases/case_solver.h>
#include <signorini/postprocessing/quantities/answer.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/methods/contact_method.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** How large the problem of one level is. */
struct LevelSizes
{
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

  /** Returns whether the mesh is a step of a sequence of graded meshes. There h alone does not tell
   * how fine a mesh is, and errors have no orders in h. */
  bool is_graded() const
  {
    return strategy == Strategy::hp;
  }
  /** Returns what the mesh is called on the screen. */
  const char *word() const
  {
    return is_graded() ? "step" : "level";
  }

  static Columns<LevelSizes> columns();
};

/** Where a plate is, and what holds it there. */
struct PlateRecord
{
  std::string side;
  Plate plate;
  PlateMotion motion;
  /** What acts on the body through the plate: along its direction, and about its centre; from the
   * nodal forces, also where they are given. */
  double force = 0.;
  double moment = 0.;
};

/** What moves freely, and how far it has moved. */
struct MotionRecord
{
  std::vector<PlateRecord> plates;
  /** Rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;

  /** Of the first plate. */
  static Columns<MotionRecord> columns();
};

/** How the load cases of a level went. */
struct CaseSummary
{
  unsigned int n_cases = 0;
  /** Cases in which nothing stops the body. */
  unsigned int n_escapes = 0;
  /** The first case whose dual problem was not solved, from 1; 0: none. */
  unsigned int first_failure = 0;
  /** The largest KKT residual of a case with a solution. */
  double max_kkt = 0.;
  /** Wall seconds of all cases. */
  double seconds = 0.;
};

CaseSummary summarise(const std::vector<CaseResult> &cases, double seconds);

/** What is known about a level: one row of convergence.csv. What a scene does not have, or what the
 * user did not ask for, is empty. */
struct LevelRecord
{
  LevelSizes sizes;
  LinearSolves linear;
  DualSolve dual;
  ContactSummary contact;
  Answer answer;
  MotionRecord motions;
  Certificate certificate;
  std::optional<ErrorEstimate> estimate;
  /** Where it was asked for. */
  std::optional<ErrorBound> bound;
  /** The constant of Lemma 1. */
  std::optional<double> inf_sup;
  /** See locking_number(); on the finest level only. */
  std::optional<double> locking_number;

  std::optional<DisplacementErrors> displacement_errors;
  std::optional<PressureErrors> pressure_errors;
  std::optional<DualNormErrors> dual_norm_errors;
  /** See contact_end_error() (length). */
  std::optional<double> endpoint_error;
  std::optional<LemmaNumbers> lemmas;
  /** On the finest level, if there are load cases. */
  std::optional<CaseSummary> load_cases;

  StageTimes times;
  Resources resources;
};

/**
 * The names of the columns whose places in convergence.csv programs rely on. Other columns follow
 * in the order of the record's members. A release adds their names here.
 */
const std::vector<std::string> &columns_with_fixed_places();

/** All columns of a record, in the order of convergence.csv. */
const Columns<LevelRecord> &level_columns();

/** The value of one column, empty if it is not known. @throws std::invalid_argument if there is no
 * such column. */
std::optional<double> value(const LevelRecord &record, const std::string &column);
} // namespace Signorini
