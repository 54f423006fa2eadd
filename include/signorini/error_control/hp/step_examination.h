// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/hp/next_plan.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/methods/solved.h>

#include <optional>
#include <vector>

namespace Signorini {
/**
 * The estimated errors of the steps, one after the other, (force length)^{1/2}.
 *
 * The distance d_k between the solutions of steps k and k - 1 is about the error of step k - 1,
 * which is many times that of step k. Three numbers show by how much: the ratio of the indicators,
 * r = η_k/η_{k-1}; the factor q by which the mesh was planned to reduce the error; and the factor
 * of the step before, d_k/d_{k-1}, as far as the indicators do not contradict. The last one takes
 * the place of q as soon as it is known:
 *
 *     estimate_k = 4/3 max(η_k, d_k min(1, max(r, min(d_k/d_{k-1}, 4 r)))).
 *
 * It is reliable as long as the error falls in step k as the indicator says, or as in the step
 * before.
 */
class ErrorHistory {
public:
  /**
   * Adds step k.
   * @param indicator η_k.
   * @param difference d_k; empty for the first step.
   * @param planned q.
   * @return the estimate of the step.
   */
  double add(double indicator, const std::optional<double> &difference, double planned);

  std::size_t n_steps() const {
    return estimates_.size();
  }
  /** Returns whether the estimates of the last steps do not fall: the solution has no finite
   * energy, or the mesh cannot be refined further where it is singular. A number that overflows
   * stagnates. */
  bool stagnates() const;
  /** Returns whether the last estimate is below nine tenths of the one before. */
  bool falls() const;

private:
  std::vector<double> estimates_;
  std::optional<double> last_indicator_, last_difference_;
};

/** Returns |||u_h - v_h||| for functions on two meshes that come from the same mesh by splitting
 * cells; (force length)^{1/2}. It is integrated on the finer cell wherever one lies in the other.
 * Where curved cells are split, the maps of both cells are assumed to agree. The energy is that in
 * the scene of @p u. */
double energy_distance(const DisplacedBody<2> &u, const DisplacedBody<2> &v);

/** Examines the steps of a graded sequence one after the other. */
class StepExamination {
public:
  /** @param target the relative error that is aimed at. */
  explicit StepExamination(const double target)
    : target_(target) {}

  /**
   * Computes the indicators, the brackets of the ends of zones and the estimated error of a step.
   * @param before the solution of the step before; empty for the first.
   * @param planned the factor by which the mesh was planned to reduce the error.
   * @throws InputError where g has no value.
   */
  StepFindings examine(const Solved<2> &solved, const EnergyScale &scale,
                       const std::optional<DisplacedBody<2>> &before, double planned);

  /** Returns whether the estimates do not fall any more, see ErrorHistory. */
  bool stagnates() const {
    return history_.stagnates();
  }
  /** Returns whether the estimate of this step is smaller than that of the step before. */
  bool falls() const {
    return history_.falls();
  }
  /** Returns whether forces press a plate into the foundation at a corner of a contact side. They
   * do so on every mesh, because no displacement of finite energy solves such a scene. The first
   * steps are not asked: their travel is inaccurate.
   * @param scene with the plates where they have moved. */
  bool plates_penetrate(Scene<2> scene) const;
  /** Returns whether a second mesh confirms the error. Bodies that nothing deforms need none. */
  bool is_checked(const StepFindings &findings) const {
    return history_.n_steps() > 1 || findings.error == 0.;
  }

private:
  double target_;
  ErrorHistory history_;
};
} // namespace Signorini
