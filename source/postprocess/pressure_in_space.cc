// SPDX-License-Identifier: LGPL-2.1-or-later
// p_H on rectangles: bilinear recovery, transfer between partitions.

#include <signorini/postprocess/contact_pressure.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Between the centres of two intervals: the numbers of both, and the share of the second. It is
 * negative beyond the first one. */
struct BetweenCentres
{
  unsigned int first, second;
  double share;
};

/** Where a point lies between the centre of interval @p i and that of the next one on its side. */
BetweenCentres
between_centres(const PatchGrid &grid, const unsigned int d, const unsigned int i, const double s)
{
  const unsigned int n = grid.n(d);
  if (n == 1)
    return {i, i, 0.};
  const double middle = grid.middle(d, i);
  const bool before = i + 1 == n || (i > 0 && s < middle);
  const unsigned int next = before ? i - 1 : i + 1;
  return {i, next, (s - middle) / (grid.middle(d, next) - middle)};
}

/** The part of an interval that another one covers. */
struct Overlap
{
  unsigned int number;
  double share;
};

/** For every interval between @p to those between @p from that it meets. */
std::vector<std::vector<Overlap>> overlaps(const std::vector<double> &from,
                                           const std::vector<double> &to)
{
  std::vector<std::vector<Overlap>> all(to.size() - 1);
  std::size_t first = 0;
  for (std::size_t t = 0; t + 1 < to.size(); ++t)
  {
    while (first + 2 < from.size() && from[first + 1] <= to[t])
      ++first;
    for (std::size_t k = first; k + 1 < from.size() && from[k] < to[t + 1]; ++k)
    {
      const double length = std::min(from[k + 1], to[t + 1]) - std::max(from[k], to[t]);
      if (length > 0.)
        all[t].push_back({static_cast<unsigned int>(k), length / (to[t + 1] - to[t])});
    }
  }
  return all;
}
} // namespace

template <>
RecoveredPressure<3>::RecoveredPressure(const MultiplierSpace<3> &space,
                                        const dealii::Vector<double> &P)
  : space_(space)
  , surface_(space.surface())
  , P_(P)
  , grids_(patch_grids(space.surface().patches()))
  , places_(space.surface().patches().size())
{
  for (unsigned int tau = 0; tau < surface_.patches().size(); ++tau)
    means_.push_back(space.value(P, tau, surface_.patches()[tau].centre()));
  for (unsigned int g = 0; g < grids_.size(); ++g)
    for (unsigned int j = 0; j < grids_[g].n(1); ++j)
      for (unsigned int i = 0; i < grids_[g].n(0); ++i)
        places_[grids_[g].at(i, j)] = {g, {{i, j}}};
}

template <>
double RecoveredPressure<3>::operator()(const unsigned int patch, const dealii::Point<2> &s) const
{
  const Place &place = places_[patch];
  const PatchGrid &grid = grids_[place.grid];
  const BetweenCentres x = between_centres(grid, 0, place.index[0], s[0]);
  const BetweenCentres y = between_centres(grid, 1, place.index[1], s[1]);
  const auto along_x = [&](const unsigned int row) {
    return (1. - x.share) * means_[grid.at(x.first, row)] +
           x.share * means_[grid.at(x.second, row)];
  };
  return std::min(0., (1. - y.share) * along_x(y.first) + y.share * along_x(y.second));
}

template <>
dealii::Vector<double> transfer_pressure(const PatchPressure<3> &from,
                                         const std::vector<Patch<3>> &to)
{
  const std::vector<PatchGrid> given = patch_grids(from.patches);
  dealii::Vector<double> transferred(to.size());
  for (const PatchGrid &grid : patch_grids(to))
  {
    const auto known = std::find_if(
      given.begin(), given.end(), [&](const PatchGrid &other) { return other.side == grid.side; });
    if (known == given.end())
      continue;
    const auto columns = overlaps(known->ends[0], grid.ends[0]);
    const auto rows = overlaps(known->ends[1], grid.ends[1]);
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int i = 0; i < grid.n(0); ++i)
        for (const Overlap &row : rows[j])
          for (const Overlap &column : columns[i])
            transferred[grid.at(i, j)] +=
              row.share * column.share * from.P[known->at(column.number, row.number)];
  }
  return transferred;
}
} // namespace Signorini
