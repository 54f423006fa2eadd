// SPDX-License-Identifier: LGPL-2.1-or-later
// p_H: resultants, recovery, transfer between partitions.

#include <signorini/postprocess/contact_pressure.h>

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
  for (unsigned int tau = 0; tau < P.size(); ++tau)
  {
    const double length = space.partition().patches[tau].length();
    if (P[tau] < threshold)
    {
      ++summary.active;
      summary.length += length;
    }
    summary.normal_force -= P[tau] * length;
    summary.max_pressure = std::max(summary.max_pressure, -P[tau]);
  }
  return summary;
}

template <int dim>
RecoveredPressure<dim>::RecoveredPressure(const MultiplierSpace<dim> &space,
                                          const dealii::Vector<double> &P)
  : space_(space)
  , P_(P)
{
}

template <int dim>
typename RecoveredPressure<dim>::Neighbour
RecoveredPressure<dim>::neighbour(const unsigned int patch, const int step) const
{
  const std::vector<Patch> &patches = space_.partition().patches;
  const auto on_side = [&](const int t) {
    return t >= 0 && t < static_cast<int>(patches.size()) && patches[t].side == patches[patch].side;
  };
  int next = static_cast<int>(patch) + step;
  if (on_side(next))
    return {static_cast<unsigned int>(next), patches[next].middle()};
  const Side<dim> &side = space_.side(patches[patch]);
  if (!side.is_closed())
    return {patch, patches[patch].middle()};
  // The patch at the other end of the list.
  for (next = static_cast<int>(patch); on_side(next - step);)
    next -= step;
  return {static_cast<unsigned int>(next), patches[next].middle() + step * side.length()};
}

template <int dim>
double RecoveredPressure<dim>::operator()(const unsigned int patch, const double s) const
{
  const double middle = space_.partition().patches[patch].middle();
  const int step = s < middle ? -1 : 1;
  Neighbour next = neighbour(patch, step);
  if (next.patch == patch)
    next = neighbour(patch, -step);
  if (next.patch == patch)
    return P_[patch];
  const double slope = (P_[next.patch] - P_[patch]) / (next.middle - middle);
  return std::min(0., P_[patch] + slope * (s - middle));
}

dealii::Vector<double> transfer_pressure(const std::vector<Patch> &from,
                                         const dealii::Vector<double> &P,
                                         const std::vector<Patch> &to)
{
  dealii::Vector<double> transferred(to.size());
  std::size_t first = 0;
  for (std::size_t t = 0; t < to.size(); ++t)
  {
    const auto before = [&](const Patch &patch) {
      return patch.side < to[t].side || (patch.side == to[t].side && patch.end <= to[t].start);
    };
    while (first < from.size() && before(from[first]))
      ++first;
    for (std::size_t k = first;
         k < from.size() && from[k].side == to[t].side && from[k].start < to[t].end;
         ++k)
    {
      const double overlap =
        std::min(from[k].end, to[t].end) - std::max(from[k].start, to[t].start);
      transferred[t] += std::max(overlap, 0.) / to[t].length() * P[k];
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
template class RecoveredPressure<2>;
} // namespace Signorini
