// SPDX-License-Identifier: LGPL-2.1-or-later
// The time that a level still takes, from the levels before it.

#include <signorini/driver/sequence/level_clock.h>

#include <cmath>

namespace Signorini {
std::string text_to_go(const double seconds) {
  constexpr double worth_telling = 5., minute = 60.;
  if (!(seconds > worth_telling))
    return "";
  const bool in_minutes = seconds > 2. * minute;
  return ", about " + std::to_string(std::lround(in_minutes ? seconds / minute : seconds)) +
         (in_minutes ? " min" : " s") + " to go";
}

void LevelClock::begin_level(const Seconds now) {
  const Seconds duration = now - start_;
  ratio_ = last_.count() > 0. && !starts_.empty() ? duration / last_ : 0.;
  last_ = starts_.empty() ? Seconds::zero() : duration;
  start_ = now;
  last_starts_ = std::move(starts_);
  starts_.clear();
}

double LevelClock::begin_stage(const std::string &stage, const Seconds now) {
  starts_.emplace(stage, now - start_);
  const auto before = last_starts_.find(stage);
  return before != last_starts_.end() ? ratio_ * (last_ - before->second).count() : 0.;
}
} // namespace Signorini
