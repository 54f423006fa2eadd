// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomial displacements under full contact: U and P are exact on meshes with hanging nodes and
// several degrees.

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
struct Exact {
  Field displacement;
  /** At a point of the contact side. */
  std::function<double(const Point<2> &)> pressure;
};

/** The degrees of a space, as "2345". */
std::string degrees_found(const DisplacementSpace<2> &space) {
  std::string found;
  for (unsigned int degree = 2; degree < 10; ++degree) {
    const auto degrees = degrees_of(space);
    if (std::find(degrees.begin(), degrees.end(), degree) != degrees.end())
      found += std::to_string(degree);
  }
  return found;
}

void check(Checks &checks, const std::string &name, const std::string &text, const MeshPlan &plan,
           const std::string &degrees, const Exact &exact) {
  checks.about(name);
  const GradedLevel level(text, plan);
  checks.that("hanging nodes", has_hanging_nodes(level.mesh()));
  checks.that("degrees " + degrees, degrees_found(level.space()) == degrees);
  checks.that("graded", is_graded(level.space()));
  const LevelSolution<2> solution = level.solve();
  checks.near("U", distance(solution.contact.U, nodal_values(level.space(), exact.displacement)),
              0., 1e-11);
  const MultiplierSpace<2> &multipliers = level.multipliers();
  double error = 0.;
  for (unsigned int k = 0; k < multipliers.n_multipliers(); ++k) {
    const Side<2> &side =
      multipliers.surface().side(multipliers.surface().patches()[multipliers.patch_of(k)]);
    error = std::max(error, std::abs(solution.contact.P.normal()[k] -
                                     exact.pressure(side.point(multipliers.node(k)))));
  }
  checks.near("P", error, 0., 1e-11);
  const Certificate &certificate = solution.record.certificate;
  checks.near("certificate",
              std::max({certificate.stationarity, certificate.penetration, certificate.sign,
                        certificate.complementarity, certificate.duality_gap,
                        certificate.force_balance, certificate.moment_balance}),
              0., 1e-11);
}

/** Splits towards a corner and towards a part of the contact side, three times, with degrees from 2
 * to 5. */
MeshPlan towards(const Point<2> &vertex, const Singularity &on_contact, const double layers = 3.) {
  MeshPlan plan;
  plan.base_level = 2;
  plan.base_size = 0.25;
  plan.singularities = {corner(vertex, layers), on_contact};
  plan.rise = 3.;
  plan.max_element_degree = 5;
  return plan;
}

/** Degrees of at least three on the cells of a uniform mesh, and with them on all their parts. */
void demand_degree_three(const std::string &text, MeshPlan &plan) {
  const GradedLevel uniform(text, uniform_plan(plan.base_level, 2));
  for (const auto &cell : uniform.mesh().triangulation().active_cell_iterators())
    plan.demands[cell->id()].degree = 3;
}

const std::string unit_moduli =
  "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n";
const std::string distorted = "subsection Geometry\nset Distortion = 0.3\nend\n";

/** lambda = mu = 1, u = (0, 0.125 (1 - y)), p = -0.125 (lambda + 2 mu). */
void constant_stress(Checks &checks) {
  const Exact exact = {[](const Point<2> &x) { return Point<2>(0., 0.125 * (1. - x[1])); },
                       [](const Point<2> &) { return -0.375; }};
  const std::string held = unit_moduli + "subsection Boundary\nset Clamped = top\n"
                                         "set Contact = bottom\n";
  const std::string gap = "Contact/Gap = -0.125\n";
  const std::string pulled = held + "set Traction = left: 0.125; 0 | right: -0.125; 0\nend\n" + gap;
  const std::string guided = held + "set Rollers = left right\nend\n" + gap;
  // The bottom is side 2. A part of a face at 0.3, and the point where two faces meet.
  const Singularity inside = end_of_contact({0.3, 0.}, 2, 0.29, 0.31, 3.);
  const Singularity between = end_of_contact({0.5, 0.}, 2, 0.5, 0.5, 3.);
  check(checks, "tractions, point of a face", pulled, towards({1., 1.}, inside), "2345", exact);
  for (const std::string &geometry : {std::string(), distorted})
    check(checks, "rollers, vertex" + geometry, geometry + guided, towards({0., 0.}, between),
          "2345", exact);
}

/** Rotated bar between rollers, lowered by 0.3 along the normal (1, -2)/sqrt(5) of side0. */
void oblique_rollers(Checks &checks) {
  const std::string text = "subsection Geometry\nset Shape = polygon\n"
                           "set Vertices = 0,0; 2,1; 1,3; -1,2\nend\n" +
                           unit_moduli +
                           "subsection Constants\nset Values = d = 0.3/sqrt(5)\nend\n"
                           "subsection Boundary\nset Contact = side0\nset Rollers = side1 side3\n"
                           "set Displacement = side2: d; -2*d\nend\n";
  const dealii::Tensor<1, 2> n = Point<2>(1., -2.) / std::sqrt(5.);
  const Exact exact = {[n](const Point<2> &x) { return -0.3 / std::sqrt(5.) * (x * n) * n; },
                       [](const Point<2> &) { return -0.9 / std::sqrt(5.); }};
  MeshPlan plan = towards({1., 3.}, end_of_contact({0.8, 0.4}, 0, 0.8, 1., 3.));
  plan.base_size = 0.5;
  check(checks, "oblique rollers", text, plan, "2345", exact);
}

/**
 * With lambda = mu = 1
 *
 *     u_1 = al x³ + de x y² - 3 k x² y + e x²/2,  u_2 = -c - a y - al x² y + k x³ + f y³
 *
 * has sigma_12 = 0 and sigma_22 = e x - 3 a at y = 0, u_1 = sigma_12 = 0 at x = 0, and
 * -div sigma = (-(14 al + 2 de) x + 18 k y - 3 e, (2 al - 18 f - 4 de) y + 6 k x).
 */
void cubic(Checks &checks) {
  const double al = 0.02, de = -0.05, k = 0.03, e = 0.1, c = 0.2, a = 0.12, f = 0.04;
  const Exact exact = {[=](const Point<2> &X) {
                         const double x = X[0], y = X[1];
                         return Point<2>(
                           al * x * x * x + de * x * y * y - 3. * k * x * x * y + 0.5 * e * x * x,
                           -c - a * y - al * x * x * y + k * x * x * x + f * y * y * y);
                       },
                       [=](const Point<2> &x) { return e * x[0] - 3. * a; }};
  const std::string first = "al*x^3 + de*x*y^2 - 3*k*x^2*y + ec*x^2/2",
                    second = "-c - a*y - al*x^2*y + k*x^3 + f*y^3";
  const std::string data =
    unit_moduli +
    "subsection Constants\nset Values = al = 0.02, de = -0.05, k = 0.03, ec = 0.1, c = 0.2, "
    "a = 0.12, f = 0.04\nend\n"
    "Load/Body force = -(14*al + 2*de)*x + 18*k*y - 3*ec; (2*al - 18*f - 4*de)*y + 6*k*x\n"
    "Contact/Gap = c - k*x^3\n";
  const auto side = [&](const std::string &name) { return name + ": " + first + "; " + second; };
  const std::string prescribed = data +
                                 "subsection Boundary\nset Contact = bottom\n"
                                 "set Displacement = " +
                                 side("left") + " | " + side("right") + " | " + side("top") +
                                 "\nend\n";
  const std::string guided = data +
                             "subsection Boundary\nset Contact = bottom\nset Rollers = left\n"
                             "set Displacement = " +
                             side("right") + " | " + side("top") + "\nend\n";
  for (const auto &[name, text] : std::vector<std::pair<std::string, std::string>>{
         {"cubic, prescribed", prescribed}, {"cubic, roller", guided}})
    for (const auto &[mesh_name, geometry] :
         std::vector<std::pair<std::string, std::string>>{{"", ""}, {", distorted", distorted}}) {
      MeshPlan plan = towards({0., 0.}, end_of_contact({0.6, 0.}, 2, 0.6, 0.61, 3.));
      demand_degree_three(geometry + text, plan);
      check(checks, name + mesh_name, geometry + text, plan, "345", exact);
    }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {constant_stress, oblique_rollers, cubic});
}
