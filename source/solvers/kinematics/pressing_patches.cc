// SPDX-License-Identifier: LGPL-2.1-or-later
// Nonnegative least squares after Lawson and Hanson.

#include <signorini/solvers/kinematics/pressing_patches.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <deal.II/lac/householder.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;
using Columns = std::vector<unsigned int>;

/** Returns the y with the smallest |b - A_S y| regardless of signs. */
Vector least_squares(const Matrix &A, const Columns &S, const Vector &b)
{
  Matrix A_S(A.m(), S.size());
  for (unsigned int i = 0; i < A.m(); ++i)
    for (unsigned int j = 0; j < S.size(); ++j)
      A_S(i, j) = A(i, S[j]);
  Vector y(S.size());
  Householder<double>(A_S).least_squares(y, b);
  return y;
}

/** Moves y towards the wanted values until the first entry vanishes, which then leaves the set. */
void step_back(Columns &S, Vector &y, const Vector &wanted)
{
  double part = 2.;
  unsigned int leaves = 0;
  for (unsigned int j = 0; j < S.size(); ++j)
    if (wanted[j] <= 0.)
    {
      const double here = y[j] > 0. ? y[j] / (y[j] - wanted[j]) : 0.;
      leaves = here < part ? j : leaves;
      part = std::min(part, here);
    }
  Columns left;
  std::vector<double> values;
  for (unsigned int j = 0; j < S.size(); ++j)
    if (j != leaves)
    {
      left.push_back(S[j]);
      values.push_back(y[j] + part * (wanted[j] - y[j]));
    }
  S = left;
  y = Vector(values.begin(), values.end());
}

bool all_positive(const Vector &y)
{
  return std::all_of(y.begin(), y.end(), [](const double value) { return value > 0.; });
}

/** Returns b - A_S y. */
Vector remainder(const Matrix &A, const Columns &S, const Vector &y, const Vector &b)
{
  Vector r = b;
  for (unsigned int j = 0; j < S.size(); ++j)
    for (unsigned int i = 0; i < A.m(); ++i)
      r[i] -= A(i, S[j]) * y[j];
  return r;
}
} // namespace

Vector remainder_outside_cone(const Matrix &A, const Vector &b, const double rounding)
{
  return project_on_cone(A, b, rounding).remainder;
}

ConeProjection project_on_cone(const Matrix &A, const Vector &b, const double rounding)
{
  Columns S;
  Vector y, r = b;
  const double small = rounding * b.l2_norm();
  // |r| falls in each turn, so no set comes back; the bound is for rounding.
  for (unsigned int turn = 0; turn < 3 * A.n() + 10; ++turn)
  {
    const Vector rates = transpose_times(A, r);
    unsigned int best = 0;
    for (unsigned int j = 1; j < A.n(); ++j)
      if (rates[j] > rates[best])
        best = j;
    const bool is_in = std::find(S.begin(), S.end(), best) != S.end();
    if (A.n() == 0 || rates[best] <= small || is_in || S.size() == A.m())
      break;
    S.push_back(best);
    Vector longer(S.size());
    std::copy(y.begin(), y.end(), longer.begin());
    y = longer;
    Vector wanted = least_squares(A, S, b);
    while (!S.empty() && !all_positive(wanted))
    {
      step_back(S, y, wanted);
      wanted = S.empty() ? Vector() : least_squares(A, S, b);
    }
    y = wanted;
    const Vector next = remainder(A, S, y, b);
    if (next.l2_norm() >= r.l2_norm())
      break;
    r = next;
  }
  return {S, y, r};
}

// Pressures and motions for given patches in contact.

namespace
{
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;
using Indices = ComplianceOperator::Indices;

using Factor = LAPACKFullMatrix<double>;

/** Adds part of the mean diagonal entry to the diagonal. */
void add_to_diagonal(Matrix &Q, const double part)
{
  double sum = 0.;
  for (unsigned int i = 0; i < Q.m(); ++i)
    sum += Q(i, i);
  for (unsigned int i = 0; i < Q.m(); ++i)
    Q(i, i) += part * sum / Q.m();
}

/**
 * Factorises C_AA by Cholesky's method.
 * @return whether it is regular: all pivots are above rounding.
 */
bool try_to_factorise(const Matrix &C_AA, Factor &factor)
{
  factor.reinit(C_AA.m());
  factor = C_AA;
  factor.set_property(LAPACKSupport::symmetric);
  try
  {
    factor.compute_cholesky_factorization();
  }
  catch (const ExceptionBase &)
  {
    return false;
  }
  for (unsigned int i = 0; i < C_AA.m(); ++i)
    if (!(factor(i, i) * factor(i, i) > 1e-12 * C_AA(i, i)))
      return false;
  return true;
}

/** Factorises C_AA, or C_AA with a little more on the diagonal where it is singular. */
bool factorise_nearly(Matrix C_AA, Factor &factor)
{
  if (try_to_factorise(C_AA, factor))
    return true;
  add_to_diagonal(C_AA, 1e-8);
  return try_to_factorise(C_AA, factor);
}

/** Refines the solution: solves for the remainders of both equations several times and adds the
 * result. X = C_AA⁻¹ B_A. */
void refine(const ComplianceOperator &C,
            const Vector &F,
            const ReducedMotions &motions,
            const Indices &A,
            const Factor &C_AA,
            const std::vector<Vector> &X,
            const SmallCholesky &Q,
            MotionState &state)
{
  for (unsigned int pass = 0; pass < 4; ++pass)
  {
    Vector rest = F, dP(A.size());
    rest -= C.apply(state.P);
    rest -= times(motions.B, state.z);
    for (unsigned int r = 0; r < A.size(); ++r)
      dP[r] = rest[A[r]];
    C_AA.solve(dP);
    for (unsigned int r = 0; r < A.size(); ++r)
      state.P[A[r]] += dP[r];
    const Vector dz = Q.solve(motions.imbalance(state.P, state.z));
    state.z += dz;
    for (unsigned int r = 0; r < A.size(); ++r)
      for (unsigned int j = 0; j < dz.size(); ++j)
        state.P[A[r]] -= X[j][r] * dz[j];
  }
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
                                                  const ReducedMotions &motions,
                                                  const MotionState &start)
{
  const Indices A = pressing_patches(start.P);
  const unsigned int n = motions.size();
  if (A.empty())
    return std::nullopt;
  Factor C_AA;
  if (!factorise_nearly(submatrix(C, A), C_AA))
    return std::nullopt;
  // Columns of C_AA⁻¹ B_A.
  std::vector<Vector> X(n, Vector(A.size()));
  PressingSolution found{start, Matrix(n, n)};
  for (double &P_i : found.state.P)
    P_i = std::min(P_i, 0.);
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
  try
  {
    refine(C, F, motions, A, C_AA, X, SmallCholesky(Q), found.state);
  }
  catch (const std::invalid_argument &)
  {
    return std::nullopt;
  }
  return found;
}
} // namespace Signorini
