// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures and motions for given patches in contact.

#include <signorini/qp/pressing_patches.h>
#include <signorini/qp/small_matrix.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;
using Indices = ComplianceOperator::Indices;

/** Adds part of the mean diagonal entry to the diagonal. */
void add_to_diagonal(Matrix &Q, const double part)
{
  double sum = 0.;
  for (unsigned int i = 0; i < Q.m(); ++i)
    sum += Q(i, i);
  for (unsigned int i = 0; i < Q.m(); ++i)
    Q(i, i) += part * sum / Q.m();
}

/** Whether every motion meets a resistance; not if K = 0 and B_A = 0. */
bool is_positive(const Matrix &Q)
{
  for (unsigned int i = 0; i < Q.m(); ++i)
    if (!(Q(i, i) > 0.))
      return false;
  return true;
}
} // namespace

Indices pressing_patches(const Vector &P)
{
  Indices A;
  for (unsigned int i = 0; i < P.size(); ++i)
    if (P[i] < 0.)
      A.push_back(i);
  return A;
}

std::optional<PressingSolution> solve_on_pressing(const ComplianceOperator &C,
                                                  const Vector &F,
                                                  const SeenMotions &motions,
                                                  const MotionState &start)
{
  const Indices A = pressing_patches(start.P);
  const unsigned int n = motions.size();
  if (A.empty())
    return std::nullopt;
  dealii::LAPACKFullMatrix<double> C_AA(A.size(), A.size());
  C_AA = submatrix(C, A);
  C_AA.set_property(dealii::LAPACKSupport::symmetric);
  try
  {
    C_AA.compute_cholesky_factorization();
  }
  catch (const dealii::ExceptionBase &)
  {
    return std::nullopt;
  }
  // Columns of C_AA^{-1} B_A.
  std::vector<Vector> X(n, Vector(A.size()));
  PressingSolution found{start, Matrix(n, n)};
  for (unsigned int j = 0; j < n; ++j)
  {
    for (unsigned int r = 0; r < A.size(); ++r)
      X[j][r] = motions.B(A[r], j);
    C_AA.solve(X[j]);
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j <= i; ++j)
    {
      for (unsigned int r = 0; r < A.size(); ++r)
        found.stiffness(i, j) += motions.B(A[r], i) * X[j][r];
      found.stiffness(j, i) = found.stiffness(i, j);
    }
  Matrix Q = found.stiffness;
  add_to_diagonal(Q, 1e-9);
  Q.add(1., motions.K);
  if (!is_positive(Q))
    return std::nullopt;
  const SmallCholesky solver(Q);
  MotionState &state = found.state;
  for (unsigned int pass = 0; pass < 4; ++pass)
  {
    if (pass > 0)
      state.z += solver.solve(motions.imbalance(state.P, state.z));
    const Vector moved = times(motions.B, state.z);
    Vector P_A(A.size());
    for (unsigned int r = 0; r < A.size(); ++r)
      P_A[r] = F[A[r]] - moved[A[r]];
    C_AA.solve(P_A);
    state.P = 0.;
    for (unsigned int r = 0; r < A.size(); ++r)
      state.P[A[r]] = P_A[r];
  }
  return found;
}
} // namespace Signorini
