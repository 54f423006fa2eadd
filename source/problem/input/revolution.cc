// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane state = axisymmetric: the body beside its axis x = 0.

#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>

#include <algorithm>
#include <cmath>

#include "input.h"

namespace Signorini {
namespace {
double rounding_of(const Geometry<2> &geometry) {
  return 1e-10 * geometry.diameter();
}

/** Returns the ends of all sides on the axis. */
std::vector<Point<2>> ends_on_axis(const Geometry<2> &geometry) {
  std::vector<Point<2>> ends;
  for (const Side<2> &side : geometry.sides)
    if (geometry.is_axis(side))
      ends.insert(ends.end(), {side.point(0.), side.point(side.length())});
  return ends;
}

/** Refuses a side that is not the axis, but touches it inside, or where no side on the axis begins.
 */
void refuse_touching(const Side<2> &side, const std::vector<Point<2>> &ends,
                     const Geometry<2> &geometry, const Entry &plane_state) {
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const double share : {0., 0.5, 1.}) {
      const Point<2> x = side.piece(k).point(share * side.piece(k).length());
      const auto is_here = [&](const Point<2> &end) {
        return x.distance(end) <= rounding_of(geometry);
      };
      if (x[0] <= rounding_of(geometry) && std::none_of(ends.begin(), ends.end(), is_here))
        throw error_at(plane_state, "the side '", side.name(), "' touches the axis at y = ",
                       std::abs(x[1]) <= rounding_of(geometry) ? 0. : x[1],
                       ", allowed: sides that lie on the axis, or meet it where such a side ends.");
    }
}
} // namespace

void revolve(const Given<PlaneState> &given, Geometry<2> &geometry) {
  geometry.axisymmetric = given == PlaneState::axisymmetric;
  if (!geometry.axisymmetric)
    return;
  if (geometry.lower[0] < -rounding_of(geometry))
    throw error_at(given, "found '", to_text(given.value),
                   "' with a body that begins at x = ", geometry.lower[0],
                   ", allowed: bodies with x >= 0, the distance from the axis.");
  const std::vector<Point<2>> ends = ends_on_axis(geometry);
  for (const Side<2> &side : geometry.sides)
    if (!geometry.is_axis(side))
      refuse_touching(side, ends, geometry, given);
}

void hold_on_axis(const std::vector<const Entry *> &entries, Scene<2> &scene) {
  for (unsigned int i = 0; i < entries.size(); ++i)
    if (scene.geometry.is_axis(scene.geometry.sides[i])) {
      Role &role = scene.boundary[i].role;
      if (entries[i] != nullptr && role != Role::roller)
        throw error_at(*entries[i], "the side '", scene.geometry.sides[i].name(),
                       "' lies on the axis of the body of revolution, allowed: no entry for it.");
      role = Role::roller;
    }
  for (const Plate<2> &plate : scene.plates)
    if (scene.geometry.axisymmetric &&
        (plate.turns || plate.drifts || std::abs(plate.direction[0]) > 0.))
      throw error_at(*entries[plate.side], "the plate '", scene.geometry.sides[plate.side].name(),
                     "' turns or leaves the axis of the body of revolution, allowed: the "
                     "direction 0, 1 or 0, -1.");
}
} // namespace Signorini
