// SPDX-License-Identifier: LGPL-2.1-or-later
// The lines on which data is not smooth, and where they cut segments and sides.

#include <signorini/problem/geometry/kinks.h>

#include <algorithm>
#include <utility>

namespace Signorini {
template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions) {
  std::vector<KinkLine<dim>> lines;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions[d])
      lines.push_back({Point<dim>::unit_vector(d), position});
  return lines;
}

template <int dim>
Kinks<dim>::Kinks(std::vector<KinkLine<dim>> lines, std::vector<Point<dim>> breaks, BoxTree boxes)
  : lines_(std::move(lines))
  , breaks_(std::move(breaks))
  , boxes_(std::make_shared<BoxTree>(std::move(boxes))) {}

template <int dim>
void Kinks<dim>::add_ends_on(const Side<dim> &contact_side) {
  static_assert(dim == 2, "in space a plane meets a side in a line, not in points");
  for (const double s : separate_crossings(contact_side))
    ends_.push_back(contact_side.point(s));
}

template <int dim>
Kinks<dim> Kinks<dim>::without_ends() const {
  Kinks result = *this;
  result.ends_.clear();
  return result;
}

template <int dim>
Kinks<dim> Kinks<dim>::with_lines(const std::vector<KinkLine<dim>> &more) const {
  Kinks result = *this;
  result.lines_.insert(result.lines_.end(), more.begin(), more.end());
  return result;
}

template <int dim>
std::vector<double> Kinks<dim>::breaks_on(const Point<dim> &a, const Point<dim> &b) const {
  std::vector<double> positions;
  const Tensor<1, dim> edge = b - a;
  for (const Point<dim> &x : breaks_) {
    const double t = edge * (x - a) / edge.norm_square();
    if (t > tolerance && t < 1. - tolerance && (x - a - t * edge).norm() < tolerance * edge.norm())
      positions.push_back(t);
  }
  return positions;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Point<dim> &a, const Point<dim> &b) const {
  std::vector<double> cuts = breaks_on(a, b);
  cuts.insert(cuts.end(), {0., 1.});
  for (const KinkLine<dim> &line : lines_) {
    const double da = line.signed_distance(a), db = line.signed_distance(b);
    const double t = da / (da - db);
    if (t > tolerance && t < 1. - tolerance)
      cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::crossings(const Side<dim> &side, const double from,
                                          const double to) const {
  Assert(from <= to, ExcMessage("The part of a side ends behind its start."));
  const double margin = tolerance * (to - from);
  std::vector<double> cuts = {from, to};
  for (const KinkLine<dim> &line : lines_)
    for (const double s : side.crossings(line.normal, line.position, from + margin, to - margin))
      cuts.push_back(s);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const Side<dim> &side, const double from,
                                    const double to) const {
  std::vector<double> cuts = crossings(side, from, to);
  const double margin = tolerance * (to - from);
  for (const Point<dim> &x : breaks_) {
    const double s = side.arc_length(x);
    if (s > from + margin && s < to - margin && side.point(s).distance(x) < margin)
      cuts.push_back(s);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
std::vector<double> Kinks<dim>::separate_crossings(const Side<dim> &side) const {
  const std::vector<double> cuts = crossings(side, 0., side.length());
  std::vector<double> separate;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
    if (separate.empty() || cuts[i] - separate.back() >= min_distance * side.length())
      separate.push_back(cuts[i]);
  return separate;
}

template <int dim>
bool Kinks<dim>::touch(const Side<dim> &side, const double from, const double to) const {
  const double margin = tolerance * (to - from);
  for (const KinkLine<dim> &line : lines_)
    for (const double end : {from, to})
      if (!side.crossings(line.normal, line.position, end - margin, end + margin).empty())
        return true;
  return false;
}

template std::vector<KinkLine<2>> lines_at<2>(const std::array<std::vector<double>, 2> &);
template class Kinks<2>;
// Planes do not cut sides in 3-D yet: none may be given.
template Kinks<3>::Kinks(std::vector<KinkLine<3>>, std::vector<Point<3>>, BoxTree);
} // namespace Signorini
