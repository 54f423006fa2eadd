// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

/**
 * The dual problem: min 1/2 P^T C P - P^T F over P in K, C symmetric positive definite, m x m.
 *
 * Its solution satisfies, with W = C P - F,  P in K  and  W.(Q - P) >= 0 for all Q in K. Contact
 * without friction has K = {P <= 0}: there  W <= 0,  P.W = 0.
 */
struct BoundConstrainedQP
{
  using Vector = dealii::Vector<double>;

  /** @throws std::invalid_argument if the sizes do not fit or a diagonal entry of C is not
   * positive. */
  BoundConstrainedQP(std::shared_ptr<const ComplianceOperator> C, Vector F, AdmissibleSet K);
  BoundConstrainedQP(dealii::FullMatrix<double> C, Vector F, AdmissibleSet K);
  /** With K = {P <= 0}. */
  BoundConstrainedQP(dealii::FullMatrix<double> C, const Vector &F);

  std::shared_ptr<const ComplianceOperator> C;
  /** Of C. */
  Vector diagonal;
  Vector F;
  AdmissibleSet K;

  unsigned int size() const
  {
    return F.size();
  }
  /** W = C P - F. */
  Vector gradient(const Vector &P) const;
  /** 1/2 P^T C P - P^T F. */
  double energy(const Vector &P) const;
  /**
   * |P - projection of P - W/diag C onto K|_2 / max(|P|_2, |F/diag C|_2), 0 if both vanish: zero
   * at the solution and nowhere else.
   */
  double kkt_residual(const Vector &P) const;
  /**
   * Whether P is the only solution: C restricted to {i : W_i = 0 within rounding} is regular. (Two
   * solutions have the same W and differ by an element of the kernel of C that lives there.)
   */
  bool has_unique_solution(const Vector &P) const;
};

/** What a solver of the dual problem returns. */
struct QPResult
{
  dealii::Vector<double> P;
  /** Sweeps of projected SOR, or linear solves of an active set method. */
  unsigned int iterations = 0;
  double kkt_residual = 0.;
  bool converged = false;
  /** Projected SOR: the sweep at which the increment alone was small enough; else 0. */
  unsigned int increment_iterations = 0;
  /** Active set: whether a set came back and single exchanges had to end the search. */
  bool cycled = false;
  /** Whether P is the only solution, as far as that was examined. */
  bool unique = true;
  /** Why the active set method failed where projected SOR answered instead. */
  std::optional<std::string> active_set_failure;
};
} // namespace Signorini
