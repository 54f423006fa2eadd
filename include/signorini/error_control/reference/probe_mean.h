// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>

namespace Signorini {
/**
 * The means of σ(u_h) over the part P of a body in a disc, a box or a region, and of u_h on a side.
 *
 * By Gauss' formula ∫_P ∂u_i/∂x_j = ∫_∂P u_i n_j: only lines are integrated. ∂P is cut where it
 * meets edges of cells, at roots of polynomials, and on each part Gauss' rule is applied to a
 * smooth function. Moduli have to be the same everywhere in P.
 */
struct ProbeMean {
  /** Why there is no mean, one sentence; mostly empty. */
  std::string missing;
  /** The mean stress (force/area), or in the first row of a tensor the mean displacement. */
  Tensor<2, 2> value;
  /** Bounds of the errors of its components by quadrature: the difference of two rules, and 1e-9 of
   * the size, as no position is known better. */
  Tensor<2, 2> margin;
  /** The area of P or the length of the side. */
  double measure = 0.;
  /** Hooke's tensor in P (force/area). */
  SymmetricTensor<4, 2> hooke;
};

ProbeMean mean_stress(const DisplacedBody<2> &body, const Probe<2> &probe);
ProbeMean mean_displacement(const DisplacedBody<2> &body, unsigned int side);
} // namespace Signorini
