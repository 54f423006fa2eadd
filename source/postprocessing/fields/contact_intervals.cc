// SPDX-License-Identifier: LGPL-2.1-or-later
// The ends of contact between the nodes of multipliers.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/patch_row.h>
#include <signorini/postprocessing/fields/contact_intervals.h>

#include <algorithm>

namespace Signorini {
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers,
                                     const std::vector<NodeState> &states) {
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<SideNodes> sides;
  for (unsigned int k = 0; k < states.size(); ++k) {
    const Patch<2> &patch = surface.patches()[multipliers.patch_of(k)];
    if (sides.empty() || sides.back().contact != patch.contact)
      sides.push_back({patch.contact,
                       patch.side,
                       surface.side(patch).length(),
                       patch.lower[0],
                       patch.upper[0],
                       false,
                       {}});
    sides.back().to = patch.upper[0];
    sides.back().closed = goes_round(surface.side(patch), sides.back().from, sides.back().to);
    sides.back().nodes.push_back({multipliers.node(k)[0], states[k]});
  }
  return sides;
}

std::vector<std::vector<SideNode>> alternations(const SideNodes &side) {
  const auto same_kind = [](const SideNode &a, const SideNode &b) { return a.state == b.state; };
  std::vector<SideNode> nodes = side.nodes;
  if (side.closed) {
    const auto same = std::adjacent_find(nodes.begin(), nodes.end(), same_kind);
    if (same != nodes.end()) {
      for (auto node = nodes.begin(); node <= same; ++node)
        node->s += side.length;
      std::rotate(nodes.begin(), same + 1, nodes.end());
    }
    nodes.push_back({nodes.front().s + side.length, nodes.front().state});
  }
  std::vector<std::vector<SideNode>> runs;
  for (auto first = nodes.begin(), last = first; first != nodes.end(); first = last) {
    last = std::adjacent_find(first, nodes.end(), same_kind);
    last += last == nodes.end() ? 0 : 1;
    if (last - first > 1)
      runs.emplace_back(first, last);
  }
  return runs;
}

namespace {
/** An end of contact, and whether contact begins or ends there. */
struct Change {
  PressedInterval::End end;
  bool begins;
};

/** Returns the change between two nodes, the second of which presses if contact begins. */
Change between(const SideNode &first, const SideNode &second) {
  return {{0.5 * (first.s + second.s), 0.5 * (second.s - first.s)}, second.state.presses};
}

std::vector<PressedInterval> intervals_of(const SideNodes &side) {
  const auto presses = [](const SideNode &node) { return node.state.presses; };
  if (std::none_of(side.nodes.begin(), side.nodes.end(), presses))
    return {};
  if (std::all_of(side.nodes.begin(), side.nodes.end(), presses))
    return {{side.contact, side.number, {side.from, 0.}, {side.to, 0.}}};
  std::vector<Change> changes;
  for (const std::vector<SideNode> &run : alternations(side))
    if (run.front().state != run.back().state)
      changes.push_back(between(run.front(), run.back()));
    else {
      changes.push_back(between(run[0], run[1]));
      changes.push_back(between(run[run.size() - 2], run.back()));
    }
  if (side.closed && !changes.front().begins) {
    // The interval that contains the first node.
    std::rotate(changes.begin(), changes.begin() + 1, changes.end());
    changes.back().end.s += side.length;
  }
  if (!side.closed && presses(side.nodes.front()))
    changes.insert(changes.begin(), {{side.from, 0.}, true});
  if (!side.closed && presses(side.nodes.back()))
    changes.push_back({{side.to, 0.}, false});
  std::vector<PressedInterval> intervals;
  for (std::size_t i = 0; i + 1 < changes.size(); i += 2) {
    const double turn = side.closed && changes[i].end.s >= side.length ? side.length : 0.;
    intervals.push_back({side.contact, side.number, changes[i].end, changes[i + 1].end});
    intervals.back().start.s -= turn;
    intervals.back().end.s -= turn;
  }
  std::sort(intervals.begin(), intervals.end(),
            [](const auto &a, const auto &b) { return a.start.s < b.start.s; });
  return intervals;
}
} // namespace

std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const std::vector<NodeState> &states) {
  std::vector<PressedInterval> intervals;
  for (const SideNodes &side : nodes_by_side(multipliers, states)) {
    const std::vector<PressedInterval> side_data = intervals_of(side);
    intervals.insert(intervals.end(), side_data.begin(), side_data.end());
  }
  return intervals;
}

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space, const Pressure &P) {
  ContactSummary summary;
  const double threshold = pressing_threshold(P);
  const dealii::Vector<double> integrals = space.integrals(), lengths = space.lengths();
  for (unsigned int k = 0; k < P.size(); ++k) {
    summary.normal_force -= P[k] * integrals[k];
    summary.max_pressure = std::max(summary.max_pressure, -P[k]);
    if (!(P[k] < threshold))
      continue;
    ++summary.active;
    if (space.is_piecewise_constant())
      summary.length += lengths[k];
  }
  if constexpr (dim == 2)
    if (!space.is_piecewise_constant())
      for (const PressedInterval &interval : pressed_intervals(space, Multiplier(P).states()))
        summary.length += interval.length();
  return summary;
}

Columns<ContactSummary> ContactSummary::columns() {
  return {{"active", &ContactSummary::active},
          {"contact_force_n", &ContactSummary::normal_force},
          {"max_pressure", &ContactSummary::max_pressure},
          {"contact_length", &ContactSummary::length}};
}

INSTANTIATE_FUNCTION(summarise_contact);
} // namespace Signorini
