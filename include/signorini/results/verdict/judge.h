// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/level_record.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** A residual of the certificate that must vanish. */
struct Residual {
  double value = 0.;
  /** The name in certificate.json. */
  const char *name = "";
  /** The cause of a large residual. */
  enum class Origin { equilibrium, contact, supports };
  Origin origin = Origin::equilibrium;
};

/** Returns the residuals, as far as their names tell; the last one is the balance of moments. */
std::vector<Residual> residuals(const Certificate &certificate);

/** Returns the largest of the residuals that must vanish; one that is not a number is the largest.
 */
Residual max_residual(const Certificate &certificate);

/** Returns the relative change of U or of its forces by rounding, the larger of both. */
double rounding(const LevelRecord &level);

/** Returns the bound of the relative error of u_h in the energy norm, where there is one; on curved
 * sides it is an estimated bound. */
std::optional<double> bound_of(const LevelRecord &level);
/** Returns the bound that is conditional, with Coulomb's law, relative in the energy norm. */
std::optional<double> conditional_bound_of(const LevelRecord &level);
/** Returns the reason why there is no bound, a clause; empty where it was not wanted. */
std::string why_no_bound(const LevelRecord &level);

/** Returns whether there is a bound that is guaranteed. */
bool is_guaranteed(const LevelRecord &level);

/** Returns whether the bound on a graded mesh is many times the estimate: rounding, or data that no
 * mesh resolves, is most of it. */
bool bound_exceeds_mesh(const LevelRecord &level);

/** Returns that bound, or else the estimated relative error in the energy norm. */
std::optional<double> relative_error(const LevelRecord &level);

/** Returns half a sentence about the error of the finest level: its bound and its estimate, or why
 * there is no bound and whether the estimate was checked. */
std::string describe_accuracy(const std::vector<LevelRecord> &levels);

enum class Outcome {
  /** More levels follow. */
  unfinished,
  /** The equations are solved, and the guaranteed bound of the error is tolerated. */
  certified,
  /** The equations are solved, and the estimated error is tolerated; there is no guaranteed bound
   * for such a scene. */
  equations_certified,
  /** The equations are solved, and the estimated error is tolerated, on a graded mesh. */
  accuracy_estimated,
  /** The equations are solved, but the error may be larger than the tolerated one. */
  not_resolved,
  /** The equations are not solved. */
  not_certified
};

/** Returns the outcome as certificate.json names it: "certified", "not resolved" and so on. */
const char *word_for(Outcome outcome);

/** The verdict on a study: whether its answer can be trusted. */
struct StudyVerdict {
  Outcome outcome = Outcome::unfinished;
  /** The reason why the study is not certified, and the remedy; otherwise empty. */
  std::string reason;
  /** Half a sentence about the error of the finest level; empty if nothing is known about it. */
  std::string accuracy;
  /** The largest Judge::residual_bound() of the levels. */
  double residual_bound = 0.;

  /** Returns whether the equations are solved, however far the mesh is from the solution. */
  bool equations_hold() const {
    return is_certified() || outcome == Outcome::not_resolved;
  }
  /** Returns whether the program ends with the exit code 0. */
  bool is_certified() const {
    return outcome == Outcome::certified || outcome == Outcome::equations_certified ||
           outcome == Outcome::accuracy_estimated;
  }
};

/** The demands of the user on an answer. */
struct Demands {
  /** The tolerance of the KKT residual of the dual problem. */
  double tolerance = 1e-10;
  /** The tolerated relative error in the energy norm: its bound, or else its estimate. */
  double tolerated_error = 0.2;
  /** The target of the same error for a study that refines until it is reached; 0: none. */
  double target_error = 0.;
  /** Whether graded meshes can solve the scene, too. */
  bool can_be_graded = false;
  /** Whether there is Element = Q1 B-bar. */
  bool has_b_bar = true;
  /** Whether the user has set the target. Where one that the user has not set is missed, a
   * guaranteed bound that is tolerated still certifies. */
  bool target_is_given = true;
};

/** Decides whether single levels and a study can be trusted. */
struct Judge {
  explicit Judge(const Demands &demands)
    : demands(demands) {}

  const Demands demands;

  /** Returns whether refinement may stop at this level because it reaches the target error, and a
   * bound that is conditional is tolerated. */
  bool reaches_target(const LevelRecord &level) const;
  /** Returns the bound on the certificate's residuals: a hundred times the tolerance, but at most
   * one per cent, or a hundred times the rounding. */
  double residual_bound(const LevelRecord &level) const;
  /** Returns one sentence with the reason why the answer of this level does not solve its
   * equations; empty if it does. */
  std::string doubt(const LevelRecord &level) const;
  /** Returns whether there is no doubt() about a level. */
  bool accepts(const LevelRecord &level) const {
    return doubt(level).empty();
  }

  /** Returns the verdict on all levels of a study. */
  StudyVerdict verdict(const std::vector<LevelRecord> &levels) const;
  /** Returns the verdict as long as more levels follow. */
  StudyVerdict unfinished(const std::vector<LevelRecord> &levels) const;
  /** Returns the verdict on a study that an error has ended; @p reason is the error's message. */
  StudyVerdict failed(const std::vector<LevelRecord> &levels, const std::string &reason) const;

  /** Returns the largest bound on the residuals of a level. */
  double max_residual_bound(const std::vector<LevelRecord> &levels) const;
};
} // namespace Signorini
