// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>

#include <optional>
#include <vector>

namespace Signorini
{
/**
 * The estimated error of one step after the other, (force length)^{1/2}.
 *
 * The distance d_k between the solutions of steps k and k - 1 is about the error of step k - 1,
 * which is many times that of step k. By how much, three numbers tell: the ratio of the indicators,
 * r = eta_k/eta_{k-1}; what the mesh was planned for, q; and how much the error fell in the step
 * before, d_k/d_{k-1}, as far as the indicators do not contradict:
 *
 *     estimate_k = 4/3 max(eta_k, d_k min(1, max(r, q, min(d_k/d_{k-1}, 4 r)))).
 *
 * It is reliable as long as the error falls in step k as the indicator says, or as planned.
 */
class ErrorHistory
{
public:
  /**
   * @param indicator eta_k.
   * @param difference d_k; empty for the first step.
   * @param planned q.
   * @return the estimate of the step.
   */
  double add(double indicator, const std::optional<double> &difference, double planned);

  std::size_t n_steps() const
  {
    return estimates_.size();
  }
  /** Whether the estimates of the last steps do not fall: the solution has no finite energy, or the
   * mesh cannot be refined further where it is singular. A number that overflows stagnates. */
  bool stagnates() const;

private:
  std::vector<double> estimates_;
  std::optional<double> last_indicator_, last_difference_;
};

/** u_h and the space that it belongs to. */
struct StepField
{
  const DisplacementSpace<2> &space;
  const NodalVector &U;
};

/**
 * |||u_h - v_h||| for functions on two meshes that come from the same mesh by splitting cells,
 * integrated on the finer cell wherever one lies in the other; (force length)^{1/2}. Where curved
 * cells are split, the maps of both cells are taken for the same.
 */
double energy_distance(const StepField &u, const StepField &v, const Scene<2> &scene);
} // namespace Signorini
