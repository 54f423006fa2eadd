// SPDX-License-Identifier: LGPL-2.1-or-later
// The trend of a number under refinement.

#include <signorini/postprocessing/quantities/answer_vector.h>

#include <cmath>

namespace Signorini {
Trend trend_of(const std::vector<std::optional<double>> &values) {
  constexpr double small = 0.01, moderate = 0.1, slowest = 0.75;
  std::vector<double> known;
  for (const std::optional<double> &value : values)
    if (value)
      known.push_back(*value);
  Trend trend;
  if (known.size() < 2)
    return trend;
  const auto last = known.rbegin();
  const double size = std::abs(last[0]), change = last[0] - last[1];
  if (size > 0.)
    trend.change = change / size;
  const double before = known.size() > 2 ? std::abs(last[1] - last[2]) : 0.;
  const double allowed_before =
    known.size() > 3 ? std::abs(last[2] - last[3]) : 2. * moderate * size;
  const bool falls = std::abs(change) <= slowest * before && before <= allowed_before;
  const bool settled =
    std::abs(change) <= small * size || (falls && std::abs(change) <= moderate * size);
  trend.kind = settled ? Trend::Kind::settled : Trend::Kind::not_settled;
  return trend;
}

std::string word_for(const Trend::Kind kind) {
  switch (kind) {
  case Trend::Kind::settled:
    return "settled";
  case Trend::Kind::not_settled:
    return "not settled";
  case Trend::Kind::not_refined:
    return "mesh around it unchanged";
  case Trend::Kind::unlimited:
    return "grows without limit";
  default:
    return "one level only";
  }
}
} // namespace Signorini
