// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a line enters a rigid obstacle. On a line every obstacle is {t: phi(t) <= 0} with a
// polynomial phi of degree two, and is entered where phi falls.

#include <signorini/problem/scene/foundation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** The angle (radians) to a plane below which a line is parallel to it but for rounding. */
constexpr double parallel = 1e-12;

} // namespace

/** The polynomial phi(t) = a t² + 2 b t + c. */
struct Obstacle::LinePolynomial {
  double a, b, c;
  /** The discriminant b² - a c, from a formula without cancellation. */
  double discriminant;

  /**
   * Returns the root at which phi falls, t = (-b - w)/a = c/(w - b) with w = sqrt(b² - a c), in the
   * form without cancellation.
   *
   * For a > 0 and t = 0 outside of {phi <= 0} there is no such root ahead if the line misses the
   * obstacle or has left it. Then the result is sqrt(c/a), the geometric mean of the roots, a
   * continuous extension: on a line that touches, both roots have this value.
   */
  std::optional<double> entry() const {
    const bool is_inside = c <= 0.;
    const double w = discriminant > 0. ? std::sqrt(discriminant) : 0.;
    if (w > 0. && b <= 0.)
      return c / (w - b);
    if (a > 0.)
      return is_inside ? -(b + w) / a : std::sqrt(c / a);
    if (a == 0. || is_inside || w == 0.)
      return {};
    return -(b + w) / a;
  }
  /** Returns whether entry() is not a root but its continuation. */
  bool misses() const {
    return a > 0. && c > 0. && !(discriminant > 0. && b <= 0.);
  }
};

Obstacle::Obstacle(std::variant<Parabola, Circle> shape)
  : shape_(shape) {}

Obstacle Obstacle::plane(const Point<2> &point, const Tensor<1, 2> &normal) {
  return parabola(point, normal, 0.);
}

Obstacle Obstacle::parabola(const Point<2> &point, const Tensor<1, 2> &normal,
                            const double curvature) {
  Assert(normal.norm() > 0., ExcMessage("The normal of an obstacle is not zero."));
  return Obstacle(Parabola{point, normal / normal.norm(), curvature});
}

Obstacle Obstacle::circle(const Point<2> &centre, const double radius, const Body body) {
  Assert(radius > 0., ExcMessage("The radius of an obstacle is positive."));
  return Obstacle(Circle{centre, radius, body});
}

Obstacle::LinePolynomial Obstacle::along(const Point<2> &x, const Tensor<1, 2> &n) const {
  const Tensor<1, 2> d = x - anchor();
  if (const auto *circle = std::get_if<Circle>(&shape_)) {
    // phi = ±(|d + t n|² - r²); b² - a c = r² - h² with the distance h of the line from the centre.
    const double sign = circle->body == Body::outside ? 1. : -1.;
    const double r = circle->radius, h = std::abs(cross_product_2d(d) * n);
    return {sign, sign * (d * n), sign * (d.norm() - r) * (d.norm() + r), (r - h) * (r + h)};
  }
  // phi = y' - k x'^2/2 in the coordinates x' along tau and y' along nu.
  const Parabola &parabola = std::get<Parabola>(shape_);
  const Tensor<1, 2> &nu = parabola.normal;
  const Tensor<1, 2> tau = cross_product_2d(nu);
  const double k = parabola.curvature;
  const double d_tau = d * tau, n_tau = n * tau, d_nu = d * nu;
  const double n_nu = std::abs(n * nu) < parallel ? 0. : n * nu;
  // b² - a c = (n_nu² - 2 k n_tau (d_tau n_nu - n_tau d_nu))/4
  return {-0.5 * k * n_tau * n_tau, 0.5 * (n_nu - k * d_tau * n_tau),
          d_nu - 0.5 * k * d_tau * d_tau,
          0.25 * (n_nu * n_nu - 2. * k * n_tau * (d_tau * n_nu - n_tau * d_nu))};
}

std::optional<double> Obstacle::distance(const Point<2> &x, const Tensor<1, 2> &n) const {
  return along(x, n).entry();
}

bool Obstacle::is_hit_by_line(const Point<2> &x, const Tensor<1, 2> &n, const double reach) const {
  const LinePolynomial phi = along(x, n);
  return !phi.misses() && phi.entry().value_or(reach) < reach;
}

bool Obstacle::can_be_hit_along(const Tensor<1, 2> &n) const {
  const auto *parabola = std::get_if<Parabola>(&shape_);
  return parabola == nullptr || parabola->curvature != 0. || n * parabola->normal < -parallel;
}

std::optional<Tensor<1, 2>> Obstacle::direction() const {
  const auto *parabola = std::get_if<Parabola>(&shape_);
  if (parabola == nullptr || parabola->curvature != 0.)
    return {};
  return -1. * parabola->normal;
}

std::optional<Tensor<1, 2>> Obstacle::normal_at_entry(const Point<2> &x,
                                                      const Tensor<1, 2> &n) const {
  const std::optional<double> t = distance(x, n);
  if (!t)
    return {};
  const Tensor<1, 2> d = x + *t * n - anchor();
  if (const auto *circle = std::get_if<Circle>(&shape_))
    return (circle->body == Body::outside ? 1. : -1.) * d / d.norm();
  const Parabola &parabola = std::get<Parabola>(shape_);
  const Tensor<1, 2> tau = cross_product_2d(parabola.normal),
                     slope = parabola.normal - parabola.curvature * (d * tau) * tau;
  return slope / slope.norm();
}

const Point<2> &Obstacle::anchor() const {
  if (const auto *circle = std::get_if<Circle>(&shape_))
    return circle->centre;
  return std::get<Parabola>(shape_).point;
}

Foundation::Foundation(std::vector<Obstacle> things, const double max_gap)
  : obstacles_(std::move(things))
  , max_gap_(max_gap) {}

std::pair<double, const Obstacle *> Foundation::nearest(const Point<2> &x,
                                                        const Tensor<1, 2> &n) const {
  std::pair<double, const Obstacle *> nearest(max_gap_, nullptr);
  for (const Obstacle &obstacle : obstacles_)
    if (const double distance = without_rounding(obstacle.distance(x, n).value_or(max_gap_),
                                                 x.distance(obstacle.anchor()));
        distance < nearest.first)
      nearest = {distance, &obstacle};
  return nearest;
}

double Foundation::gap(const Point<2> &x, const Tensor<1, 2> &n) const {
  return nearest(x, n).first;
}

std::optional<Tensor<1, 2>> Foundation::direction(const Point<2> &x, const Tensor<1, 2> &n) const {
  constexpr double far = std::numeric_limits<double>::max();
  double least = far, facing = -far;
  std::optional<Tensor<1, 2>> nearest, elsewhere;
  for (const Obstacle &obstacle : obstacles_) {
    const std::optional<Tensor<1, 2>> m = obstacle.direction();
    const double distance = obstacle.distance(x, m.value_or(n)).value_or(far),
                 share = m ? *m * n : 1.;
    if (share > parallel) {
      if (distance < least - parallel * max_gap_) {
        least = distance;
        nearest = m;
      }
    } else if (distance >= 0. && share > facing) {
      facing = share;
      elsewhere = m;
    }
  }
  return least < far ? nearest : elsewhere;
}

std::optional<Tensor<1, 2>> Foundation::normal_at_entry(const Point<2> &x,
                                                        const Tensor<1, 2> &n) const {
  const Obstacle *const obstacle = nearest(x, n).second;
  return obstacle != nullptr ? obstacle->normal_at_entry(x, n) : std::nullopt;
}

ContactDirections::ContactDirections(const Side<2> &side, const Foundation &foundation,
                                     const Tensor<1, 2> &position) {
  constexpr unsigned int n_samples = 64;
  const auto begin_part = [this](const double s, const std::optional<Tensor<1, 2>> &m) {
    if (!of_parts_.empty() && of_parts_.back() == m)
      return;
    if (!of_parts_.empty())
      changes_.push_back(s);
    of_parts_.push_back(m);
  };
  for (unsigned int k = 0; k < side.n_pieces(); ++k) {
    const Curve &piece = side.piece(k);
    // On a straight side that is parallel to a plane m is its normal to the last digit.
    const auto direction = [&](const double s) {
      const Tensor<1, 2> n = piece.normal(s);
      const auto m = foundation.direction(piece.point(s) - position, n);
      return m && side.is_flat() && (*m - n).norm() < parallel ? std::nullopt : m;
    };
    const double step = piece.length() / n_samples;
    double from = 0.5 * step;
    begin_part(side.start_of(k), direction(from));
    for (unsigned int i = 1; i < n_samples; ++i) {
      const double to = (i + 0.5) * step;
      while (direction(to) != of_parts_.back()) {
        // The next change: halves until no number lies between.
        double after = to;
        for (double middle = 0.5 * (from + after); middle > from && middle < after;
             middle = 0.5 * (from + after))
          (direction(middle) == of_parts_.back() ? from : after) = middle;
        begin_part(side.start_of(k) + after, direction(after));
        from = after;
      }
      from = to;
    }
  }
}

ContactDirections::ContactDirections(const Side<2> &first, const Side<2> &second) {
  // The normals of parallel sides are the mean normals to the last digit.
  if (!(first.is_flat() && second.is_flat() &&
        (first.normal(0.) + second.normal(0.)).norm() < parallel))
    second_ = second;
}

std::optional<Tensor<1, 2>> ContactDirections::at(const double s) const {
  if (of_parts_.empty())
    return {};
  return of_parts_[std::upper_bound(changes_.begin(), changes_.end(), s) - changes_.begin()];
}

Tensor<1, 2> ContactDirections::at(const double s, const Point<2> &x, const Tensor<1, 2> &n) const {
  if (!second_)
    return at(s).value_or(n);
  const std::optional<double> d = second_->distance_along(x, n);
  if (!d)
    return n;
  const Tensor<1, 2> m = n - second_->normal(second_->arc_length(x + *d * n));
  // Sides that face each other have |m| > 1.
  return m.norm() > 1. ? m / m.norm() : n;
}

bool ContactDirections::change_between(const double from, const double to) const {
  return std::upper_bound(changes_.begin(), changes_.end(), from) !=
         std::lower_bound(changes_.begin(), changes_.end(), to);
}

bool ContactDirections::are_normals() const {
  return !second_ && std::none_of(of_parts_.begin(), of_parts_.end(),
                                  [](const auto &m) { return m.has_value(); });
}

std::shared_ptr<const Function<2>>
foundation_gap(const Side<2> &side, const std::shared_ptr<const Foundation> &foundation,
               const Tensor<1, 2> &position, const ContactDirections &directions) {
  return std::make_shared<ScalarFunctionFromFunctionObject<2>>([=](const Point<2> &x) {
    const Point<1> s = side.coordinates(x);
    const Point<2> on_side = side.is_flat() ? x : side.point(s);
    return without_rounding(
      foundation->gap(on_side - position, directions.at(s[0], on_side, side.normal(s))),
      foundation->max_gap() + on_side.norm() + position.norm());
  });
}

std::shared_ptr<const Function<2>> gap_of_pair(const Side<2> &first, const Side<2> &second,
                                               const ContactDirections &directions,
                                               const std::shared_ptr<const Function<2>> &given) {
  return std::make_shared<ScalarFunctionFromFunctionObject<2>>([=](const Point<2> &x) {
    const Point<1> s = first.coordinates(x);
    const Tensor<1, 2> n = first.normal(s), m = directions.at(s[0], x, n);
    const double g = given->value(x), d = second.distance_along(x, n).value_or(0.) * (m * n);
    double size = std::abs(g) + x.norm() + first.length() + second.length();
    for (const Side<2> *const side : {&first, &second})
      if (const std::optional<Point<2>> centre = side->centre_at(x))
        size += x.distance(*centre);
    return without_rounding(g + d, size);
  });
}
} // namespace Signorini
