// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/answer/answer.h>
#include <signorini/bound/error_bound.h>
#include <signorini/errors/displacement_errors.h>
#include <signorini/errors/dual_norm_errors.h>
#include <signorini/errors/lemma_numbers.h>
#include <signorini/errors/pressure_errors.h>
#include <signorini/postprocess/certificate.h>
#include <signorini/postprocess/contact_pressure.h>
#include <signorini/postprocess/error_estimate.h>
#include <signorini/record/case_summary.h>
#include <signorini/record/costs.h>
#include <signorini/record/level_sizes.h>
#include <signorini/record/motion_record.h>
#include <signorini/record/solves.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
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
