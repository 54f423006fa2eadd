// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier.h>

#include <algorithm>
#include <vector>

namespace Signorini {
/**
 * A continuous pressure of second order, recovered from the means of p_H over the patches and cut
 * off at zero.
 *
 * In 2-D it is piecewise linear through the middles of the patches of a side, continued to its ends
 * (around a closed side). In 3-D it is bilinear between the centres of four patches of a side,
 * continued to its edges. Where patches have polynomials, it is p_H itself, cut off at zero.
 */
template <int dim>
class RecoveredPressure {
public:
  RecoveredPressure(const MultiplierSpace<dim> &space, const Pressure &P);

  /** Returns the value at the point @p s of the side to which @p patch belongs; @p patch contains
   * it. */
  double operator()(unsigned int patch, const Point<dim - 1> &s) const {
    return std::min(0., without_sign(patch, s));
  }
  /** Returns the same without the cut. */
  double without_sign(unsigned int patch, const Point<dim - 1> &s) const {
    return space_.is_piecewise_constant() ? interpolate(patch, s) : space_.value(P_, patch, s);
  }

private:
  /** Returns the mean of a patch with the changes towards the middles of neighbours, linear in each
   * coordinate. */
  double interpolate(unsigned int patch, const Point<dim - 1> &s) const;

  const MultiplierSpace<dim> &space_;
  Pressure P_;
  std::vector<Neighbours<dim>> neighbours_;
  /** The means of the patches. */
  std::vector<double> means_;
};
} // namespace Signorini
