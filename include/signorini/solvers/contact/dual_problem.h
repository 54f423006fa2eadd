// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/multiplier/admissible_set.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/**
 * The compliance C, symmetric positive definite, m x m, as solvers of the dual problem use it.
 * Where C is not explicit, each column costs a linear solve, and a solver should need few.
 */
class ComplianceOperator
{
public:
  using Vector = dealii::Vector<double>;
  using Matrix = FullMatrix<double>;
  using Indices = std::vector<unsigned int>;

  virtual ~ComplianceOperator() = default;

  /** Returns m. */
  virtual unsigned int size() const = 0;
  /** Returns C P. */
  virtual Vector apply(const Vector &P) const = 0;
  /** Returns C_kk for all k. */
  virtual Vector diagonal() const = 0;
  /** Returns the columns with the given numbers, m x n. */
  virtual Matrix columns(const Indices &numbers) const = 0;
  /** Returns the whole matrix C. */
  virtual const Matrix &dense() const = 0;
  /** Returns whether all entries are stored, so that no function above costs a linear solve. */
  virtual bool is_explicit() const = 0;
};

/** The compliance C as a stored matrix. */
class DenseCompliance final : public ComplianceOperator
{
public:
  /** Stores C. @throws std::invalid_argument if C is not square. */
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

/** Returns C_kk P_k for all k: how far each multiplier opens its own patch. Reads only the columns
 * with P_k != 0. */
dealii::Vector<double> diagonal_times(const ComplianceOperator &C, const dealii::Vector<double> &P);

/** Returns the block of C that belongs to the given rows and columns. */
FullMatrix<double> submatrix(const ComplianceOperator &C,
                             const ComplianceOperator::Indices &numbers);

/**
 * The dual problem: min ½ Pᵀ C P - Pᵀ F over P in K, C symmetric positive definite, m x m.
 *
 * Its solution satisfies, with W = C P - F,  P in K  and  Wᵀ(Q - P) ≥ 0 for all Q in K. Contact
 * without friction has K = {P ≤ 0}: there  W ≤ 0,  Pᵀ W = 0.
 */
struct BoundConstrainedQP
{
  using Vector = dealii::Vector<double>;

  /** Stores the problem. @throws std::invalid_argument if the sizes do not fit or a diagonal entry
   * of C is not positive. */
  BoundConstrainedQP(std::shared_ptr<const ComplianceOperator> C, Vector F, AdmissibleSet K);
  BoundConstrainedQP(FullMatrix<double> C, Vector F, AdmissibleSet K);
  /** Makes the problem with K = {P ≤ 0}. */
  BoundConstrainedQP(FullMatrix<double> C, const Vector &F);

  std::shared_ptr<const ComplianceOperator> C;
  /** The diagonal of C. */
  Vector diagonal;
  Vector F;
  AdmissibleSet K;

  unsigned int size() const
  {
    return F.size();
  }
  /** Returns W = C P - F. */
  Vector gradient(const Vector &P) const;
  /** Returns ½ Pᵀ C P - Pᵀ F. */
  double energy(const Vector &P) const;
  /**
   * Returns |P - projection of P - W/diag C onto K|₂ / max(|P|₂, |F/diag C|₂), or the numerator if
   * the denominator vanishes. It is zero at the solution and nowhere else.
   */
  double kkt_residual(const Vector &P) const;
  /**
   * Returns whether the solution P is the only one: whether C restricted to {i : W_i = 0 within
   * rounding} is regular. (Two solutions have the same W; their difference lies in the kernel of C
   * and vanishes on all other i.)
   */
  bool has_unique_solution(const Vector &P) const;
};

/** The result of a solver of the dual problem. */
struct QPResult
{
  dealii::Vector<double> P;
  /** The number of sweeps of projected SOR, linear solves of an active set method, or products of
   * MPRGP. */
  unsigned int iterations = 0;
  double kkt_residual = 0.;
  bool converged = false;
  /** The sweep of projected SOR at which the increment alone was small enough; else 0. */
  unsigned int increment_iterations = 0;
  /** Whether a set of the active set method came back, and single exchanges ended the search. */
  bool cycled = false;
  /** Whether P is the only solution; true if that was not examined. */
  bool unique = true;
  /** The reason why the active set method failed and projected SOR took its place. */
  std::optional<std::string> active_set_failure;
};
} // namespace Signorini
