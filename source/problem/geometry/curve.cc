// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments, circular arcs and chains of them by arc length.

#include <signorini/base/message.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/numbers.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini {
using numbers::PI;

namespace {
/** The largest distance between pieces that follow one another, in lengths of the chain. */
constexpr double max_gap_between_pieces = 1e-8;

/** Returns the angle (radians) from one vector to another, in (-pi, pi]. */
double angle_between(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return std::atan2(a * cross_product_2d(b), a * b);
}

double angle_of(const Tensor<1, 2> &x) {
  return std::atan2(x[1], x[0]);
}
} // namespace

/** The pieces of a chain. */
struct Curve::Chain {
  std::vector<Curve> pieces;
  /** The arc lengths at which pieces start, and the length. */
  std::vector<double> starts;
  std::vector<double> corners;
  bool is_closed;
  /** The pieces by the boxes around them. */
  RTree<std::pair<BoundingBox<2>, unsigned int>> boxes;
};

Curve::Curve(const Point<2> &start, const Point<2> &end, const Tensor<1, 2> &normal)
  : start_(start)
  , end_(end)
  , length_(start.distance(end))
  , normal_(normal) {}

Curve::Curve(const Point<2> &start, const Point<2> &end)
  : Curve(start, end, cross_product_2d((end - start) / start.distance(end))) {}

Curve Curve::arc(const Point<2> &centre, const double radius, const double first, const double last,
                 const Body body) {
  Assert(radius > 0., ExcMessage("The radius of an arc is positive."));
  const double orientation = body == Body::inside ? 1. : -1.;
  Curve curve({}, {}, {});
  curve.circle_ = Circle{centre, radius, first, orientation, last < first ? -1. : 1.};
  curve.length_ = radius * std::abs(last - first);
  curve.start_ = centre + radius * curve.circle_->direction(0.);
  curve.end_ = curve.point(curve.length_);
  curve.normal_ = curve.normal(0.);
  return curve;
}

Curve Curve::arc_between(const Point<2> &start, const Point<2> &end, const Point<2> &centre,
                         const bool counter_clockwise) {
  const double first = angle_of(start - centre);
  double turn = angle_of(end - centre) - first;
  if (counter_clockwise && turn <= 0.)
    turn += 2. * PI;
  if (!counter_clockwise && turn >= 0.)
    turn -= 2. * PI;
  return arc(centre, centre.distance(start), first, first + turn,
             counter_clockwise ? Body::inside : Body::outside);
}

Point<2> Curve::circumcentre(const Point<2> &a, const Tensor<1, 2> &u, const Tensor<1, 2> &v) {
  return a + (u.norm_square() * cross_product_2d(v) - v.norm_square() * cross_product_2d(u)) /
               (2. * (u * cross_product_2d(v)));
}

Curve Curve::between(const Point<2> &start, const Point<2> &end,
                     const std::optional<Point<2>> &centre) {
  if (!centre)
    return Curve(start, end);
  // From the chord: in cells that are small compared with the radius, differences of angles would
  // be rounding.
  const double radius = centre->distance(start),
               turn = angle_between(start - *centre, end - *centre) > 0. ? 1. : -1.,
               half = std::asin(std::min(1., 0.5 * start.distance(end) / radius)),
               first = angle_of(end - start) - turn * (0.5 * PI + half);
  Curve curve =
    arc(*centre, radius, first, first + 2. * turn * half, turn > 0. ? Body::inside : Body::outside);
  curve.start_ = start;
  curve.end_ = end;
  curve.length_ = 2. * half * radius;
  return curve;
}

Curve Curve::chain(const std::vector<Curve> &pieces) {
  Assert(!pieces.empty(), ExcMessage("A chain has pieces."));
  Chain chain;
  for (const Curve &piece : pieces)
    if (Curve *const last = chain.pieces.empty() ? nullptr : &chain.pieces.back();
        last != nullptr && last->is_flat() && piece.is_flat() &&
        (last->tangent(0., 1.) - piece.tangent(0., 1.)).norm() < 1e-10)
      *last = Curve(last->start(), piece.end(), last->normal(0.));
    else
      chain.pieces.push_back(piece);
  const auto n = static_cast<unsigned int>(chain.pieces.size());
  if (n == 1)
    return chain.pieces[0];
  Curve curve(chain.pieces[0].start(), chain.pieces[n - 1].end(), chain.pieces[0].normal(0.));
  chain.starts = {0.};
  for (const Curve &piece : chain.pieces)
    chain.starts.push_back(chain.starts.back() + piece.length());
  curve.length_ = chain.starts.back();
  const double max_gap = max_gap_between_pieces * curve.length_;
  chain.is_closed = curve.end_.distance(curve.start_) <= max_gap;
  std::vector<std::pair<BoundingBox<2>, unsigned int>> boxes;
  for (unsigned int k = 0; k < n; ++k) {
    const Curve &before = chain.pieces[(k + n - 1) % n], &piece = chain.pieces[k];
    boxes.emplace_back(piece.box(), k);
    if (k == 0 && !chain.is_closed)
      continue;
    Assert(before.end().distance(piece.start()) <= max_gap, ExcInternalError());
    const double s = before.length();
    if (std::abs(angle_between(before.tangent(s, s), piece.tangent(0., 0.))) > min_corner_turn)
      chain.corners.push_back(chain.starts[k]);
  }
  chain.boxes = pack_rtree(boxes);
  curve.chain_ = std::make_shared<const Chain>(std::move(chain));
  return curve;
}

bool Curve::is_closed() const {
  return chain_ ? chain_->is_closed : circle_ && length_ > (2. * PI - 1e-12) * circle_->radius;
}

unsigned int Curve::n_pieces() const {
  return chain_ ? static_cast<unsigned int>(chain_->pieces.size()) : 1;
}

const Curve &Curve::piece(const unsigned int k) const {
  AssertIndexRange(k, n_pieces());
  return chain_ ? chain_->pieces[k] : *this;
}

double Curve::start_of(const unsigned int k) const {
  AssertIndexRange(k, n_pieces() + 1);
  return chain_ ? chain_->starts[k] : k * length_;
}

const std::vector<double> &Curve::corners() const {
  static const std::vector<double> none;
  return chain_ ? chain_->corners : none;
}

bool Curve::has_corner(const double s) const {
  const double margin = 1e-9 * length_;
  const double on_first_turn = is_closed() ? s - length_ * std::floor((s + margin) / length_) : s;
  const auto next = std::lower_bound(corners().begin(), corners().end(), on_first_turn - margin);
  return next != corners().end() && *next <= on_first_turn + margin;
}

std::vector<unsigned int> Curve::pieces_near(const Point<2> &x, const double distance) const {
  if (!chain_)
    return {0};
  std::vector<unsigned int> found;
  BoundingBox<2> around({x, x});
  around.extend(distance);
  for (const auto &[box, k] : chain_->boxes | boost::geometry::index::adaptors::queried(
                                                boost::geometry::index::intersects(around))) {
    const Curve &on = piece(k);
    if (on.point(std::clamp(on.arc_length(x), 0., on.length())).distance(x) <= distance)
      found.push_back(k);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<Point<2>> Curve::centre_at(const Point<2> &x) const {
  if (is_flat())
    return {};
  const Curve &on = locate(arc_length(x)).piece;
  return on.circle_ ? std::optional<Point<2>>(on.circle_->centre) : std::nullopt;
}

BoundingBox<2> Curve::box() const {
  BoundingBox<2> box(std::vector<Point<2>>{start_, end_});
  for (unsigned int k = 0; chain_ && k < n_pieces(); ++k)
    box.merge_with(piece(k).box());
  for (unsigned int d = 0; circle_ && d < 2; ++d)
    for (const double sign : {-1., 1.}) {
      // The point of the circle that is farthest in this direction, if it is on the arc.
      const Point<2> x = circle_->centre + sign * circle_->radius * Point<2>::unit_vector(d);
      const double s = arc_length(x);
      if (s > 0. && s < length_)
        box.merge_with({{x, x}});
    }
  return box;
}

Tensor<1, 2> Curve::Circle::direction(const double s) const {
  const double angle = first + turn * s / radius;
  return Tensor<1, 2>({std::cos(angle), std::sin(angle)});
}

Curve::Location Curve::locate(double s) const {
  if (!chain_)
    return {*this, s};
  if (chain_->is_closed)
    s -= length_ * std::floor(s / length_);
  const auto &starts = chain_->starts;
  const auto start = std::upper_bound(starts.begin() + 1, starts.end() - 1, s) - 1;
  return {chain_->pieces[start - starts.begin()], s - *start};
}

Curve::Location Curve::locate(const double s, const double towards) const {
  if (!chain_)
    return {*this, s};
  const double step =
    std::copysign(std::min(1e-9 * length_, 0.5 * std::abs(towards - s)), towards - s);
  const Location beside = locate(s + step);
  return {beside.piece, beside.s - step};
}

Point<2> Curve::point(const double s) const {
  const auto [on, t] = locate(s);
  if (!on.circle_)
    return on.start_ + (t / on.length_) * (on.end_ - on.start_);
  // The chord from the start: small arcs keep their digits.
  const auto &[centre, radius, first, orientation, turn] = *on.circle_;
  return on.start_ - 2. * radius * std::sin(0.5 * t / radius) * turn *
                       cross_product_2d(on.circle_->direction(0.5 * t));
}

Tensor<1, 2> Curve::normal(const double s) const {
  const auto [on, t] = locate(s);
  return on.circle_ ? on.circle_->orientation * on.circle_->direction(t) : on.normal_;
}

Tensor<1, 2> Curve::normal(const double s, const double towards) const {
  const auto [on, t] = locate(s, towards);
  return on.normal(t);
}

Tensor<1, 2> Curve::normal_at(const Point<2> &x, const Point<2> &inside) const {
  const Curve &on = locate(arc_length(inside)).piece;
  return on.normal(on.arc_length(x));
}

Tensor<1, 2> Curve::tangent(const double s, const double towards) const {
  const auto [on, t] = locate(s, towards);
  return on.circle_ ? -on.circle_->turn * cross_product_2d(on.circle_->direction(t))
                    : (on.end_ - on.start_) / on.length_;
}

double Curve::arc_length(const Point<2> &x) const {
  if (chain_) {
    // The pieces by the distances of their boxes, until these are farther than the nearest piece.
    double nearest = HUGE_VAL, s = 0.;
    for (auto entry = chain_->boxes.qbegin(boost::geometry::index::nearest(x, n_pieces()));
         entry != chain_->boxes.qend() &&
         boost::geometry::comparable_distance(x, entry->first) < nearest;
         ++entry) {
      const Curve &on = piece(entry->second);
      const double on_line = on.arc_length(x), on_piece = std::clamp(on_line, 0., on.length());
      const double distance = on.point(on_piece).distance_square(x);
      if (distance >= nearest)
        continue;
      nearest = distance;
      // The outer pieces go on beyond the ends of the chain.
      const bool is_beyond =
        !is_closed() && on_line != on_piece && entry->second == (on_line < 0. ? 0 : n_pieces() - 1);
      s = start_of(entry->second) + (is_beyond ? on_line : on_piece);
    }
    return is_closed() && s >= length_ ? 0. : s;
  }
  if (!circle_)
    return (x - start_) * (end_ - start_) / length_;
  // From the start, as in point(): small arcs keep their digits.
  double angle = circle_->turn * angle_between(start_ - circle_->centre, x - circle_->centre);
  // The end of an arc may come out a little before its start: only points far behind the middle of
  // the missing piece lie there.
  const double missing = 2. * PI - length_ / circle_->radius;
  const double lowest = is_closed() ? 0. : -0.5 * missing;
  angle -= 2. * PI * std::floor((angle - lowest) / (2. * PI));
  return circle_->radius * angle;
}

std::optional<double> Curve::distance_along(const Point<2> &x, const Tensor<1, 2> &n) const {
  Assert(std::abs(n.norm() - 1.) < 1e-9, ExcMessage("A direction has the length 1."));
  std::optional<double> nearest;
  const auto take = [&](const double d) {
    if (std::isfinite(d) && (!nearest || std::abs(d) < std::abs(*nearest)))
      nearest = d;
  };
  if (chain_)
    for (unsigned int k = 0; k < n_pieces(); ++k) {
      const auto d = piece(k).distance_along(x, n);
      const double s = d ? piece(k).arc_length(x + *d * n) : -1.;
      if (d && s >= -1e-10 * length_ && s <= piece(k).length() + 1e-10 * length_)
        take(*d);
    }
  else if (circle_) {
    const Tensor<1, 2> arm = x - circle_->centre;
    const double half = arm * n,
                 root = half * half - arm.norm_square() + circle_->radius * circle_->radius;
    if (root >= 0.)
      for (const double sign : {-1., 1.})
        take(-half + sign * std::sqrt(root));
  } else if (std::abs(normal_ * n) > 1e-10)
    take((start_ - x) * normal_ / (normal_ * n));
  return nearest;
}

std::vector<double> Curve::crossings(const Tensor<1, 2> &m, const double position,
                                     const double from, const double to) const {
  Assert(std::abs(m.norm() - 1.) < 1e-9, ExcMessage("The normal of a line has the length 1."));
  std::vector<double> found;
  if (chain_) {
    const double apart = 1e-12 * length_;
    const int last = static_cast<int>(n_pieces()) - 1;
    const auto first_turn = static_cast<int>(is_closed() ? std::floor(from / length_) : 0.);
    const auto last_turn = static_cast<int>(is_closed() ? std::floor(to / length_) : 0.);
    for (int turn = first_turn; turn <= last_turn; ++turn)
      for (int k = 0; k <= last; ++k) {
        // The search on each piece reaches 1e-12 beyond its ends; that on the first and last piece
        // reaches the ends of the search.
        const double start = turn * length_ + start_of(k), length = piece(k).length();
        const double lowest = k == 0 && !is_closed() ? from : std::max(from, start - apart);
        const double highest =
          k == last && !is_closed() ? to : std::min(to, start + length + apart);
        if (lowest <= highest)
          for (const double s : piece(k).crossings(m, position, lowest - start, highest - start))
            if (found.empty() || start + s > found.back() + 4. * apart)
              found.push_back(start + s);
      }
    return found;
  }
  const auto add = [&](const double s) {
    if (s >= from && s <= to)
      found.push_back(s);
  };
  if (!circle_) {
    const double slope = m * (end_ - start_) / length_;
    if (std::abs(slope) > 1e-14)
      add((position - m * start_) / slope);
    return found;
  }
  // m.(centre + R e(angle)) = position
  const double cosine = (position - m * circle_->centre) / circle_->radius;
  if (std::abs(cosine) >= 1.)
    return found;
  const double around = 2. * PI * circle_->radius;
  for (const double sign : {-1., 1.}) {
    const double s =
      circle_->radius * circle_->turn * (angle_of(m) + sign * std::acos(cosine) - circle_->first);
    for (double k = std::ceil((from - s) / around); s + k * around <= to; ++k)
      add(s + k * around);
  }
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace Signorini
