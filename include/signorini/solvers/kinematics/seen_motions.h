// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/kinematics/free_motions.h>

#include <optional>
#include <vector>

namespace Signorini
{
/**
 * Free motions in coordinates z without units: q = T z. Columns of B have norm one before they are
 * combined, and what nothing sees (K v = 0, B v = 0) is left out. W = C P + B z - F,
 * K z - B^T P = b with the matrices of this class; z has the unit of W, b that of P.
 */
class SeenMotions
{
public:
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::FullMatrix<double>;

  /**
   * @param stiffness a typical 1/C_ii, sum over all patches of |B_i|^2/C_ii: K is zero where it is
   * below 1e-12 of it. @throws std::invalid_argument if sizes do not fit or K is not symmetric.
   */
  SeenMotions(const FreeMotions &motions, unsigned int m, double stiffness);

  /** Their number n <= k. */
  unsigned int size() const
  {
    return b.size();
  }
  /** q = T z. */
  Vector original(const Vector &z) const;
  /** b + B^T P - K z: what is missing in the balance. */
  Vector imbalance(const Vector &P, const Vector &z) const;

  /** m x n. */
  Matrix B;
  /** n x n. */
  Matrix K;
  Vector b;
  /** See MotionResult. */
  std::vector<Vector> unseen;
  /**
   * b has to lie in the cone {-B^T P : P <= 0} as far as K does not resist. By nonnegative least
   * squares with rows of B of norm one (a cone knows directions only); what is left of b is the
   * motion that escapes. Remainders below 1e-9 of b are rounding: a load just above the edge of a
   * body does not tip it.
   */
  std::optional<Vector> escape;

private:
  /** k x n. */
  Matrix T_;
  unsigned int n_original_ = 0;
};

/** @throws std::invalid_argument if B, K and b do not fit m patches, or K is not symmetric or has
 * a negative diagonal entry. */
void check_sizes(const FreeMotions &motions, unsigned int m);

/** The norms of the columns of B; zero if below 1e-12 of the largest, as for normals (0, 1) and
 * motions along x. */
dealii::Vector<double> column_norms(const dealii::FullMatrix<double> &B);
} // namespace Signorini
