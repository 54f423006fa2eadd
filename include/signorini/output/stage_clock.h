// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

namespace Signorini
{
/** Measures stages that follow one another (wall seconds). */
class StageClock
{
public:
  /** Seconds since the construction or the last lap. */
  double lap()
  {
    const double seconds = timer_.wall_time();
    timer_.restart();
    return seconds;
  }
  void add_to(double &seconds)
  {
    seconds += lap();
  }

private:
  dealii::Timer timer_;
};
} // namespace Signorini
