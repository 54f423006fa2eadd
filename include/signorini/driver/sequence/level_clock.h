// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace Signorini {
/** Returns ", about 12 s to go"; nothing below five seconds. */
std::string text_to_go(double seconds);

/**
 * Predicts how long a level goes on. A level takes r times as long as the one before, where r is
 * the ratio of the last two levels, and so does each of its stages.
 */
class LevelClock {
public:
  using Seconds = std::chrono::duration<double>;

  /** Begins a level at a time since any origin. */
  void begin_level(Seconds now);
  /** Begins a stage. @return the seconds from there to the end of the level; zero as long as that
   * is not known: on the first two levels, and in a stage that the level before did not have. */
  double begin_stage(const std::string &stage, Seconds now);

private:
  Seconds start_ = Seconds::zero();
  /** The duration of the last level, and r. */
  Seconds last_ = Seconds::zero();
  double ratio_ = 0.;
  /** The starts of the stages of this level and of the last one, from the start of their level. */
  std::map<std::string, Seconds> starts_, last_starts_;
};
} // namespace Signorini
