// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displaced_body.h>
#include <signorini/error_control/reference/reference_stress.h>
#include <signorini/error_control/verify/foreign_works.h>
#include <signorini/postprocessing/quantities/answer.h>

#include <optional>
#include <vector>

namespace Signorini {
/** A support or a contact side as v sees it. */
struct VerifiedSide {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  bool is_support = false;
  /** On a support the largest v - u_D, on a roller its normal part, and its position (length). */
  Tensor<1, 2> miss;
  Point<2> at;
  /** The sum of the residual forces of its nodes, with the moduli of the scene, and of their
   * moments about the origin (force per thickness); contact has those of nodes that no support
   * holds. */
  Tensor<1, 2> force;
  double moment = 0.;
  /** The force again with other weights: the same where v is in balance. */
  Tensor<1, 2> other;
};

/** The displacement v of another program against the solution u of a scene. */
struct Verification {
  /** |||v - u|||, and |||u|||. */
  WithMargin error, norm;
  /** Whether u is the solution for the bound f |τ_n| of Coulomb's law, see ReferenceStress. */
  bool is_conditional = false;
  double strain = 0., load = 0.;
  /** The area of the cells. */
  double area = 0.;
  /** The α for which α v is nearest to u, and its distance. */
  double factor = 1., factor_distance = 0.;
  std::vector<VerifiedSide> sides;
  /** The largest v.m - g at 33 points of every edge; none without contact. */
  std::optional<Penetration> penetration;
  /** The norms |||v - u_h|||_K by cell, by points. */
  std::vector<double> cells;
  /** The number of the largest one, and the middle of that cell. */
  unsigned int largest_cell = 0;
  Point<2> middle_of_largest;
  /** v - u_h by node of the field; NaN where a node was not found in the mesh of u_h. */
  std::vector<Tensor<1, 2>> differences;

  /** Returns the root of the sum of squares of all cells, which is the error up to the points. */
  double sum_of_cells() const;
};

/**
 * Compares v with u by the distance to a stress in equilibrium, and cell by cell with a solution
 * u_h that is much nearer to u than v is.
 *
 * With B = 1/2 (|||v|||² + |||u|||² - |||v - u|||²), the product of v and u, the best factor is
 * B/|||v|||² and its distance (|||u|||² - B²/|||v|||²)^{1/2}. @throws InputError where g has no
 * value.
 */
Verification verify(const ForeignField &field, const DisplacedBody<2> &solution,
                    const ReferenceStress &reference);
} // namespace Signorini
