// SPDX-License-Identifier: LGPL-2.1-or-later
// A pressure at the nodes of another mesh.

#include <signorini/refinement/pressure_transfer.h>

#include <algorithm>

namespace Signorini
{
dealii::Vector<double> transfer_pressure(const MultiplierSpace<2> &from,
                                         const dealii::Vector<double> &P,
                                         const MultiplierSpace<2> &to)
{
  const std::vector<Patch<2>> &known = from.surface().patches();
  dealii::Vector<double> transferred(to.n_multipliers());
  std::size_t patch = 0;
  for (unsigned int k = 0; k < transferred.size(); ++k)
  {
    const unsigned int side = to.surface().patches()[to.patch_of(k)].side;
    const dealii::Point<1> s = to.node(k);
    // Patches and nodes are sorted by side and arc length.
    while (patch + 1 < known.size() && (known[patch].side < side || (known[patch].side == side &&
                                                                     known[patch].upper[0] < s[0])))
      ++patch;
    if (known[patch].side == side)
      transferred[k] = std::min(0., from.value(P, patch, s));
  }
  return transferred;
}
} // namespace Signorini
