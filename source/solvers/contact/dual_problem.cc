// SPDX-License-Identifier: LGPL-2.1-or-later
// The compliance C as a matrix, and the dual problem with the residual by which every solver is
// judged.

#include <signorini/solvers/contact/dual_problem.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace Signorini {
using Vector = ComplianceOperator::Vector;
using Matrix = ComplianceOperator::Matrix;
using Indices = ComplianceOperator::Indices;

namespace {
Indices nonzeros(const Vector &P) {
  Indices numbers;
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] != 0.)
      numbers.push_back(k);
  return numbers;
}
} // namespace

Indices all_indices(const unsigned int n) {
  Indices numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

Indices indices_of(const std::vector<bool> &set) {
  Indices numbers;
  for (unsigned int i = 0; i < set.size(); ++i)
    if (set[i])
      numbers.push_back(i);
  return numbers;
}

DenseCompliance::DenseCompliance(Matrix C) {
  AssertDimension(C.m(), C.n());
  C_ = std::move(C);
}

unsigned int DenseCompliance::size() const {
  return C_.m();
}

Vector DenseCompliance::apply(const Vector &P) const {
  const Indices pressing = nonzeros(P);
  require(pressing);
  Vector product(size());
  for (unsigned int i = 0; i < size(); ++i)
    for (const unsigned int k : pressing)
      product[i] += C_(i, k) * P[k];
  return product;
}

Vector DenseCompliance::diagonal() const {
  require(all_indices(size()));
  Vector diagonal(size());
  for (unsigned int k = 0; k < size(); ++k)
    diagonal[k] = C_(k, k);
  return diagonal;
}

Vector DenseCompliance::diagonal_times(const Vector &P) const {
  require(nonzeros(P));
  Vector product(P);
  for (unsigned int k = 0; k < size(); ++k)
    product[k] *= P[k] != 0. ? C_(k, k) : 0.;
  return product;
}

Matrix DenseCompliance::columns(const Indices &numbers) const {
  require(numbers);
  Matrix columns(size(), numbers.size());
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      columns(i, j) = C_(i, numbers[j]);
  return columns;
}

const Matrix &DenseCompliance::dense() const {
  require(all_indices(size()));
  return C_;
}

Matrix submatrix(const ComplianceOperator &C, const Indices &numbers) {
  const Matrix columns = C.columns(numbers);
  Matrix part(numbers.size(), numbers.size());
  for (unsigned int i = 0; i < numbers.size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      part(i, j) = columns(numbers[i], j);
  return part;
}

LAPACKFullMatrix<double> cholesky(const Matrix &C, const double rounding) {
  LAPACKFullMatrix<double> L(C.m());
  if (C.m() == 0)
    return L;
  L = C;
  L.set_property(LAPACKSupport::symmetric);
  L.compute_cholesky_factorization();
  // Elimination leaves L_ii² of a diagonal entry.
  for (unsigned int i = 0; i < C.m(); ++i)
    if (!(L(i, i) * L(i, i) > rounding * C(i, i)))
      throw LACExceptions::ExcSingular();
  return L;
}

Splitting::Splitting(const Matrix &M, const double threshold) {
  const unsigned int k = M.m();
  LAPACKFullMatrix<double> svd(k);
  svd = M;
  svd.compute_svd();
  unsigned int n = 0;
  while (n < k && svd.singular_value(n) > threshold)
    ++n;
  null.reinit(k, k - n);
  rest.reinit(k, n);
  for (unsigned int i = 0; i < k; ++i)
    for (unsigned int j = 0; j < k; ++j)
      (j < n ? rest(i, j) : null(i, j - n)) = svd.get_svd_vt()(j, i);
}

Matrix projector_on(const Matrix &M, const unsigned int k) {
  Matrix square(k, k);
  if (M.n() > 0)
    M.mTmult(square, M);
  return square;
}

double kkt_residual(const AdmissibleSet &K, const Vector &P, const Vector &W, const Vector &F,
                    const Vector &c, const Vector &imbalance, const Vector &b) {
  Vector step(W);
  for (unsigned int i = 0; i < P.size(); ++i)
    step[i] /= c[i];
  const Vector rest = K.residual(P, step);
  double residual = 0., size_of_P = 0., size_of_F = 0., size_of_b = 0.;
  for (const double r : imbalance)
    residual += r * r;
  for (const double b_j : b)
    size_of_b += b_j * b_j;
  for (unsigned int i = 0; i < P.size(); ++i) {
    residual += rest[i] * rest[i];
    size_of_P += P[i] * P[i];
    if (P[i] != 0. || rest[i] != 0.)
      size_of_F += std::pow(F[i] / c[i], 2);
  }
  const double scale = std::max({size_of_P, size_of_F, size_of_b});
  return std::sqrt(scale > 0. ? residual / scale : residual);
}

BoundConstrainedQP::BoundConstrainedQP(std::shared_ptr<const ComplianceOperator> C_, Vector F_,
                                       AdmissibleSet K_, Balances balances_)
  : C(std::move(C_))
  , diagonal(C->diagonal())
  , F(std::move(F_))
  , K(std::move(K_))
  , balances(std::move(balances_)) {
  AssertDimension(C->size(), F.size());
  AssertDimension(K.size(), F.size());
  for (unsigned int i = 0; i < size(); ++i)
    if (!(diagonal[i] > 0.))
      throw std::invalid_argument("C has a diagonal entry that is not positive: row " +
                                  std::to_string(i) + ".");
  K.average(diagonal);
}

BoundConstrainedQP::BoundConstrainedQP(Matrix C_, const Vector &F_, Balances balances_)
  : BoundConstrainedQP(std::make_shared<const DenseCompliance>(std::move(C_)), F_,
                       AdmissibleSet::nonpositive(F_.size()), std::move(balances_)) {}

Vector BoundConstrainedQP::gradient(const Vector &P, const Vector &z) const {
  Vector W = C->apply(P);
  if (size() > 0 && balances.size() > 0)
    balances.B.vmult_add(W, z);
  if (size() > 0)
    W -= F;
  return W;
}

Vector BoundConstrainedQP::imbalance(const Vector &P, const Vector &z) const {
  Vector r(balances.b), K_z(r);
  if (r.size() == 0)
    return r;
  if (size() > 0)
    balances.B.Tvmult_add(r, P);
  balances.K.vmult(K_z, z);
  r -= K_z;
  return r;
}

double BoundConstrainedQP::energy(const Vector &P) const {
  return size() > 0 ? 0.5 * (P * gradient(P)) - 0.5 * (P * F) : 0.;
}

bool BoundConstrainedQP::has_unique_solution(const Vector &P, const Vector &z) const {
  if (size() == 0)
    return true;
  const Vector W = gradient(P, z);
  Vector B_z(size());
  if (balances.size() > 0)
    balances.B.vmult(B_z, z);
  const double zero = 1e-9 * (F.linfty_norm() + B_z.linfty_norm());
  Indices touching;
  for (unsigned int i = 0; i < size(); ++i)
    if (K.is_inside(i, P[i]) || (P[i] >= K[i].upper ? W[i] > -zero : W[i] < zero))
      touching.push_back(i);
  // Q with C Q = 0 and Bᵀ Q = 0 is one with (C + s B Bᵀ) Q = 0.
  Matrix C_TT = submatrix(*C, touching);
  const double s = C_TT.m() * diagonal.linfty_norm();
  for (unsigned int i = 0; i < C_TT.m(); ++i)
    for (unsigned int j = 0; j < C_TT.m(); ++j)
      for (unsigned int l = 0; l < balances.size(); ++l)
        C_TT(i, j) += s * balances.B(touching[i], l) * balances.B(touching[j], l);
  try {
    cholesky(C_TT, 1e-12);
  } catch (const ExceptionBase &) {
    return false;
  }
  return true;
}

MotionResistance::MotionResistance(const Matrix &K, const Matrix &B_A, const Matrix &B_trial,
                                   const LAPACKFullMatrix<double> &C_AA)
  : S(K) {
  for (unsigned int j = 0; j < K.n(); ++j) {
    Vector column(B_A.m());
    for (unsigned int r = 0; r < column.size(); ++r)
      column[r] = B_A(r, j);
    if (column.size() > 0)
      C_AA.solve(column);
    for (unsigned int i = 0; i < K.m(); ++i)
      for (unsigned int r = 0; r < column.size(); ++r)
        S(i, j) += B_trial(r, i) * column[r];
    X.push_back(column);
  }
}
} // namespace Signorini
