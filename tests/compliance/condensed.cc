// SPDX-License-Identifier: LGPL-2.1-or-later
// C = D^T S^{-1} D read from the factor is C = D^T A^{-1} D by one solve per column.

#include <signorini/compliance/compliance.h>
#include <signorini/norms/h1_gram_matrix.h>
#include <signorini/recovery/recovery.h>
#include <signorini/stiffness_inverse/condensed_inverse.h>

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
             const dealii::TrilinosWrappers::SparseMatrix &A)
{
  const auto &D = level.discretization.condensed_D;
  const auto condensed = factorise(A, LinearSolver::condensed, contact_unknowns(D));
  const auto C = compute_compliance(*condensed, level.space(), D);
  checks.that(name + ": no solve", condensed->n_solves() == 0);
  checks.near(name + ": symmetric", asymmetry(C), 0., 0.);
  const auto P = RandomNumbers(5).vector(C.m());
  const DistributedVector zero = level.space().make_vector();
  const NodalVector U = recover_displacement(*condensed, level.space(), D, P, zero);
  for (const LinearSolver solver : {LinearSolver::amesos_klu, LinearSolver::amesos_mumps})
  {
    const auto inverse = factorise(A, solver);
    const std::string other = to_text(solver);
    checks.near(name + ": C as by " + other,
                relative_distance(C, compute_compliance(*inverse, level.space(), D)),
                0.,
                1e-12);
    checks.that(name + ": a solve per patch by " + other, inverse->n_solves() == C.m());
    const NodalVector V = recover_displacement(*inverse, level.space(), D, P, zero);
    checks.near(name + ": U as by " + other, distance(U, V), 0., 1e-12 * V.l2_norm());
  }
  // Without the contact unknowns the columns are solved for.
  const auto plain = factorise(A, LinearSolver::condensed);
  checks.near(name + ": C by solves with CHOLMOD",
              relative_distance(compute_compliance(*plain, level.space(), D), C),
              0.,
              1e-12);
}

void compare(Checks &checks, const std::string &name, const std::string &text, const unsigned int n)
{
  const OneLevel level(text, n);
  compare(checks, name + ", A", level, assemble_linear_system(level.space(), level.scene, 2).A);
  // Without oblique rollers the components of A_1 do not couple: two elimination trees.
  compare(checks, name + ", A_1", level, assemble_h1_gram_matrix(level.space()));
}

std::string boundary(const std::string &roles)
{
  return "subsection Boundary\n" + roles + "end\n";
}

void blocks(Checks &checks)
{
  const OneLevel level(boundary("set Clamped = top\nset Contact = bottom\n"), 3);
  const auto A = assemble_linear_system(level.space(), level.scene, 2).A;
  const auto &D = level.discretization.condensed_D;
  const auto unknowns = contact_unknowns(D);
  const CondensedInverse inverse(A, unknowns);
  const auto L = inverse.schur_factor();
  checks.that("one row per contact unknown", L.m() == unknowns.size() && L.n() == unknowns.size());
  checks.that("all contact unknowns are last", inverse.eliminates_last(unknowns));
  checks.that("others are not", !inverse.eliminates_last({unknowns.back() + 1}));
  // (A^{-1})_22 S = 1, column by column.
  double largest = 0.;
  DistributedVector e = level.space().make_vector(), x = e;
  for (const auto j : unknowns)
  {
    e = 0.;
    e(j) = 1.;
    e.compress(dealii::VectorOperation::insert);
    inverse.solve(x, e);
    dealii::Vector<double> column(L.m()), LTx(L.m()), Sx(L.m());
    for (const auto i : unknowns)
      column[inverse.schur_row(i)] = x(i);
    for (unsigned int i = 0; i < L.m(); ++i)
      for (unsigned int k = 0; k <= i; ++k)
        LTx[k] += L(i, k) * column[i];
    for (unsigned int i = 0; i < L.m(); ++i)
      for (unsigned int k = 0; k <= i; ++k)
        Sx[i] += L(i, k) * LTx[k];
    Sx[inverse.schur_row(j)] -= 1.;
    largest = std::max(largest, Sx.linfty_norm());
  }
  checks.near("S = L_22 L_22^T is the inverse of (A^{-1})_22", largest, 0., 1e-12);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  blocks(checks);
  const std::string clamped = boundary("set Clamped = top\nset Contact = bottom\n");
  for (const unsigned int n : {1U, 2U, 4U})
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
