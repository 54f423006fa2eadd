// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact zones: runs of pressing patches, their ends, and the points where the pressure
// vanishes.

#include <signorini/discretization/mesh/patch_row.h>
#include <signorini/postprocessing/fields/contact_intervals.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini {
std::vector<ZoneBracket> zone_brackets(const MultiplierSpace<2> &multipliers,
                                       const std::vector<NodeState> &states) {
  std::vector<ZoneBracket> brackets;
  for (const SideNodes &side : nodes_by_side(multipliers, states))
    for (const std::vector<SideNode> &run : alternations(side)) {
      const double turn = side.closed && run.front().s >= side.length ? side.length : 0.;
      brackets.push_back({side.number, run.front().s - turn, run.back().s - turn});
    }
  std::sort(brackets.begin(), brackets.end(), [](const auto &a, const auto &b) {
    return std::tie(a.side, a.from) < std::tie(b.side, b.from);
  });
  return brackets;
}

namespace {
/** The data of a pressure that ends: the lengths of the last two patches that press, the distance
 * from the edge between them to the farthest possible end, and the ratio of the means, that of the
 * last patch over the other. */
struct EndOfPressure {
  double inner, last, farthest, ratio;
};

/**
 * Returns the distance e from the edge between both patches at which -p = c (e - x)_+^{1/2}
 * vanishes if its means have the given ratio:
 *
 *     (F(e) - F(e - last)) / last = ratio (F(e + inner) - F(e)) / inner,   F(x) = x_+^{3/2}.
 */
double root_end(const EndOfPressure &given) {
  const auto F = [](const double x) { return std::pow(std::max(x, 0.), 1.5); };
  const auto ratio = [&](const double e) {
    return (F(e) - F(e - given.last)) / given.last / ((F(e + given.inner) - F(e)) / given.inner);
  };
  // The ratio grows with e from zero.
  double low = 0., high = given.farthest;
  for (unsigned int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio(middle) < given.ratio ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/** Returns a point of a side; on a closed one the end of the side stays its end. */
BoundaryPoint point_on(const Side<2> &side, double s) {
  if (side.is_closed() && (s < 0. || s > side.length()))
    s -= side.length() * std::floor(s / side.length());
  return {side.name(), s, side.point(s)};
}

/** A patch of a side. */
struct PatchMean {
  double lower, upper, mean;
  bool presses;
};

/** Returns the patches of a side in their order, for three turns where they go around it. */
std::vector<PatchMean> patches_on(const PatchGrid &grid, const ContactSurface<2> &surface,
                                  const std::vector<NodeState> &states, const Pressure &P,
                                  const bool is_round) {
  const Side<2> &side = surface.scene().geometry.sides[grid.side];
  const int n_turns = is_round ? 1 : 0;
  std::vector<PatchMean> patches;
  for (int turn = -n_turns; turn <= n_turns; ++turn)
    for (const unsigned int tau : grid.patches) {
      const Patch<2> &patch = surface.patches()[tau];
      const double mean = P.size() > 0 ? P[tau] : 0., shift = turn * side.length();
      patches.push_back(
        {patch.lower[0] + shift, patch.upper[0] + shift, mean, states[tau].presses});
    }
  return patches;
}

/** Returns the end of a run of pressing patches; patch @p last belongs to it, and last + @p step
 * does not. */
ZoneEnd end_of_run(const Side<2> &side, const std::vector<PatchMean> &patches, const int last,
                   const int step) {
  const auto exists = [&](const int i) { return i >= 0 && i < static_cast<int>(patches.size()); };
  const PatchMean &patch = patches[last];
  const double inner_edge = step > 0 ? patch.lower : patch.upper;
  const double edge = step > 0 ? patch.upper : patch.lower;
  if (!exists(last + step))
    return {point_on(side, edge), 0.};
  const PatchMean &next = patches[last + step];
  double s = edge;
  if (exists(last - step) && patches[last - step].presses &&
      std::abs(patch.mean) < std::abs(patches[last - step].mean) && !side.has_corner(inner_edge) &&
      !side.has_corner(edge)) {
    const PatchMean &before = patches[last - step];
    s = inner_edge + step * root_end({before.upper - before.lower, patch.upper - patch.lower,
                                      std::abs(0.5 * (next.lower + next.upper) - inner_edge),
                                      patch.mean / before.mean});
  }
  const PatchMean &holder = (edge - s) * step >= 0. ? patch : next;
  return {point_on(side, s), holder.upper - holder.lower};
}

/** Adds the zones of a contact, where multipliers are constants. */
void add_zones(const PatchGrid &grid, const Side<2> &side, const std::vector<PatchMean> &patches,
               const bool is_round, std::vector<ContactZone> &zones) {
  const auto presses = [](const PatchMean &patch) { return patch.presses; };
  if (is_round && std::all_of(patches.begin(), patches.end(), presses)) {
    zones.push_back(
      {{point_on(side, 0.), 0.}, {point_on(side, side.length()), 0.}, side.length(), grid.contact});
    return;
  }
  const int n_turns = is_round ? 3 : 1, n = patches.size() / n_turns;
  const int begin = n * (n_turns / 2);
  for (int first = begin; first < begin + n; ++first)
    if (presses(patches[first]) && (first == 0 || !presses(patches[first - 1]))) {
      const auto end = std::find_if_not(patches.begin() + first, patches.end(), presses);
      const int last = static_cast<int>(end - patches.begin()) - 1;
      ContactZone zone = {end_of_run(side, patches, first, -1), end_of_run(side, patches, last, 1)};
      zone.length = zone.end.at.arc_length - zone.start.at.arc_length;
      if (zone.length < 0.) // It contains the start of a closed side.
        zone.length += side.length();
      zone.contact = grid.contact;
      zones.push_back(zone);
    }
}
} // namespace

std::vector<ContactZone> contact_zones(const MultiplierSpace<2> &multipliers,
                                       const std::vector<NodeState> &states, const Pressure &P) {
  const ContactSurface<2> &surface = multipliers.surface();
  const std::vector<Side<2>> &sides = surface.scene().geometry.sides;
  std::vector<ContactZone> zones;
  if (multipliers.is_piecewise_constant())
    for (const PatchGrid &grid : patch_grids(surface.patches())) {
      const Side<2> &side = sides[grid.side];
      const bool is_round = goes_round(side, grid.ends[0].front(), grid.ends[0].back());
      add_zones(grid, side, patches_on(grid, surface, states, P, is_round), is_round, zones);
    }
  else
    for (const PressedInterval &interval : pressed_intervals(multipliers, states)) {
      const auto end_at = [&](const PressedInterval::End &end) {
        return ZoneEnd{point_on(sides[interval.side], end.s), end.uncertainty};
      };
      zones.push_back(
        {end_at(interval.start), end_at(interval.end), interval.length(), interval.contact});
    }
  return zones;
}

std::vector<PressedArea> pressed_areas(const MultiplierSpace<3> &multipliers, const Pressure &P) {
  const std::vector<Patch<3>> &patches = multipliers.surface().patches();
  const std::vector<Neighbours<3>> neighbours = multipliers.surface().neighbours();
  const double threshold = pressing_threshold(P);
  std::vector<bool> remains(patches.size());
  for (unsigned int t = 0; t < patches.size(); ++t)
    remains[t] = P[t] < threshold;
  std::vector<PressedArea> areas;
  for (unsigned int first = 0; first < patches.size(); ++first) {
    if (!remains[first])
      continue;
    remains[first] = false;
    PressedArea &area = areas.emplace_back();
    area.patches.push_back(first);
    area.zone.contact = patches[first].contact;
    for (std::size_t i = 0; i < area.patches.size(); ++i) {
      area.zone.length += patches[area.patches[i]].measure;
      for (const auto &pair : neighbours[area.patches[i]])
        for (const auto &next : pair)
          if (next && remains[next->patch]) {
            remains[next->patch] = false;
            area.patches.push_back(next->patch);
          }
    }
  }
  return areas;
}
} // namespace Signorini
