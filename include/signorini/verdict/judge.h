// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

#include <string>
#include <vector>

namespace Signorini
{
enum class Outcome
{
  /** More levels follow. */
  unfinished,
  certified,
  not_certified
};

/** The outcome as certificate.json names it: "unfinished", "certified" or "not certified". */
const char *word_for(Outcome outcome);

/** Whether the answer of a study can be trusted. */
struct StudyVerdict
{
  Outcome outcome = Outcome::unfinished;
  /** One sentence that says why the study is not certified; otherwise empty. */
  std::string reason;
  /** The largest Judge::residual_bound() of the levels. */
  double residual_bound = 0.;

  bool is_certified() const
  {
    return outcome == Outcome::certified;
  }
};

/** Decides what can be trusted: single levels, and a study. */
class Judge
{
public:
  /** @param tolerance the bound on the KKT residual of the dual problem. */
  explicit Judge(double tolerance);

  double tolerance() const
  {
    return tolerance_;
  }
  /** The bound on the certificate's residuals: a hundred times the tolerance or the rounding. */
  double residual_bound(const LevelRecord &level) const;
  /** One sentence that says why the answer of this level does not solve its equations; empty if it
   * does. */
  std::string doubt(const LevelRecord &level) const;
  /** Whether there is no doubt() about a level. */
  bool accepts(const LevelRecord &level) const
  {
    return doubt(level).empty();
  }

  /** The verdict on all levels of a study. */
  StudyVerdict verdict(const std::vector<LevelRecord> &levels) const;
  /** The verdict as long as more levels follow. */
  StudyVerdict unfinished(const std::vector<LevelRecord> &levels) const;
  /** The verdict on a study that an error has ended; @p reason is the error's message. */
  StudyVerdict failed(const std::vector<LevelRecord> &levels, const std::string &reason) const;

private:
  double largest_residual_bound(const std::vector<LevelRecord> &levels) const;

  double tolerance_;
};
} // namespace Signorini
