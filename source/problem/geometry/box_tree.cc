// SPDX-License-Identifier: LGPL-2.1-or-later
// A tree of boxes.

#include <signorini/problem/geometry/box_tree.h>

#include <queue>

namespace Signorini {
namespace {
/** A box that may still be divided. */
struct Open {
  unsigned int node;
  BoundingBox<2> box;
  std::array<unsigned int, 2> halvings;
};

/** Returns the direction in which a box is divided next: the one with fewer halvings; 2 if there is
 * none. */
unsigned int next_direction(const Open &open, const std::array<bool, 2> &wanted,
                            const unsigned int most) {
  unsigned int found = 2;
  for (unsigned int d = 0; d < 2; ++d)
    if (wanted[d] && open.halvings[d] < most &&
        (found == 2 || open.halvings[d] < open.halvings[found]))
      found = d;
  return found;
}

/** Returns whether the interior of a box meets the part before and the one behind a line. */
std::array<bool, 2> halves_met(const KinkLine<2> &line, const BoundingBox<2> &box) {
  const unsigned int d = line.normal[0] == 0. ? 1 : 0;
  const double margin = 1e-10 * box.side_length(d);
  return {
    {box.lower_bound(d) < line.position - margin, box.upper_bound(d) > line.position + margin}};
}
} // namespace

BoxTree::BoxTree(const BoundingBox<2> &body, const Look &look, const IsSmooth &is_smooth,
                 const unsigned int max_looks) {
  std::queue<Open> open;
  open.push({0, body, {{0, 0}}});
  unsigned int n_deep_looks = 0;
  for (unsigned int n_looks = 0; !open.empty(); open.pop()) {
    const Open whole = open.front();
    unsigned int d = next_direction(whole, {{true, true}}, first_halvings);
    const bool asks = d == 2;
    if (asks) {
      const auto [varies, matters, hidden] = look(whole.box);
      if (n_looks++ < max_looks)
        d = next_direction(whole, varies, max_halvings);
      if (d == 2 && matters && n_looks < max_looks && n_deep_looks++ < max_deep_looks)
        d = next_direction(whole, varies, deepest_halvings);
      nodes_[whole.node].is_rough = varies[0] || varies[1];
      nodes_[whole.node].hidden = hidden;
    }
    if (d == 2)
      continue;
    nodes_[whole.node] = {{Point<2>::unit_vector(d), whole.box.center()[d]},
                          static_cast<unsigned int>(nodes_.size()),
                          asks};
    for (unsigned int part = 0; part < 2; ++part) {
      Open half = {static_cast<unsigned int>(nodes_.size()),
                   half_of(whole.box, nodes_[whole.node], part), whole.halvings};
      ++half.halvings[d];
      nodes_.emplace_back();
      open.push(half);
    }
  }
  join(0, body, is_smooth);
}

BoundingBox<2> BoxTree::half_of(const BoundingBox<2> &box, const Node &node,
                                const unsigned int half) {
  auto [lower, upper] = box.get_boundary_points();
  (half == 0 ? upper : lower)[node.line.normal[0] == 0. ? 1 : 0] = node.line.position;
  return BoundingBox<2>({lower, upper});
}

bool BoxTree::join(const unsigned int node, const BoundingBox<2> &box, const IsSmooth &is_smooth) {
  if (nodes_[node].parts == 0)
    return false;
  const std::array<unsigned int, 2> parts = {{nodes_[node].parts, nodes_[node].parts + 1}};
  bool is_divided = false, is_rough = false;
  double hidden = 0.;
  for (unsigned int half = 0; half < 2; ++half) {
    is_divided |= join(parts[half], half_of(box, nodes_[node], half), is_smooth);
    is_rough |= nodes_[parts[half]].is_rough;
    hidden += 0.5 * nodes_[parts[half]].hidden;
  }
  if (is_divided || (nodes_[node].is_asked_for && (is_rough || !is_smooth(box))))
    return true;
  nodes_[node].parts = 0;
  nodes_[node].is_rough = is_rough;
  nodes_[node].hidden = hidden;
  return false;
}

bool BoxTree::divides(const BoundingBox<2> &box, const unsigned int skipped,
                      const unsigned int node) const {
  const auto &[line, parts, is_asked_for, is_rough, hidden] = nodes_[node];
  if (parts == 0)
    return false;
  const auto [before, behind] = halves_met(line, box);
  if (before && behind && is_asked_for && skipped == 0)
    return true;
  const unsigned int rest = is_asked_for && skipped > 0 ? skipped - 1 : skipped;
  return (before && divides(box, rest, parts)) || (behind && divides(box, rest, parts + 1));
}

template <typename Condition>
bool BoxTree::any_met(const BoundingBox<2> &box, const unsigned int node,
                      const Condition &holds) const {
  const auto &[line, parts, is_asked_for, is_rough, hidden] = nodes_[node];
  if (parts == 0)
    return holds(nodes_[node]);
  const auto [before, behind] = halves_met(line, box);
  return (before && any_met(box, parts, holds)) || (behind && any_met(box, parts + 1, holds));
}

bool BoxTree::shows_some(const BoundingBox<2> &box) const {
  return any_met(box, 0, [](const Node &node) { return !node.is_rough; });
}

bool BoxTree::hides_some(const BoundingBox<2> &box) const {
  return any_met(box, 0, [](const Node &node) { return node.is_rough; });
}

unsigned int BoxTree::n_met(const BoundingBox<2> &box, const unsigned int most) const {
  unsigned int n = 0;
  any_met(box, 0, [&](const Node &) { return ++n >= most; });
  return n;
}
} // namespace Signorini
