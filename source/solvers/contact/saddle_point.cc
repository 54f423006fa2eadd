// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of contact by V-cycles on (5): the residuals of U and P, the problem on the boundary,
// and MINRES on the saddle point problem of a set.

#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/saddle_point.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_minres.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "saddle_point_internal.h"

namespace Signorini {
double rounding_of(const StiffnessOperator &A) {
  NodalVector x = A.make_vector(), y(x);
  for (const auto i : x.locally_owned_elements())
    x(i) = std::sin(1. + 2.3 * i);
  A.vmult(y, x);
  return std::numeric_limits<double>::epsilon() * y.l2_norm() / x.l2_norm();
}

namespace {
double relative_or_absolute(const double value, const double scale) {
  return scale > 0. ? value / scale : value;
}

/**
 * Sets the stationarity.
 * @return the residual.
 */
NodalVector measure_forces(const ContactSystem &system, ContactIterationResult &result) {
  constexpr double min_term_share = 1e-3;
  NodalVector pressing = system.A.make_vector(), r(pressing);
  system.condensed_D.add_product(result.P, pressing);
  system.A.vmult(r, result.U);
  const double contact_size = pressing.l2_norm();
  const double largest = std::max({r.l2_norm(), contact_size, system.f.l2_norm()});
  // Where nothing touches, prescribed displacements may move the body as a whole: nothing else
  // shows how small its forces are.
  const double scale = std::max({contact_size, system.loads, min_term_share * largest});
  r *= -1.;
  r += system.f;
  r += pressing;
  result.stationarity = relative_or_absolute(r.l2_norm(), scale);
  result.rounding_of_stationarity =
    relative_or_absolute(result.rounding_of_A * result.U.l2_norm(), scale);
  return r;
}

/** Sets the KKT residual with C = t Ĉ_1 and F = C P - W, and |P.W|. */
void measure_contact(const ContactSystem &system, ContactIterationResult &result) {
  const dealii::Vector<double> W = system.opening(result.U);
  dealii::Vector<double> diagonal = system.model.diagonal(), C_P = system.model.apply(result.P);
  diagonal *= result.scale;
  C_P *= result.scale;
  dealii::Vector<double> F(C_P);
  F -= W;
  double terms = 0.;
  for (unsigned int k = 0; k < W.size(); ++k)
    terms += std::abs(result.P[k]) * (std::abs(system.gap[k]) + std::abs(W[k] + system.gap[k]));
  const double energy = result.P * C_P;
  result.kkt_residual =
    kkt_residual(AdmissibleSet::nonpositive(W.size()), result.P, W, F, diagonal);
  result.complementarity = relative_or_absolute(std::abs(result.P * W), energy);
  result.rounding_of_complementarity =
    relative_or_absolute(std::numeric_limits<double>::epsilon() * terms, energy);
}
} // namespace

NodalVector measure(const ContactSystem &system, const ContactIterationOptions &options,
                    ContactIterationResult &result) {
  constexpr double multiples_of_rounding = 10.;
  NodalVector r = measure_forces(system, result);
  measure_contact(system, result);
  const auto is_small = [](const double residual, const double allowed, const double rounding) {
    return residual <= std::max(allowed, multiples_of_rounding * rounding);
  };
  // Where nothing touches, the tolerance of contact does not apply.
  const bool touches =
    std::any_of(result.P.begin(), result.P.end(), [](const double P_k) { return P_k != 0.; });
  const double allowed = touches ? options.stationarity : std::min(options.stationarity, 1e-9);
  result.converged =
    result.kkt_residual <= options.tolerance &&
    is_small(result.stationarity, allowed, result.rounding_of_stationarity) &&
    is_small(result.complementarity, options.stationarity, result.rounding_of_complementarity);
  return r;
}

namespace {
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;

/** Returns d with (W + Ĉ d)_S = 0 and d = -P elsewhere. */
Vector change_on_set(const BoundaryModel &model, const Vector &W, const Vector &P,
                     const Indices &S) {
  Vector d(P), rhs(S.size());
  d *= -1.;
  for (const unsigned int i : S)
    d[i] = 0.;
  Vector V(W);
  if (d.l2_norm() > 0.)
    V += model.apply(d);
  for (unsigned int r = 0; r < S.size(); ++r)
    rhs[r] = -V[S[r]];
  const Vector d_S = model.solve(S, rhs);
  for (unsigned int r = 0; r < S.size(); ++r)
    d[S[r]] = d_S[r];
  return d;
}
} // namespace

Vector solve_boundary_problem(const BoundaryModel &model, const Vector &W, const Vector &P) {
  constexpr unsigned int max_steps = 30;
  std::vector<bool> active = next_set(std::vector<bool>(P.size(), true), P, W, true);
  for (unsigned int k = 0;; ++k) {
    const Vector d = change_on_set(model, W, P, indices_of(active));
    Vector Q(P), V = model.apply(d);
    Q += d;
    V += W;
    const std::vector<bool> next = next_set(active, Q, V);
    if (next == active || k == max_steps) {
      for (unsigned int i = 0; i < Q.size(); ++i)
        Q[i] = active[i] ? std::min(Q[i], 0.) : 0.;
      return Q;
    }
    active = next;
  }
}

namespace {
/** (U, P_S), where rank 0 has P_S. */
using BlockVector = LinearAlgebra::distributed::BlockVector<double>;

/** Returns P_S on every rank. */
Vector on_all_ranks(const NodalVector &block) {
  return Utilities::MPI::broadcast(block.get_mpi_communicator(),
                                   Vector(block.begin(), block.end()));
}

/** Sets P_S of rank 0. */
void set_on_first_rank(NodalVector &block, const Vector &values) {
  if (block.locally_owned_size() > 0)
    std::copy(values.begin(), values.end(), block.begin());
}

/** The matrix (A, -D_S; -D_Sᵀ, 0) and its preconditioner. */
class SaddlePoint {
public:
  SaddlePoint(const ContactSystem &system, Indices set, const double scale)
    : system_(system)
    , set_(std::move(set))
    , scale_(scale) {}

  BlockVector make_vector() const {
    BlockVector vector(2);
    vector.block(0) = system_.A.make_vector();
    const MPI_Comm communicator = vector.block(0).get_mpi_communicator();
    IndexSet rows(set_.size());
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      rows.add_range(0, set_.size());
    vector.block(1).reinit(rows, communicator);
    vector.collect_sizes();
    return vector;
  }

  void vmult(BlockVector &y, const BlockVector &x) const {
    system_.A.vmult(y.block(0), x.block(0));
    Vector minus_P = spread(on_all_ranks(x.block(1)));
    minus_P *= -1.;
    system_.condensed_D.add_product(minus_P, y.block(0));
    set_on_first_rank(y.block(1), restricted(system_.condensed_D.transpose_product(x.block(0))));
    y.block(1) *= -1.;
  }

  /** Returns the entries of the set. */
  Vector restricted(const Vector &values) const {
    Vector result(set_.size());
    for (unsigned int r = 0; r < set_.size(); ++r)
      result[r] = values[set_[r]];
    return result;
  }
  /** Returns a vector on all patches that is zero outside of the set. */
  Vector spread(const Vector &values) const {
    Vector result(system_.gap.size());
    for (unsigned int r = 0; r < set_.size(); ++r)
      result[set_[r]] = values[r];
    return result;
  }

  /** The preconditioner diag(V, (t Ĉ_1)_SS⁻¹). */
  struct Preconditioner {
    const SaddlePoint &matrix;
    unsigned int &cycles;

    void vmult(BlockVector &z, const BlockVector &r) const {
      matrix.system_.A.precondition(z.block(0), r.block(0));
      ++cycles;
      if (!matrix.set_.empty())
        set_on_first_rank(z.block(1),
                          matrix.system_.model.solve(matrix.set_, on_all_ranks(r.block(1))));
      z.block(1) /= matrix.scale_;
    }
  };

private:
  const ContactSystem &system_;
  Indices set_;
  double scale_;
};

/** Solves for the change of U and P on one set. */
void solve_on(const ContactSystem &system, const Indices &set, const double reduction,
              const unsigned int max_cycles, ContactIterationResult &result) {
  const SaddlePoint matrix(system, set, result.scale);
  // P vanishes outside of the set.
  result.P = matrix.spread(matrix.restricted(result.P));
  BlockVector rhs = matrix.make_vector(), x = matrix.make_vector();
  rhs.block(0) = system.residual(result.U, result.P);
  set_on_first_rank(rhs.block(1), matrix.restricted(system.opening(result.U)));
  ReductionControl control(max_cycles, 1e-300, reduction, false, false);
  SolverMinRes<BlockVector> minres(control);
  try {
    minres.solve(matrix, x, rhs, SaddlePoint::Preconditioner{matrix, result.cycles});
  } catch (const SolverControl::NoConvergence &) {
    // The residual is checked by the caller.
  }
  result.U += x.block(0);
  result.P += matrix.spread(on_all_ranks(x.block(1)));
}
} // namespace

void solve_by_minres(const ContactSystem &system, const ContactIterationOptions &options,
                     ContactIterationResult &result) {
  constexpr double reduction = 1e-3;
  std::vector<bool> active =
    next_set(std::vector<bool>(result.P.size(), true), result.P, system.opening(result.U), true);
  while (result.cycles < options.maximum_cycles) {
    solve_on(system, indices_of(active), reduction, options.maximum_cycles - result.cycles, result);
    // A set without a residual needs no cycle.
    ++result.cycles;
    active = next_set(active, result.P, system.opening(result.U));
    for (double &p : result.P)
      p = std::min(p, 0.);
    measure(system, options, result);
    if (result.converged)
      return;
  }
}
} // namespace Signorini
