// SPDX-License-Identifier: LGPL-2.1-or-later
// Means of p_H, interpolated between the middles of patches.

#include <signorini/postprocessing/fields/recovered_pressure.h>

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
double RecoveredPressure<dim>::interpolate(const unsigned int patch,
                                           const Point<dim - 1> &s) const {
  const Point<dim - 1> centre = space_.surface().patches()[patch].centre();
  double value = means_[patch];
  for (unsigned int d = 0; d < dim - 1; ++d) {
    const auto &[before, after] = neighbours_[patch][d];
    if (const auto &next = (s[d] < centre[d] && before) || !after ? before : after)
      value +=
        (s[d] - centre[d]) / (next->middle() - centre[d]) * (means_[next->patch] - means_[patch]);
  }
  return value;
}

template class RecoveredPressure<2>;
template class RecoveredPressure<3>;
} // namespace Signorini
