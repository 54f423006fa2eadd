// SPDX-License-Identifier: LGPL-2.1-or-later
// p_H: resultants, recovery, transfer between partitions.

#include <signorini/postprocess/contact_pressure.h>
#include <signorini/postprocess/pressed_intervals.h>

#include <algorithm>

namespace Signorini
{
double pressing_threshold(const dealii::Vector<double> &P)
{
  return P.size() == 0 ? 0. : -1e-12 * P.linfty_norm();
}

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space, const dealii::Vector<double> &P)
{
  ContactSummary summary;
  const double threshold = pressing_threshold(P);
  const dealii::Vector<double> integrals = space.integrals();
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    summary.normal_force -= P[k] * integrals[k];
    summary.max_pressure = std::max(summary.max_pressure, -P[k]);
    if (!(P[k] < threshold))
      continue;
    ++summary.active;
    if (space.is_piecewise_constant())
      summary.length += integrals[k];
  }
  if constexpr (dim == 2)
    if (!space.is_piecewise_constant())
      for (const PressedInterval &interval : pressed_intervals(space, P))
        summary.length += interval.length();
  return summary;
}

template <>
RecoveredPressure<2>::RecoveredPressure(const MultiplierSpace<2> &space,
                                        const dealii::Vector<double> &P)
  : space_(space)
  , surface_(space.surface())
  , P_(P)
{
  for (unsigned int tau = 0; tau < surface_.patches().size(); ++tau)
    means_.push_back(space.value(P, tau, surface_.patches()[tau].centre()));
}

template <>
RecoveredPressure<2>::Neighbour RecoveredPressure<2>::neighbour(const unsigned int patch,
                                                                const int step) const
{
  const std::vector<Patch<2>> &patches = surface_.patches();
  const auto on_side = [&](const int t) {
    return t >= 0 && t < static_cast<int>(patches.size()) && patches[t].side == patches[patch].side;
  };
  int next = static_cast<int>(patch) + step;
  const Side<2> &side = surface_.side(patches[patch]);
  // Beyond a corner, the pressure is that of another direction.
  const bool has_corner =
    side.has_corner(step > 0 ? patches[patch].upper[0] : patches[patch].lower[0]);
  if (on_side(next) && !has_corner)
    return {static_cast<unsigned int>(next), patches[next].centre()[0]};
  if (!side.is_closed() || has_corner)
    return {patch, patches[patch].centre()[0]};
  // The patch at the other end of the list.
  for (next = static_cast<int>(patch); on_side(next - step);)
    next -= step;
  return {static_cast<unsigned int>(next), patches[next].centre()[0] + step * side.length()};
}

template <>
double RecoveredPressure<2>::operator()(const unsigned int patch, const dealii::Point<1> &s) const
{
  if (!space_.is_piecewise_constant())
    return std::min(0., space_.value(P_, patch, s));
  const double middle = surface_.patches()[patch].centre()[0];
  const int step = s[0] < middle ? -1 : 1;
  Neighbour next = neighbour(patch, step);
  if (next.patch == patch)
    next = neighbour(patch, -step);
  if (next.patch == patch)
    return means_[patch];
  const double slope = (means_[next.patch] - means_[patch]) / (next.middle - middle);
  return std::min(0., means_[patch] + slope * (s[0] - middle));
}

template <>
dealii::Vector<double> transfer_pressure(const PatchPressure<2> &from,
                                         const std::vector<Patch<2>> &to)
{
  const std::vector<Patch<2>> &patches = from.patches;
  dealii::Vector<double> transferred(to.size());
  std::size_t first = 0;
  for (std::size_t t = 0; t < to.size(); ++t)
  {
    const double start = to[t].lower[0], end = to[t].upper[0];
    const auto before = [&](const Patch<2> &patch) {
      return patch.side < to[t].side || (patch.side == to[t].side && patch.upper[0] <= start);
    };
    while (first < patches.size() && before(patches[first]))
      ++first;
    for (std::size_t k = first;
         k < patches.size() && patches[k].side == to[t].side && patches[k].lower[0] < end;
         ++k)
    {
      const double overlap =
        std::min(patches[k].upper[0], end) - std::max(patches[k].lower[0], start);
      transferred[t] += std::max(overlap, 0.) / to[t].measure * from.P[k];
    }
  }
  return transferred;
}

Columns<ContactSummary> ContactSummary::columns()
{
  return {{"active", &ContactSummary::active},
          {"contact_force_n", &ContactSummary::normal_force},
          {"max_pressure", &ContactSummary::max_pressure},
          {"contact_length", &ContactSummary::length}};
}

template ContactSummary summarise_contact(const MultiplierSpace<2> &,
                                          const dealii::Vector<double> &);
template ContactSummary summarise_contact(const MultiplierSpace<3> &,
                                          const dealii::Vector<double> &);
} // namespace Signorini
