// SPDX-License-Identifier: LGPL-2.1-or-later
// Where nodes of multipliers press.

#include <signorini/postprocess/contact_pressure.h>
#include <signorini/postprocess/side_nodes.h>

namespace Signorini
{
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers,
                                     const dealii::Vector<double> &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  std::vector<SideNodes> sides;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<2> &patch = surface.patches()[multipliers.patch_of(k)];
    if (sides.empty() || sides.back().number != patch.side)
    {
      const Side<2> &side = surface.side(patch);
      sides.push_back({patch.side, side.length(), side.is_closed(), {}});
    }
    sides.back().nodes.push_back({multipliers.node(k)[0], P[k] < threshold});
  }
  return sides;
}
} // namespace Signorini
