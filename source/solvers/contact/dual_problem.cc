// SPDX-License-Identifier: LGPL-2.1-or-later
// The compliance C as a matrix, and parts of C.

#include <signorini/solvers/contact/dual_problem.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <stdexcept>

namespace Signorini
{
using Vector = ComplianceOperator::Vector;
using Matrix = ComplianceOperator::Matrix;
using Indices = ComplianceOperator::Indices;

DenseCompliance::DenseCompliance(Matrix C)
  : C_(std::move(C))
{
  if (C_.m() != C_.n())
    throw std::invalid_argument("C is not a square matrix.");
}

unsigned int DenseCompliance::size() const
{
  return C_.m();
}

Vector DenseCompliance::apply(const Vector &P) const
{
  Vector product(size());
  if (size() > 0)
    C_.vmult(product, P);
  return product;
}

Vector DenseCompliance::diagonal() const
{
  Vector diagonal(size());
  for (unsigned int k = 0; k < size(); ++k)
    diagonal[k] = C_(k, k);
  return diagonal;
}

Matrix DenseCompliance::columns(const Indices &numbers) const
{
  Matrix columns(size(), numbers.size());
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      columns(i, j) = C_(i, numbers[j]);
  return columns;
}

const Matrix &DenseCompliance::dense() const
{
  return C_;
}

bool DenseCompliance::is_explicit() const
{
  return true;
}

Vector diagonal_times(const ComplianceOperator &C, const Vector &P)
{
  Indices pressing;
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] != 0.)
      pressing.push_back(k);
  const Matrix columns = C.columns(pressing);
  Vector product(P.size());
  for (unsigned int j = 0; j < pressing.size(); ++j)
    product[pressing[j]] = columns(pressing[j], j) * P[pressing[j]];
  return product;
}

Matrix submatrix(const ComplianceOperator &C, const Indices &numbers)
{
  const auto n = static_cast<unsigned int>(numbers.size());
  const Matrix columns = C.columns(numbers);
  Matrix part(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      part(i, j) = columns(numbers[i], j);
  return part;
}

// The problem min ½ Pᵀ C P - Pᵀ F over P in K, and the residual by which every solver is judged.

BoundConstrainedQP::BoundConstrainedQP(std::shared_ptr<const ComplianceOperator> C_,
                                       Vector F_,
                                       AdmissibleSet K_)
  : C(std::move(C_))
  , diagonal(C->diagonal())
  , F(std::move(F_))
  , K(std::move(K_))
{
  if (C->size() != F.size() || K.size() != F.size())
    throw std::invalid_argument("The sizes of C, F and K do not fit together.");
  for (unsigned int i = 0; i < size(); ++i)
    if (!(diagonal[i] > 0.))
      throw std::invalid_argument("C has a diagonal entry that is not positive: row " +
                                  std::to_string(i) + ".");
}

BoundConstrainedQP::BoundConstrainedQP(FullMatrix<double> C_, Vector F_, AdmissibleSet K_)
  : BoundConstrainedQP(std::make_shared<const DenseCompliance>(std::move(C_)),
                       std::move(F_),
                       std::move(K_))
{
}

BoundConstrainedQP::BoundConstrainedQP(FullMatrix<double> C_, const Vector &F_)
  : BoundConstrainedQP(std::move(C_), F_, AdmissibleSet::nonpositive(F_.size()))
{
}

BoundConstrainedQP::Vector BoundConstrainedQP::gradient(const Vector &P) const
{
  Vector W = C->apply(P);
  if (size() > 0)
    W -= F;
  return W;
}

double BoundConstrainedQP::energy(const Vector &P) const
{
  if (size() == 0)
    return 0.;
  const Vector W = gradient(P);
  return 0.5 * (P * W) - 0.5 * (P * F);
}

double BoundConstrainedQP::kkt_residual(const Vector &P) const
{
  const Vector W = gradient(P);
  double residual = 0.;
  double size_of_P = 0.;
  double size_of_F = 0.;
  for (unsigned int i = 0; i < size(); ++i)
  {
    const double r = K.residual(i, P[i], W[i] / diagonal[i]);
    residual += r * r;
    size_of_P += P[i] * P[i];
    size_of_F += F[i] * F[i] / (diagonal[i] * diagonal[i]);
  }
  const double scale = std::max(size_of_P, size_of_F);
  return scale > 0. ? std::sqrt(residual / scale) : std::sqrt(residual);
}

bool BoundConstrainedQP::has_unique_solution(const Vector &P) const
{
  const Vector W = gradient(P);
  const double zero = size() > 0 ? 1e-9 * F.linfty_norm() : 0.;
  std::vector<unsigned int> touching;
  for (unsigned int i = 0; i < size(); ++i)
    if (K.is_inside(i, P[i]) || (P[i] >= K[i].upper ? W[i] > -zero : W[i] < zero))
      touching.push_back(i);
  const auto n = static_cast<unsigned int>(touching.size());
  if (n == 0)
    return true;
  const FullMatrix<double> C_TT = submatrix(*C, touching);
  LAPACKFullMatrix<double> L(n, n);
  L = C_TT;
  L.set_property(LAPACKSupport::symmetric);
  try
  {
    L.compute_cholesky_factorization();
  }
  catch (const ExceptionBase &)
  {
    return false;
  }
  // The pivots: L_ii² is what elimination leaves of a diagonal entry.
  constexpr double rounding = 1e-12;
  for (unsigned int i = 0; i < n; ++i)
    if (!(L(i, i) * L(i, i) > rounding * C_TT(i, i)))
      return false;
  return true;
}
} // namespace Signorini
