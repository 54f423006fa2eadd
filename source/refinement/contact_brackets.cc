// SPDX-License-Identifier: LGPL-2.1-or-later
// Where contact ends, as far as the nodes of the multipliers tell.

#include <signorini/postprocess/side_nodes.h>
#include <signorini/refinement/contact_brackets.h>

namespace Signorini
{
std::vector<ContactBracket> contact_brackets(const MultiplierSpace<2> &multipliers,
                                             const dealii::Vector<double> &P)
{
  std::vector<ContactBracket> brackets;
  for (SideNodes side : nodes_by_side(multipliers, P))
  {
    std::vector<SideNode> &nodes = side.nodes;
    if (side.closed)
      nodes.push_back({nodes.front().s + side.length, nodes.front().presses});
    const std::size_t first = brackets.size();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      if (nodes[i].presses == nodes[i + 1].presses)
        continue;
      if (brackets.size() > first && brackets.back().to == nodes[i].s)
        brackets.back().to = nodes[i + 1].s;
      else
        brackets.push_back({side.number, nodes[i].s, nodes[i + 1].s});
    }
    // The first node of a closed side is the last one, too.
    if (side.closed && brackets.size() > first + 1 && brackets[first].from == nodes.front().s &&
        brackets.back().to == nodes.back().s)
    {
      brackets.back().to += brackets[first].to - brackets[first].from;
      brackets.erase(brackets.begin() + first);
    }
  }
  return brackets;
}
} // namespace Signorini
