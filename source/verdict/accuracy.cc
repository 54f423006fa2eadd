// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about the error of the finest level, in words.

#include <signorini/verdict/accuracy.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini
{
namespace
{
/** "0.85 %"; what may be rounding has no digits. */
std::string percent(const double share)
{
  constexpr double rounding = 1e-8;
  if (share < rounding)
    return "0.000001 %";
  std::ostringstream text;
  text << std::setprecision(3) << 100. * share << " %";
  return text.str();
}

/** So many levels show whether an estimate falls. */
constexpr std::size_t enough_levels = 3;
} // namespace

std::optional<double> bound_of(const LevelRecord &level)
{
  return level.bound ? level.bound->relative : std::nullopt;
}

bool is_guaranteed(const LevelRecord &level)
{
  return bound_of(level) && level.bound->guaranteed;
}

std::optional<double> relative_error(const LevelRecord &level)
{
  if (const std::optional<double> bound = bound_of(level))
    return bound;
  return level.estimate ? std::optional<double>(level.estimate->relative) : std::nullopt;
}

std::string describe_accuracy(const std::vector<LevelRecord> &levels)
{
  const LevelRecord &finest = levels.back();
  std::ostringstream text;
  if (finest.sizes.is_graded())
  {
    if (!finest.estimate)
      return "nothing is known about the error: contact was not seen before this step";
    text << "the error is about " << percent(finest.estimate->relative)
         << " (energy norm, estimated from u_h and "
         << (levels.size() > 1 ? "from its change over the steps" : "not checked by another step")
         << ")";
    return text.str();
  }
  if (const std::optional<double> bound = bound_of(finest))
  {
    if (is_guaranteed(finest))
    {
      text << "the error is at most " << percent(*bound) << " (energy norm, guaranteed";
      if (finest.bound->post_relative)
        text << "; " << percent(*finest.bound->post_relative) << " for pi^2h u_h";
      text << ")";
    }
    else
      text << "the error is at most about " << percent(*bound)
           << " (energy norm, estimated bound; the sides are curved: geometric part "
           << percent(finest.bound->relative_geometry.value_or(0.)) << ")";
  }
  else
  {
    text << "there is no bound of the error";
    if (finest.bound)
      text << " (" << finest.bound->missing << ")";
    if (levels.size() < enough_levels)
      text << ", and with fewer than three levels the accuracy is not checked";
  }
  if (finest.estimate)
    // What is guaranteed counts more.
    text << ", about "
         << percent(std::min(finest.estimate->relative,
                             is_guaranteed(finest) ? *bound_of(finest) : finest.estimate->relative))
         << " (energy norm, estimated)";
  return text.str();
}
} // namespace Signorini
