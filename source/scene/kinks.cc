// SPDX-License-Identifier: LGPL-2.1-or-later
// Where lines cut segments and sides.

#include <signorini/scene/kinks.h>

#include <algorithm>

namespace Signorini
{
template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions)
{
  std::vector<KinkLine<dim>> lines;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions[d])
      lines.push_back({dealii::Point<dim>::unit_vector(d), position});
  return lines;
}

template <int dim>
Kinks<dim>::Kinks(std::vector<KinkLine<dim>> lines)
  : lines_(std::move(lines))
{
}

template <int dim>
void Kinks<dim>::add_ends_on(const Side<dim> &contact_side)
{
  static_assert(dim == 2, "in space a plane meets a side in a line, not in points");
  const std::vector<double> cuts = cut(contact_side, 0., contact_side.length());
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
    ends_.push_back(contact_side.point(cuts[i]));
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const
{
  std::vector<double> cuts = {0., 1.};
  for (const KinkLine<dim> &line : lines_)
  {
    const double da = line.signed_distance(a), db = line.signed_distance(b);
    const double t = da / (da - db);
    if (t > tolerance && t < 1. - tolerance)
      cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Side<dim> &side, const double from, const double to) const
{
  const double margin = tolerance * (to - from);
  std::vector<double> cuts = {from, to};
  for (const KinkLine<dim> &line : lines_)
    for (const double s : side.crossings(line.normal, line.position, from + margin, to - margin))
      cuts.push_back(s);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
bool Kinks<dim>::touch(const Side<dim> &side, const double from, const double to) const
{
  const double margin = tolerance * (to - from);
  for (const KinkLine<dim> &line : lines_)
    for (const double end : {from, to})
      if (!side.crossings(line.normal, line.position, end - margin, end + margin).empty())
        return true;
  return false;
}

template std::vector<KinkLine<2>> lines_at<2>(const std::array<std::vector<double>, 2> &);
template class Kinks<2>;
// Planes do not cut sides in space yet: none may be given.
template Kinks<3>::Kinks(std::vector<KinkLine<3>>);
} // namespace Signorini
