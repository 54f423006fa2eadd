// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/quantities/case_solver.h>
#include <signorini/results/verdict/judge.h>

#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace Signorini {
/** Returns the names of the columns, separated by commas. */
template <typename Row>
std::string csv_header(const Columns<Row> &columns) {
  std::string line;
  for (const Column<Row> &column : columns)
    line += (line.empty() ? "" : ",") + column.name;
  return line;
}

/** Returns the values of a row with all digits, separated by commas; unknown ones are empty. */
template <typename Row>
std::string csv_row(const Columns<Row> &columns, const Row &row) {
  std::ostringstream line;
  line << std::setprecision(16);
  const char *separator = "";
  for (const Column<Row> &column : columns) {
    line << separator;
    separator = ",";
    if (const std::optional<double> value = column.value(row))
      line << *value;
  }
  return line.str();
}

/** Prints rows of texts in aligned columns, the first @p n_left of them on the left. */
void print_columns(std::ostream &stream, const std::vector<std::vector<std::string>> &rows,
                   std::size_t n_left);

/** Writes a table of numbers with all digits. @param header the names, separated by commas. */
void write_rows(std::ostream &stream, const std::string &header,
                const std::vector<std::vector<double>> &rows);

/** Returns the line of column names of the table that grows as levels finish. @param graded whether
 * levels are steps of a graded sequence (LevelSizes::is_graded). */
std::string screen_header(bool graded = false);

/** Returns the line of a level; the order of the estimate is taken against @p before, which may be
 * null. Steps of a graded sequence have no orders. */
std::string screen_row(const LevelRecord &level, const LevelRecord *before);

/** Returns the meaning of the columns. */
std::string screen_legend(bool graded = false);

/**
 * Returns the errors that are known with their orders from level to level, and below them the
 * slopes of log(error) over log(h), least squares over the last four levels; without orders and
 * slopes for a graded sequence. Empty if nothing is known.
 */
std::string error_table(const std::vector<LevelRecord> &levels);

/** Returns the errors of nested levels that ErrorBound::distance tells, with their margins and
 * orders; empty where they are not known. */
std::string distance_table(const std::vector<LevelRecord> &levels);

/** Writes convergence.csv, all levels. */
void write_convergence_csv(std::ostream &stream, const std::vector<LevelRecord> &levels);

/** Writes certificate.json, all levels. */
void write_certificate(std::ostream &stream, const std::vector<LevelRecord> &levels,
                       const Judge &judge, const StudyVerdict &verdict);

/** Writes cases.csv: one row per load case; numbers of a case without a solution are empty. */
void write_cases_csv(std::ostream &stream, const std::vector<CaseResult> &cases);
} // namespace Signorini
