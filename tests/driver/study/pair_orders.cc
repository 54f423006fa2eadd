// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solutions of two bodies: orders on meshes that match and others, and the guaranteed bound.

#include <signorini/base/text.h>

#include <cmath>
#include <fstream>
#include <regex>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** A field on the unit square with contact on y = 0, lambda = mu = 1, as expressions of x and y. */
struct Field {
  std::string u1, u2, gradient_1, gradient_2, s11, s12, f1, f2, p, g;
};

/** Returns the lift of the catalogue (smooth_scenes.cc) for the pressure p with these derivatives,
 * and an opening. */
Field lifted(const std::string &p, const std::string &p_x, const std::string &p_xx,
             const std::string &opening) {
  const std::string c = "(1-y^2)", c_y = "(-2*y)", A = "(0.1*x^2-0.1*y+0.2*x*y)",
                    B = "(0.1*x*(1-x)+y*(" + p + "-0.2*x)/3)", A_x = "(0.2*x+0.2*y)",
                    A_y = "(0.2*x-0.1)", B_x = "(0.1-0.2*x+y*(" + p_x + "-0.2)/3)",
                    B_y = "((" + p + "-0.2*x)/3)", B_xy = "((" + p_x + "-0.2)/3)",
                    B_xx = "(-0.2+y*(" + p_xx + ")/3)";
  const auto product = [](const std::string &a, const std::string &b) { return a + "*" + b; };
  const auto y_derivative = [&](const std::string &a, const std::string &a_y) {
    return "(" + product(a_y, c) + "+" + product(a, c_y) + ")";
  };
  const std::string u1_x = product(A_x, c), u1_y = y_derivative(A, A_y), u2_x = product(B_x, c),
                    u2_y = y_derivative(B, B_y), u1_xx = product("0.2", c),
                    u1_xy = y_derivative(A_x, "0.2"),
                    u1_yy = "(2*" + A_y + "*" + c_y + "-2*" + A + ")", u2_xx = product(B_xx, c),
                    u2_xy = y_derivative(B_x, B_xy),
                    u2_yy = "(2*" + B_y + "*" + c_y + "-2*" + B + ")";
  return {product(A, c),
          product(B, c),
          u1_x + "; " + u1_y,
          u2_x + "; " + u2_y,
          "(3*" + u1_x + "+" + u2_y + ")",
          "(" + u1_y + "+" + u2_x + ")",
          "(-3*" + u1_xx + "-2*" + u2_xy + "-" + u1_yy + ")",
          "(-2*" + u1_xy + "-" + u2_xx + "-3*" + u2_yy + ")",
          p,
          opening + " - 0.1*x*(1-x)"};
}

/** Returns the field of prm/described_b1.prm. */
Field singular() {
  const Parameters file = read_parameters(SOURCE_DIR "/prm/described_b1.prm", {});
  const auto parts = [](const std::string &text) { return split_list(text, ';'); };
  const std::string traction = file.boundary.traction.value;
  const auto u = parts(file.exact.displacement.value),
             gradient = parts(file.exact.displacement_gradient.value),
             s = parts(traction.substr(traction.rfind("right:") + 6)),
             f = parts(file.load.body_force.value);
  return {u[0],
          u[1],
          gradient[0] + "; " + gradient[1],
          gradient[2] + "; " + gradient[3],
          s[0],
          s[1],
          f[0],
          f[1],
          file.exact.pressure.value,
          "0"};
}

/** Returns an expression on the body below: y is the depth below its upper side at y = -1/4. */
std::string below(const std::string &text) {
  return "(" + std::regex_replace(text, std::regex("\\by\\b"), "(-0.25-y)") + ")";
}

/**
 * Returns the text of two bodies with the same stress, one the image of the other in the line
 * between them, the lower one k times as stiff: its displacement is (u1, -u2)/k at the image. The
 * gap is the motion of both, and the distance 1/4 as drawn is subtracted.
 */
std::string pair_of(const Field &field, const std::string &k, const std::string &cells) {
  const auto both = [](const std::string &above, const std::string &lower) {
    return "y > -0.1 ? " + above + " : " + lower;
  };
  const auto image = [&](const std::string &sign, const std::string &text) {
    return sign + below(text) + "/" + k;
  };
  const auto in_both = [&](const std::string &text, const std::string &sign) {
    return both("(" + text + ")", image(sign, text));
  };
  const std::vector<std::string> d1 = split_list(field.gradient_1, ';'),
                                 d2 = split_list(field.gradient_2, ';');
  const std::string u2 = std::regex_replace(field.u2, std::regex("\\by\\b"), "0");
  return "Constants/Values = xi=1/sqrt(2)\nGeometry/Bodies = a b\n"
         "Geometry/Lower left = a: 0, 0 | b: 0, -1.25\n"
         "Geometry/Upper right = a: 1, 1 | b: 1, -0.25\nGeometry/Cells = " +
         cells + "\nMaterial/Young's modulus = a: 2.5 | b: 2.5*" + k +
         "\nMaterial/Poisson's ratio = 0.25\nBoundary/Clamped = a.top b.bottom\n"
         "Boundary/Contact = a.bottom with b.top\nBoundary/Traction = a.left: -(" +
         field.s11 + "); -(" + field.s12 + ") | a.right: " + field.s11 + "; " + field.s12 +
         " | b.left: -" + below(field.s11) + "; " + below(field.s12) +
         " | b.right: " + below(field.s11) + "; -" + below(field.s12) +
         "\nLoad/Body force = " + both("(" + field.f1 + ")", below(field.f1)) + "; " +
         both("(" + field.f2 + ")", "-" + below(field.f2)) + "\nContact/Gap = -0.25 - (" + u2 +
         ")*(1+1/" + k + ") + (" + u2 + ") + " + field.g +
         "\nExact solution/Displacement = " + in_both(field.u1, "") + "; " +
         in_both(field.u2, "-") + "\nExact solution/Displacement gradient = " + in_both(d1[0], "") +
         "; " + in_both(d1[1], "-") + "; " + in_both(d2[0], "-") + "; " + in_both(d2[1], "") +
         "\nExact solution/Pressure = " + field.p + "\nOutput/VTU = none\n";
}

/** Meshes of both bodies: those that match, one nested in the other, and others. */
struct Meshes {
  std::string cells;
  unsigned int coarsest;
};
const Meshes matching = {"a: 2, 2 | b: 2, 2", 1}, thirds = {"a: 4, 4 | b: 3, 3", 1},
             halves = {"a: 2, 2 | b: 1, 1", 2}, unrelated = {"a: 5, 5 | b: 3, 4", 1};

/** Two bodies, and the least orders of |I^h u - u_h|_1 and p. */
struct Pair {
  std::string name;
  Field field;
  std::string k;
  Meshes meshes;
  double least, least_of_p;
};

/** Returns all pairs. The order is two where patches are faces of both meshes or nearly so, else
 * 3/2; at the end of contact in B1 3/2, and noisy. */
std::vector<Pair> pairs() {
  const Field a1 = lifted("(-10*max(0,xi-x)^3)", "(30*max(0,xi-x)^2)", "(-60*max(0,xi-x))",
                          "max(0,x-xi)^2"),
              c1 = lifted("(-2-cos(pi*x))", "(pi*sin(pi*x))", "(pi^2*cos(pi*x))", "0"),
              b1 = singular();
  std::vector<Pair> pairs;
  for (const Meshes &meshes : {matching, thirds, halves, unrelated}) {
    pairs.push_back({"A1", a1, "1", meshes, 1.75, 0.85});
    pairs.push_back({"C1", c1, "1", meshes, 1.5, 0.95});
    pairs.push_back({"B1", b1, "1", meshes, 1.25, 0.6});
  }
  pairs.push_back({"A1", a1, "1000", unrelated, 1.7, 0.85});
  pairs.push_back({"A1", a1, "0.001", halves, 1.7, 0.85});
  return pairs;
}

/** Checks orders by least squares over three levels (four in the long test): 1 in H1, 1 of p, more
 * than 3/2 between I^h u and u_h, and the bound of the error, which is also a bracket of the
 * energy. */
void test_orders(Checks &checks) {
  std::ofstream table("pair_orders.csv");
  table << "scene,ratio_of_E,cells,u_h1,u_superclose_h1,p_l2,bound_over_error\n";
  for (const auto &[name, field, k, meshes, least, least_of_p] : checks.rows(pairs(), 3)) {
    checks.about(name + ", E " + k + ", " + meshes.cells);
    const auto result =
      solve(pair_of(field, k, meshes.cells),
            levels(meshes.coarsest, meshes.coarsest + (checks.is_long() ? 3 : 2)));
    check_orders(checks, result.levels,
                 {{"u_h1", 0.95, 1.7},
                  {"u_superclose_h1", least, 2.6},
                  {"u_post_h1", least, 2.4},
                  {"p_l2", least_of_p, 1.1},
                  {"p_dual_spectral", least_of_p + 0.4, 1.8}});
    const double ratio = last(result, "bound_energy") / last(result, "u_energy");
    checks.between("bound / error", ratio, 1., 1.3);
    checks.that("the bound is guaranteed", result.levels.back().bound->is_guaranteed());
    table << name << ',' << k << ",\"" << meshes.cells << '"';
    for (const char *column : {"u_h1", "u_superclose_h1", "p_l2"})
      table << ',' << std::round(100. * slope(result.levels, column)) / 100.;
    table << ',' << std::round(1000. * ratio) / 1000. << '\n';
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_orders});
}
