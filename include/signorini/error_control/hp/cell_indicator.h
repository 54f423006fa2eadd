// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>

#include <vector>

namespace Signorini {
/** The error and the smoothness of u_h on a cell, from its coefficients. */
struct CellIndicator {
  /** An approximation of the energy norm of the error on the cell, (force length)^{1/2}. */
  double error = 0.;
  /** The factor by which the error falls when the degree grows by one: near 0 where u is analytic,
   * near 1 where it is singular. */
  double decay = 0.;
  /** The part of a bound that comes from loads which no stress on the cell balances exactly,
   * whatever its degree; zero as long as there is no bound. */
  double oscillation = 0.;
};

/**
 * Returns the indicator of every active cell, in their order.
 *
 * On a cell of degree p let s_i be the part of the derivative of u_h along a reference coordinate
 * that has Legendre's degree i in that coordinate, i = 0, ..., p - 1, measured in the energy norm.
 * A line through the last log s_i gives the decay ρ and the first part that is missing, s_p. The
 * missing parts amount to s_p (1 + ρ² + rho⁴ + ...)^{1/2}. The indicator steers the mesh; it is
 * not a bound. (Decay of Legendre coefficients as a measure of smoothness: C. Mavriplis, Comput.
 * Methods Appl. Mech. Eng. 116 (1994) 77-86; P. Houston, E. Suli, ibid. 194 (2005) 229-243.)
 */
std::vector<CellIndicator> indicate(const DisplacedBody<2> &body);

/** Returns the root of the sum of the squares of errors and oscillations. */
double total(const std::vector<CellIndicator> &indicators);
} // namespace Signorini
