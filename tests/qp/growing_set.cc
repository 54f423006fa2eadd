// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with columns on demand: the same answer from fewer columns.

#include <signorini/qp/active_set.h>
#include <signorini/qp/growing_set.h>

#include <algorithm>
#include <cmath>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace
{
QPResult by_active_set(const BoundConstrainedQP &qp, const Vector &start)
{
  return solve_by_active_set(qp, start, ActiveSetOptions());
}

/** Hands out columns of a matrix and remembers which. */
struct Columns
{
  const Matrix &from;
  std::vector<unsigned int> asked = {};
  unsigned int n_calls = 0;

  void operator()(const std::vector<unsigned int> &columns, Matrix &C)
  {
    ++n_calls;
    for (const unsigned int j : columns)
    {
      asked.push_back(j);
      for (unsigned int i = 0; i < from.m(); ++i)
        C(i, j) = C(j, i) = from(i, j);
    }
  }
};

/** Solves with columns on demand and compares with the whole matrix. @return the columns asked for.
 */
unsigned int compare(Checks &checks,
                     const std::string &name,
                     const Matrix &C,
                     const Vector &F,
                     const Vector &start)
{
  const BoundConstrainedQP qp(C, F);
  const QPResult whole = by_active_set(qp, Vector());
  Columns columns{C};
  Matrix partial;
  const QPResult found = solve_on_growing_set(F, start, std::ref(columns), by_active_set, partial);
  Vector difference = found.P;
  difference -= whole.P;
  checks.near(name + ": P", difference.linfty_norm(), 0., 1e-10 * whole.P.linfty_norm());
  checks.that(name + ": converged", found.converged);
  checks.near(name + ": KKT residual of the whole problem", qp.kkt_residual(found.P), 0., 1e-12);
  std::sort(columns.asked.begin(), columns.asked.end());
  checks.that(name + ": no column twice",
              std::adjacent_find(columns.asked.begin(), columns.asked.end()) ==
                columns.asked.end());
  double missing = 0.;
  for (const unsigned int j : columns.asked)
    for (unsigned int i = 0; i < F.size(); ++i)
      missing = std::max(missing, std::abs(partial(i, j) - C(i, j)));
  checks.near(name + ": C holds its columns", missing, 0., 0.);
  return columns.asked.size();
}

/** Like a compliance: positive definite, entries that decay away from the diagonal. */
Matrix make_compliance(const unsigned int m)
{
  Matrix C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      C(i, j) = std::exp(-0.2 * std::abs(double(i) - double(j)));
  return C;
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  const unsigned int m = 40;
  const Matrix C = make_compliance(m);

  Vector F(m);
  for (unsigned int i = 0; i < m; ++i)
    F[i] = std::pow((double(i) - 20.) / 20., 2) - 0.1;
  const unsigned int n = compare(checks, "a dent", C, F, Vector());
  checks.between("a dent: columns", n, 1, 20);

  Vector start(m);
  for (unsigned int i = 30; i < m; ++i)
    start[i] = -1.;
  compare(checks, "a wrong start", C, F, start);

  // Pulled down at one place, with negative couplings to patches that were open: they close.
  Matrix coupled = C;
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      coupled(i, j) = (i == j ? 2. : 0.) - (std::abs(int(i) - int(j)) == 1 ? 0.9 : 0.);
  Vector pulled(m);
  for (unsigned int i = 0; i < m; ++i)
    pulled[i] = i == 20 ? -1. : 0.01;
  const unsigned int joined = compare(checks, "patches that join", coupled, pulled, Vector());
  checks.between("patches that join: columns", joined, 5, m - 5);

  RandomNumbers random(7);
  for (unsigned int k = 0; k < 20; ++k)
  {
    const Vector shifted = random.vector(m);
    compare(
      checks, "random " + std::to_string(k), C, shifted, k % 2 == 0 ? Vector() : random.vector(m));
  }

  Columns columns{C};
  Matrix partial;
  Vector open(m);
  open = 1.;
  const QPResult nothing =
    solve_on_growing_set(open, Vector(), std::ref(columns), by_active_set, partial);
  checks.that("nothing touches: no column", columns.asked.empty() && nothing.P.linfty_norm() == 0.);
  return checks.exit_code();
}
