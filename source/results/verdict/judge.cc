// SPDX-License-Identifier: LGPL-2.1-or-later
// The judge: the rounding and the residuals of a level, the error of the finest one in words, and
// the verdict.

#include <signorini/base/text.h>
#include <signorini/results/verdict/judge.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Signorini {
std::vector<Residual> residuals(const Certificate &certificate) {
  using Origin = Residual::Origin;
  const Certificate &c = certificate;
  std::vector<Residual> all = {{c.stationarity, "stationarity", Origin::equilibrium},
                               {c.penetration, "penetration", Origin::contact},
                               {c.sign, "sign", Origin::contact},
                               {c.complementarity, "complementarity", Origin::contact},
                               {c.duality_gap, "duality_gap", Origin::contact},
                               {c.force_balance, "force_balance", Origin::equilibrium},
                               {c.motion_balance, "motion_balance", Origin::contact},
                               {c.support, "support", Origin::supports}};
  if (c.dissipation_balance)
    all.push_back({*c.dissipation_balance, "dissipation_balance", Origin::contact});
  all.push_back({c.moment_balance, "moment_balance", Origin::equilibrium});
  return all;
}

Residual max_residual(const Certificate &certificate) {
  std::vector<Residual> all = residuals(certificate);
  if (!certificate.moments_are_exact)
    all.pop_back();
  Residual largest;
  for (const Residual &residual : all) {
    if (std::isnan(residual.value))
      return residual;
    if (residual.value > largest.value)
      largest = residual;
  }
  return largest;
}

double rounding(const LevelRecord &level) {
  return std::max(level.linear.rounding_error, level.certificate.rounding);
}

namespace {
/** Returns "0.85 %"; a share that may be rounding has no digits. */
std::string percent(const double share) {
  constexpr double rounding = 1e-8;
  if (share < rounding)
    return "0.000001 %";
  std::ostringstream text;
  text << std::setprecision(3) << 100. * share << " %";
  return text.str();
}

/** The number of levels that shows whether an estimate falls. */
constexpr std::size_t min_trend_levels = 3;
} // namespace

std::optional<double> bound_of(const LevelRecord &level) {
  return level.bound && !level.bound->is_conditional ? level.bound->relative : std::nullopt;
}

std::optional<double> conditional_bound_of(const LevelRecord &level) {
  return level.bound && level.bound->is_conditional ? level.bound->relative : std::nullopt;
}

std::string why_no_bound(const LevelRecord &level) {
  const std::optional<double> conditional = conditional_bound_of(level);
  if (!conditional)
    return level.bound ? level.bound->missing : "";
  return "with Coulomb's law it is conditional, at most " + percent(*conditional) +
         " if friction carried at most f times the computed pressure";
}

bool is_guaranteed(const LevelRecord &level) {
  return bound_of(level) && level.bound->is_guaranteed();
}

bool bound_exceeds_mesh(const LevelRecord &level) {
  constexpr double many = 5.;
  return level.sizes.is_graded() && bound_of(level) && level.estimate &&
         *bound_of(level) > many * level.estimate->relative;
}

std::optional<double> relative_error(const LevelRecord &level) {
  if (const std::optional<double> bound = bound_of(level))
    return bound;
  return level.estimate ? std::optional<double>(level.estimate->relative) : std::nullopt;
}

std::string describe_accuracy(const std::vector<LevelRecord> &levels) {
  Assert(!levels.empty(), ExcMessage("The accuracy is that of a level."));
  const LevelRecord &finest = levels.back();
  std::ostringstream text;
  if (finest.tangential && !finest.tangential->is_regular.value_or(true))
    text << "this is one of at least two solutions of the discrete problem; ";
  if (finest.sizes.is_graded() && !bound_of(finest)) {
    if (!finest.estimate)
      return "nothing is known about the error: contact was not seen before this step";
    text << "the error is about " << percent(finest.estimate->relative)
         << " (energy norm, estimated from u_h and "
         << (levels.size() > 1 ? "from its change over the steps" : "not checked by another step")
         << ")";
    if (const std::string reason = why_no_bound(finest); !reason.empty())
      text << "; there is no bound: " << reason;
    return text.str();
  }
  if (const std::optional<double> bound = bound_of(finest)) {
    if (is_guaranteed(finest) && finest.bound->distance) {
      const ErrorBound &known = *finest.bound;
      const double scale = 100. * *known.relative / *known.absolute;
      text << "the error is "
           << text_with_margin(scale * *known.distance, scale * *known.margin, " %")
           << " (energy norm, guaranteed)";
      if (known.post_distance)
        text << "; that of the recovered displacement (smoothed over blocks of 2 x 2 cells) is "
             << text_with_margin(scale * *known.post_distance, scale * *known.post_margin, " %");
      return text.str();
    }
    if (is_guaranteed(finest)) {
      text << "the error is at most " << percent(*bound) << " (energy norm, guaranteed)";
    } else
      text << "the error is at most about " << percent(*bound)
           << " (energy norm, estimated bound: " << finest.bound->only_estimated << ")";
  } else {
    text << "there is no bound of the error";
    if (const std::string reason = why_no_bound(finest); !reason.empty())
      text << " (" << reason << ")";
    if (levels.size() < min_trend_levels)
      text << ", and with fewer than three levels the accuracy is not checked";
  }
  if (finest.estimate && !finest.sizes.is_graded())
    // A guaranteed bound counts more than an estimate.
    text << ", about "
         << percent(std::min(finest.estimate->relative,
                             is_guaranteed(finest) ? *bound_of(finest) : finest.estimate->relative))
         << " (energy norm, estimated)";
  return text.str();
}

const char *word_for(const Outcome outcome) {
  switch (outcome) {
  case Outcome::unfinished:
    return "unfinished";
  case Outcome::certified:
    return "certified";
  case Outcome::equations_certified:
    return "equations certified";
  case Outcome::accuracy_estimated:
    return "equations certified, accuracy estimated";
  case Outcome::not_resolved:
    return "not resolved";
  default:
    return "not certified";
  }
}

bool Judge::reaches_target(const LevelRecord &level) const {
  const std::optional<double> error = relative_error(level);
  return error && *error < demands.target_error &&
         conditional_bound_of(level).value_or(0.) <= demands.tolerated_error;
}

double Judge::residual_bound(const LevelRecord &level) const {
  // A residual is a difference of terms that are larger than itself; five digits are necessary.
  constexpr double max_rounding_bound = 1e-5;
  const double rounding_bound = std::min(100. * rounding(level), max_rounding_bound);
  // Direct solves and sums over all cells lose some digits of their own, and so do other measures
  // of contact than the KKT residual. No tolerance makes an imbalance of one per cent a balance.
  const double tolerance_bound = std::min(100. * demands.tolerance, 0.01);
  return std::max({1e-8, tolerance_bound, rounding_bound});
}

double Judge::max_residual_bound(const std::vector<LevelRecord> &levels) const {
  double bound = residual_bound(LevelRecord());
  for (const LevelRecord &level : levels)
    bound = std::max(bound, residual_bound(level));
  return bound;
}

StudyVerdict Judge::unfinished(const std::vector<LevelRecord> &levels) const {
  return {Outcome::unfinished, "", "", max_residual_bound(levels)};
}

StudyVerdict Judge::failed(const std::vector<LevelRecord> &levels,
                           const std::string &reason) const {
  return {Outcome::not_certified, reason, "", max_residual_bound(levels)};
}
} // namespace Signorini
