// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces through points of a side: points of planes, spheres and cylinders with known numbers, as
// they are and rounded, and points of other surfaces, which must not be taken for one of them.

#include <signorini/problem/geometry/surface_fit.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "../../random_numbers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;

/** Three unit vectors at right angles, in no special direction, and a place. */
struct Frame {
  std::array<Vector, 3> e;
  Vector origin;

  explicit Frame(RandomNumbers &random) {
    for (Vector &v : e)
      for (unsigned int d = 0; d < 3; ++d)
        v[d] = random();
    e[0] /= e[0].norm();
    e[2] = cross_product_3d(e[0], e[1]);
    e[2] /= e[2].norm();
    e[1] = cross_product_3d(e[2], e[0]);
    for (unsigned int d = 0; d < 3; ++d)
      origin[d] = 0.3 * random();
  }
  Point operator()(const Vector &y) const {
    return Point(origin + y[0] * e[0] + y[1] * e[1] + y[2] * e[2]);
  }
};

using Map = std::function<Vector(double, double)>;

/** A grid of m × n faces on the image of the unit square, with the nodes of degree 1 or 2, rounded
 * to multiples of a number; normals along dx/ds × dx/dt. */
SurfaceSamples grid(const Map &map, const Frame &frame, const unsigned int m, const unsigned int n,
                    const unsigned int degree = 1, const double unit = 0.) {
  const auto at = [&](const double s, const double t) {
    Point x = frame(map(s, t));
    for (unsigned int d = 0; d < 3 && unit > 0.; ++d)
      x[d] = unit * std::round(x[d] / unit);
    return x;
  };
  SurfaceSamples samples;
  for (unsigned int i = 0; i <= degree * m; ++i)
    for (unsigned int j = 0; j <= degree * n; ++j)
      samples.points.push_back(at(double(i) / (degree * m), double(j) / (degree * n)));
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < n; ++j) {
      const auto corner = [&](const unsigned int a, const unsigned int b) {
        return at(double(i + a) / m, double(j + b) / n);
      };
      const std::array<Point, 4> x = {{corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)}};
      const Vector normal = cross_product_3d(x[3] - x[0], x[2] - x[1]);
      samples.faces.push_back({Point((x[0] + x[1] + x[2] + x[3]) / 4.), normal / normal.norm()});
    }
  return samples;
}

constexpr double R = 1.3;

/** A cylinder about z with the outer normal, or the inner one. */
Map cylinder(const double angle, const double length, const bool outer = true) {
  return [=](const double s, const double t) {
    const double a = angle * ((outer ? s : 1. - s) - 0.5);
    return Vector({R * std::cos(a), R * std::sin(a), length * t});
  };
}

/** A square piece of a sphere about the x-axis with the outer normal. */
Map sphere(const double angle) {
  return [=](const double s, const double t) {
    const double a = std::tan(angle / 2.);
    const Vector y({1., a * (2. * s - 1.), a * (2. * t - 1.)});
    return R / y.norm() * y;
  };
}

/** y = f(x) or (x, y)(s), extruded along z. */
Map extruded(const std::function<Vector(double)> &curve, const double length = 1.) {
  return [=](const double s, const double t) { return curve(s) + Vector({0., 0., length * t}); };
}

Vector ellipse_point(const double ratio, const double angle, const double s) {
  const double a = PI / 4. + angle * (s - 0.5);
  return Vector({ratio * std::cos(a), std::sin(a), 0.});
}

/** What digits of the coordinates and an angle leave of the radius: the table of a fit. */
void test_angles(Checks &checks) {
  RandomNumbers random(3);
  const std::vector<double> angles = {90., 20., 5., 2.};
  const std::array<std::vector<double>, 2> errors = {
    {{1e-8, 1e-7, 1e-6, 1e-5}, {1e-5, 2e-4, 3e-3, 2e-2}}};
  for (unsigned int k = 0; k < angles.size(); ++k)
    for (unsigned int repetition = 0; repetition < 5; ++repetition) {
      const Frame frame(random);
      const double angle = angles[k] * PI / 180.;
      checks.about("angle " + std::to_string(int(angles[k])));
      const bool outer = repetition % 2 == 0;
      const Map shaft = cylinder(angle, R * angle, outer), ball = sphere(angle);
      const auto round = [&](const SurfaceFit &fit, const std::string &kind, const double error) {
        checks.that("the kind is found", fit.surface.name() == kind);
        checks.near("the radius", fit.surface.radius() / R, 1., error);
        const Vector arm = fit.surface.point() - frame.origin;
        const Vector off = arm - (arm * fit.surface.axis()) * fit.surface.axis();
        checks.near("the centre or the axis", off.norm(), 0., error * R);
        if (kind == "cylinder")
          checks.near("the direction", std::abs(fit.surface.axis() * frame.e[2]), 1., error);
        checks.that("the hand",
                    (fit.surface.body() == Body::inside) == (kind == "sphere" || outer));
      };
      const double exact = 1e-12 * std::pow(90. / angles[k], 2);
      round(fit_surface(grid(shaft, frame, 8, 5)), "cylinder", exact);
      round(fit_surface(grid(ball, frame, 6, 6)), "sphere", exact);
      for (unsigned int d = 0; d < 2; ++d) {
        const double unit = d == 0 ? 1e-9 : 1e-6;
        round(fit_surface(grid(shaft, frame, 8, 5, 1, unit)), "cylinder", errors[d][k]);
        round(fit_surface(grid(ball, frame, 6, 6, 1, unit)), "sphere", errors[d][k]);
        checks.between("the residual is that of the rounding",
                       fit_surface(grid(ball, frame, 6, 6, 1, unit)).residual / unit, 0.2, 1.);
      }
    }
  checks.about("");
  const Frame frame(random);
  const std::array<double, 4> known = {{5e-2, 3e-3, 2e-4, 3e-5}};
  for (unsigned int k = 0; k < angles.size(); ++k) {
    const double angle = angles[k] * PI / 180.;
    checks.between("the condition falls like the square of the angle",
                   fit_surface(grid(sphere(angle), frame, 6, 6)).condition / known[k], 0.4, 2.5);
    checks.between("the condition falls like the square of the angle",
                   fit_surface(grid(cylinder(angle, R * angle), frame, 8, 5)).condition / known[k],
                   0.4, 2.5);
  }
}

/** Surfaces that are none of the three, and points that belong to several. */
void test_others(Checks &checks) {
  RandomNumbers random(5);
  constexpr double degree = PI / 180.;
  const auto parabola = [](const double s) { return Vector({-0.5 * s * s, s, 0.}); };
  const auto circle = [](const double s) {
    return R * Vector({std::cos(s * PI / 2.), std::sin(s * PI / 2.), 0.});
  };
  const auto ellipse = [](const double ratio, const double angle) {
    return extruded([=](const double s) { return ellipse_point(ratio, angle * degree, s); });
  };
  const Map cone = [](const double s, const double t) {
    const double a = PI / 2. * s, r = 1. + std::tan(1. * degree) * t;
    return Vector({r * std::cos(a), r * std::sin(a), t});
  };
  const Map torus = [](const double s, const double t) {
    const double a = PI / 2. * s, b = PI / 2. * (t - 0.5), r = 1. + 0.4 * std::cos(b);
    return Vector({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
  };
  const Map saddle = [](const double s, const double t) { return Vector({s, t, 0.1 * s * t}); };
  struct Case {
    std::string name;
    Map map;
    unsigned int m, n, degree;
  };
  for (const Case &c : std::vector<Case>{
         {"ellipse 1 : 1.1 over 90 degrees", ellipse(1.1, 90.), 8, 5, 1},
         {"ellipse 1 : 1.1 over 20 degrees", ellipse(1.1, 20.), 8, 5, 1},
         {"ellipse 1 : 1.01 over 20 degrees", ellipse(1.01, 20.), 8, 5, 2},
         {"parabola", extruded(parabola), 8, 5, 1},
         {"cone of one degree", cone, 8, 5, 1},
         {"torus", torus, 8, 5, 1},
         {"one row of second-order faces on a parabola", extruded(parabola), 1, 6, 2},
         {"two rows of first-order faces on a parabola", extruded(parabola), 2, 6, 1},
         {"one row of second-order faces on a circle", extruded(circle), 1, 6, 2},
         {"four vertices of one face", saddle, 1, 1, 1},
         {"one layer of a cone, which has a sphere through all nodes", cone, 8, 1, 1}})
    for (unsigned int repetition = 0; repetition < 3; ++repetition)
      checks.that(c.name + " is none",
                  fit_surface(grid(c.map, Frame(random), c.m, c.n, c.degree)).surface.kind() ==
                    Surface::Kind::faces);

  const Frame frame(random);
  checks.between(
    "an ellipse 1 : 1.1 over 90 degrees differs from a circle",
    fit_surface(grid(ellipse(1.1, 90.), frame, 8, 5), Surface::Kind::cylinder).residual, 4e-3,
    9e-3);
  SurfaceSamples samples = grid(cylinder(1., 1.), frame, 8, 5);
  samples.faces[7].n *= -1.;
  checks.that("a normal on the other side: none",
              fit_surface(samples).surface.kind() == Surface::Kind::faces &&
                !fit_surface(samples, Surface::Kind::cylinder).follows_normals);
  const SurfaceFit layer = fit_surface(grid(cylinder(1., 0.1), frame, 8, 1));
  checks.that("one layer of a cylinder is one, though a sphere goes through all nodes",
              layer.surface.name() == "cylinder");
  checks.near("its radius", layer.surface.radius(), R, 1e-11);
  checks.that("four points of a sphere in a plane are a plane",
              fit_surface(grid(sphere(1.), frame, 1, 1)).surface.is_flat());
  const SurfaceFit whole = fit_surface(grid(cylinder(2. * PI, 3.), frame, 16, 2));
  checks.near("the radius of a whole cylinder", whole.surface.radius(), R, 1e-13);
}

/** Kinds that the user says. */
void test_kinds(Checks &checks) {
  RandomNumbers random(9);
  const Frame frame(random);
  const auto ellipse = [](const double s) { return ellipse_point(1.001, PI / 2., s); };
  const SurfaceFit nearly =
    fit_surface(grid(extruded(ellipse), frame, 8, 5), Surface::Kind::cylinder);
  checks.that("an ellipse that is nearly round can be said to be one",
              nearly.surface.name() == "cylinder" && nearly.follows_normals);
  checks.between("with the residual that it has", nearly.residual, 1e-5, 1e-4);
  const auto circle = [](const double s) { return R * Vector({std::cos(s), std::sin(s), 0.}); };
  const SurfaceFit row =
    fit_surface(grid(extruded(circle), frame, 1, 6, 2), Surface::Kind::cylinder);
  checks.near("three lines tell the cylinder that is said", row.surface.radius(), R, 1e-11);
  checks.that("and not badly", row.condition > 1e-3);
  checks.near("two lines do not",
              fit_surface(grid(extruded(circle), frame, 1, 6), Surface::Kind::cylinder).condition,
              0., 0.);
  SurfaceSamples flat = grid(extruded([](const double s) {
                               return Vector({0., s, 0.});
                             }),
                             frame, 4, 3);
  const SurfaceFit plane = fit_surface(flat);
  checks.that("a plane", plane.surface.name() == "plane" && plane.follows_normals);
  checks.near("its normal", plane.surface.axis(), frame.e[0], 1e-14);
  checks.near("its residual", plane.residual, 0., 1e-14);
  for (SurfacePoint<3> &face : flat.faces)
    face.n *= -1.;
  checks.near("with the body on the other side", fit_surface(flat).surface.axis(), -frame.e[0],
              1e-14);
  for (const Surface::Kind kind : {Surface::Kind::sphere, Surface::Kind::cylinder})
    checks.that("a plane tells no radius", fit_surface(flat, kind).condition < 1e-5);
  checks.that("faces can be said",
              fit_surface(flat, Surface::Kind::faces).surface.name() == "faces");
}
} // namespace

int main() {
  return run_tests({test_angles, test_others, test_kinds});
}
