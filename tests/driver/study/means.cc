// SPDX-License-Identifier: LGPL-2.1-or-later
// Guaranteed means of Output/Report against closed forms: Lame's ring, Kirsch's plate, linear
// fields, A1 and B1 on nested and on graded meshes. No interval may miss, and none may be wider
// than its proof makes it.

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Returns the means of the finest level by name and place: "mean u_x at right". */
std::map<std::string, BoundedValue> means_of(const StudyResult<2> &result) {
  std::map<std::string, BoundedValue> means;
  for (const ProbeReport &report : result.levels.back().answer.reports)
    for (const BoundedValue &mean : report.means)
      means[mean.name + " at " + report.probe] = mean;
  return means;
}

double bound_of(const StudyResult<2> &result) {
  return result.levels.back().bound->absolute.value();
}

/** Checks that an interval contains the exact value, and has at most a certain half width.
 * @return the half width over the true error. */
double check(Checks &checks, const std::map<std::string, BoundedValue> &means,
             const std::string &name, const double exact, const double widest) {
  const auto found = means.find(name);
  checks.that(name + " is there", found != means.end());
  if (found == means.end())
    return 0.;
  const BoundedValue &mean = found->second;
  checks.that(name + " has an interval", mean.error.has_value());
  const double error = mean.error.value_or(0.);
  checks.near(name, mean.value, exact, error);
  checks.between("width of " + name, error, 0., widest);
  return error / std::abs(mean.value - exact);
}

/** Returns the integral of f over [a, b]. */
template <typename Function>
double integral(const Function &f, const double a, const double b, const unsigned int n = 40) {
  const dealii::QGauss<1> rule(8);
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int q = 0; q < rule.size(); ++q)
      sum += rule.weight(q) * (b - a) / n * f(a + (i + rule.point(q)[0]) * (b - a) / n);
  return sum;
}

template <typename Function>
double plane_integral(const Function &f, const dealii::Point<2> &a, const dealii::Point<2> &b) {
  constexpr unsigned int n = 10;
  return integral(
    [&](const double x) {
      return integral([&](const double y) { return f(x, y); }, a[1], b[1], n);
    },
    a[0], b[0], n);
}

const std::vector<std::string> graded = {"Discretization/Strategy=hp",
                                         "Discretization/Target error=1e-4"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::string &report) {
  overrides.push_back("Output/Report=" + report);
  return overrides;
}

/** Lame's ring, a quarter, E = 1, nu = 0.3: xx = A - B Re z^-2, yy = A + B Re z^-2, xy = B Im z^-2
 * with A = 1/3, B = 4/3. These are harmonic: their mean over a disc is the value in its middle. */
void check_ring(Checks &checks, const std::vector<std::string> &mesh) {
  const double A = 1. / 3., B = 4. / 3., pi = dealii::numbers::PI;
  const std::string report =
    "0.9,1.2 radius 0.3 guaranteed | 1.2,0.9 radius 0.499 guaranteed | 0,0 radius 1.5 guaranteed | "
    "-1,-1 box 3,3 guaranteed | side1 guaranteed | side3 guaranteed | 1,1 box 1.2,1.3 guaranteed";
  const StudyResult<2> result =
    solve("subsection Geometry\nset Shape = polygon\nset Vertices = 1,0; 2,0; arc 0,0 ccw; 0,2; "
          "0,1; arc 0,0 cw\nend\nsubsection Boundary\nset Rollers = side0 side2\nset Contact = "
          "side1\nset Traction = side3: x; y\nend\nContact/Gap = 10\n",
          with(mesh, report));
  const auto means = means_of(result);
  const double b = bound_of(result), E1 = 0.7 / (1.3 * 0.4), mu = 1. / 2.6;
  struct Row {
    std::string place;
    double area, xx, yy, xy;
  };
  const double all = 0.75 * pi, part = 0.25 * pi * 1.25;
  for (const Row &row :
       std::vector<Row>{{"0.9,1.2 radius 0.3", pi * 0.09, A + 0.28 / 2.25 * B, A - 0.28 / 2.25 * B,
                         -0.96 / 2.25 * B},
                        {"1.2,0.9 radius 0.499", pi * 0.499 * 0.499, A - 0.28 / 2.25 * B,
                         A + 0.28 / 2.25 * B, -0.96 / 2.25 * B},
                        {"0,0 radius 1.5", part, A, A, -B * std::log(1.5) / part},
                        {"-1,-1 box 3,3", all, A, A, -B * std::log(2.) / all}}) {
    // The bound of the study is the only unknown of the half width.
    const double normal = 1.0001 * std::sqrt(E1 / row.area) * b + 1e-8,
                 shear = 1.0001 * std::sqrt(mu / row.area) * b + 1e-8;
    check(checks, means, "mean stress_xx at " + row.place, row.xx, normal);
    check(checks, means, "mean stress_yy at " + row.place, row.yy, normal);
    check(checks, means, "mean stress_xy at " + row.place, row.xy, shear);
  }
  const auto re_square = [](const double x, const double y) {
    return (x * x - y * y) / ((x * x + y * y) * (x * x + y * y));
  };
  const double in_box = plane_integral(re_square, {1., 1.}, {1.2, 1.3}) / 0.06;
  check(checks, means, "mean stress_xx at 1,1 box 1.2,1.3", A - B * in_box,
        1.0001 * std::sqrt(E1 / 0.06) * b + 1e-8);
  for (const auto &[side, r] : {std::pair("side1", 2.), {"side3", 1.}})
    for (const std::string axis : {"x", "y"})
      check(checks, means, "mean u_" + axis + " at " + side,
            1.3 / 3. * (0.4 * r + 4. / r) * 2. / pi, 5. * b);
}

/** Kirsch's plate under the tension 1 along x, a hole of radius one. The stresses are derivatives
 * of a biharmonic function: their mean over a disc of radius R is f + R²/8 Δf in its middle. */
struct Kirsch {
  static std::array<double, 3> stress(const double x, const double y) {
    const double r2 = x * x + y * y, c2 = (x * x - y * y) / r2, s2 = 2. * x * y / r2,
                 c4 = c2 * c2 - s2 * s2, s4 = 2. * s2 * c2, q = 1. / r2, h = 1.5 * q * q;
    return {{1. - q * (1.5 * c2 + c4) + h * c4, -q * (0.5 * c2 - c4) - h * c4,
             -q * (0.5 * s2 + s4) + h * s4}};
  }
  static double mean(const unsigned int i, const double x, const double y, const double R) {
    constexpr double h = 0.01;
    double laplacian = 0.;
    for (const auto &[k, weight] : {std::pair(0., -5.), {1., 4. / 3.}, {2., -1. / 12.}})
      for (const double sign : {-1., 1.})
        laplacian += weight / (h * h) * (k == 0. ? 0.25 : 1.) *
                     (stress(x + sign * k * h, y)[i] + stress(x, y + sign * k * h)[i]);
    return stress(x, y)[i] + R * R / 8. * laplacian;
  }
};

void check_plate(Checks &checks) {
  const std::string r2 = "(x*x+y*y)", c2 = "((x*x-y*y)/" + r2 + ")", s2 = "(2*x*y/" + r2 + ")",
                    c4 = "(" + c2 + "^2-" + s2 + "^2)", s4 = "(2*" + s2 + "*" + c2 + ")",
                    h = "1.5/" + r2 + "^2*",
                    xx = "1-(1.5*" + c2 + "+" + c4 + ")/" + r2 + "+" + h + c4,
                    yy = "-(0.5*" + c2 + "-" + c4 + ")/" + r2 + "-" + h + c4,
                    xy = "-(0.5*" + s2 + "+" + s4 + ")/" + r2 + "+" + h + s4;
  const StudyResult<2> result = solve(
    "subsection Geometry\nset Shape = polygon\nset Vertices = 1,0; 4,0; 4,4; 0,4; 0,1; arc 0,0 "
    "cw\nend\nsubsection Boundary\nset Rollers = side0 side3\nset Contact = side4\n"
    "set Traction = side1: " +
      xx + "; " + xy + " | side2: " + xy + "; " + yy + "\nend\nContact/Gap = 10\n",
    with(graded, "1.2,1.2 radius 0.65 guaranteed | 0.4,2 radius 0.3 guaranteed"));
  const auto means = means_of(result);
  const double b = bound_of(result), E1 = 0.7 / (1.3 * 0.4);
  for (const auto &[x, y, R, place] :
       {std::tuple(1.2, 1.2, 0.65, "1.2,1.2 radius 0.65"), {0.4, 2., 0.3, "0.4,2 radius 0.3"}})
    for (unsigned int i = 0; i < 3; ++i)
      check(checks, means,
            "mean stress_" +
              std::string(i == 0   ? "xx"
                          : i == 1 ? "yy"
                                   : "xy") +
              " at " + place,
            Kirsch::mean(i, x, y, R),
            1.0001 * std::sqrt(E1 / (dealii::numbers::PI * R * R)) * b + 1e-8);
}

/** A bar with Poisson's ratio zero, clamped on the left: the displacement under a uniform traction
 * 1/|side| along it is x/E, with the energy 2/E. By equilibrium the reaction is known exactly. */
void check_bar(Checks &checks) {
  const StudyResult<2> result =
    solve("Geometry/Upper right = 2, 1\nMaterial/Poisson's ratio = 0\nBoundary/Clamped = left\n"
          "Boundary/Contact = bottom\nBoundary/Traction = right: 0.3+y^2; 0 | top: 0; -exp(x)\n"
          "Contact/Gap = 0\n",
          with(graded, "right guaranteed | left guaranteed | bottom guaranteed | "
                       "bottom from 0 to 1 guaranteed | top from 0 to 1 guaranteed"));
  const auto means = means_of(result);
  checks.between("norm of the dual solution",
                 *means.at("mean u_x at right").error / bound_of(result), std::sqrt(2.),
                 1.2 * std::sqrt(2.));
  check(checks, means, "force_x at left", -0.3 - 1. / 3., 1e-8);
  checks.that("infinite energy",
              means.at("force_y at left").missing.find("infinite") != std::string::npos);
  checks.that("clamped corner", !means.at("force_y at bottom").error.has_value());
  checks.that("no force along a smooth foundation", means.count("force_x at bottom") == 0);
  checks.that("given traction", !means.at("weighted force_n at top from 0 to 1").error.has_value());
}

/** Constant stress and a uniform pressure: 0.75 is the integral of the weight over its stretch. */
void check_block(Checks &checks) {
  const StudyResult<2> result =
    solve("Geometry/Upper right = 2, 1\nBoundary/Rollers = left\nBoundary/Contact = bottom\n"
          "Boundary/Traction = right: 0.3; 0 | top: 0; -0.5\nMaterial/Plane state = stress\n"
          "Geometry/Thickness = 2\n",
          with(graded, "bottom from 0.5 to 1.5 guaranteed | bottom guaranteed | left guaranteed | "
                       "0,0 box 1,1 guaranteed | 0,0 radius 0.5 guaranteed"));
  const auto means = means_of(result);
  check(checks, means, "weighted force_n at bottom from 0.5 to 1.5", -0.75, 1e-8);
  check(checks, means, "force_y at bottom", 2., 1e-8);
  check(checks, means, "force_x at left", -0.6, 1e-8);
  check(checks, means, "mean stress_xx at 0,0 box 1,1", 0.3, 1e-7);
  check(checks, means, "mean stress_yy at 0,0 radius 0.5", -0.5, 1e-7);
  checks.that("nothing holds the body",
              means.at("mean u_y at bottom").missing == "supports do not hold the body alone");
}

/** A scene of the catalogue on the unit square with lambda = mu = 1, clamped at the top. */
void check_catalogue(Checks &checks, const std::string &name,
                     const std::vector<std::string> &mesh) {
  const Parameters parameters = parse_parameters(
    named_scene(name), "test",
    with(mesh,
         "right guaranteed | bottom guaranteed | top guaranteed | 0.2,0.1 box 0.7,0.6 guaranteed | "
         "0.5,0.4 radius 0.35 guaranteed | bottom from 0.1 to 0.6 guaranteed"));
  const Scene<2> scene = make_scene<2>(parameters, named_scenes());
  const StudyResult<2> result = run(parameters, scene);
  const auto means = means_of(result);
  const double b = bound_of(result);
  const Function<2> &u = *scene.exact_displacement;
  const auto stress = [&](const double x, const double y) {
    const dealii::Tensor<1, 2> a = u.gradient({x, y}, 0), c = u.gradient({x, y}, 1);
    return std::array<double, 3>{{3. * a[0] + c[1], a[0] + 3. * c[1], a[1] + c[0]}};
  };
  for (unsigned int i = 0; i < 2; ++i) {
    const std::string axis = i == 0 ? "x" : "y";
    check(checks, means, "mean u_" + axis + " at right",
          integral(
            [&](const double y) {
              return u.value({1., y}, i);
            },
            0., 1.),
          3. * b);
    check(checks, means, "mean u_" + axis + " at bottom",
          integral(
            [&](const double x) {
              return u.value({x, 0.}, i);
            },
            0., 1.),
          3. * b);
  }
  const double xi = 1. / std::sqrt(2.), sides = 5. * b + 1e-5;
  const auto pressure = [&](const double x) {
    return scene.contacts[0].exact_pressure->value({x, 0.});
  };
  // The root at the end of contact: x = xi - t^2.
  const double force =
    integral([&](const double t) { return 2. * t * pressure(xi - t * t); }, 0., std::sqrt(xi));
  check(checks, means, "force_y at bottom", -force, sides);
  const auto weight = [](const double x) {
    const double r = std::clamp(std::min(x - 0.1, 0.6 - x) / 0.125, 0., 1.);
    return r * r * r * (10. - 15. * r + 6. * r * r);
  };
  check(checks, means, "weighted force_n at bottom from 0.1 to 0.6",
        integral([&](const double x) { return weight(x) * pressure(x); }, 0.1, 0.6), sides);
  check(checks, means, "force_y at top",
        integral([&](const double x) { return stress(x, 1.)[1]; }, 0., 1.), sides);
  const double in_box =
    plane_integral([&](const double x, const double y) { return stress(x, y)[1]; }, {0.2, 0.1},
                   {0.7, 0.6}) /
    0.25;
  check(checks, means, "mean stress_yy at 0.2,0.1 box 0.7,0.6", in_box,
        1.0001 * std::sqrt(3. / 0.25) * b + 1e-8);
  const double R = 0.35, in_disc = plane_integral(
                                     [&](const double r, const double angle) {
                                       return r * stress(0.5 + r * std::cos(angle),
                                                         0.4 + r * std::sin(angle))[2];
                                     },
                                     {0., 0.}, {R, 2. * dealii::numbers::PI}) /
                                   (dealii::numbers::PI * R * R);
  check(checks, means, "mean stress_xy at 0.5,0.4 radius 0.35", in_disc,
        1.0001 * std::sqrt(1. / (dealii::numbers::PI * R * R)) * b + 1e-8);
}

/** Places that are refused. */
void check_refusals(Checks &checks) {
  const std::string scene = "Boundary/Contact = bottom\nBoundary/Clamped = top\n";
  for (const std::string report : {"0.5,0.5 guaranteed", "0,0 to 1,1 guaranteed"})
    checks.throws<InputError>(report, "values at points are estimates",
                              [&]() { solve(scene, {"Output/Report=" + report}); });
  for (const std::string report : {"bottom from 0.5 to 2", "bottom from 0.5 to 0.2", "0,0 box 0,1"})
    checks.throws<InputError>(report,
                              "allowed: ", [&]() { solve(scene, {"Output/Report=" + report}); });
  const auto coulomb = means_of(solve(
    scene + "Contact/Friction = coulomb\nContact/Friction coefficient = 0.3\nContact/Gap = -0.01\n",
    with(graded, "bottom guaranteed")));
  checks.that("Coulomb's law has no intervals", !coulomb.at("means at bottom").error.has_value());
}
} // namespace

int main(int argc, char *argv[]) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  checks.about("ring");
  check_ring(checks, graded);
  checks.about("ring, nested");
  check_ring(checks, levels(1, 4));
  checks.about("plate");
  check_plate(checks);
  checks.about("bar");
  check_bar(checks);
  checks.about("block");
  check_block(checks);
  for (const std::string name : {"A1", "B1"}) {
    for (const unsigned int level : {3, 5}) {
      checks.about(name + " on level " + std::to_string(level));
      check_catalogue(checks, name, levels(2, level, {"Output/Inf-sup constant=false"}));
    }
    for (const std::string target : {"1e-2", "1e-4"}) {
      checks.about(name + " with the target " + target);
      check_catalogue(checks, name,
                      {"Discretization/Strategy=hp", "Discretization/Target error=" + target});
    }
  }
  checks.about("");
  check_refusals(checks);
  return checks.exit_code();
}
