// SPDX-License-Identifier: LGPL-2.1-or-later
// Where contact ends, as far as the nodes of the multipliers tell.

#include <signorini/postprocess/contact_pressure.h>
#include <signorini/refinement/contact_brackets.h>

namespace Signorini
{
namespace
{
/** A node of a multiplier on its side. */
struct Node
{
  double s;
  bool presses;
};

/** The nodes of a side in the order of arc length; a closed side ends with its first node again. */
struct NodesOfSide
{
  std::vector<Node> nodes;
  bool closed = false;
};

NodesOfSide nodes_on(const unsigned int side,
                     const MultiplierSpace<2> &multipliers,
                     const dealii::Vector<double> &P)
{
  const double threshold = pressing_threshold(P);
  const std::vector<Patch<2>> &patches = multipliers.surface().patches();
  std::vector<Node> nodes;
  const Side<2> *curve = nullptr;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<2> &patch = patches[multipliers.patch_of(k)];
    if (patch.side != side)
      continue;
    curve = &multipliers.surface().side(patch);
    nodes.push_back({multipliers.node(k)[0], P[k] < threshold});
  }
  const bool closed = curve != nullptr && curve->is_closed();
  if (closed)
    nodes.push_back({nodes.front().s + curve->length(), nodes.front().presses});
  return {nodes, closed};
}
} // namespace

std::vector<ContactBracket> contact_brackets(const MultiplierSpace<2> &multipliers,
                                             const dealii::Vector<double> &P)
{
  std::vector<ContactBracket> brackets;
  unsigned int n_sides = 0;
  for (const Patch<2> &patch : multipliers.surface().patches())
    n_sides = std::max(n_sides, patch.side + 1);
  for (unsigned int side = 0; side < n_sides; ++side)
  {
    const auto [nodes, closed] = nodes_on(side, multipliers, P);
    const std::size_t first = brackets.size();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      if (nodes[i].presses == nodes[i + 1].presses)
        continue;
      if (brackets.size() > first && brackets.back().to == nodes[i].s)
        brackets.back().to = nodes[i + 1].s;
      else
        brackets.push_back({side, nodes[i].s, nodes[i + 1].s});
    }
    // The first node of a closed side is the last one, too.
    if (closed && brackets.size() > first + 1 && brackets[first].from == nodes.front().s &&
        brackets.back().to == nodes.back().s)
    {
      brackets.back().to += brackets[first].to - brackets[first].from;
      brackets.erase(brackets.begin() + first);
    }
  }
  return brackets;
}
} // namespace Signorini
