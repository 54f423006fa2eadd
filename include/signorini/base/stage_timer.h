// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

namespace Signorini
{
/**
 * Adds the wall seconds of its life to a number. A timer that starts within another one's life
 * stops that one meanwhile: the time of a stage within a stage counts once.
 */
class StageTimer
{
public:
  explicit StageTimer(double &seconds)
    : seconds_(seconds)
    , outer_(innermost)
  {
    if (outer_ != nullptr)
      outer_->stop();
    innermost = this;
    start_ = Clock::now();
  }
  ~StageTimer()
  {
    stop();
    innermost = outer_;
    if (outer_ != nullptr)
      outer_->start_ = Clock::now();
  }
  StageTimer(const StageTimer &) = delete;
  StageTimer &operator=(const StageTimer &) = delete;

private:
  using Clock = std::chrono::steady_clock;

  void stop()
  {
    seconds_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }

  /** The timer that runs on this thread. */
  static inline thread_local StageTimer *innermost = nullptr;

  double &seconds_;
  StageTimer *outer_;
  Clock::time_point start_;
};

/** What @p stage returns; its wall seconds are added to @p seconds. */
template <typename Stage>
auto timed(double &seconds, const Stage &stage)
{
  const StageTimer timer(seconds);
  return stage();
}
} // namespace Signorini
