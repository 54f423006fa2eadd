// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>

#include <vector>

namespace Signorini {
/** A part of a curve that faces another one. */
struct FacingPart {
  /** The arc lengths of its ends; around a closed curve @p to may exceed the length (length). */
  double from, to;
  /** The smallest distance along the normals to the other curve, negative where both overlap, and
   * its arc length (length). */
  double distance, nearest;
};

/**
 * Returns the parts of @p first, sorted, from whose points x the line along the outward normal n
 * meets @p second at a point with an outward normal m, m.n < -@p least, 0 <= least < 1. On a piece
 * of each this changes only where the line goes through an end of the other piece, or where m.n =
 * -least: the parts are exact, however short they are.
 */
std::vector<FacingPart> facing_parts(const Curve &first, const Curve &second, double least);

/** The smallest -m.n at which sides count as facing each other: 60 degrees, so that both normals
 * and their mean never graze a side. */
constexpr double grazing = 0.5;

/** Returns the shortest part of @p first that contains all its parts with m.n < -grazing. These
 * must exist. */
FacingPart overlap_of(const Curve &first, const Curve &second);
} // namespace Signorini
