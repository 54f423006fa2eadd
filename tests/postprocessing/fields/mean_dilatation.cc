// SPDX-License-Identifier: LGPL-2.1-or-later
// Means of the dilatation, the number that tells locking, and pressures that are not unique, in
// closed form.

#include <signorini/error_control/estimate/certificate.h>
#include <signorini/postprocessing/fields/stress.h>
#include <signorini/solvers/contact/dual_problem.h>

#include <algorithm>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
const std::string block = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** u = (x^2, 3 y): the interpolant's dilatation is the slope of x^2 between the nodes, plus 3. */
void means(Checks &checks)
{
  for (const unsigned int number : {0, 3})
  {
    const OneLevel level(block, number);
    const Displacement U = nodal_values(
      level.space(), [](const Point<2> &x) { return Point<2>(x[0] * x[0], 3. * x[1]); });
    const std::vector<double> means = mean_dilatations(level.space(), U);
    double largest = 0.;
    for (const auto &cell : level.space().dofs().active_cell_iterators())
    {
      const Point<2> centre = number > 0 ? cell->parent()->center() : cell->center();
      largest =
        std::max(largest, std::abs(means[cell->active_cell_index()] - (2. * centre[0] + 3.)));
    }
    checks.near("means over parents, level " + std::to_string(number), largest, 0., 1e-13);
  }
}

/** K/mu = (lambda + mu)/mu = 1/(1 - 2 nu) in plane strain, h/l = 1/8. */
void locking(Checks &checks)
{
  const auto number = [](const std::string &material) {
    const OneLevel level(block + "subsection Material\n" + material + "end\n", 3);
    return locking_number(level.discretization.mesh, *level.scene.material);
  };
  checks.near("nu = 0.3 does not lock", number("set Poisson's ratio = 0.3\n"), 0., 0.);
  checks.near("nu = 0.49", number("set Poisson's ratio = 0.49\n"), 50. / 64., 1e-12);
  checks.near("units do not matter",
              number("set Poisson's ratio = 0.49\nset Young's modulus = 2e9\n"),
              50. / 64.,
              1e-12);
  checks.near("plane stress does not lock",
              number("set Poisson's ratio = 0.4999\nset Plane state = stress\n"),
              0.,
              0.);
  // K = (100 + 2 * 98 + 100)/4 = 99, mu = 1 in all directions.
  checks.near("general law",
              number("set Law = general\nset Hooke tensor = 100; 98; 0; 100; 0; 1\n"),
              99. / 64.,
              1e-12);
}

/** C = (1 1; 1 1) in all, or only where nothing touches. */
void uniqueness(Checks &checks)
{
  dealii::FullMatrix<double> C(3, 3);
  for (unsigned int i = 0; i < 3; ++i)
    C(i, i) = 1.;
  dealii::Vector<double> F(3);
  const auto is_unique = [&](const double F_2) {
    F[0] = F[1] = -1.;
    F[2] = F_2;
    dealii::Vector<double> P(3);
    P[0] = -1.;
    return BoundConstrainedQP(C, F).has_unique_solution(P);
  };
  C(0, 1) = C(1, 0) = 1.;
  checks.that("two patches that cannot be told apart", !is_unique(1.));
  C(0, 1) = C(1, 0) = 0.5;
  F = 0.;
  dealii::Vector<double> P(3);
  F[0] = F[1] = -1.5;
  F[2] = 1.;
  P[0] = P[1] = -1.;
  checks.that("two that can", BoundConstrainedQP(C, F).has_unique_solution(P));
  C(1, 2) = C(2, 1) = 1.;
  C(0, 2) = C(2, 0) = 0.5;
  C(0, 1) = C(1, 0) = 0.5;
  F[0] = -1.;
  F[1] = 1.;
  F[2] = 1.;
  P[0] = -1.;
  P[1] = P[2] = 0.;
  checks.that("two that cannot, but are open", BoundConstrainedQP(C, F).has_unique_solution(P));
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  means(checks);
  locking(checks);
  uniqueness(checks);
  return checks.exit_code();
}
