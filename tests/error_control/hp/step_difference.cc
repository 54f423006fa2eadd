// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy of the difference of functions on two meshes, against integrals by hand.

#include <signorini/error_control/hp/step_examination.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** lambda = mu = 1 on the unit square. */
const std::string square =
  "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
  "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** Meshes that are finer in different parts. */
struct TwoMeshes {
  explicit TwoMeshes(const std::string &text)
    : first(text, plan({0., 0.}, 4., 2.))
    , second(text, plan({1., 0.}, 3., 5.)) {}
  static MeshPlan plan(const Point<2> &vertex, const double layers, const double rise) {
    MeshPlan plan = uniform_plan(2, 2);
    plan.base_size = 0.25;
    plan.singularities = {corner(vertex, layers),
                          end_of_contact({0.4, 0.}, 2, 0.4, 0.41, 6. - layers)};
    plan.rise = rise;
    return plan;
  }
  /** |||u - v|||, u on the first mesh and v on the second; or the other way round. */
  double distance(const Field &u, const Field &v, const bool is_opposite = false) const {
    const Displacement U = nodal_values(first.space(), u), V = nodal_values(second.space(), v);
    return is_opposite ? energy_distance(second.body(V), first.body(U))
                       : energy_distance(first.body(U), second.body(V));
  }

  GradedLevel first, second;
};

/** w = (x² + y, x y), eps = (2 x, (1 + y)/2, x): E eps : eps = (3 x)² + 2 (4 x² + x² + (1 + y)²/2),
 * whose mean over the unit square is 3 + 10/3 + 7/3. */
void polynomials(Checks &checks) {
  const Field v = [](const Point<2> &x) { return Point<2>(x[0] * x[1], 0.3 - x[1] * x[1]); };
  const Field u = [&v](const Point<2> &x) {
    return v(x) + Point<2>(x[0] * x[0] + x[1], x[0] * x[1]);
  };
  const double exact = std::sqrt(3. + 10. / 3. + 7. / 3.);
  for (const auto &[name, text] : std::vector<std::pair<std::string, std::string>>{
         {"squares", square},
         {"distorted", "subsection Geometry\nset Distortion = 0.3\nend\n" + square}}) {
    const TwoMeshes meshes(text);
    checks.that(name + ": hanging nodes",
                has_hanging_nodes(meshes.first.mesh()) && has_hanging_nodes(meshes.second.mesh()));
    checks.near(name + ": distance", meshes.distance(u, v), exact, 1e-12);
    checks.near(name + ": symmetric", meshes.distance(u, v, true), exact, 1e-12);
    checks.near(name + ": the same function", meshes.distance(u, u), 0., 1e-12);
    checks.near(
      name + ": a rigid motion",
      meshes.distance(
        u, [&u](const Point<2> &x) { return u(x) + Point<2>(0.2 - 0.1 * x[1], 0.1 * x[0]); }),
      0., 1e-12);
  }
}

/** E = 1 + x with nu = 0: |||(x, 0)|||² = int 1 + x = 3/2. */
void variable_material(Checks &checks) {
  const std::string text =
    "subsection Material\nset Young's modulus = 1 + x\nset Poisson's ratio = 0\nend\n"
    "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";
  const TwoMeshes meshes(text);
  checks.near("a variable modulus",
              meshes.distance([](const Point<2> &x) { return Point<2>(x[0], 0.); },
                              [](const Point<2> &) { return Point<2>(); }),
              std::sqrt(1.5), 1e-12);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {polynomials, variable_material});
}
