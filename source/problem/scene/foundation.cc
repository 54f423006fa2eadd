// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a line enters a rigid obstacle. On a line every obstacle is {t: phi(t) <= 0} with a
// polynomial phi of degree two, and is entered where phi falls.

#include <signorini/base/instantiate.h>
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
template <int dim>
struct Obstacle<dim>::LinePolynomial {
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

template <int dim>
Obstacle<dim>::Obstacle(std::variant<Parabola, Round> shape)
  : shape_(shape) {}

template <int dim>
Obstacle<dim> Obstacle<dim>::plane(const Point<dim> &point, const Vector &normal) {
  return parabola(point, normal, 0.);
}

template <int dim>
Obstacle<dim> Obstacle<dim>::parabola(const Point<dim> &point, const Vector &normal,
                                      const double curvature) {
  Assert(normal.norm() > 0., ExcMessage("The normal of an obstacle is not zero."));
  Assert(dim == 2 || curvature == 0., ExcNotImplemented());
  return Obstacle(Parabola{point, normal / normal.norm(), curvature});
}

template <int dim>
Obstacle<dim> Obstacle<dim>::circle(const Point<dim> &centre, const double radius,
                                    const Body body) {
  Assert(radius > 0., ExcMessage("The radius of an obstacle is positive."));
  return Obstacle(Round{centre, Vector(), radius, body});
}

template <int dim>
Obstacle<dim> Obstacle<dim>::cylinder(const Point<dim> &point, const Vector &axis,
                                      const double radius, const Body body) {
  Assert(radius > 0. && axis.norm() > 0., ExcMessage("A cylinder has a radius and an axis."));
  return Obstacle(Round{point, axis / axis.norm(), radius, body});
}

namespace {
/** Returns |a × b|. */
double area_of(const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
  return std::abs(cross_product_2d(a) * b);
}
double area_of(const Tensor<1, 3> &a, const Tensor<1, 3> &b) {
  return cross_product_3d(a, b).norm();
}
} // namespace

template <int dim>
typename Obstacle<dim>::LinePolynomial Obstacle<dim>::along(const Point<dim> &x,
                                                            const Vector &n) const {
  const Vector from_anchor = x - anchor();
  if (const auto *round = std::get_if<Round>(&shape_)) {
    // phi = ±(|d + t n'|² - r²) across the axis; b² - a c = |n'|² (r² - h²) with the distance h of
    // the line from the centre or the axis.
    const double sign = round->body == Body::outside ? 1. : -1., r = round->radius;
    const Vector d = round->across(from_anchor);
    Vector m = round->across(n);
    double size = round->axis.norm_square() > 0. ? m.norm() : 1.;
    if (size < parallel) {
      m = Vector();
      size = 0.;
    }
    const double h = area_of(d, m), distance = d.norm();
    return {sign * size * size, sign * (d * m), sign * (distance - r) * (distance + r),
            (size * r - h) * (size * r + h)};
  }
  // phi = y' - k x'^2/2 in the coordinates x' along tau and y' along nu.
  const Parabola &parabola = std::get<Parabola>(shape_);
  const Vector &nu = parabola.normal;
  const double d_nu = from_anchor * nu, n_nu = std::abs(n * nu) < parallel ? 0. : n * nu;
  if constexpr (dim == 2) {
    const Vector tau = cross_product_2d(nu);
    const double k = parabola.curvature, d_tau = from_anchor * tau, n_tau = n * tau;
    // b² - a c = (n_nu² - 2 k n_tau (d_tau n_nu - n_tau d_nu))/4
    return {-0.5 * k * n_tau * n_tau, 0.5 * (n_nu - k * d_tau * n_tau),
            d_nu - 0.5 * k * d_tau * d_tau,
            0.25 * (n_nu * n_nu - 2. * k * n_tau * (d_tau * n_nu - n_tau * d_nu))};
  } else
    return {0., 0.5 * n_nu, d_nu, 0.25 * n_nu * n_nu};
}

template <int dim>
std::optional<double> Obstacle<dim>::distance(const Point<dim> &x, const Vector &n) const {
  return along(x, n).entry();
}

template <int dim>
bool Obstacle<dim>::is_hit_by_line(const Point<dim> &x, const Vector &n, const double reach) const {
  const LinePolynomial phi = along(x, n);
  return !phi.misses() && phi.entry().value_or(reach) < reach;
}

template <int dim>
bool Obstacle<dim>::can_be_hit_along(const Vector &n) const {
  const auto *parabola = std::get_if<Parabola>(&shape_);
  if (parabola == nullptr)
    return std::get<Round>(shape_).across(n).norm() > parallel;
  return parabola->curvature != 0. || n * parabola->normal < -parallel;
}

template <int dim>
std::optional<Tensor<1, dim>> Obstacle<dim>::direction() const {
  const auto *parabola = std::get_if<Parabola>(&shape_);
  if (parabola == nullptr || parabola->curvature != 0.)
    return {};
  return -1. * parabola->normal;
}

template <int dim>
std::optional<Tensor<1, dim>> Obstacle<dim>::normal_at_entry(const Point<dim> &x,
                                                             const Vector &n) const {
  const std::optional<double> t = distance(x, n);
  if (!t)
    return {};
  const Vector from_anchor = x + *t * n - anchor();
  if (const auto *round = std::get_if<Round>(&shape_)) {
    const Vector d = round->across(from_anchor);
    return (round->body == Body::outside ? 1. : -1.) * d / d.norm();
  }
  const Parabola &parabola = std::get<Parabola>(shape_);
  Vector slope = parabola.normal;
  if constexpr (dim == 2) {
    const Vector tau = cross_product_2d(parabola.normal);
    slope -= parabola.curvature * (from_anchor * tau) * tau;
  }
  return slope / slope.norm();
}

template <int dim>
const Point<dim> &Obstacle<dim>::anchor() const {
  if (const auto *round = std::get_if<Round>(&shape_))
    return round->centre;
  return std::get<Parabola>(shape_).point;
}

template <int dim>
Foundation<dim>::Foundation(std::vector<Obstacle<dim>> things, const double max_gap)
  : obstacles_(std::move(things))
  , max_gap_(max_gap) {}

template <int dim>
std::pair<double, const Obstacle<dim> *> Foundation<dim>::nearest(const Point<dim> &x,
                                                                  const Tensor<1, dim> &n) const {
  std::pair<double, const Obstacle<dim> *> nearest(max_gap_, nullptr);
  for (const Obstacle<dim> &obstacle : obstacles_)
    if (const double distance = without_rounding(obstacle.distance(x, n).value_or(max_gap_),
                                                 x.distance(obstacle.anchor()));
        distance < nearest.first)
      nearest = {distance, &obstacle};
  return nearest;
}

template <int dim>
double Foundation<dim>::gap(const Point<dim> &x, const Tensor<1, dim> &n) const {
  return nearest(x, n).first;
}

template <int dim>
std::optional<Tensor<1, dim>> Foundation<dim>::direction(const Point<dim> &x,
                                                         const Tensor<1, dim> &n) const {
  constexpr double far = std::numeric_limits<double>::max();
  double least = far, facing = -far;
  std::optional<Tensor<1, dim>> nearest, elsewhere;
  for (const Obstacle<dim> &obstacle : obstacles_) {
    const std::optional<Tensor<1, dim>> m = obstacle.direction();
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

template <int dim>
std::optional<Tensor<1, dim>> Foundation<dim>::normal_at_entry(const Point<dim> &x,
                                                               const Tensor<1, dim> &n) const {
  const Obstacle<dim> *const obstacle = nearest(x, n).second;
  return obstacle != nullptr ? obstacle->normal_at_entry(x, n) : std::nullopt;
}

ContactDirections<2>::ContactDirections(const Side<2> &side, const Foundation<2> &foundation,
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

ContactDirections<2>::ContactDirections(const Side<2> &first, const Side<2> &second) {
  // The normals of parallel sides are the mean normals to the last digit.
  if (!(first.is_flat() && second.is_flat() &&
        (first.normal(0.) + second.normal(0.)).norm() < parallel))
    second_ = second;
}

std::optional<Tensor<1, 2>> ContactDirections<2>::at(const double s) const {
  if (of_parts_.empty())
    return {};
  return of_parts_[std::upper_bound(changes_.begin(), changes_.end(), s) - changes_.begin()];
}

Tensor<1, 2> ContactDirections<2>::at(const double s, const Point<2> &x,
                                      const Tensor<1, 2> &n) const {
  if (!second_)
    return at(s).value_or(n);
  const std::optional<double> d = second_->distance_along(x, n);
  if (!d)
    return n;
  const Tensor<1, 2> m = n - second_->normal(second_->arc_length(x + *d * n));
  // Sides that face each other have |m| > 1.
  return m.norm() > 1. ? m / m.norm() : n;
}

bool ContactDirections<2>::change_between(const double from, const double to) const {
  return std::upper_bound(changes_.begin(), changes_.end(), from) !=
         std::lower_bound(changes_.begin(), changes_.end(), to);
}

bool ContactDirections<2>::are_normals() const {
  return !second_ && std::none_of(of_parts_.begin(), of_parts_.end(),
                                  [](const auto &m) { return m.has_value(); });
}

ContactDirections<3>::ContactDirections(const Side<3> &side, const Foundation<3> &foundation,
                                        const Tensor<1, 3> &position)
  : position_(position) {
  // On a flat side that is parallel to all planes m is its normal to the last digit.
  const auto acts = [&](const Obstacle<3> &obstacle) {
    const std::optional<Tensor<1, 3>> m = obstacle.direction();
    return m && !(side.is_flat() && (*m - side.surface().axis()).norm() < parallel);
  };
  if (std::any_of(foundation.things().begin(), foundation.things().end(), acts))
    foundation_ = std::make_shared<const Foundation<3>>(foundation);
}

Tensor<1, 3> ContactDirections<3>::at(const Point<3> &x, const Tensor<1, 3> &n) const {
  return are_normals() ? n : foundation_->direction(x - position_, n).value_or(n);
}

template <int dim>
std::shared_ptr<const Function<dim>>
foundation_gap(const Side<dim> &side, const std::shared_ptr<const Foundation<dim>> &foundation,
               const Tensor<1, dim> &position, const ContactDirections<dim> &directions) {
  return std::make_shared<ScalarFunctionFromFunctionObject<dim>>([=](const Point<dim> &x) {
    const Point<dim> on_side = side.is_flat() ? x : side.project(x);
    const Tensor<1, dim> n = side.normal_at(x);
    Tensor<1, dim> m;
    if constexpr (dim == 2)
      m = directions.at(side.arc_length(x), on_side, n);
    else
      m = directions.at(on_side, n);
    return without_rounding(foundation->gap(on_side - position, m),
                            foundation->max_gap() + on_side.norm() + position.norm());
  });
}

std::shared_ptr<const Function<2>> gap_of_pair(const Side<2> &first, const Side<2> &second,
                                               const ContactDirections<2> &directions,
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

template class Obstacle<2>;
template class Obstacle<3>;
template class Foundation<2>;
template class Foundation<3>;
INSTANTIATE_FUNCTION(foundation_gap);
} // namespace Signorini
