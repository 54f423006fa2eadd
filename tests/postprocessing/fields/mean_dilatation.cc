// SPDX-License-Identifier: LGPL-2.1-or-later
// Means of the dilatation, the number that tells locking, and pressures that are not unique, in
// closed form.

#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/estimate/certificate.h>
#include <signorini/error_control/estimate/locking_number.h>
#include <signorini/solvers/contact/dual_problem.h>

#include <algorithm>
#include <array>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
const std::string block = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** u = (x^2, 3 y): the interpolant's dilatation is the slope of x^2 between the nodes, plus 3. */
void means(Checks &checks) {
  for (const unsigned int number : {0, 3}) {
    const OneLevel level(block, number);
    const Displacement U = nodal_values(
      level.space(), [](const Point<2> &x) { return Point<2>(x[0] * x[0], 3. * x[1]); });
    const std::vector<double> means = mean_dilatations(level.body(U));
    double largest = 0.;
    for (const auto &cell : level.space().dofs().active_cell_iterators()) {
      const Point<2> centre = number > 0 ? cell->parent()->center() : cell->center();
      largest =
        std::max(largest, std::abs(means[cell->active_cell_index()] - (2. * centre[0] + 3.)));
    }
    checks.near("means over parents, level " + std::to_string(number), largest, 0., 1e-13);
  }
}

/** K/mu = (lambda + mu)/mu = 1/(1 - 2 nu) in plane strain, h/l = 1/8. */
void locking(Checks &checks) {
  const auto number = [](const std::string &material) {
    const OneLevel level(block + "subsection Material\n" + material + "end\n", 3);
    return locking_number(level.discretization.mesh, level.scene);
  };
  // General law: K = (100 + 2 * 98 + 100)/4 = 99, mu = 1 in all directions. Units do not matter,
  // and plane stress does not lock.
  for (const auto &[material, expected] :
       {std::pair("set Poisson's ratio = 0.3\n", 0.),
        std::pair("set Poisson's ratio = 0.49\n", 50. / 64.),
        std::pair("set Poisson's ratio = 0.49\nset Young's modulus = 2e9\n", 50. / 64.),
        std::pair("set Poisson's ratio = 0.4999\nset Plane state = stress\n", 0.),
        std::pair("set Law = general\nset Hooke tensor = 100; 98; 0; 100; 0; 1\n", 99. / 64.)})
    checks.near(material, number(material), expected, expected == 0. ? 0. : 1e-12);
  // An arc in contact: of the first order in h.
  const OneLevel disc(
    "Geometry/Shape = half disc\nBoundary/Contact = arc\nBoundary/Clamped = flat\n"
    "Material/Poisson's ratio = 0.49\nContact/Gap = 1\n",
    3);
  const Mesh<2> &mesh = disc.discretization.mesh;
  checks.near("arc", locking_number(mesh, disc.scene), 50. * mesh.longest_edge() / mesh.size(),
              1e-12);
}

/** Two patches that cannot be told apart, two that can, and two that cannot, but are open. */
void uniqueness(Checks &checks) {
  struct Row {
    double c_01, c_02, c_12;
    std::array<double, 3> F, P;
    bool is_unique;
  };
  for (const Row &row : {Row{1., 0., 0., {{-1., -1., 1.}}, {{-1., 0., 0.}}, false},
                         Row{0.5, 0., 0., {{-1.5, -1.5, 1.}}, {{-1., -1., 0.}}, true},
                         Row{0.5, 0.5, 1., {{-1., 1., 1.}}, {{-1., 0., 0.}}, true}}) {
    dealii::FullMatrix<double> C(3, 3);
    for (unsigned int i = 0; i < 3; ++i)
      C(i, i) = 1.;
    C(0, 1) = C(1, 0) = row.c_01;
    C(0, 2) = C(2, 0) = row.c_02;
    C(1, 2) = C(2, 1) = row.c_12;
    using Vector = dealii::Vector<double>;
    checks.that("unique",
                BoundConstrainedQP(C, Vector(row.F.begin(), row.F.end()))
                    .has_unique_solution(Vector(row.P.begin(), row.P.end())) == row.is_unique);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {means, locking, uniqueness});
}
