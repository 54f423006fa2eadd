// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/singular_edges.h>
#include <signorini/postprocessing/quantities/von_mises.h>

#include <functional>
#include <optional>

namespace Signorini {
/** A largest contact pressure, positive in compression (force/area). */
struct PressureMaximum {
  double value = 0.;
  BoundaryPoint at;
  /** The mean of -p_H over the patch on which the peak lies. */
  double mean = 0.;
  /** The patch on which the peak lies. */
  MeshAt mesh;
};

/** The largest contact pressure. */
struct PeakPressure : PressureMaximum {
  /** The edge where the exact value is infinite, if there is one: the value then depends only on
   * how fine the mesh is. */
  std::optional<GrowthEdge> grows_at;
  /** The largest pressure away from all SingularEdge, where there are any and something presses.
   */
  std::optional<PressureMaximum> away;
};

/**
 * Returns the maximum, outside of given edges and on the patches that @p belong (all without it),
 * of a pressure that is recovered from the means over
 * patches; empty if nothing presses. Where both neighbours of a patch press, the recovered pressure
 * is the parabola with the means of the three patches, elsewhere RecoveredPressure. Both are of
 * second order. Where patches have polynomials, the maximum is the largest value of -p_H on the
 * patches that press.
 *
 * In 3-D, where all four neighbours press, it is the sum of the parabolas in both coordinates of
 * the patch, less its mean. At the edge of the side to a roller the mirror image is the neighbour,
 * if the material is its own mirror image.
 */
template <int dim>
std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<dim> &multipliers,
                                             const Pressure &P,
                                             const std::vector<SingularEdge<dim>> &outside_of = {},
                                             const std::function<bool(unsigned int)> &belong = {});
} // namespace Signorini
