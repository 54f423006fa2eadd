// SPDX-License-Identifier: LGPL-2.1-or-later
// C = D^T S^{-1} D read from the factor is C = D^T A^{-1} D by one solve per column, and columns
// are solved for only where they are asked for.

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/contact/compliance.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
double relative_distance(const dealii::FullMatrix<double> &a, const dealii::FullMatrix<double> &b)
{
  dealii::FullMatrix<double> difference(a);
  difference.add(-1., b);
  return difference.linfty_norm() / b.linfty_norm();
}

double asymmetry(const dealii::FullMatrix<double> &C)
{
  double largest = 0.;
  for (unsigned int i = 0; i < C.m(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      largest = std::max(largest, std::abs(C(i, j) - C(j, i)));
  return largest;
}

/** The same matrix by all solvers. */
void compare(Checks &checks,
             const std::string &name,
             const OneLevel &level,
             const dealii::TrilinosWrappers::SparseMatrix &A,
             const double unit)
{
  double seconds = 0.;
  const auto compliance = [&](const StiffnessInverse &inverse) {
    return dealii::FullMatrix<double>(
      make_compliance(inverse, level.discretization.condensed_D, seconds)->dense());
  };
  const auto &D = level.discretization.condensed_D;
  const auto condensed = factorise(A, unit, LinearSolver::condensed, contact_unknowns(D));
  const auto C = compliance(*condensed);
  checks.that(name + ": no solve", condensed->n_solves() == 0);
  checks.near(name + ": symmetric", asymmetry(C), 0., 0.);
  for (const LinearSolver solver : {LinearSolver::amesos_klu, LinearSolver::amesos_mumps})
  {
    const auto inverse = factorise(A, unit, solver);
    const std::string other = to_text(solver);
    checks.near(name + ": C as by " + other, relative_distance(C, compliance(*inverse)), 0., 1e-12);
    checks.that(name + ": a solve per patch by " + other, inverse->n_solves() == C.m());
  }
  // Without the contact unknowns the columns are solved for.
  const auto plain = factorise(A, unit, LinearSolver::condensed);
  checks.near(
    name + ": C by solves with CHOLMOD", relative_distance(compliance(*plain), C), 0., 1e-12);
}

void compare(Checks &checks, const std::string &name, const std::string &text, const unsigned int n)
{
  const OneLevel level(text, n);
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 2);
  compare(checks, name + ", A", level, system.matrix, system.unit);
  // Without oblique rollers the components of A_1 do not couple: two elimination trees.
  compare(checks, name + ", A_1", level, assemble_h1_gram_matrix(level.space()), 1.);
}

std::string boundary(const std::string &roles)
{
  return "subsection Boundary\n" + roles + "end\n";
}

/** The interface of C with one solve per column that is asked for, and not one more. */
void columns_on_demand(Checks &checks)
{
  const OneLevel level(boundary("set Clamped = top\nset Contact = bottom left\n") +
                         entry("Material", "Young's modulus", "40"),
                       4);
  const LinearSystem<2> system = assemble_linear_system(level.space(), level.scene, 2);
  const auto &D = level.discretization.condensed_D;
  const auto condensed =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(D));
  double seconds = 0.;
  const auto known = make_compliance(*condensed, D, seconds);
  const dealii::FullMatrix<double> &C = known->dense();
  const unsigned int m = C.m();
  const double size = C.linfty_norm();
  checks.that("condensed: all entries are known at once",
              known->is_explicit() && m == level.multipliers().n_multipliers() && m > 10);
  dealii::Vector<double> few(m), product(m);
  few[2] = -1.;
  few[m - 3] = -0.25;
  C.vmult(product, few);
  const auto all = RandomNumbers(4).vector(m);
  for (const LinearSolver solver : {LinearSolver::condensed, LinearSolver::amesos_mumps})
  {
    const std::string name = "columns by " + std::string(to_text(solver));
    const auto inverse = factorise(system.matrix, system.unit, solver);
    unsigned int n_done = 0;
    const ColumnCompliance by_columns(
      *inverse, D, seconds, [&](const unsigned int n) { n_done = n; });
    checks.that(name + ": size", by_columns.size() == m && !by_columns.is_explicit());
    checks.near(name + ": C P for two pressing patches",
                distance(by_columns.apply(few), product),
                0.,
                1e-12 * size);
    checks.that(name + ": two solves", inverse->n_solves() == 2 && n_done == 2);
    checks.near(name + ": C_kk P_k",
                distance(by_columns.diagonal_times(few), known->diagonal_times(few)),
                0.,
                1e-12 * size);
    checks.that(name + ": no further solve", inverse->n_solves() == 2);
    const dealii::FullMatrix<double> two = by_columns.columns({m - 3, 5});
    double largest = 0.;
    for (unsigned int i = 0; i < m; ++i)
      largest =
        std::max({largest, std::abs(two(i, 0) - C(i, m - 3)), std::abs(two(i, 1) - C(i, 5))});
    checks.near(name + ": columns in the order asked for", largest, 0., 1e-12 * size);
    checks.that(name + ": a third solve", inverse->n_solves() == 3 && !by_columns.is_explicit());
    const dealii::FullMatrix<double> block = submatrix(by_columns, {2, 5});
    checks.near(name + ": a block",
                std::abs(block(0, 0) - C(2, 2)) + std::abs(block(1, 1) - C(5, 5)) +
                  std::abs(block(0, 1) - C(2, 5)) + std::abs(block(1, 0) - C(5, 2)),
                0.,
                1e-12 * size);
    checks.near(
      name + ": diagonal", distance(by_columns.diagonal(), known->diagonal()), 0., 1e-12 * size);
    checks.near(name + ": all of C", relative_distance(by_columns.dense(), C), 0., 1e-12);
    checks.near(name + ": symmetric", asymmetry(by_columns.dense()), 0., 0.);
    checks.near(name + ": C P for all patches",
                distance(by_columns.apply(all), known->apply(all)),
                0.,
                1e-12 * size);
    checks.that(name + ": a solve per column and no more",
                inverse->n_solves() == m && n_done == m && by_columns.is_explicit());
  }
}

} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  columns_on_demand(checks);
  const std::string clamped = boundary("set Clamped = top\nset Contact = bottom\n");
  for (const unsigned int n : {1U, 4U})
    compare(checks, "level " + std::to_string(n), clamped, n);
  compare(checks, "H = h", clamped + entry("Discretization", "Patch ratio", "1"), 4);
  compare(checks,
          "patches aligned with nothing",
          clamped + entry("Discretization", "Patches", "5") +
            entry("Geometry", "Distortion", "0.2"),
          3);
  compare(checks,
          "two contact sides and a corner",
          boundary("set Clamped = top\nset Contact = bottom left\n"),
          4);
  compare(checks,
          "contact all around",
          boundary("set Contact = bottom left top\nset Clamped = right\n"),
          3);
  compare(
    checks,
    "rollers and prescribed displacements",
    boundary("set Rollers = left right\nset Displacement = top: 0; -0.1\nset Contact = bottom\n"),
    3);
  const std::string pentagon = "subsection Geometry\nset Shape = polygon\n"
                               "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n";
  compare(checks,
          "oblique rollers next to oblique contact",
          pentagon +
            boundary("set Contact = side0 side2\nset Rollers = side1 side4\nset Clamped = side3\n"),
          2);
  return checks.exit_code();
}
