// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments and circular arcs by arc length.

#include <signorini/scene/curve.h>

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

Curve::Curve(const dealii::Point<2> &start,
             const dealii::Point<2> &end,
             const dealii::Tensor<1, 2> &normal)
  : start_(start)
  , end_(end)
  , length_(start.distance(end))
  , normal_(normal)
{
}

Curve Curve::arc(const dealii::Point<2> &centre,
                 const double radius,
                 const double first,
                 const double last,
                 const Body body)
{
  const double orientation = body == Body::inside ? 1. : -1.;
  Curve curve(centre + radius * direction(first),
              centre + radius * direction(last),
              orientation * direction(first));
  curve.length_ = radius * (last - first);
  curve.circle_ = Circle{centre, radius, first, orientation};
  return curve;
}

bool Curve::is_closed() const
{
  return circle_ && length_ > (2. * PI - 1e-12) * circle_->radius;
}

dealii::Point<2> Curve::point(const double s) const
{
  if (!circle_)
    return start_ + (s / length_) * (end_ - start_);
  return circle_->centre + circle_->radius * direction(circle_->first + s / circle_->radius);
}

dealii::Tensor<1, 2> Curve::normal(const double s) const
{
  if (!circle_)
    return normal_;
  return circle_->orientation * direction(circle_->first + s / circle_->radius);
}

double Curve::arc_length(const dealii::Point<2> &x) const
{
  if (!circle_)
    return (x - start_) * (end_ - start_) / length_;
  const dealii::Tensor<1, 2> from_centre = x - circle_->centre;
  double angle = std::atan2(from_centre[1], from_centre[0]) - circle_->first;
  // The end of an arc may come out a little before its start: only points far behind the middle of
  // the missing piece lie there.
  const double missing = 2. * PI - length_ / circle_->radius;
  const double lowest = is_closed() ? 0. : -0.5 * missing;
  angle -= 2. * PI * std::floor((angle - lowest) / (2. * PI));
  return circle_->radius * angle;
}

std::vector<double> Curve::crossings(const dealii::Tensor<1, 2> &m,
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
      add((position - m * (start_ - dealii::Point<2>())) / slope);
    return found;
  }
  // m.(centre + R e(angle)) = position
  const double cosine = (position - m * (circle_->centre - dealii::Point<2>())) / circle_->radius;
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
} // namespace Signorini
