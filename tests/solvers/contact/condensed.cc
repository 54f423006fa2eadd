// SPDX-License-Identifier: LGPL-2.1-or-later
// C = D^T S^{-1} D read from the factor is C = D^T A^{-1} D by one solve per column, and columns
// are solved for only where they are asked for.

#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/verification/norms/inf_sup.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
double relative_distance(const dealii::FullMatrix<double> &a, const dealii::FullMatrix<double> &b) {
  dealii::FullMatrix<double> difference(a);
  difference.add(-1., b);
  return difference.linfty_norm() / b.linfty_norm();
}

double asymmetry(const dealii::FullMatrix<double> &C) {
  double largest = 0.;
  for (unsigned int i = 0; i < C.m(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      largest = std::max(largest, std::abs(C(i, j) - C(j, i)));
  return largest;
}

/** The same matrix by all solvers. */
void compare(Checks &checks, const std::string &name, const OneLevel &level,
             const dealii::TrilinosWrappers::SparseMatrix &A, const double unit) {
  checks.about(name);
  const auto compliance = [&](const StiffnessInverse &inverse) {
    return dealii::FullMatrix<double>(
      make_compliance(inverse, level.discretization.condensed_D)->dense());
  };
  const auto &D = level.discretization.condensed_D;
  const auto condensed = factorise(A, unit, LinearSolver::condensed, contact_unknowns(D));
  const auto C = compliance(*condensed);
  checks.that("no solve", condensed->n_solves() == 0);
  checks.near("symmetric", asymmetry(C), 0., 0.);
  for (const LinearSolver solver : {LinearSolver::amesos_klu, LinearSolver::amesos_mumps}) {
    const auto inverse = factorise(A, unit, solver);
    const std::string other = to_text(solver);
    checks.near("C as by " + other, relative_distance(C, compliance(*inverse)), 0., 1e-12);
    checks.that("a solve per patch by " + other, inverse->n_solves() == C.m());
  }
  // Without the contact unknowns the columns are solved for.
  const auto plain = factorise(A, unit, LinearSolver::condensed);
  checks.near("C by solves with CHOLMOD", relative_distance(compliance(*plain), C), 0., 1e-12);
}

void compare(Checks &checks, const std::string &name, const std::string &text,
             const unsigned int n) {
  const OneLevel level(text, n);
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 2);
  compare(checks, name + ", A", level, system.matrix, system.unit);
  // Without oblique rollers the components of A_1 do not couple: two elimination trees.
  compare(checks, name + ", A_1", level, assemble_h1_gram_matrix(level.space()), 1.);
}

/** The interface of C with one solve per column that is asked for, and not one more. */
void columns_on_demand(Checks &checks) {
  const OneLevel level("Boundary/Clamped = top\nBoundary/Contact = bottom left\n"
                       "Material/Young's modulus = 40\n",
                       4);
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 2);
  const auto &D = level.discretization.condensed_D;
  const auto condensed =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(D));
  const auto known = make_compliance(*condensed, D);
  const dealii::FullMatrix<double> &C = known->dense();
  const unsigned int m = C.m();
  const double size = C.linfty_norm();
  checks.that("condensed: all entries are known at once",
              known->is_explicit() && m == level.multipliers().n_multipliers() && m > 10);
  dealii::Vector<double> few(m), product(m);
  few[2] = -1.;
  few[m - 3] = -0.25;
  C.vmult(product, few);
  for (const LinearSolver solver : {LinearSolver::condensed, LinearSolver::amesos_mumps}) {
    checks.about("columns by " + std::string(to_text(solver)));
    const auto inverse = factorise(system.matrix, system.unit, solver);
    unsigned int n_done = 0;
    const ColumnCompliance by_columns(*inverse, D, [&](const unsigned int n) { n_done = n; });
    checks.that("size", by_columns.size() == m && !by_columns.is_explicit());
    checks.near("C P for two pressing patches", distance(by_columns.apply(few), product), 0.,
                1e-12 * size);
    checks.that("two solves", inverse->n_solves() == 2 && n_done == 2);
    checks.near("C_kk P_k", distance(by_columns.diagonal_times(few), known->diagonal_times(few)),
                0., 1e-12 * size);
    checks.that("no further solve", inverse->n_solves() == 2);
    const dealii::FullMatrix<double> two = by_columns.columns({m - 3, 5});
    double largest = 0.;
    for (unsigned int i = 0; i < m; ++i)
      largest =
        std::max({largest, std::abs(two(i, 0) - C(i, m - 3)), std::abs(two(i, 1) - C(i, 5))});
    checks.near("columns in the order asked for", largest, 0., 1e-12 * size);
    checks.that("a third solve", inverse->n_solves() == 3 && !by_columns.is_explicit());
    checks.near("diagonal", distance(by_columns.diagonal(), known->diagonal()), 0., 1e-12 * size);
    checks.near("all of C", relative_distance(by_columns.dense(), C), 0., 1e-12);
    checks.that("a solve per column and no more",
                inverse->n_solves() == m && n_done == m && by_columns.is_explicit());
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv,
    {columns_on_demand, [](Checks &checks) {
       const std::string pentagon =
         "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\n";
       for (const auto &[name, text, level] :
            {std::tuple("two faces", "Boundary/Clamped = top\nBoundary/Contact = bottom\n", 1U),
             std::tuple("patches aligned with nothing",
                        "Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                        "Discretization/Patches = 5\nGeometry/Distortion = 0.2\n",
                        3U),
             std::tuple("contact all around",
                        "Boundary/Contact = bottom left top\nBoundary/Clamped = right\n", 3U),
             std::tuple("rollers and prescribed displacements, H = h",
                        "Boundary/Rollers = left right\nBoundary/Displacement = top: 0; -0.1\n"
                        "Boundary/Contact = bottom\nDiscretization/Patch ratio = 1\n",
                        4U),
             std::tuple("oblique rollers next to oblique contact",
                        "Boundary/Contact = side0 side2\nBoundary/Rollers = side1 side4\n"
                        "Boundary/Clamped = side3\n",
                        2U)})
         compare(checks, name, (level == 2 ? pentagon : "") + text, level);
     }});
}
