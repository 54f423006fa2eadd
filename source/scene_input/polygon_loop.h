// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/side.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
struct PolygonVertex
{
  dealii::Point<2> x;
  /** The radius that rounds the corner; 0: none. */
  double fillet;
  /** In the list of the parameter file. */
  unsigned int number;
};

struct PolygonArc
{
  dealii::Point<2> centre;
  bool counter_clockwise;
};

struct PolygonEdge
{
  /** None: a segment. */
  std::optional<PolygonArc> arc;
  /** In the list of the parameter file. */
  unsigned int number;
};

/** Edge i joins vertex i with the next. */
struct PolygonLoop
{
  std::vector<PolygonVertex> vertices;
  std::vector<PolygonEdge> edges;
};

/**
 * The sides of a loop in a row with the body on the left: @p is_outer tells whether it lies inside
 * of the loop. Lists in the other direction are turned round; names keep the numbers of the list.
 * @throws InputError if an arc does not fit its ends or a fillet its edges.
 */
std::vector<Side<2>> sides_of(const PolygonLoop &loop, bool is_outer, const std::string &where);
} // namespace Signorini
