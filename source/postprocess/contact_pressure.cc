// SPDX-License-Identifier: LGPL-2.1-or-later
// p_H: resultants, recovery, transfer between partitions.

#include <signorini/postprocess/contact_pressure.h>

#include <algorithm>

namespace Signorini
{
template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space, const dealii::Vector<double> &P)
{
  ContactSummary summary;
  for (unsigned int tau = 0; tau < P.size(); ++tau)
  {
    const double length = space.partition().patches[tau].length();
    summary.active += P[tau] < 0. ? 1 : 0;
    summary.length += P[tau] < 0. ? length : 0.;
    summary.normal_force -= P[tau] * length;
    summary.max_pressure = std::max(summary.max_pressure, -P[tau]);
  }
  return summary;
}

template <int dim>
RecoveredPressure<dim>::RecoveredPressure(const MultiplierSpace<dim> &space,
                                          const dealii::Vector<double> &P)
  : patches_(space.partition().patches)
  , P_(P)
{
}

template <int dim>
double RecoveredPressure<dim>::operator()(const unsigned int patch, const double s) const
{
  const auto on_side = [&](const int t) {
    return t >= 0 && t < static_cast<int>(patches_.size()) &&
           patches_[t].side == patches_[patch].side;
  };
  const int here = static_cast<int>(patch);
  int next = s < patches_[patch].middle() ? here - 1 : here + 1;
  if (!on_side(next))
    next = 2 * here - next;
  if (!on_side(next))
    return P_[patch];
  const double slope =
    (P_[next] - P_[patch]) / (patches_[next].middle() - patches_[patch].middle());
  return std::min(0., P_[patch] + slope * (s - patches_[patch].middle()));
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

template ContactSummary summarise_contact(const MultiplierSpace<2> &,
                                          const dealii::Vector<double> &);
template class RecoveredPressure<2>;
} // namespace Signorini
