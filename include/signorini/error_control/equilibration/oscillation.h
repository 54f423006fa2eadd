// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/bound_data.h>
#include <signorini/error_control/equilibration/cell_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Signorini {
/** A traction r on an edge that has neither force nor moment: its norm, and those of F' and F,
 * where F'' = r along the edge and F = F' = 0 at both ends. */
struct TractionRest {
  double norm = 0., slope = 0., primitive = 0.;

  /** Returns a rest of which the norm alone is known, on an edge of this length: by Wirtinger ‖F'‖
   * ≤ L/(2 π) ‖r‖, and by the clamped beam ‖F‖² ≤ L⁴/500.56 ‖r‖². */
  static TractionRest of_norm(double norm, double length);
};

/**
 * The constants for loads r on a cell K and r_e on its edges that have neither force nor moment.
 * There is, with Hooke's tensor E, a stress τ_r on K with div τ_r + r = 0 and the tractions r_e
 * on the edges, and
 *
 * ‖τ_r‖_{E⁻¹,K} ≤ (body ‖r‖_K + Σ_e edge_e ‖r_e‖_e)/sqrt(c),   e:E:e ≥ c e:e on K.
 *
 * The least such norm is, by duality, the largest value of (∫_K r.v + Σ_e ∫_e
 * r_e.v)/‖v‖_{E,K} for v in H^1(K)². A rigid motion may be subtracted from v: the load does no
 * work on it. Choose its rotation such that the curl of v has the mean zero on K, its translation
 * such that v has the mean zero, on K or on a triangle in it. Then
 *
 * 1. ‖grad v‖_K ≤ korn ‖ε(v)‖_K with korn² = 1 + 2/β². For ω = (d_1 v_2 - d_2 v_1)/2 the
 * derivatives are those of strains, grad ω = (d_1 e_12 - d_2 e_11, d_1 e_22 - d_2 e_12), so
 * that its norm in H⁻¹ is at most ‖ε(v)‖; as ω has the mean zero, β ‖ω‖ ≤ ‖grad
 * ω‖_{-1}; and ‖grad v‖² = ‖ε‖² + 2 ‖ω‖². A convex K inside of the disc of radius R about
 * a point and around the disc of radius ρ about it has β ≥ (ρ/(sqrt(2) R)) (1 + (1 -
 * ρ²/R²)^{1/2})^{-1/2} (Costabel and Dauge, Arch. Ration. Mech. Anal. 217 (2015) 873-898, Theorem
 * 2.3).
 * 2. ‖v‖_K ≤ (h_K/π) ‖grad v‖_K (Payne and Weinberger, 1960; K is convex). Where r is orthogonal to
 * polynomials of degree n, v may lose those, too. On an interval of length h, Legendre's equation
 * gives ‖v - Π_m v‖ ≤ h/(2 ((m + 1) (m + 2))^{1/2}) ‖v'‖. On a parallelogram, the image of [0,1]²
 * under a map with the matrix J, the polynomials of degree n contain the products of degree m =
 * floor(n/2) in each direction. Their projection is that in one direction after the other, so that
 * ‖v - Π v‖_K ≤ |J|_2/(2 ((m + 1) (m + 2))^{1/2}) ‖grad v‖_K.
 * A cell with an arc need not be convex. Then β is that of the largest disc from which all of K is
 * seen, and in a strip of width w, ‖v‖_K ≤ (w/(π β)) ‖grad v‖_K: ‖v‖ ≤ ‖grad v‖_{-1}/β for v with
 * the mean zero, and the inequality of Friedrichs.
 * 3. On the triangle T = conv(e, P) with another corner P of K, or the crossing of the diagonals:
 * (x - P).n is 2|T|/|e| on e and zero on the two other edges, so that (2|T|/|e|) ‖v‖_e² = ∫_T
 * div((x - P) |v|²) ≤ 2 ‖v‖_T² + 2 l ‖v‖_T ‖grad v‖_T with l = max_T |x - P|, and ‖v‖_T ≤ (h_T/π)
 * ‖grad v‖_T.
 *
 * Normal tractions r_e n on an edge with right or obtuse angles at both ends need neither: with x
 * along e, y inwards and a rectangle [0,L] x [0,d] in K, Airy's function F(x) ψ(y/d) with F'' =
 * r_e, ψ(s) = (1 - s)² (1 + 2 s) has F = F' = 0 at both ends, as r_e has neither force nor
 * moment; its stress (F ψ''/d², F'' ψ, -F' ψ'/d) has the traction r_e n on e and none on the
 * three other edges of the rectangle, outside of which it is continued by zero. The square of its
 * norm is
 *
 *     13/35 d ‖r_e‖² + 12/(5 d) ‖F'‖² + 12/d³ ‖F‖²,
 *
 * of which the best d is known. What jumps or is singular within the edge has much smaller F' and F
 * than a wave as long as the edge.
 */
struct OscillationConstants {
  /** @param degree n: the body force is orthogonal to polynomials up to this degree. */
  OscillationConstants(const CellShape &shape, unsigned int degree);

  double korn;
  double body;
  /** The constants for tractions in any direction. */
  std::array<double, 4> edge;
  /** Returns the norm for a normal traction on an edge. */
  double normal(unsigned int k, const TractionRest &rest) const;

private:
  /** The depths of the largest rectangles on the edges, zero where there is none. */
  std::array<double, 4> depths_;
};
} // namespace Signorini
