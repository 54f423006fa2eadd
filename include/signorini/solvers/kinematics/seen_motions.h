// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/kinematics/free_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <optional>
#include <vector>

namespace Signorini
{
/** The Cholesky factorisation Q = L Lᵀ for the few unknowns of free motions. */
class SmallCholesky
{
public:
  /**
   * Factorises Q.
   * @throws std::invalid_argument if Q is not positive definite.
   */
  explicit SmallCholesky(const FullMatrix<double> &Q);

  /** Returns Q⁻¹ x. */
  dealii::Vector<double> solve(const dealii::Vector<double> &x) const;
  /** Returns L⁻¹ x. */
  dealii::Vector<double> forward(const dealii::Vector<double> &x) const;

private:
  FullMatrix<double> L_;
};

/** An orthonormal basis of a null space, and one of its orthogonal complement. */
struct Splitting
{
  std::vector<dealii::Vector<double>> null, rest;
};

/** Splits the space by singular values: |M v| ≤ threshold for unit vectors v in `null`; M is n x
 * k, k small. */
Splitting split_by_size(const FullMatrix<double> &M, double threshold);

/** times() returns M x, transpose_times() Mᵀ y, also for matrices without rows or columns. */
dealii::Vector<double> times(const FullMatrix<double> &M, const dealii::Vector<double> &x);
dealii::Vector<double> transpose_times(const FullMatrix<double> &M,
                                       const dealii::Vector<double> &y);

/** The free motions in coordinates z without units: q = T z. Columns of B have norm one before they
 * are combined. Motions without any resistance (K v = 0, B v = 0) are left out. W = C P + B z - F
 * and K z - Bᵀ P = b hold with the matrices of this class; z has the unit of W, b that of P. */
class ReducedMotions
{
public:
  using Vector = dealii::Vector<double>;
  using Matrix = FullMatrix<double>;

  /**
   * Reduces the motions.
   * @param stiffness a typical 1/C_ii, that is, the sum over all patches of |B_i|²/C_ii. K is zero
   * where it is below 1e-12 of it.
   * @throws std::invalid_argument if sizes do not fit or K is not symmetric.
   */
  ReducedMotions(const FreeMotions &motions, unsigned int m, double stiffness);

  /** Returns the number n ≤ k of the reduced motions. */
  unsigned int size() const
  {
    return b.size();
  }
  /** Returns q = T z. */
  Vector original(const Vector &z) const;
  /** Returns b + Bᵀ P - K z, the imbalance. */
  Vector imbalance(const Vector &P, const Vector &z) const;

  /** The coupling B, m x n. */
  Matrix B;
  /** The stiffness K, n x n. */
  Matrix K;
  Vector b;
  /** The motions without resistance, see MotionResult. */
  std::vector<Vector> unseen;
  /** The motion that escapes, if there is one. b has to lie in the cone {-Bᵀ P : P ≤ 0} as far as
   * K does not resist. Nonnegative least squares with rows of B of norm one decide this (a cone
   * depends on directions only): the remainder of b is the motion that escapes. Remainders below
   * 1e-9 of b are rounding: a load just above the edge of a body does not tip it. */
  std::optional<Vector> escape;

private:
  /** The matrix T, k x n. */
  Matrix T_;
  unsigned int n_original_ = 0;
};

/**
 * Checks the sizes.
 * @throws std::invalid_argument if B, K and b do not fit m patches, or K is not symmetric or has a
 * negative diagonal entry.
 */
void check_sizes(const FreeMotions &motions, unsigned int m);

/** Returns the norms of the columns of B; zero if below 1e-12 of the largest, as for normals (0, 1)
 * and motions along x. */
dealii::Vector<double> column_norms(const FullMatrix<double> &B);
} // namespace Signorini
