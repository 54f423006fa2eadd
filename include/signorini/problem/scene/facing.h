// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>

#include <utility>
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
 * meets @p second at a point with an outward normal m, m.n < -@p least, 0 <= least < 1, and its
 * circle nowhere nearer: the back of a disc does not face what lies behind it. On a piece of each
 * this changes only where the line goes through an end of the other piece, where m.n = -least, or
 * where both points of a circle are equally far: the parts are exact, however short they are.
 */
std::vector<FacingPart> facing_parts(const Curve &first, const Curve &second, double least);

/** The smallest -m.n at which sides count as facing each other: 60 degrees, so that both normals
 * and their mean never graze a side. */
constexpr double grazing = 0.5;

/** Returns those of facing_parts() from which @p second is seen: at some point of them the line
 * meets no body of the geometry on its way. A disc between two rings sees each of them on one side.
 */
std::vector<FacingPart> seen_parts(const Curve &first, const Curve &second, double least,
                                   const Geometry<2> &geometry);

/** Returns the arc lengths on @p second of the points across from both ends of a part of @p first.
 * Around a closed curve both lie within half a turn of the point across from its middle. */
std::pair<double, double> part_across(const Curve &first, const Curve &second, double from,
                                      double to);

/** Returns the shortest part of a curve that contains all of some parts of it; there are any. */
FacingPart hull_of(const Curve &curve, const std::vector<FacingPart> &parts);
} // namespace Signorini
