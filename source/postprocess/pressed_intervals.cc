// SPDX-License-Identifier: LGPL-2.1-or-later
// Where contact ends between the nodes of multipliers.

#include <signorini/postprocess/pressed_intervals.h>
#include <signorini/postprocess/side_nodes.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** The nodes around a closed side, the first one again at the end; they begin where two neighbours
 * are of the same kind, if there are such. */
std::vector<SideNode> once_around(const SideNodes &side)
{
  const std::size_t n = side.nodes.size();
  std::size_t first = 0;
  while (first + 1 < n && side.nodes[first].presses != side.nodes[(first + n - 1) % n].presses)
    ++first;
  std::vector<SideNode> nodes;
  for (std::size_t i = first; i <= first + n; ++i)
    nodes.push_back({side.nodes[i % n].s + (i < n ? 0. : side.length), side.nodes[i % n].presses});
  return nodes;
}

/** An end of contact, and whether contact begins or ends there. */
struct Change
{
  PressedInterval::End end;
  bool begins;
};

/** Between nodes i and j, the second of which presses if contact begins. */
Change between(const std::vector<SideNode> &nodes, const std::size_t i, const std::size_t j)
{
  return {{0.5 * (nodes[i].s + nodes[j].s), 0.5 * (nodes[j].s - nodes[i].s)}, nodes[j].presses};
}

std::vector<Change> find_changes(const std::vector<SideNode> &nodes)
{
  std::vector<Change> changes;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    const std::size_t first = i;
    while (i + 1 < nodes.size() && nodes[i].presses != nodes[i + 1].presses)
      ++i;
    if (i == first)
      continue;
    // From here on nodes i and i + 1 are of the same kind.
    if (nodes[first].presses != nodes[i].presses)
      changes.push_back(between(nodes, first, i));
    else
    {
      changes.push_back(between(nodes, first, first + 1));
      changes.push_back(between(nodes, i - 1, i));
    }
  }
  return changes;
}

std::vector<PressedInterval> intervals_of(const SideNodes &side)
{
  const auto presses = [](const SideNode &node) { return node.presses; };
  if (std::none_of(side.nodes.begin(), side.nodes.end(), presses))
    return {};
  if (std::all_of(side.nodes.begin(), side.nodes.end(), presses))
    return {{side.number, {0., 0.}, {side.length, 0.}}};
  std::vector<Change> changes = find_changes(side.closed ? once_around(side) : side.nodes);
  if (side.closed && !changes.front().begins)
  {
    // The interval that contains the first node.
    Change last = changes.front();
    last.end.s += side.length;
    changes.erase(changes.begin());
    changes.push_back(last);
  }
  if (!side.closed && side.nodes.front().presses)
    changes.insert(changes.begin(), {{0., 0.}, true});
  if (!side.closed && side.nodes.back().presses)
    changes.push_back({{side.length, 0.}, false});
  std::vector<PressedInterval> intervals;
  for (std::size_t i = 0; i + 1 < changes.size(); i += 2)
  {
    const double turn = changes[i].end.s < side.length ? 0. : side.length;
    intervals.push_back({side.number, changes[i].end, changes[i + 1].end});
    intervals.back().start.s -= turn;
    intervals.back().end.s -= turn;
  }
  std::sort(intervals.begin(), intervals.end(), [](const auto &a, const auto &b) {
    return a.start.s < b.start.s;
  });
  return intervals;
}
} // namespace

std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const dealii::Vector<double> &P)
{
  std::vector<PressedInterval> intervals;
  for (const SideNodes &side : nodes_by_side(multipliers, P))
  {
    const std::vector<PressedInterval> of_side = intervals_of(side);
    intervals.insert(intervals.end(), of_side.begin(), of_side.end());
  }
  return intervals;
}
} // namespace Signorini
