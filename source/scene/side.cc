// SPDX-License-Identifier: LGPL-2.1-or-later
// The pieces of the boundary: segments and circular arcs by arc length.

#include <signorini/scene/side.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
using dealii::numbers::PI;

namespace
{
dealii::Tensor<1, 2> direction(const double angle)
{
  return dealii::Tensor<1, 2>({std::cos(angle), std::sin(angle)});
}
} // namespace

template <int dim>
Side<dim>::Side(std::string name,
                const dealii::Point<dim> &start,
                const dealii::Point<dim> &end,
                const dealii::Tensor<1, dim> &normal)
  : name_(std::move(name))
  , start_(start)
  , end_(end)
  , length_(start.distance(end))
  , normal_(normal)
{
}

template <int dim>
Side<dim> Side<dim>::arc(std::string name,
                         const dealii::Point<dim> &centre,
                         const double radius,
                         const double first,
                         const double last,
                         const Body body)
{
  static_assert(dim == 2, "in three dimensions arcs are no sides");
  const double orientation = body == Body::inside ? 1. : -1.;
  Side side(std::move(name),
            centre + radius * direction(first),
            centre + radius * direction(last),
            orientation * direction(first));
  side.length_ = radius * (last - first);
  side.circle_ = Circle{centre, radius, first, orientation};
  return side;
}

template <int dim>
bool Side<dim>::is_closed() const
{
  return circle_ && length_ > (2. * PI - 1e-12) * circle_->radius;
}

template <int dim>
dealii::Point<dim> Side<dim>::point(const double s) const
{
  if (!circle_)
    return start_ + (s / length_) * (end_ - start_);
  return circle_->centre + circle_->radius * direction(circle_->first + s / circle_->radius);
}

template <int dim>
dealii::Tensor<1, dim> Side<dim>::normal(const double s) const
{
  if (!circle_)
    return normal_;
  return circle_->orientation * direction(circle_->first + s / circle_->radius);
}

template <int dim>
double Side<dim>::arc_length(const dealii::Point<dim> &x) const
{
  if (!circle_)
    return (x - start_) * (end_ - start_) / length_;
  const dealii::Tensor<1, dim> from_centre = x - circle_->centre;
  double angle = std::atan2(from_centre[1], from_centre[0]) - circle_->first;
  // The end of an arc may come out a little before its start: only points far behind the middle of
  // the missing piece lie there.
  const double missing = 2. * PI - length_ / circle_->radius;
  const double lowest = is_closed() ? 0. : -0.5 * missing;
  angle -= 2. * PI * std::floor((angle - lowest) / (2. * PI));
  return circle_->radius * angle;
}

template <int dim>
std::vector<double> Side<dim>::crossings(const dealii::Tensor<1, dim> &m,
                                         const double position,
                                         const double from,
                                         const double to) const
{
  std::vector<double> found;
  const auto add = [&](const double s) {
    if (s >= from && s <= to)
      found.push_back(s);
  };
  if (!circle_)
  {
    const double slope = m * (end_ - start_) / length_;
    if (std::abs(slope) > 1e-14)
      add((position - m * (start_ - dealii::Point<dim>())) / slope);
    return found;
  }
  // m.(centre + R e(angle)) = position
  const double cosine = (position - m * (circle_->centre - dealii::Point<dim>())) / circle_->radius;
  if (std::abs(cosine) >= 1.)
    return found;
  const double turn = 2. * PI * circle_->radius;
  for (const double sign : {-1., 1.})
  {
    const double angle = std::atan2(m[1], m[0]) + sign * std::acos(cosine) - circle_->first;
    const double s = circle_->radius * angle;
    for (double k = std::ceil((from - s) / turn); s + k * turn <= to; ++k)
      add(s + k * turn);
  }
  std::sort(found.begin(), found.end());
  return found;
}

template class Side<2>;
} // namespace Signorini
