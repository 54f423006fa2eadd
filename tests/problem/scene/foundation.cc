// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid things: where lines enter them, against a search that only asks which points they contain,
// and against closed forms; foundations in parameter files.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/facing.h>
#include <signorini/problem/scene/foundation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "../../random_numbers.h"
#include "contact_of.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
Vector at_angle(const double angle) {
  return Vector({std::cos(angle), std::sin(angle)});
}

/** A thing, a function that is negative inside of it, and, where lines pass by it, the distance of
 * the place that then counts: sqrt(t_1 t_2). */
struct Thing {
  std::string name;
  Obstacle<2> obstacle;
  std::function<double(const Point &)> height;
  std::function<double(const Point &, const Vector &)> beside = {};
};

/** Random lines: the distance is that to the first point where height has the value zero. */
void test_lines(Checks &checks) {
  constexpr double reach = 20., rounding = 1e-9;
  RandomNumbers random(7);
  const auto point = [&]() { return Point(2. * random(), 2. * random()); };
  std::map<std::string, std::array<unsigned int, 3>> cases;
  for (unsigned int i = 0; i < 600; ++i) {
    const Point p = point(), x = point();
    const Vector nu = at_angle(PI * random()), n = at_angle(PI * random());
    const double length = std::exp(3. * random()), r = 1. + 0.9 * random(), k = 1. + 0.9 * random();
    const auto parabola = [=](const double curvature) {
      return [=](const Point &y) {
        const double across = (y - p).norm_square() - std::pow((y - p) * nu, 2);
        return (y - p) * nu - 0.5 * curvature * across;
      };
    };
    for (const Thing &thing : std::vector<Thing>{
           {"plane", Obstacle<2>::plane(p, length * nu),
            [&](const Point &y) { return (y - p) * nu; }},
           {"disc", Obstacle<2>::circle(p, r, Body::outside),
            [&](const Point &y) { return y.distance(p) - r; },
            [&](const Point &y, const Vector &) {
              return std::sqrt((y - p).norm_square() - r * r);
            }},
           {"hole", Obstacle<2>::circle(p, r, Body::inside),
            [&](const Point &y) { return r - y.distance(p); }},
           {"hill", Obstacle<2>::parabola(p, length * nu, -k), parabola(-k),
            [&](const Point &y, const Vector &m) {
              return std::sqrt(2. * parabola(-k)(y) / (k * (1. - std::pow(m * nu, 2))));
            }},
           {"valley", Obstacle<2>::parabola(p, length * nu, k), parabola(k)}}) {
      const std::optional<double> t = thing.obstacle.distance(x, n);
      const bool is_inside = thing.height(x) <= 0.;
      const double far = t ? std::min(std::abs(*t), reach) : reach;
      for (double s = 0.01; s < 1. && !is_inside; s += 0.01)
        checks.that(thing.name + ": nothing before",
                    thing.height(x + (1. - rounding) * s * far * n) > -rounding ||
                      (t && thing.beside));
      for (double s = 0.01; s < 1. && is_inside; s += 0.01)
        checks.that(thing.name + ": inside until there",
                    thing.height(x - (1. - rounding) * s * far * n) < rounding);
      const bool is_beside =
        t && thing.beside && !is_inside && std::abs(*t - thing.beside(x, n)) < rounding * *t;
      if (t && !is_beside && std::abs(*t) < reach)
        checks.near(thing.name + ": is met there", thing.height(x + *t * n), 0., 1e-9);
      ++cases[thing.name][!t || is_beside ? 2 : is_inside ? 0 : 1];
    }
  }
  for (const auto &[name, n] : cases)
    checks.that(name + ": all cases occur", n[0] > 50 && n[1] > 50 && n[2] > 50);
}

const Vector up({0., 1.}), down({0., -1.}), right({1., 0.});

double entry(const Obstacle<2> &obstacle, const Point &x, const Vector &n) {
  return obstacle.distance(x, n).value_or(std::numeric_limits<double>::quiet_NaN());
}

/** Where a formula with cancellation would lose digits. */
void test_digits(Checks &checks) {
  // The line y = slope x meets x²/2 at x = 0 and at x = 2 slope; it starts at x = 1, almost
  // parallel to the parabola there.
  const double slope = 1. + 1e-9, norm = std::hypot(1., slope);
  checks.near("a chord of a parabola",
              entry(Obstacle<2>::parabola(Point(0., 0.), up, 1.), Point(1., slope),
                    Vector({1. / norm, slope / norm})),
              norm * (2. * slope - 1.), 1e-15);
  // With a small curvature the second root is far away.
  for (const double k : {1e-8, 1e-14, -1e-14}) {
    const double angle = 0.7, h = 0.3, s = std::sin(angle);
    // h - s t = k/2 (cos t)²: t = h/s - k/2 (cos h/s)²/s + O(k²).
    checks.near("nearly a plane, curvature " + std::to_string(std::log10(std::abs(k))),
                entry(Obstacle<2>::parabola(Point(0., 0.), up, k), Point(0., h), at_angle(-angle)),
                h / s - 0.5 * k * std::pow(std::cos(angle) * h / s, 2) / s, 1e-15);
  }
  // A large disc is a parabola up to x⁴/(8 R³).
  const double R = 1e4, x = 0.5;
  checks.near("a large disc",
              entry(Obstacle<2>::circle(Point(0., -R), R, Body::outside), Point(x, 0.), down),
              x * x / (2. * R), 4e-12);
}

void test_directions(Checks &checks) {
  const Point x(0., 1.);
  const Obstacle<2> ground = Obstacle<2>::plane(Point(3., 0.), up);
  checks.that("along a plane", !ground.distance(x, right));
  const Obstacle<2> slope = Obstacle<2>::plane(Point(1., 1.), Vector({1., 3.}));
  const Vector along({3. / std::sqrt(10.), -1. / std::sqrt(10.)});
  bool is_parallel = !slope.can_be_hit_along(along);
  for (const double height : {-1e-16, 0., 1e-16})
    is_parallel = is_parallel && !slope.distance(Point(1., 1. + height), along) &&
                  !slope.distance(Point(1., 1. + height), -along);
  checks.that("along a plane but for rounding", is_parallel);
  checks.that("can_be_hit_along", ground.can_be_hit_along(down) &&
                                    !ground.can_be_hit_along(right) &&
                                    !ground.can_be_hit_along(up));
  const Obstacle<2> disc = Obstacle<2>::circle(Point(), 0.5, Body::outside);
  checks.that("is_hit_by_line: what is ahead, near enough, or around the point",
              disc.is_hit_by_line(x, down, 1.) && !disc.is_hit_by_line(x, down, 0.4) &&
                !disc.is_hit_by_line(x, up, 1.) &&
                !disc.is_hit_by_line(Point(0.6, 0.8), down, 1.) &&
                disc.is_hit_by_line(Point(), right, 1.) && ground.is_hit_by_line(x, down, 2.) &&
                !ground.is_hit_by_line(x, up, 2.));
}

/** Half disc on a plane: (R + t) n_y = -(R + h), so that t = h/|n_y| + R (1/|n_y| - 1). */
void test_gaps(Checks &checks) {
  const double R = 2., h = 0.125, largest = 40.;
  const Side<2> arc = make_half_disc(R).sides[1], flat = make_half_disc(R).sides[0];
  const auto ground = std::make_shared<Foundation<2>>(
    std::vector<Obstacle<2>>{Obstacle<2>::plane(Point(0., -R), Vector({0., 5.}))}, largest);
  const auto gap = foundation_gap<2>(arc, ground, Vector({7., -h}));
  for (double angle = 0.2; angle < 3.; angle += 0.1)
    checks.near("a half disc above a plane", gap->value(arc.point(R * angle)),
                (R + h) / std::sin(angle) - R, 1e-13);
  checks.near("beside the arc as on it", gap->value(Point(0., -R - 1e-3)), h, 1e-14);
  checks.near("at most the largest gap", gap->value(arc.point(1e-4)), largest, 0.);
  checks.near("the flat side sees nothing",
              foundation_gap<2>(flat, ground, Vector())->value(Point(0., 0.)), largest, 0.);
  // In a hole about its own centre the gap of a disc is the same everywhere; moved by e it is
  // e cos(theta) + sqrt(r² - e² sin²(theta)) - R.
  const Side<2> outer = make_ring(1., R).sides[1];
  const auto hole = std::make_shared<Foundation<2>>(
    std::vector<Obstacle<2>>{Obstacle<2>::circle(Point(0., 0.), R + h, Body::inside)}, largest);
  for (const double e : {0., 0.1}) {
    const auto moved = foundation_gap<2>(outer, hole, Vector({e, 0.}));
    for (double position = 0.; position < outer.length(); position += 0.1) {
      const Point x = outer.point(position);
      checks.near("a shaft in a hole", moved->value(x),
                  e * x[0] / R + std::sqrt(std::pow(R + h, 2) - std::pow(e * x[1] / R, 2)) - R,
                  1e-14);
    }
  }
}

/** Things in space: where a line enters one, its distance from the centre or the axis is the
 * radius, and that does not change with turns of everything. */
void test_space(Checks &checks) {
  using Point3 = dealii::Point<3>;
  using Vector3 = dealii::Tensor<1, 3>;
  const Point3 c(0.3, -0.2, 0.5);
  const double r = 0.7;
  const Vector3 axis({1., 2., -2.}), e = axis / 3., away({2., -2., -1.}); // away is across the axis
  const auto ball = Obstacle<3>::circle(c, r, Body::outside),
             socket = Obstacle<3>::circle(c, r, Body::inside),
             bar = Obstacle<3>::cylinder(c, axis, r, Body::outside),
             hole = Obstacle<3>::cylinder(c, axis, r, Body::inside),
             ground = Obstacle<3>::plane(c, axis);
  const auto across = [&](const Vector3 &v) { return v - (v * e) * e; };
  RandomNumbers random(7);
  for (unsigned int i = 0; i < 100; ++i) {
    Vector3 n, d;
    for (unsigned int k = 0; k < 3; ++k) {
      n[k] = random();
      d[k] = random();
    }
    n /= n.norm();
    const Vector3 far = 2. * d / d.norm(), near = 0.3 * d / d.norm();
    const double of_ball = *ball.distance(c + far, n), of_bar = *bar.distance(c + far, n),
                 of_socket = *socket.distance(c + near, n), of_hole = *hole.distance(c + near, n);
    if (ball.is_hit_by_line(c + far, n, 10.)) {
      checks.near("a ball is met on its surface", (far + of_ball * n).norm(), r, 1e-12);
      checks.that("ahead, on the near side", of_ball > 0. && (far + of_ball * n) * n < 0.);
      checks.near("its normal",
                  ((far + of_ball * n) / r - *ball.normal_at_entry(c + far, n)).norm(), 0., 1e-11);
    } else
      checks.near("beside a ball, the length of the tangent", of_ball,
                  std::sqrt(far.norm_square() - r * r), 1e-12);
    if (bar.is_hit_by_line(c + far, n, 10.))
      checks.near("a bar is met on its surface", across(far + of_bar * n).norm(), r, 1e-10);
    checks.near("a socket", (near + of_socket * n).norm(), r, 1e-13);
    checks.near("a round hole", across(near + of_hole * n).norm(), r, 1e-11);
    checks.that("both ahead", of_socket > 0. && of_hole > 0.);
    if (const auto t = ground.distance(c + far, n); t && far * e > 0.)
      checks.near("a plane", (far + *t * n) * e, 0., 1e-9 * (1. + std::abs(*t)));
  }
  checks.that("along its axis nothing meets a bar",
              !bar.distance(c + away, e) && !bar.can_be_hit_along(e) && !hole.distance(c, -1. * e));
  // A ball in a socket with another centre: as in the plane through both centres.
  const Side<3> lower("ball", SurfacePart(Surface::sphere(Point3(), 1., Body::inside),
                                          {{{Point3(-1., 0., 0.), Point3(0., 1., 0.),
                                             Point3(0., -1., 0.), Point3(1., 0., 0.)}}}));
  const auto above = std::make_shared<Foundation<3>>(
    std::vector<Obstacle<3>>{Obstacle<3>::circle(Point3(0., 0., 0.05), 1.05, Body::inside)}, 10.);
  const auto gap = foundation_gap<3>(lower, above, Vector3());
  for (const double angle : {0., 0.4, 1., 1.5}) {
    const Point3 x(std::sin(angle), 0., -std::cos(angle));
    checks.near("a ball in a socket", gap->value(x),
                -0.05 * std::cos(angle) +
                  std::sqrt(1.05 * 1.05 - std::pow(0.05 * std::sin(angle), 2)) - 1.,
                1e-14);
    checks.near("beside the ball as on it", gap->value(Point3(0.98 * x)), gap->value(x), 1e-14);
  }
}

/** Planes act along their own normals on all of a round side, whose gap then is the height above
 * them; where there are several, the nearest one that the body faces. */
void test_planes(Checks &checks) {
  const double R = 2., largest = 40.;
  const Side<2> arc = make_half_disc(R).sides[1], flat = make_half_disc(R).sides[0];
  const auto ground = std::make_shared<Foundation<2>>(
    std::vector<Obstacle<2>>{Obstacle<2>::plane(Point(0., -R), Vector({0., 5.}))}, largest);
  const ContactDirections<2> below(arc, *ground, Vector({0., -0.25}));
  const auto height = foundation_gap<2>(arc, ground, Vector({0., -0.25}), below);
  checks.that("one plane, one direction", below.changes().empty() && !below.are_normals());
  for (double s = 0.05; s < arc.length(); s += 0.1) {
    checks.near("along the plane's normal", (*below.at(s) - down).norm(), 0., 1e-15);
    checks.near("the gap is the height", height->value(arc.point(s)), arc.point(s)[1] + R + 0.25,
                1e-14);
  }
  checks.that(
    "a straight side that is parallel keeps its normal",
    ContactDirections<2>(
      flat, Foundation<2>({Obstacle<2>::plane(Point(0., 1.), Vector({0., -3.}))}, largest), {})
      .are_normals());
  // A groove about the line that is tilted by 0.1: the nearest plane changes at the lowest point of
  // that line, and beside the groove planes go on.
  const double tilt = 0.1;
  const Vector left = at_angle(PI / 4. + tilt), to_right = at_angle(3. * PI / 4. + tilt);
  const Foundation<2> groove({Obstacle<2>::plane(Point(-2. * R * left), left),
                              Obstacle<2>::plane(Point(-2. * R * to_right), to_right)},
                             largest);
  const ContactDirections<2> two(arc, groove, {});
  const double bottom = arc.arc_length(Point(R * at_angle(-PI / 2. + tilt)));
  checks.near("a groove", two.changes().size(), 1., 0.);
  checks.near("the nearest plane changes", two.changes().at(0), bottom, 1e-10);
  for (const double s : {bottom - 0.3, bottom + 0.3})
    checks.near("the plane on this side", *two.at(s) * arc.normal(s), std::cos(PI / 4. - 0.3 / R),
                1e-12);
  checks.that("changes lie between", two.change_between(bottom - 1e-9, bottom + 1e-9) &&
                                       !two.change_between(bottom + 1e-9, arc.length()));
  // Between two plates: a side does not belong to the one behind the body, however near it is.
  const Foundation<2> plates(
    {Obstacle<2>::plane(Point(0., -30.), up), Obstacle<2>::plane(Point(0., 0.), down)}, largest);
  checks.near("the plate in front",
              (*ContactDirections<2>(arc, plates, {}).at(bottom) - down).norm(), 0., 1e-15);
  const Obstacle<2> disc = Obstacle<2>::circle(Point(0., -5.), 2., Body::outside);
  checks.that("round things",
              ContactDirections<2>(arc, Foundation<2>({disc}, largest), {}).are_normals() &&
                !disc.direction());
  checks.near(
    "their normals",
    (*disc.normal_at_entry(Point(0., 0.), down) - up).norm() +
      (*Obstacle<2>::parabola(Point(0., 0.), up, 1.).normal_at_entry(Point(1., 3.), down) -
       Vector({-1., 1.}) / std::sqrt(2.))
        .norm(),
    0., 1e-15);
}

/** A body that fits its foundation has no gap: not by rounding either, which would press it. */
void test_exact_fit(Checks &checks) {
  const auto fits = [&checks](const std::string &name, std::vector<std::string> settings,
                              const std::string &side) {
    const Scene<2> scene = make_scene<2>(parse_parameters("", "fit.prm", settings));
    const ContactCondition<2> &contact = contact_of(scene, side);
    const Side<2> &on = scene.geometry.sides[contact.side];
    double largest = 0.;
    for (unsigned int k = 0; k <= 200; ++k)
      largest = std::max(largest, std::abs(contact.gap->value(on.point(on.length() * k / 200.))));
    checks.near(name, largest, 0., 0.);
  };
  const std::vector<std::string> half_disc = {"Geometry/Shape=half disc", "Geometry/Radius=0.7",
                                              "Geometry/Centre=0.3,0.1", "Boundary/Clamped=flat",
                                              "Boundary/Contact=arc"};
  const auto with = [](std::vector<std::string> settings, const std::string &more) {
    settings.push_back(more);
    return settings;
  };
  fits("a half disc in its circle",
       with(half_disc, "Contact/Foundation=circle 0.3,0.1 radius 0.7 inside"), "arc");
  fits("the same by a formula", with(half_disc, "Contact/Gap=0.7 - sqrt((x-0.3)^2 + (y-0.1)^2)"),
       "arc");
  fits("a rectangle on a plane that was moved",
       {"Geometry/Lower left=0,0.3", "Boundary/Clamped=top", "Boundary/Contact=bottom",
        "Contact/Foundation=plane 0,0.1 normal 0,1", "Contact/Foundation position=0,0.2"},
       "bottom");
}

Scene<2> scene(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"Boundary/Clamped=top", "Boundary/Contact=bottom, left"});
  return make_scene<2>(parse_parameters("", "foundation.prm", settings));
}

/** The unit square. */
void test_scenes(Checks &checks) {
  const Scene<2> two =
    scene({"Constants/Values=R=0.25, gap=0.01",
           "Contact/Foundation=circle 0.25,-R-gap radius R | left: plane "
           "-0.5, 0 normal 2*R,0 | bottom: parabola 1,-0.1 normal 0,1 curvature -1/R"});
  const Scene<2> mixed =
    scene({"Contact/Gap=left: y^2",
           "Contact/Foundation=bottom:circle 0.5, -1 radius 1 | bottom: circle "
           "0,-(1+1) radius (2)",
           "Contact/Foundation position=0.25, -1/8"});
  checks.near("a circle, beside it a parabola, a plane, a gap, what is moved",
              {contact_of(two, "bottom").gap->value(Point(0.25, 0.)),
               contact_of(two, "bottom").gap->value(Point(0.75, 0.)),
               contact_of(two, "left").gap->value(Point(0., 0.3)),
               contact_of(mixed, "left").gap->value(Point(0., 0.5)),
               contact_of(mixed, "bottom").gap->value(Point(0.75, 0.))},
              {0.01, 0.225, 0.5, 0.25, 0.125}, 1e-15);
  for (const char *side : {"left", "bottom"})
    checks.near("things by side", contact_of(two, side).foundation->things().size(), 2, 0);
  checks.that("no foundation", contact_of(mixed, "left").foundation == nullptr);
}

/** Returns whether the line along the normal of a curve meets another one at a point that faces it,
 * among the chords of that, and its circle nowhere nearer: no formula of facing_parts(). */
bool faces(const Curve &curve, const double s, const Curve &other, const double least) {
  constexpr unsigned int n = 4000;
  const Point x = curve.point(s);
  const Vector n_x = curve.normal(s), t({-n_x[1], n_x[0]});
  double before = 0.;
  bool found = false;
  for (unsigned int i = 0; i <= n; ++i) {
    const double on = i * other.length() / n, side = (other.point(on) - x) * t;
    if (i > 0 && side * before <= 0.) {
      const double at = on - 0.5 * other.length() / n, d = (other.point(at) - x) * n_x,
                   farther = other.is_flat()
                               ? HUGE_VAL
                               : 2. * (*other.centre_at(other.point(at)) - x) * n_x - d;
      found = found || (other.normal(at) * n_x < -least && std::abs(d) < std::abs(farther));
    }
    before = side;
  }
  return found;
}

/** The parts that face each other, in closed form and at points of random segments and arcs. */
void test_facing(Checks &checks) {
  const Curve table(Point(-1., 0.), Point(2., 0.), Vector({0., 1.}));
  for (const double length : {0.1, 1e-6}) {
    const Curve seat(Point(0.5, 0.2), Point(0.5 + length, 0.2), Vector({0., -1.}));
    const std::vector<FacingPart> parts = facing_parts(table, seat, 0.8);
    checks.that("one short part", parts.size() == 1);
    checks.near("  its ends and distance", {parts[0].from, parts[0].to, parts[0].distance},
                {1.5, 1.5 + length, 0.2}, 1e-14);
  }
  checks.that("no back of a side",
              facing_parts(table, Curve(Point(0.6, 0.2), Point(0.5, 0.2)), 0.).empty());
  const Side<2> disc = make_disc(1.).sides[0];
  const Curve wall(Point(-1.5, -1.5), Point(-1.5, 1.5), Vector({1., 0.}));
  const auto overlap = [](const Curve &first, const Curve &second) {
    return hull_of(first, facing_parts(first, second, grazing));
  };
  const FacingPart round = overlap(disc, wall), flat = overlap(wall, disc);
  checks.near("around the start of a circle", {round.from, round.to, round.distance},
              {1.75 * PI, 2.25 * PI, 0.5}, 1e-12);
  const double turned = std::sin(PI / 3.);
  checks.near("a disc: normals that turn by less than 60 degrees",
              {flat.from, flat.to, flat.distance}, {1.5 - turned, 1.5 + turned, 0.5}, 1e-12);
  checks.near("a shaft in a hole: all around", overlap(make_ring(1., 2.).sides[0], disc).to,
              2. * PI, 1e-12);
  RandomNumbers random(11);
  const auto curve = [&random]() {
    const Point a(2. * random(), 2. * random()), b(2. * random(), 2. * random());
    const double first = PI * random();
    return random() > 0. ? Curve(a, b)
                         : Curve::arc(a, 1.1 + random(), first, first + 3. * random(),
                                      random() > 0. ? Body::inside : Body::outside);
  };
  unsigned int n_wrong = 0, n_facing = 0;
  for (unsigned int i = 0; i < 200; ++i) {
    const Curve first = curve(), second = curve();
    const double least = i % 2 == 0 ? 0. : 0.5;
    const std::vector<FacingPart> parts = facing_parts(first, second, least);
    for (unsigned int k = 0; k < 10; ++k) {
      const double s = 0.5 * (1. + random()) * first.length();
      double margin = first.length();
      bool inside = false;
      for (const FacingPart &part : parts) {
        margin = std::min({margin, std::abs(s - part.from), std::abs(s - part.to)});
        inside = inside || (s > part.from && s < part.to);
      }
      if (margin < 0.01 * first.length())
        continue;
      n_facing += inside;
      n_wrong += inside != faces(first, s, second, least);
    }
  }
  checks.that("random curves face each other", n_facing > 50);
  checks.near("  where the chords say so", n_wrong, 0, 0);
}
} // namespace

int main() {
  return run_tests({test_lines, test_digits, test_directions, test_gaps, test_space, test_planes,
                    test_exact_fit, test_scenes, test_facing});
}
