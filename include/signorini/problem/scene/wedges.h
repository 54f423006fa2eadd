// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace Signorini {
/** The support of an edge of the body next to a corner. */
enum class EdgeSupport {
  /** The traction is given. */
  free,
  /** Both components of u are given, or frictional contact sticks. */
  held,
  /** u.n and the shear are given: rollers, or closed contact that slips. */
  sliding
};

/** The homogeneous conditions on an edge. */
struct EdgeCondition {
  EdgeSupport support = EdgeSupport::free;
  /** With Coulomb's friction on a sliding edge the ratio q/p of tractions along the tangent, which
   * is the outward normal turned counter-clockwise, and along the normal; else zero. */
  double ratio = 0.;
};

/** A part of a wedge with one isotropic material. */
struct WedgeLayer {
  /** The opening (radians), Kolosov's constant, and the shear modulus in any unit. */
  double angle, kappa, shear_modulus;
};

/** Returns the opening of all layers (radians). */
double opening(const std::vector<WedgeLayer> &layers);

/** The largest value that corner_exponent() returns. */
constexpr double max_corner_exponent = 3.;

/**
 * Returns the smallest Re lambda > 0, at most max_corner_exponent, of the solutions r^lambda
 * v(theta) of -sigma_ij,j = 0 between two straight edges with homogeneous conditions that are not
 * polynomials. The equations are (W1) to (W6) of doc/formulas.md.
 *
 * Integer lambda are left out: their solutions are polynomials, rigid motions among them. The
 * result therefore jumps where a root passes through an integer. It can be close to zero: between
 * sliding edges it is |pi/angle - 1| near a straight angle.
 *
 * Loads that do not fit together at the corner, say different shears on two free edges at a right
 * angle, may add r^n or r^n log r with an integer n >= 1. The exponent does not include these.
 *
 * @param angle the opening inside the body, 0 < angle <= 2 pi (radians).
 * @param kappa Kolosov's constant, at least 1: that of make_layer().
 */
double corner_exponent(double angle, EdgeSupport first, EdgeSupport second, double kappa);

/**
 * Returns the same for a wedge of several materials, the first of them next to the first edge, and
 * for edges with friction. Then it is at most 1, which it is where stresses are bounded: roots of
 * (W7) in doc/formulas.md are not sought further on.
 */
double corner_exponent(const std::vector<WedgeLayer> &layers, const EdgeCondition &first,
                       const EdgeCondition &second);

/** Two wedges, counter-clockwise one after the other, that slip on their common edge. */
struct SlippingWedges {
  std::vector<WedgeLayer> first, second;
  /** The ratio q/p of the tractions on the common edge, as in EdgeCondition. */
  double ratio = 0.;
};

/** Returns the same for two wedges with the outer edges @p first and @p second: on the common edge
 * u_theta and both tractions are continuous, and q = ratio p. */
double corner_exponent(const SlippingWedges &wedges, const EdgeCondition &first,
                       const EdgeCondition &second);
} // namespace Signorini
