// SPDX-License-Identifier: LGPL-2.1-or-later
// Means of p_H, interpolated between the middles of patches.

#include <signorini/postprocessing/fields/recovered_pressure.h>

#include <optional>

namespace Signorini {
template <int dim>
RecoveredPressure<dim>::RecoveredPressure(const MultiplierSpace<dim> &space, const Pressure &P)
  : space_(space)
  , P_(P)
  , neighbours_(space.surface().neighbours()) {
  const std::vector<Patch<dim>> &patches = space.surface().patches();
  for (unsigned int tau = 0; tau < patches.size(); ++tau)
    means_.push_back(space.value(P, tau, patches[tau].centre()));
}

template <int dim>
double RecoveredPressure<dim>::interpolate(const unsigned int patch, const Point<dim - 1> &s,
                                           const unsigned int n_directions) const {
  if (n_directions == 0)
    return means_[patch];
  const unsigned int d = n_directions - 1;
  const double middle = space_.surface().patches()[patch].centre()[d];
  const auto &[before, after] = neighbours_[patch][d];
  const std::optional<Neighbour> &next = (s[d] < middle && before) || !after ? before : after;
  const double value = interpolate(patch, s, d);
  if (!next)
    return value;
  const double share = (s[d] - middle) / (next->middle() - middle);
  return value + share * (interpolate(next->patch, s, d) - value);
}

template class RecoveredPressure<2>;
template class RecoveredPressure<3>;
} // namespace Signorini
