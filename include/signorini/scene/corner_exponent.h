// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
/** What holds an edge of the body next to a corner. */
enum class EdgeSupport
{
  /** The traction is given. */
  free,
  /** Both components of u are given. */
  held,
  /** u.n and the shear are given: rollers, or frictionless contact that is closed. */
  sliding
};

/** What corner_exponent() returns where no term is rougher. */
constexpr double largest_corner_exponent = 3.;

/**
 * The smallest Re lambda > 0 of the solutions r^lambda v(theta) of -sigma_ij,j = 0 between two
 * straight edges with homogeneous conditions that are no polynomials, and at most
 * largest_corner_exponent. The equations are (W1) to (W6) of doc/formulas.md.
 *
 * Integer lambda are left out: their solutions are polynomials, rigid motions among them. The
 * result therefore jumps where a root passes through an integer. It can be close to zero: between
 * sliding edges it is |pi/angle - 1| near a straight angle.
 *
 * Loads that do not fit together at the corner, say different shears on two free edges at a right
 * angle, may add r^n or r^n log r with an integer n >= 1. The exponent does not know of them.
 *
 * @param angle the opening inside the body, 0 < angle <= 2 pi (radians).
 * @param kappa Kolosov's constant, at least 1: see kolosov_constant().
 */
double corner_exponent(double angle, EdgeSupport first, EdgeSupport second, double kappa);

/**
 * Kolosov's constant (lambda + 3 mu)/(lambda + mu) of Hooke's tensor, in any unit: 3 - 4 nu in
 * plane strain, (3 - nu)/(1 + nu) in plane stress. An anisotropic tensor is replaced by its mean
 * over all rotations in the plane, which is the isotropic tensor nearest to it in the sum of
 * squares of E_ijkl. The exponents of such a body are then approximations.
 */
double kolosov_constant(const dealii::SymmetricTensor<4, 2> &hooke);
} // namespace Signorini
