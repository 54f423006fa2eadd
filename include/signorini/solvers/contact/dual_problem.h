// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/admissible_set.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/**
 * The compliance C, symmetric positive definite, m x m, as solvers of the dual problem use it.
 * Where C is not explicit, each column costs a linear solve, and a solver should need few.
 */
class ComplianceOperator {
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
  /** Returns C_kk P_k for all k: how far each multiplier opens its own patch. */
  virtual Vector diagonal_times(const Vector &P) const = 0;
  /** Returns the columns with the given numbers, m x n. */
  virtual Matrix columns(const Indices &numbers) const = 0;
  /** Returns the whole matrix C. */
  virtual const Matrix &dense() const = 0;
  /** Returns whether all entries are stored, so that no function above costs a linear solve. */
  virtual bool is_explicit() const = 0;
};

/** The compliance C as a stored matrix. Derived classes may compute its columns at their first use.
 */
class DenseCompliance : public ComplianceOperator {
public:
  /** Stores C, which is square. */
  explicit DenseCompliance(Matrix C);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector diagonal() const override;
  /** Reads only the columns with P_k != 0. */
  Vector diagonal_times(const Vector &P) const override;
  Matrix columns(const Indices &numbers) const override;
  const Matrix &dense() const override;
  bool is_explicit() const override {
    return true;
  }

protected:
  /** Makes the given columns and rows of C known. */
  virtual void require(const Indices & /*numbers*/) const {}

  /** The entries, as far as they are known. */
  mutable Matrix C_;
};

/** Returns the numbers 0, ..., n - 1. */
ComplianceOperator::Indices all_indices(unsigned int n);

/** Returns the numbers of the members of a set. */
ComplianceOperator::Indices indices_of(const std::vector<bool> &set);

/** Returns the block of C that belongs to the given rows and columns. */
FullMatrix<double> submatrix(const ComplianceOperator &C,
                             const ComplianceOperator::Indices &numbers);

/**
 * Factorises a symmetric matrix by Cholesky's method.
 * @throws LACExceptions::ExcSingular if a pivot is not above rounding relative to its diagonal
 * entry.
 */
LAPACKFullMatrix<double> cholesky(const FullMatrix<double> &C, double rounding = 0.);

/** The right singular vectors of a square matrix with singular values up to a threshold, and the
 * others, as columns; orthonormal. */
struct Splitting {
  Splitting(const FullMatrix<double> &M, double threshold);

  FullMatrix<double> null, rest;
};

/** Returns the projector M Mᵀ, k x k, also without columns. */
FullMatrix<double> projector_on(const FullMatrix<double> &M, unsigned int k);

/**
 * The linear balances of a body that n motions z move freely beside the pressures:
 *
 *     K z - Bᵀ P = b.
 *
 * Motion j closes patch i by B_ij, K (n x n, symmetric, positive semi-definite) is the elastic
 * resistance, and b the work of the loads. Without free motions everything is empty. Columns of B
 * are of size one, so that b has the unit of P, and z that of W.
 */
struct Balances {
  FullMatrix<double> B{};
  FullMatrix<double> K{};
  dealii::Vector<double> b = {};
  /** An admissible P for which some z balances. */
  dealii::Vector<double> P = {};

  unsigned int size() const {
    return b.size();
  }
};

/**
 * Returns |P - projection of P - W/c onto K|₂ / max(|P|₂, |F/c|₂), or the numerator if the
 * denominator vanishes, for positive c (diag C). It is zero at the solution of the dual problem and
 * nowhere else. F counts on patches that press or penetrate only: on tiny faces far away F/c is so
 * large that a wrong set would pass for rounding, and for a body that moves gaps far away are
 * irrelevant.
 * @param K a set that does not move.
 * @param imbalance, b further vectors of the numerator and of the denominator; may be empty.
 */
double kkt_residual(const AdmissibleSet &K, const dealii::Vector<double> &P,
                    const dealii::Vector<double> &W, const dealii::Vector<double> &F,
                    const dealii::Vector<double> &c, const dealii::Vector<double> &imbalance = {},
                    const dealii::Vector<double> &b = {});

/**
 * The dual problem: min ½ Pᵀ C P - Pᵀ F over P in K, C symmetric positive definite, m x m. With
 * balances ½ zᵀ K z is added, and P and z balance.
 *
 * Its solution satisfies, with W = C P + B z - F,  P in K  and  Wᵀ(Q - P) ≥ 0 for all Q in K.
 * Contact without friction has K = {P ≤ 0}: there  W ≤ 0,  Pᵀ W = 0. The motions are the
 * multipliers of the balances.
 */
struct BoundConstrainedQP {
  using Vector = dealii::Vector<double>;

  /** Stores the problem. @throws std::invalid_argument if a diagonal entry of C is not positive. */
  BoundConstrainedQP(std::shared_ptr<const ComplianceOperator> C, Vector F, AdmissibleSet K,
                     Balances balances = {});
  /** Makes the problem with K = {P ≤ 0}. */
  BoundConstrainedQP(FullMatrix<double> C, const Vector &F, Balances balances = {});

  std::shared_ptr<const ComplianceOperator> C;
  /** The diagonal of C; its means over the blocks of K. */
  Vector diagonal;
  Vector F;
  AdmissibleSet K;
  Balances balances;

  unsigned int size() const {
    return F.size();
  }
  /** Returns the relative residual that rounding leaves after a solve with a part of C. */
  double rounding() const {
    return (size() + 10) * std::numeric_limits<double>::epsilon();
  }
  /** Returns W = C P + B z - F. */
  Vector gradient(const Vector &P, const Vector &z = {}) const;
  /** Returns b + Bᵀ P - K z. */
  Vector imbalance(const Vector &P, const Vector &z) const;
  /** Returns ½ Pᵀ C P - Pᵀ F. */
  double energy(const Vector &P) const;
  /** Returns the KKT residual. With balances the imbalance belongs to the numerator, and |b|₂ to
   * the denominator. */
  double kkt_residual(const Vector &P, const Vector &z = {}) const {
    return Signorini::kkt_residual(K.at(P), P, gradient(P, z), F, diagonal, imbalance(P, z),
                                   balances.b);
  }
  /**
   * Returns whether the pressure P of a solution is the only one: whether no Q ≠ 0 that vanishes
   * where W_i ≠ 0 has C Q = 0 and Bᵀ Q = 0. (Two solutions have the same W; their difference is
   * such a Q.)
   */
  bool has_unique_solution(const Vector &P, const Vector &z = {}) const;
};

/** The resistance of a set A of patches against the motions of Balances: the columns of
 * X = C_AA⁻¹ B_A, and S = K + B_trialᵀ X. */
struct MotionResistance {
  /** Computes X and S with a factor of C_AA. @param B_trial the closing by the motions where one of
   * the unknowns of A is one: B_A, or more where bounds follow. */
  MotionResistance(const FullMatrix<double> &K, const FullMatrix<double> &B_A,
                   const FullMatrix<double> &B_trial, const LAPACKFullMatrix<double> &C_AA);

  std::vector<dealii::Vector<double>> X;
  FullMatrix<double> S;
};

/** The options of the methods that solve the dual problem. */
struct IterationOptions {
  /** The tolerance of the KKT residual, for projected SOR also of the increment. */
  double tolerance = 1e-10;
  /** The maximal number of sweeps or linear solves. */
  unsigned int maximum_iterations = 100000;
  /** The factor ω of projected SOR, 0 < ω < 2. */
  double relaxation = 1.1;
  /** Whether projected SOR ends where, at the pace of the last hundred sweeps, the others that are
   * allowed would not reach the tolerance. */
  bool may_give_up = false;
};

/** The result of a solver of the dual problem. */
struct QPResult {
  dealii::Vector<double> P;
  /** The free motions of Balances. Where pressing patches leave a motion free (tipping about an
   * edge), one of several solutions. */
  dealii::Vector<double> z;
  /** The number of sweeps of projected SOR, or linear solves of an active set method. */
  unsigned int iterations = 0;
  double kkt_residual = 0.;
  bool converged = false;
  /** The sweep of projected SOR at which the increment alone was small enough; else 0. */
  unsigned int increment_iterations = 0;
  /** Whether a set of the active set method came back, and steps by single patches ended the
   * search. */
  bool cycled = false;
  /** Whether Newton's method did not end with Coulomb's law, so that the path of solutions was
   * followed. */
  bool by_path = false;
  /** Whether P is the only solution; true if that was not examined. */
  bool unique = true;
  /** The reason why the active set method failed and projected SOR replaced it. */
  std::optional<std::string> active_set_failure;
};
} // namespace Signorini
