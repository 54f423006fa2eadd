// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/level_record.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** The trend of a maximum over the levels, and that of the maximum away from all SingularEdge. */
struct MaximumTrends {
  Trend all, away;
};

/** The answer of the finest level, with the trends of its maxima over the levels. */
struct AnswerSummary {
  /** @param levels at least one; they must outlive the summary. */
  explicit AnswerSummary(const std::vector<LevelRecord> &levels);

  const LevelRecord &level;
  MaximumTrends peak_pressure, von_mises;
  /** The trends of the fields of each report. */
  std::vector<std::vector<Trend>> reports;
  /** The ratio of the friction force to the normal force; empty where nothing presses. */
  std::optional<double> tangential_ratio;
  /** The wall seconds of all levels. */
  double seconds = 0.;
};

/** Returns the coordinates, displacements and stresses of a report at a single point, with their
 * names; nothing for other reports. */
std::vector<std::pair<std::string, double>> values_at_point(const ProbeReport &report,
                                                            unsigned int dimension);
} // namespace Signorini
