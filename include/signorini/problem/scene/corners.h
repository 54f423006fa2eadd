// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <string>
#include <vector>

namespace Signorini {
/** The support of an edge of the body next to a corner. */
enum class EdgeSupport {
  /** The traction is given. */
  free,
  /** Both components of u are given. */
  held,
  /** u.n and the shear are given: rollers, or frictionless contact that is closed. */
  sliding
};

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
 * @param kappa Kolosov's constant, at least 1: see kolosov_constant().
 */
double corner_exponent(double angle, EdgeSupport first, EdgeSupport second, double kappa);

/** Returns the smallest exponent in all states of contact that sides with these roles may have. */
double min_corner_exponent(double angle, Role first, Role second, double kappa);

/**
 * Returns Kolosov's constant (lambda + 3 mu)/(lambda + mu) of Hooke's tensor, in any unit: 3 - 4 nu
 * in plane strain, (3 - nu)/(1 + nu) in plane stress. An anisotropic tensor is replaced by its mean
 * over all plane rotations, which is the isotropic tensor nearest to it in the sum of squares of
 * E_ijkl. The exponents of such a body are then approximations.
 */
double kolosov_constant(const SymmetricTensor<4, 2> &hooke);

/** A point where two sides of a 2-D body meet, also at a straight angle, or where one side has a
 * corner (Curve::corners()). */
struct Corner {
  Point<2> position;
  /** The angle between the tangents inside the body, 0 < angle <= 2 pi (radians). */
  double angle;
  /** The numbers of the two sides. Counter-clockwise about the corner the first one comes before
   * the body, the second one after it. They are equal inside of a side. */
  std::array<unsigned int, 2> sides;
};

/** Returns all corners of a body, in the order of their first sides. Ends of sides are one point if
 * they are closer than 1e-8 diameters; closed sides have no ends. */
std::vector<Corner> corners(const Geometry<2> &geometry);

/** Returns how a side of this role may be supported at its ends: a contact side is free or sliding,
 * all others have one support. */
std::vector<EdgeSupport> possible_supports(Role role);

/**
 * Returns the smallest exponent at a corner of the scene, over the states of contact sides, with
 * the material at the corner. At a straight angle between contact sides one state may be open and
 * the other closed, which gives 1/2. The inequalities of (1) exclude this root where the gap is
 * smooth, and leave 3/2.
 */
double corner_exponent(const Scene<2> &scene, const Corner &corner);

/**
 * Returns a sentence about a place where two sides that meet prescribe a displacement that jumps,
 * so that no displacement of finite energy (with traces in H^{1/2}) obeys both, or where a side
 * holds a plate that a force or a moment has to move; empty if there is no such place.
 *
 * At a common point x a clamped or prescribed side or a plate prescribes u = a(x) + V q, with the
 * unknown motions q of the plate, and its neighbour prescribes N u = N (b(x) + W r): N = 1 on sides
 * of the same kind and N = n^T on rollers. Both hold for all q and r if N a = N b, N V = 0 and N
 * W = 0. In 2-D the points are the corners, in 3-D they are points of the common edges. Jumps below
 * a millionth of the prescribed displacements count as rounding. A contact
 * side beside a prescribed one needs a.n <= g at the common point.
 */
template <int dim>
std::string find_contradiction(const Scene<dim> &scene);
} // namespace Signorini
