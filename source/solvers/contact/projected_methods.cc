// SPDX-License-Identifier: LGPL-2.1-or-later
// Projected successive over-relaxation, algorithm (i)-(iii), and its proximal form where motions
// are free.

#include <signorini/solvers/contact/projected_methods.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Signorini {
using Vector = dealii::Vector<double>;

namespace {
/** Returns the largest eigenvalue of the symmetric matrix of a block: C_ii if it has one unknown.
 */
double largest_eigenvalue(const FullMatrix<double> &C, const AdmissibleSet &K,
                          const unsigned int i) {
  if (!K.is_disc(i))
    return C(i, i);
  const unsigned int j = i + K.n_discs();
  return 0.5 * (C(i, i) + C(j, j)) + std::hypot(0.5 * (C(i, i) - C(j, j)), C(i, j));
}
} // namespace

double psor_sweep(const BoundConstrainedQP &qp, const double relaxation, Vector &P) {
  const FullMatrix<double> &C = qp.C->dense();
  const AdmissibleSet K = qp.K.at(P);
  const unsigned int stride = K.n_discs();
  double squared_increment = 0.;
  std::array<double, 2> relaxed, before;
  for (unsigned int i = 0; i < K.n_blocks(); ++i) {
    const double c = largest_eigenvalue(C, K, i);
    const unsigned int n = K.is_disc(i) ? 2 : 1;
    for (unsigned int a = 0; a < n; ++a) {
      const unsigned int k = i + a * stride;
      const double *row = &C(k, 0);
      double CP_k = 0.;
      for (unsigned int j = 0; j < qp.size(); ++j)
        CP_k += row[j] * P[j];
      const double lambda = P[k] - (CP_k - qp.F[k]) / c;
      before[a] = P[k];
      relaxed[a] = (1. - relaxation) * P[k] + relaxation * lambda;
    }
    for (unsigned int a = 0; a < n; ++a)
      P[i + a * stride] = relaxed[a];
    K.project(i, P);
    for (unsigned int a = 0; a < n; ++a)
      squared_increment += std::pow(P[i + a * stride] - before[a], 2);
  }
  return std::sqrt(squared_increment);
}

namespace {
/** The pace of sweeps, which decides whether those that are left may reach the tolerance. */
class Pace {
public:
  explicit Pace(const IterationOptions &options)
    : options_(options) {}

  /** Returns whether sweeps may go on; asked after each of them. */
  bool suffices(const BoundConstrainedQP &qp, const QPResult &result) {
    constexpr unsigned int window = 100;
    if (!options_.may_give_up || result.iterations % window > 0)
      return true;
    const double residual = qp.kkt_residual(result.P), fall = residual / before_;
    before_ = residual;
    const double n_windows = double(options_.maximum_iterations - result.iterations) / window;
    return residual * std::pow(fall, n_windows) <= options_.tolerance;
  }

private:
  const IterationOptions &options_;
  double before_ = std::numeric_limits<double>::infinity();
};

/** Solves a problem without balances. */
QPResult sweep_until_settled(const BoundConstrainedQP &qp, const Vector &start,
                             const IterationOptions &options) {
  QPResult result;
  result.P = start.size() > 0 ? start : Vector(qp.size());
  qp.K.at(result.P).project(result.P);
  result.converged = qp.size() == 0; // nothing to do
  double last_increment = 0.;
  Pace pace(options);
  while (result.iterations < options.maximum_iterations && !result.converged &&
         pace.suffices(qp, result)) {
    ++result.iterations;
    const double increment = psor_sweep(qp, options.relaxation, result.P);
    const double small = options.tolerance * result.P.l2_norm();
    if (increment <= small) {
      if (result.increment_iterations == 0)
        result.increment_iterations = result.iterations;
      // The increments fall like ρ^k: the error is about increment ρ/(1 - ρ).
      const double rho = last_increment > 0. ? increment / last_increment : 0.;
      const bool crawling = rho < 1. && increment * rho > 50. * (1. - rho) * small;
      result.kkt_residual = qp.kkt_residual(result.P);
      result.converged = result.kkt_residual <= options.tolerance && !crawling;
    }
    last_increment = increment;
  }
  if (!result.converged)
    result.kkt_residual = qp.kkt_residual(result.P);
  return result;
}

/** Returns Bᵀ C_AA⁻¹ B, the resistance of patches to the motions. */
FullMatrix<double> resistance_of(const BoundConstrainedQP &qp,
                                 const ComplianceOperator::Indices &A) {
  constexpr double regular = 1e-8;
  FullMatrix<double> C_AA = submatrix(*qp.C, A);
  C_AA.diagadd(regular * C_AA.trace() / A.size());
  const unsigned int n = qp.balances.size();
  FullMatrix<double> B_A(A.size(), n);
  B_A.extract_submatrix_from(qp.balances.B, A, all_indices(n));
  return MotionResistance(FullMatrix<double>(n, n), B_A, B_A, cholesky(C_AA)).S;
}

/** Returns E: part of the stiffness of the patches that press, or of all; motions that it does not
 * resist get some, too. */
FullMatrix<double> proximal_stiffness(const BoundConstrainedQP &qp, const Vector &P) {
  constexpr double part = 0.3, small = 1e-4, rounding = 1e-10;
  ComplianceOperator::Indices A;
  const AdmissibleSet K = qp.K.at(P);
  // The resistance of separate patches; B may be rounding on A.
  double typical = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i) {
    if (K.is_inside(i, P[i]))
      A.push_back(i);
    for (unsigned int j = 0; j < qp.balances.size(); ++j)
      typical += std::pow(qp.balances.B(i, j), 2) / qp.diagonal[i];
  }
  FullMatrix<double> E(qp.balances.size(), qp.balances.size());
  if (!A.empty())
    E = resistance_of(qp, A);
  // Where all of them slip, P_n resists no motion along the contact sides.
  if (E.trace() <= rounding * typical)
    E = resistance_of(qp, all_indices(qp.size()));
  E.diagadd(small * E.trace());
  E *= part;
  return E;
}

/** Solves a problem with balances by proximal iteration. */
QPResult sweep_proximally(const BoundConstrainedQP &qp, const Vector &start,
                          const IterationOptions &options) {
  const Balances &balances = qp.balances;
  QPResult result;
  result.P = start.size() > 0 ? start : Vector(qp.size());
  result.z.reinit(balances.size());
  result.kkt_residual = 1.;
  const Vector no_pressure(qp.size());
  while (result.iterations < options.maximum_iterations && !result.converged) {
    FullMatrix<double> Q = proximal_stiffness(qp, result.P), C = qp.C->dense(),
                       B_Q(qp.size(), balances.size());
    Q.add(1., balances.K);
    Q.gauss_jordan();
    balances.B.mmult(B_Q, Q);
    B_Q.mTmult(C, balances.B, true);
    // z = z_old + Q⁻¹(b - K z_old + Bᵀ P).
    Vector z(result.z);
    Q.vmult_add(z, qp.imbalance(no_pressure, z));
    Vector F(qp.size());
    balances.B.vmult(F, z);
    F.sadd(-1., 1., qp.F);
    const QPResult swept = sweep_until_settled(
      BoundConstrainedQP(std::make_shared<const DenseCompliance>(std::move(C)), F, qp.K), result.P,
      {std::max(0.1 * options.tolerance, std::min(1e-4, 1e-2 * result.kkt_residual)),
       options.maximum_iterations - result.iterations, options.relaxation});
    result.P = swept.P;
    result.iterations += std::max(1U, swept.iterations);
    B_Q.Tvmult_add(z, result.P);
    result.z = z;
    result.kkt_residual = qp.kkt_residual(result.P, result.z);
    // A body that slides far makes F large, which must not hide forces without balance.
    const double size = std::max(balances.b.l2_norm(), result.P.l2_norm());
    result.converged = result.kkt_residual <= options.tolerance &&
                       qp.imbalance(result.P, z).l2_norm() <= 10. * options.tolerance * size;
  }
  return result;
}
} // namespace

QPResult solve_by_psor(const BoundConstrainedQP &qp, const Vector &start,
                       const IterationOptions &options) {
  if (!(options.relaxation > 0. && options.relaxation < 2.))
    throw std::invalid_argument("Projected SOR converges for relaxations between 0 and 2 only.");
  return qp.balances.size() > 0 ? sweep_proximally(qp, start, options)
                                : sweep_until_settled(qp, start, options);
}
} // namespace Signorini
