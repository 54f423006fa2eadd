// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/verdict/judge.h>

#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
/** Columns of the table on the screen, with the widths that keep it aligned. */
class ScreenTable
{
public:
  /** @param with_displacement_errors, with_pressure_errors whether those columns will be filled. */
  ScreenTable(bool with_displacement_errors, bool with_pressure_errors);

  /** The line of column names. */
  std::string header() const;
  /** The line of a level; orders are taken against @p before, which may be null. */
  std::string row(const LevelRecord &level, const LevelRecord *before) const;

private:
  bool with_displacement_errors_;
  bool with_pressure_errors_;
};

/** convergence.csv, all levels. */
void write_convergence_csv(std::ostream &stream, const std::vector<LevelRecord> &levels);

/** convergence.md: sizes, errors with their orders, or estimates, bound and contact force, as far
 * as they are known. */
void write_convergence_markdown(std::ostream &stream, const std::vector<LevelRecord> &levels);

/** convergence.tex: the same as a LaTeX tabular. */
void write_convergence_latex(std::ostream &stream, const std::vector<LevelRecord> &levels);

/** certificate.json, all levels. */
void write_certificate(std::ostream &stream,
                       const std::vector<LevelRecord> &levels,
                       const Judge &judge,
                       const StudyVerdict &verdict);
} // namespace Signorini
