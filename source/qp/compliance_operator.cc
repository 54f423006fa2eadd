// SPDX-License-Identifier: LGPL-2.1-or-later
// C as a matrix, and parts of C.

#include <signorini/qp/compliance_operator.h>

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
} // namespace Signorini
