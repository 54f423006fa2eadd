// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid things: where lines enter them, against a search that only asks which points they contain,
// and against closed forms; foundations in parameter files.

#include <signorini/base/errors.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/foundation.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <functional>
#include <limits>

#include "../../random_numbers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
/** Whether a thing contains a point, by its definition. */
using Contains = std::function<bool(const Point &)>;
/** What the distance is where a line does not enter a thing: sqrt(t_1 t_2). */
using Beside = std::function<double(const Point &, const Vector &)>;

Vector at_angle(const double angle)
{
  return Vector({std::cos(angle), std::sin(angle)});
}

/** Steps of the search. */
constexpr double step = 0.01, reach = 20.;

/** The first t > 0 at which `found` holds, by steps and bisection; nothing within reach. */
std::optional<double> first(const std::function<bool(double)> &found)
{
  for (double t = 0.; t < reach; t += step)
    if (found(t + step))
    {
      double low = t, high = t + step;
      for (unsigned int i = 0; i < 60; ++i)
        (found(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
      return 0.5 * (low + high);
    }
  return {};
}

/** The distance as Obstacle defines it. */
std::optional<double> search(const Contains &contains, const Point &x, const Vector &n)
{
  if (!contains(x))
    return first([&](const double t) { return contains(x + t * n); });
  const std::optional<double> back = first([&](const double t) { return !contains(x - t * n); });
  return back ? std::optional<double>(-*back) : std::nullopt;
}

/** How often a thing and the search agree for random lines. */
struct Agreement
{
  unsigned int n_hits = 0, n_inside = 0, n_misses = 0, n_grazing = 0;
  double largest_difference = 0.;
  bool wrong = false;

  void add(const Obstacle &obstacle,
           const Contains &contains,
           const Beside &beside,
           const Point &x,
           const Vector &n)
  {
    const std::optional<double> t = obstacle.distance(x, n), found = search(contains, x, n);
    if (beside && t && !found && !contains(x) && std::abs(*t - beside(x, n)) < 1e-9 * *t)
    {
      ++n_misses;
      return;
    }
    // Beyond the reach of the search, or less than a step inside of the thing.
    const bool grazes = t && (std::abs(*t) > reach - 1. || !contains(x + (*t + 1.1 * step) * n) ||
                              contains(x + (*t - 1.1 * step) * n));
    if (grazes)
    {
      ++n_grazing;
      wrong = wrong || (std::abs(*t) < 1e3 && contains(x + (*t - 1e-6) * n));
    }
    else if (t.has_value() != found.has_value())
      wrong = true;
    else if (!t)
      ++n_misses;
    else
    {
      ++n_hits;
      n_inside += *t < 0. ? 1 : 0;
      largest_difference = std::max(largest_difference, std::abs(*t - *found));
    }
  }

  void check(Checks &checks, const std::string &name) const
  {
    checks.that(name + ", hits and misses", !wrong);
    checks.near(name + ", distances", largest_difference, 0., 1e-10);
    checks.that(name + ", all cases occur",
                n_hits > 150 && n_inside > 50 && n_misses > 50 && n_grazing < 100);
  }
};

void test_search(Checks &checks)
{
  RandomNumbers random(7);
  const auto point = [&]() { return Point(2. * random(), 2. * random()); };
  Agreement planes, discs, holes, bumps, cups;
  for (unsigned int i = 0; i < 600; ++i)
  {
    const Point p = point(), x = point();
    const Vector nu = at_angle(PI * random()), n = at_angle(PI * random());
    const double length = std::exp(3. * random()), r = 1. + 0.9 * random(), k = 1. + 0.9 * random();
    planes.add(
      Obstacle::plane(p, length * nu),
      [&](const Point &y) { return (y - p) * nu <= 0.; },
      {},
      x,
      n);
    discs.add(
      Obstacle::circle(p, r, Body::outside),
      [&](const Point &y) { return y.distance(p) <= r; },
      [&](const Point &y, const Vector &) { return std::sqrt((y - p).norm_square() - r * r); },
      x,
      n);
    holes.add(
      Obstacle::circle(p, r, Body::inside),
      [&](const Point &y) { return y.distance(p) >= r; },
      {},
      x,
      n);
    for (const double curvature : {-k, k})
    {
      const auto height = [&](const Point &y) {
        const double across = (y - p).norm_square() - std::pow((y - p) * nu, 2);
        return (y - p) * nu - 0.5 * curvature * across;
      };
      const Beside beside = [&](const Point &y, const Vector &m) {
        return std::sqrt(2. * height(y) / (k * (1. - std::pow(m * nu, 2))));
      };
      (curvature < 0. ? bumps : cups)
        .add(
          Obstacle::parabola(p, length * nu, curvature),
          [&](const Point &y) { return height(y) <= 0.; },
          curvature < 0. ? beside : Beside(),
          x,
          n);
    }
  }
  planes.check(checks, "planes");
  discs.check(checks, "discs");
  holes.check(checks, "holes");
  bumps.check(checks, "parabolas that bend away");
  cups.check(checks, "parabolas that bend towards the body");
}

double entry(const Obstacle &obstacle, const Point &x, const Vector &n)
{
  return obstacle.distance(x, n).value_or(std::numeric_limits<double>::quiet_NaN());
}

/** Where a formula with cancellation would lose digits. */
void test_digits(Checks &checks)
{
  const Vector up({0., 1.}), down({0., -1.});
  // The line y = slope x meets x²/2 at x = 0 and at x = 2 slope; it starts at x = 1, almost
  // parallel to the parabola there.
  const double slope = 1. + 1e-9, norm = std::hypot(1., slope);
  checks.near("a chord of a parabola",
              entry(Obstacle::parabola(Point(0., 0.), up, 1.),
                    Point(1., slope),
                    Vector({1. / norm, slope / norm})),
              norm * (2. * slope - 1.),
              1e-15);
  // With a small curvature the second root is far away.
  for (const double k : {1e-8, 1e-14, -1e-14})
  {
    const double angle = 0.7, h = 0.3, s = std::sin(angle);
    // h - s t = k/2 (cos t)²: t = h/s - k/2 (cos h/s)²/s + O(k²).
    checks.near("nearly a plane, curvature " + std::to_string(std::log10(std::abs(k))),
                entry(Obstacle::parabola(Point(0., 0.), up, k), Point(0., h), at_angle(-angle)),
                h / s - 0.5 * k * std::pow(std::cos(angle) * h / s, 2) / s,
                1e-15);
  }
  // A large disc is a parabola up to x⁴/(8 R³).
  const double R = 1e4, x = 0.5;
  checks.near("a large disc",
              entry(Obstacle::circle(Point(0., -R), R, Body::outside), Point(x, 0.), down),
              x * x / (2. * R),
              4e-12);
}

void test_misses(Checks &checks)
{
  const Vector up({0., 1.}), down({0., -1.}), right({1., 0.});
  const Point x(0., 1.);
  const Obstacle ground = Obstacle::plane(Point(3., 0.), up);
  checks.that("along a plane", !ground.distance(x, right));
  const Obstacle slope = Obstacle::plane(Point(1., 1.), Vector({1., 3.}));
  const Vector along({3. / std::sqrt(10.), -1. / std::sqrt(10.)});
  bool is_parallel = !slope.can_be_hit_along(along);
  for (const double height : {-1e-16, 0., 1e-16})
    is_parallel = is_parallel && !slope.distance(Point(1., 1. + height), along) &&
                  !slope.distance(Point(1., 1. + height), -along);
  checks.that("along a plane but for rounding", is_parallel);
  checks.that("away from a plane", !ground.distance(x, up));
  checks.that("out of a plane", !ground.distance(Point(0., -1.), up));
  checks.near("into a plane from inside", entry(ground, Point(0., -1.), down), -1., 0.);
  checks.that("can_stop",
              ground.can_be_hit_along(down) && !ground.can_be_hit_along(right) &&
                !ground.can_be_hit_along(up));
  const Obstacle disc = Obstacle::circle(Point(0., 0.), 0.5, Body::outside);
  const double tangent = std::sqrt(0.75);
  checks.near("a disc behind", entry(disc, x, up), tangent, 1e-15);
  checks.that("is_met: what is ahead, near enough, or around the point",
              disc.is_hit_by_line(x, down, 1.) && !disc.is_hit_by_line(x, down, 0.4) &&
                !disc.is_hit_by_line(x, up, 1.) &&
                !disc.is_hit_by_line(Point(0.6, 0.8), down, 1.) &&
                disc.is_hit_by_line(Point(), right, 1.) && ground.is_hit_by_line(x, down, 2.) &&
                !ground.is_hit_by_line(x, up, 2.));
  checks.near("beside a disc", entry(disc, Point(0.6, 0.8), down), tangent, 1e-15);
  const Obstacle hole = Obstacle::circle(Point(0., 0.), 2., Body::inside);
  checks.near("in a hole", entry(hole, x, up), 1., 1e-15);
  checks.near("a hole that is too small", entry(hole, Point(0., 2.25), up), -0.25, 1e-15);
  checks.that("outside of a hole", !hole.distance(Point(0., 3.), down));
}

/** Half disc on a plane: (R + t) n_y = -(R + h), so that t = h/|n_y| + R (1/|n_y| - 1). */
void test_gaps(Checks &checks)
{
  const double R = 2., h = 0.125, largest = 40.;
  const Side<2> arc = make_half_disc(R).sides[1], flat = make_half_disc(R).sides[0];
  const auto ground = std::make_shared<Foundation>(
    std::vector<Obstacle>{Obstacle::plane(Point(0., -R), Vector({0., 5.}))}, largest);
  const auto gap = foundation_gap(arc, ground, Vector({7., -h}));
  double difference = 0.;
  for (double angle = 0.2; angle < 3.; angle += 0.1)
    difference = std::max(difference,
                          std::abs(gap->value(arc.point(R * angle)) - h / std::sin(angle) -
                                   R * (1. / std::sin(angle) - 1.)));
  checks.near("a half disc above a plane", difference, 0., 1e-13);
  checks.near("beside the arc as on it", gap->value(Point(0., -R - 1e-3)), h, 1e-14);
  checks.near("at most the largest gap", gap->value(arc.point(1e-4)), largest, 0.);
  checks.near("the flat side sees nothing",
              foundation_gap(flat, ground, Vector())->value(Point(0., 0.)),
              largest,
              0.);
  // In a hole about its own centre the gap of a disc is the same everywhere; moved by e it is
  // e cos(theta) + sqrt(r² - e² sin²(theta)) - R.
  const Side<2> outer = make_ring(1., R).sides[1];
  const auto hole = std::make_shared<Foundation>(
    std::vector<Obstacle>{Obstacle::circle(Point(0., 0.), R + h, Body::inside)}, largest);
  const double e = 0.1;
  const auto moved = foundation_gap(outer, hole, Vector({e, 0.}));
  double eccentric = 0.;
  for (double position = 0.; position < outer.length(); position += 0.1)
  {
    const Point x = outer.point(position);
    const double cosine = x[0] / R, sine = x[1] / R;
    const double t = e * cosine + std::sqrt(std::pow(R + h, 2) - std::pow(e * sine, 2)) - R;
    eccentric = std::max(eccentric, std::abs(moved->value(x) - t));
  }
  checks.near("a shaft in a hole", eccentric, 0., 1e-14);
  checks.near("a shaft in the middle of it",
              foundation_gap(outer, hole, Vector())->value(Point(0., R)),
              h,
              1e-15);
}

Scene<2> scene(std::vector<std::string> settings)
{
  settings.insert(settings.end(), {"Boundary/Clamped=top", "Boundary/Contact=bottom, left"});
  return make_scene<2>(parse_parameters("", "foundation.prm", settings));
}

const BoundaryCondition<2> &condition(const Scene<2> &scene, const std::string &side)
{
  return scene.boundary.at(scene.geometry.find_side(side));
}

/** The unit square. */
void test_scenes(Checks &checks)
{
  const auto value = [&](const Scene<2> &of, const std::string &side, const Point &x) {
    return condition(of, side).data->value(x);
  };
  const Scene<2> two =
    scene({"Constants/Values=R=0.25, gap=0.01",
           "Contact/Foundation=circle 0.25,-R-gap radius R | left: plane "
           "-0.5, 0 normal 2*R,0 | bottom: parabola 1,-0.1 normal 0,1 curvature -1/R"});
  checks.near("a circle", value(two, "bottom", Point(0.25, 0.)), 0.01, 1e-15);
  checks.near("beside it the parabola", value(two, "bottom", Point(0.75, 0.)), 0.225, 1e-15);
  checks.near("a plane on the left", value(two, "left", Point(0., 0.3)), 0.5, 1e-15);
  checks.that("things by side",
              condition(two, "left").foundation->things().size() == 2 &&
                condition(two, "bottom").foundation->things().size() == 2 &&
                condition(two, "right").foundation == nullptr);
  const Scene<2> mixed =
    scene({"Contact/Gap=left: y^2",
           "Contact/Foundation=bottom:circle 0.5, -1 radius 1 | bottom: circle "
           "0,-(1+1) radius (2)",
           "Contact/Foundation position=0.25, -1/8"});
  checks.near("a gap on the left", value(mixed, "left", Point(0., 0.5)), 0.25, 0.);
  checks.that("which is no foundation", condition(mixed, "left").foundation == nullptr);
  checks.near("moved", value(mixed, "bottom", Point(0.75, 0.)), 0.125, 1e-15);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_search(checks);
  test_digits(checks);
  test_misses(checks);
  test_gaps(checks);
  test_scenes(checks);
  return checks.exit_code();
}
