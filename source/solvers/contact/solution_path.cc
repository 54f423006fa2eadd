// SPDX-License-Identifier: LGPL-2.1-or-later
// The path of solutions from an open gap to contact with Coulomb's friction.

#include <signorini/solvers/contact/active_set.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** The path, with the inverse of the linear system of the states: column j belongs to P_j inside of
 * its interval, else to W_j; the last ones to the motions. */
class SolutionPath {
public:
  explicit SolutionPath(const BoundConstrainedQP &qp)
    : qp_(qp)
    , C_(qp.C->dense())
    , n_patches_(qp.size() / 2)
    , states_(states_of(qp.K, Vector(qp.size())))
    , inverse_(qp.size() + qp.balances.size()) {
    F_ = {qp.F, Vector(qp.size())};
    b_ = {qp.balances.b, Vector(qp.balances.size())};
    // Gaps of different sizes, so that no two patches close at once.
    for (unsigned int i = 0; i < n_patches_; ++i)
      F_[1][i] = qp.F.linfty_norm() * std::sqrt(qp.diagonal[i] / qp.diagonal.linfty_norm()) *
                 (1. + 0.5 * std::sin(1. + i * i));
    spring_ = weak_spring(qp);
  }

  std::optional<States> follow() {
    // Most paths take one to ten steps for each unknown, and τ has a new minimum every few steps,
    // with very large coefficients at least after a tenth of n. Others go around in rounding.
    constexpr unsigned int n_updates = 64, most_per_unknown = 10, patience = 100;
    constexpr double rounding = 1e-8;
    double direction = -1., smallest = 1.;
    std::optional<Change> back;
    for (unsigned int step = 0, last = 0;
         step < most_per_unknown * qp_.size() && step < last + qp_.size() + patience; ++step) {
      if (step == 0 || (step % n_updates == 0 && inaccuracy() > rounding))
        invert();
      if (step % n_updates == 0 || moves_sides_)
        y_ = {solution(0), solution(1)};
      if (back)
        direction = rate(*back) < 0. ? -1. : 1.;
      double length = direction < 0. ? tau_ : std::numeric_limits<double>::max();
      std::optional<Change> change;
      for (const Change &next : possible_changes())
        if (const double fall = -direction * rate(next); fall > 0.)
          if (const double zero = std::max(0., margin(next)) / fall; zero < length) {
            length = zero;
            change = next;
          }
      if (!change)
        return direction < 0. ? std::optional<States>(states_) : std::nullopt;
      tau_ += direction * length;
      if (tau_ < smallest) {
        smallest = tau_;
        last = step;
      }
      back = Change{change->unknown, states_[change->unknown]};
      moves_sides_ = qp_.K[change->unknown].upper > 0.;
      make(*change);
    }
    return {};
  }

private:
  /** An unknown that takes another state. */
  struct Change {
    unsigned int unknown;
    State to;
  };

  bool is_inside(const unsigned int i) const {
    return states_[i] == State::inside;
  }
  /** Returns the sign of the end of the interval at which an unknown is. */
  double sign(const unsigned int i) const {
    return states_[i] == State::upper ? 1. : -1.;
  }
  /** Adds a multiple of the column of P_j. */
  void add_column(const unsigned int j, const double factor, Vector &to) const {
    for (unsigned int i = 0; i < qp_.size(); ++i)
      to[i] += factor * C_(i, j);
    for (unsigned int k = 0; k < qp_.balances.size(); ++k)
      to[qp_.size() + k] -= factor * qp_.balances.B(j, k);
  }
  Vector column(const unsigned int j) const {
    const unsigned int n = qp_.size();
    Vector a(inverse_.m());
    if (j >= n) {
      for (unsigned int i = 0; i < n; ++i)
        a[i] = qp_.balances.B(i, j - n);
      for (unsigned int k = n; k < a.size(); ++k)
        a[k] = qp_.balances.K(k - n, j - n) + (k == j ? spring_ : 0.);
    } else if (!is_inside(j)) {
      a[j] = -1.;
    } else {
      add_column(j, 1., a);
      if (const unsigned int t = j + n_patches_; j < n_patches_ && !is_inside(t))
        add_column(t, -sign(t) * qp_.K.coefficient(t), a);
    }
    return a;
  }
  /** Solves for all unit vectors at once, which takes a fraction of the time of Gauss-Jordan's
   * method. */
  void invert() {
    LAPACKFullMatrix<double> basis(inverse_.m()), inverse(inverse_.m());
    for (unsigned int j = 0; j < inverse_.n(); ++j) {
      const Vector a = column(j);
      for (unsigned int i = 0; i < a.size(); ++i)
        basis(i, j) = a[i];
      inverse(j, j) = 1.;
    }
    basis.compute_lu_factorization();
    basis.solve(inverse);
    inverse_ = inverse;
  }
  /** Updates the inverse, and with it the unknowns, after a change of column j. */
  void update(const unsigned int j) {
    Vector d(inverse_.m());
    inverse_.vmult(d, column(j));
    for (unsigned int k = 0; k < d.size(); ++k)
      inverse_(j, k) /= d[j];
    for (unsigned int i = 0; i < d.size(); ++i)
      if (i != j)
        inverse_.add_row(i, -d[i], j);
    for (Vector &y : y_) {
      const double y_j = y[j] / d[j];
      y.add(-y_j, d);
      y[j] = y_j;
    }
  }
  /** Returns the largest error of I v, for the v whose components are one. */
  double inaccuracy() const {
    Vector sum(inverse_.m()), v(inverse_.m());
    for (unsigned int j = 0; j < v.size(); ++j)
      sum += column(j);
    inverse_.vmult(v, sum);
    v.add(-1.);
    return v.linfty_norm();
  }
  /** Returns the unknowns of the states for τ = 0 or 1. */
  Vector solution(const unsigned int end) const {
    Vector side(inverse_.m()), y(inverse_.m());
    for (unsigned int i = 0; i < side.size(); ++i)
      side[i] = i < qp_.size() ? F_[end][i] : b_[end][i - qp_.size()];
    for (unsigned int i = 0; i < qp_.size(); ++i)
      if (!is_inside(i) && qp_.K[i].upper > 0.)
        add_column(i, -sign(i) * qp_.K[i].upper, side);
    inverse_.vmult(y, side);
    return y;
  }
  std::vector<Change> possible_changes() const {
    std::vector<Change> changes;
    for (unsigned int i = 0; i < qp_.size(); ++i)
      if (is_inside(i)) {
        changes.push_back({i, State::upper});
        if (!std::isinf(qp_.K[i].lower))
          changes.push_back({i, State::lower});
      } else if (!is_idle(i)) {
        changes.push_back({i, State::inside});
      }
    return changes;
  }
  /** Returns whether P_t,i of an open patch has no room: then its state means nothing. */
  bool is_idle(const unsigned int i) const {
    return i >= n_patches_ && qp_.K[i].upper == 0. && !is_inside(i - n_patches_);
  }
  /** Returns the number at one end of τ that is positive as long as a change is not due. */
  double margin(const Change &change, const unsigned int end) const {
    const unsigned int i = change.unknown;
    const Vector &y = y_[end];
    if (!is_inside(i))
      return -sign(i) * y[i];
    const bool follows = i >= n_patches_ && is_inside(i - n_patches_);
    const double bound = qp_.K[i].upper - (follows ? qp_.K.coefficient(i) * y[i - n_patches_] : 0.);
    return change.to == State::upper ? bound - y[i] : bound + y[i];
  }
  double rate(const Change &change) const {
    return margin(change, 1) - margin(change, 0);
  }
  double margin(const Change &change) const {
    return margin(change, 0) + tau_ * rate(change);
  }
  /** Makes a change. A patch without s that closes begins to slip. */
  void make(const Change &change) {
    const unsigned int i = change.unknown, t = i + n_patches_;
    if (i < n_patches_ && qp_.K[t].upper == 0.)
      states_[t] =
        is_inside(i) || y_[0][t] + tau_ * (y_[1][t] - y_[0][t]) <= 0. ? State::upper : State::lower;
    states_[i] = change.to;
    update(i);
    if (i >= n_patches_ && is_inside(i - n_patches_))
      update(i - n_patches_);
  }

  const BoundConstrainedQP &qp_;
  const FullMatrix<double> &C_;
  unsigned int n_patches_;
  States states_;
  FullMatrix<double> inverse_;
  /** The stiffness of weak springs, which hold a free body where no patch does. */
  double spring_ = 0.;
  double tau_ = 1.;
  /** Whether the last change moved the right side, by an end that is not zero. */
  bool moves_sides_ = false;
  /** The data and the unknowns for τ = 0 and 1. */
  std::array<Vector, 2> F_, b_, y_;
};
} // namespace

double weak_spring(const BoundConstrainedQP &qp) {
  constexpr double weak = 1e-6;
  double stiffness = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i)
    for (unsigned int j = 0; j < qp.balances.size(); ++j)
      stiffness += weak * std::pow(qp.balances.B(i, j), 2) / qp.diagonal[i];
  return stiffness;
}

std::optional<States> follow_solutions(const BoundConstrainedQP &qp) {
  try {
    return SolutionPath(qp).follow();
  } catch (const LACExceptions::ExcSingular &) {
    return {};
  }
}
} // namespace Signorini
