// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments, circular arcs and chains of them by arc length.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "curve_chain.h"

namespace Signorini
{
using numbers::PI;

namespace
{
Tensor<1, 2> direction(const double angle)
{
  return Tensor<1, 2>({std::cos(angle), std::sin(angle)});
}
} // namespace

Curve::Curve(const Point<2> &start, const Point<2> &end, const Tensor<1, 2> &normal)
  : start_(start)
  , end_(end)
  , length_(start.distance(end))
  , normal_(normal)
{
}

Curve Curve::arc(const Point<2> &centre,
                 const double radius,
                 const double first,
                 const double last,
                 const Body body)
{
  const double orientation = body == Body::inside ? 1. : -1.;
  Curve curve(centre + radius * direction(first),
              centre + radius * direction(last),
              orientation * direction(first));
  curve.length_ = radius * std::abs(last - first);
  curve.circle_ = Circle{centre, radius, first, orientation, last < first ? -1. : 1.};
  return curve;
}

Curve Curve::chain(const std::vector<Curve> &pieces)
{
  const auto chain = std::make_shared<const Chain>(pieces);
  if (chain->n_pieces() == 1)
    return chain->piece(0);
  Curve curve(
    chain->piece(0).start(), chain->piece(chain->n_pieces() - 1).end(), chain->piece(0).normal(0.));
  curve.length_ = chain->length();
  curve.chain_ = chain;
  return curve;
}

bool Curve::is_closed() const
{
  if (chain_)
    return chain_->is_closed();
  return circle_ && length_ > (2. * PI - 1e-12) * circle_->radius;
}

unsigned int Curve::n_pieces() const
{
  return chain_ ? chain_->n_pieces() : 1;
}

const Curve &Curve::piece(const unsigned int k) const
{
  return chain_ ? chain_->piece(k) : *this;
}

double Curve::start_of(const unsigned int k) const
{
  if (chain_)
    return chain_->start_of(k);
  return k == 0 ? 0. : length_;
}

const std::vector<double> &Curve::corners() const
{
  static const std::vector<double> none;
  return chain_ ? chain_->corners() : none;
}

bool Curve::has_corner(const double s) const
{
  if (corners().empty())
    return false;
  const double margin = 1e-9 * length_;
  const double on_first_turn = is_closed() ? s - length_ * std::floor((s + margin) / length_) : s;
  const auto next = std::lower_bound(corners().begin(), corners().end(), on_first_turn - margin);
  return next != corners().end() && *next <= on_first_turn + margin;
}

std::vector<unsigned int> Curve::pieces_near(const Point<2> &x, const double distance) const
{
  return chain_ ? chain_->pieces_near(x, distance) : std::vector<unsigned int>{0};
}

Point<2> Curve::point(const double s) const
{
  if (chain_)
  {
    const auto [k, s_on_piece] = chain_->place(s);
    return chain_->piece(k).point(s_on_piece);
  }
  if (!circle_)
    return start_ + (s / length_) * (end_ - start_);
  return circle_->centre +
         circle_->radius * direction(circle_->first + circle_->turn * s / circle_->radius);
}

Tensor<1, 2> Curve::normal(const double s) const
{
  if (chain_)
  {
    const auto [k, s_on_piece] = chain_->place(s);
    return chain_->piece(k).normal(s_on_piece);
  }
  if (!circle_)
    return normal_;
  return circle_->orientation * direction(circle_->first + circle_->turn * s / circle_->radius);
}

Tensor<1, 2> Curve::normal(const double s, const double towards) const
{
  if (!chain_)
    return normal(s);
  const auto [k, s_on_piece] = chain_->place(s, towards);
  return chain_->piece(k).normal(s_on_piece);
}

Tensor<1, 2> Curve::normal_at(const Point<2> &x, const Point<2> &inside) const
{
  const Curve &on = chain_ ? chain_->piece(chain_->place(arc_length(inside)).first) : *this;
  return on.normal(on.arc_length(x));
}

Tensor<1, 2> Curve::tangent(const double s, const double towards) const
{
  if (chain_)
  {
    const auto [k, s_on_piece] = chain_->place(s, towards);
    return chain_->piece(k).tangent(s_on_piece, s_on_piece);
  }
  if (!circle_)
    return (end_ - start_) / length_;
  const Tensor<1, 2> outwards = circle_->orientation * normal(s);
  return circle_->turn * Tensor<1, 2>({-outwards[1], outwards[0]});
}

double Curve::arc_length(const Point<2> &x) const
{
  if (chain_)
    return chain_->arc_length(x);
  if (!circle_)
    return (x - start_) * (end_ - start_) / length_;
  const Tensor<1, 2> from_centre = x - circle_->centre;
  double angle = circle_->turn * (std::atan2(from_centre[1], from_centre[0]) - circle_->first);
  // The end of an arc may come out a little before its start: only points far behind the middle of
  // the missing piece lie there.
  const double missing = 2. * PI - length_ / circle_->radius;
  const double lowest = is_closed() ? 0. : -0.5 * missing;
  angle -= 2. * PI * std::floor((angle - lowest) / (2. * PI));
  return circle_->radius * angle;
}

std::vector<double> Curve::crossings(const Tensor<1, 2> &m,
                                     const double position,
                                     const double from,
                                     const double to) const
{
  if (chain_)
    return chain_->crossings(m, position, from, to);
  std::vector<double> found;
  const auto add = [&](const double s) {
    if (s >= from && s <= to)
      found.push_back(s);
  };
  if (!circle_)
  {
    const double slope = m * (end_ - start_) / length_;
    if (std::abs(slope) > 1e-14)
      add((position - m * (start_ - Point<2>())) / slope);
    return found;
  }
  // m.(centre + R e(angle)) = position
  const double cosine = (position - m * (circle_->centre - Point<2>())) / circle_->radius;
  if (std::abs(cosine) >= 1.)
    return found;
  const double around = 2. * PI * circle_->radius;
  for (const double sign : {-1., 1.})
  {
    const double angle =
      circle_->turn * (std::atan2(m[1], m[0]) + sign * std::acos(cosine) - circle_->first);
    const double s = circle_->radius * angle;
    for (double k = std::ceil((from - s) / around); s + k * around <= to; ++k)
      add(s + k * around);
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Transfinite interpolation in a cell with circular edges.

Point<2> ArcCell::Edge::point(const double t) const
{
  if (!centre)
    return start + t * (end - start);
  const double radius = centre->distance(start), at = angle + t * turn;
  return *centre + radius * Tensor<1, 2>({std::cos(at), std::sin(at)});
}

Tensor<1, 2> ArcCell::Edge::derivative(const double t) const
{
  if (!centre)
    return end - start;
  const double speed = centre->distance(start) * turn, at = angle + t * turn;
  return speed * Tensor<1, 2>({-std::sin(at), std::cos(at)});
}

ArcCell::ArcCell(const std::array<Point<2>, 4> &corners,
                 const std::array<std::optional<Point<2>>, 4> &centres)
{
  for (unsigned int i = 0; i < 4; ++i)
  {
    Edge &edge = edges_[i];
    edge.start = corners[i];
    edge.end = corners[(i + 1) % 4];
    edge.centre = centres[i];
    if (!edge.centre)
      continue;
    const Tensor<1, 2> a = edge.start - *edge.centre, b = edge.end - *edge.centre;
    edge.angle = std::atan2(a[1], a[0]);
    edge.turn = std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
  }
}

std::unique_ptr<Manifold<2, 2>> ArcCell::clone() const
{
  return std::make_unique<ArcCell>(*this);
}

Point<2> ArcCell::push_forward(const Point<2> &chart_point) const
{
  const double a = chart_point[0], b = chart_point[1];
  Tensor<1, 2> x;
  x += (1. - b) * edges_[0].point(a) + b * edges_[2].point(1. - a);
  x += a * edges_[1].point(b) + (1. - a) * edges_[3].point(1. - b);
  x -= (1. - a) * (1. - b) * edges_[0].start + a * (1. - b) * edges_[1].start;
  x -= a * b * edges_[2].start + (1. - a) * b * edges_[3].start;
  return Point<2>(x);
}

DerivativeForm<1, 2, 2> ArcCell::push_forward_gradient(const Point<2> &chart_point) const
{
  const double a = chart_point[0], b = chart_point[1];
  const Tensor<1, 2> bottom = edges_[1].start - edges_[0].start,
                     top = edges_[2].start - edges_[3].start,
                     left = edges_[3].start - edges_[0].start,
                     right = edges_[2].start - edges_[1].start;
  const Tensor<1, 2> along_a = (1. - b) * (edges_[0].derivative(a) - bottom) -
                               b * (edges_[2].derivative(1. - a) + top) +
                               (edges_[1].point(b) - edges_[3].point(1. - b));
  const Tensor<1, 2> along_b = a * (edges_[1].derivative(b) - right) -
                               (1. - a) * (edges_[3].derivative(1. - b) + left) +
                               (edges_[2].point(1. - a) - edges_[0].point(a));
  DerivativeForm<1, 2, 2> gradient;
  for (unsigned int d = 0; d < 2; ++d)
  {
    gradient[d][0] = along_a[d];
    gradient[d][1] = along_b[d];
  }
  return gradient;
}

Point<2> ArcCell::pull_back(const Point<2> &x) const
{
  constexpr unsigned int max_steps = 50;
  const double size = edges_[0].start.distance(edges_[2].start);
  const double rounding = 1e-15 * (size + x.norm());
  Point<2> chart_point(0.5, 0.5);
  double distance = HUGE_VAL;
  for (unsigned int step = 0; step < max_steps; ++step)
  {
    const Tensor<1, 2> residual = x - push_forward(chart_point);
    // Newton's method continues until rounding ends it.
    if (residual.norm() < rounding ||
        (residual.norm() < 1e-12 * size && residual.norm() >= distance))
      return chart_point;
    distance = residual.norm();
    const Tensor<2, 2> gradient(push_forward_gradient(chart_point));
    chart_point += invert(gradient) * residual;
    for (unsigned int d = 0; d < 2; ++d)
      chart_point[d] = std::min(std::max(chart_point[d], -0.5), 1.5);
  }
  std::ostringstream text;
  text
    << "Geometry: the point (" << x << ") is not found in the coarse cell from (" << edges_[0].start
    << ") to (" << edges_[2].start
    << "), an edge of which lies on a circle, allowed: a finer mesh there (Mesh size, or another "
       "File).";
  throw ComputationError(text.str());
}

bool ArcCell::is_valid(const unsigned int n, const double min_ratio) const
{
  double lowest = HUGE_VAL, highest = 0.;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
    {
      const double determinant =
        push_forward_gradient(Point<2>(double(i) / n, double(j) / n)).determinant();
      lowest = std::min(lowest, determinant);
      highest = std::max(highest, determinant);
    }
  return lowest > min_ratio * highest;
}
} // namespace Signorini
