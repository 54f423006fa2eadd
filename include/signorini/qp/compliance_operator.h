// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/**
 * C, symmetric positive definite, m x m, as far as solvers of the dual problem need it. Where C is
 * not explicit, each column costs a linear solve, and a solver should ask for few.
 */
class ComplianceOperator
{
public:
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::FullMatrix<double>;
  using Indices = std::vector<unsigned int>;

  virtual ~ComplianceOperator() = default;

  /** m. */
  virtual unsigned int size() const = 0;
  /** C P. */
  virtual Vector apply(const Vector &P) const = 0;
  /** C_kk for all k. */
  virtual Vector diagonal() const = 0;
  /** The columns with the given numbers, m x n. */
  virtual Matrix columns(const Indices &numbers) const = 0;
  /** All of C. */
  virtual const Matrix &dense() const = 0;
  /** Whether all entries are known, so that nothing of the above costs a linear solve. */
  virtual bool is_explicit() const = 0;
};

/** C as a matrix. */
class DenseCompliance final : public ComplianceOperator
{
public:
  /** @throws std::invalid_argument if C is not square. */
  explicit DenseCompliance(Matrix C);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector diagonal() const override;
  Matrix columns(const Indices &numbers) const override;
  const Matrix &dense() const override;
  bool is_explicit() const override;

private:
  Matrix C_;
};

/** C_kk P_k for all k: what each multiplier does to itself. Asks for the columns with P_k != 0. */
dealii::Vector<double> diagonal_times(const ComplianceOperator &C, const dealii::Vector<double> &P);

/** The block of C that belongs to the given rows and columns. */
dealii::FullMatrix<double> submatrix(const ComplianceOperator &C,
                                     const ComplianceOperator::Indices &numbers);
} // namespace Signorini
