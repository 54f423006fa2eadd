// SPDX-License-Identifier: LGPL-2.1-or-later
// The active set method, in intervals and in discs.

#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** Returns P - W/diag C. @param solved the states for which x is the solution, so that W vanishes
 * on active unknowns; may be empty. */
Vector predict(const BoundConstrainedQP &qp, const States &solved, const Iterate &x) {
  const Vector W = qp.gradient(x.P, x.z);
  Vector a(x.P);
  for (unsigned int i = 0; i < qp.size(); ++i)
    if (solved.empty() || solved[i] != State::inside)
      a[i] -= W[i] / qp.diagonal[i];
  return a;
}

/** Returns the states that the solution x for @p states predicts. */
States improve(const BoundConstrainedQP &qp, const States &states, const Iterate &x) {
  const Vector a = predict(qp, states, x);
  States next = states_of(qp.K.at(a), a);
  if (x.stopping)
    next[*x.stopping] = State::inside;
  return next;
}

/** Moves P towards the wanted one; where an unknown would leave its interval, only to the first end
 * that is met, which that unknown keeps. @return whether P is the wanted one. */
bool step_to_first_end(const BoundConstrainedQP &qp, const Vector &wanted, Vector &P,
                       States &states) {
  const AdmissibleSet &K = qp.K;
  double size = 0.;
  for (const double b : qp.balances.b)
    size = std::max(size, std::abs(b));
  for (unsigned int i = 0; i < P.size(); ++i)
    if (states[i] == State::inside)
      size = std::max({size, std::abs(wanted[i]), std::abs(qp.F[i]) / qp.diagonal[i]});
  const double rounding = 1e-13 * size;
  double part = 1.;
  unsigned int leaving = P.size();
  for (unsigned int i = 0; i < P.size(); ++i)
    if (states[i] == State::inside && std::abs(wanted[i] - K.project(i, wanted[i])) > rounding) {
      const double share = (K.project(i, wanted[i]) - P[i]) / (wanted[i] - P[i]);
      if (leaving == P.size() || share < part) {
        part = share;
        leaving = i;
      }
    }
  P.sadd(1. - part, part, wanted);
  K.project(P);
  if (leaving == P.size())
    return true;
  P[leaving] = K.project(leaving, wanted[leaving]);
  states[leaving] = P[leaving] >= K[leaving].upper ? State::upper : State::lower;
  return false;
}

/** Lets the unknown join whose residual is largest. @return whether there is one above rounding. */
bool join_deepest(const BoundConstrainedQP &qp, const Iterate &x, States &states) {
  const Vector W = qp.gradient(x.P, x.z);
  double largest = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i)
    largest = std::max({largest, std::abs(qp.F[i]), std::abs(qp.F[i] + W[i])});
  double deepest = 0.;
  unsigned int joining = qp.size();
  for (unsigned int i = 0; i < qp.size(); ++i) {
    const double inward = std::abs(qp.K.inward(i, x.P[i], W[i]));
    if (states[i] != State::inside && inward > 1e-13 * largest &&
        inward > deepest * qp.diagonal[i]) {
      deepest = inward / qp.diagonal[i];
      joining = i;
    }
  }
  if (joining < qp.size())
    states[joining] = State::inside;
  return joining < qp.size();
}
} // namespace

namespace {
/** Performs a step of Newton's method, shorter where that decreases the residual and the whole step
 * does not. @throws LACExceptions::ExcSingular */
void newton_step(const BoundConstrainedQP &qp, Vector &P) {
  const Vector a = predict(qp, {}, {P, {}}),
               wanted = solve_on_set(qp, states_of(qp.K.at(a), a), a).P;
  const double before = qp.kkt_residual(P);
  const auto at = [&](const double part) {
    Vector moved(P);
    moved.sadd(1. - part, part, wanted);
    qp.K.at(moved).project(moved);
    return moved;
  };
  const Vector whole = at(1.);
  constexpr double shortest = 1e-2;
  for (double part = 1.; part > shortest; part *= 0.5)
    if (const Vector moved = at(part); qp.kkt_residual(moved) < before) {
      P = moved;
      return;
    }
  P = whole;
}

/** Performs sweeps of projected SOR. */
void sweep(const BoundConstrainedQP &qp, const unsigned int n_sweeps, Vector &P) {
  for (unsigned int i = 0; i < n_sweeps; ++i)
    psor_sweep(qp, 1., P);
  qp.K.at(P).project(P);
}

/** Returns a random P. */
Vector random_start(const BoundConstrainedQP &qp, const double size, std::minstd_rand &random) {
  Vector P(qp.size());
  std::uniform_real_distribution<double> share(-1., 1.);
  for (double &p : P)
    p = size * share(random);
  qp.K.at(P).project(P);
  return P;
}

/** Solves a problem with discs. */
QPResult solve_with_discs(const BoundConstrainedQP &qp, const Vector &start,
                          const IterationOptions &options) {
  constexpr unsigned int patience = 4;
  QPResult result;
  std::minstd_rand random;
  unsigned int n_sweeps = 10, all_sweeps = 0, idle = 0;
  Vector P = start.size() > 0 ? start : Vector(qp.size());
  sweep(qp, n_sweeps, P);
  result.P = P;
  result.kkt_residual = qp.kkt_residual(P);
  while (result.kkt_residual > qp.rounding() && all_sweeps < options.maximum_iterations) {
    if (idle < patience)
      try {
        ++idle;
        ++result.iterations;
        newton_step(qp, P);
      } catch (const LACExceptions::ExcSingular &) {
        idle = patience;
      }
    else {
      idle = 0;
      n_sweeps += 10;
      all_sweeps += n_sweeps;
      if (qp.K.moves() && random() % 2 == 0)
        P = random_start(qp, result.P.linfty_norm(), random);
      else
        sweep(qp, n_sweeps, P = result.P);
    }
    if (const double residual = qp.kkt_residual(P); residual < 0.9 * result.kkt_residual) {
      result.P = P;
      result.kkt_residual = residual;
      idle = 0;
    } else if (result.kkt_residual <= options.tolerance)
      // The rest is rounding.
      break;
  }
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
}

/** Returns the problem of bodies that weak springs hold at the motions z: it determines where a
 * body goes that no patch of a set holds. */
BoundConstrainedQP held_by_springs(const BoundConstrainedQP &qp, const Vector &z) {
  BoundConstrainedQP held(qp);
  const double spring = weak_spring(qp);
  held.balances.K.diagadd(spring);
  held.balances.b.add(spring, z);
  return held;
}

/** Searches the set by Newton's method, and where a set comes back by a primal method, whose energy
 * falls in every step. */
class ActiveSetSearch {
public:
  ActiveSetSearch(const BoundConstrainedQP &qp, const Vector &start,
                  const IterationOptions &options)
    : qp_(qp)
    , options_(options)
    , moves_(qp.balances.size() > 0)
    , states_(start.size() == 0 ? States(qp.size(), State::inside)
                                : states_of(qp.K.at(start), start)) {}

  QPResult run() {
    const unsigned int max_solves = std::min(options_.maximum_iterations, 20 * qp_.size() + 100);
    while (!settled_ && !gives_up_ && result_.iterations < max_solves) {
      ++result_.iterations;
      // Where a set comes back although the energy falls, it leaves bodies free.
      if (result_.cycled && moves_ && !held_ && !visited_.insert(states_).second)
        held_ = held_by_springs(qp_, x_.z);
      const Iterate wanted = solve_on_set(problem(), states_);
      if (result_.cycled)
        lower_energy(wanted);
      else
        take_newton_step(wanted);
    }
    qp_.K.at(x_.P).project(x_.P);
    result_.P = x_.P;
    result_.z = x_.z;
    result_.kkt_residual = qp_.kkt_residual(result_.P, result_.z);
    result_.converged = result_.kkt_residual <= options_.tolerance;
    return result_;
  }

private:
  /** Returns the problem whose sets are solved. */
  const BoundConstrainedQP &problem() const {
    return held_ ? *held_ : qp_;
  }
  /** Where P and W vanish together, rounding changes the set each time, although P is the solution.
   */
  double residual_of(const Iterate &of) const {
    Vector projected = of.P;
    qp_.K.at(projected).project(projected);
    return qp_.kkt_residual(projected, of.z, qp_.gradient(projected, of.z), false);
  }

  void take_newton_step(const Iterate &wanted) {
    // Newton's method takes some 10 systems; far from a solution it may not come back for
    // thousands.
    constexpr unsigned int max_wandering = 20;
    const double residual = residual_of(wanted);
    x_ = wanted;
    visited_.insert(states_);
    const States next = improve(qp_, states_, x_);
    const bool came_back = visited_.count(next) > 0;
    settled_ = residual <= qp_.rounding() ||
               (next == states_ && (!moves_ || residual <= options_.tolerance)) ||
               (came_back && residual <= 1e-3 * options_.tolerance);
    result_.cycled = came_back && !settled_;
    states_ = next;
    const bool wanders = !settled_ && !result_.by_path && result_.iterations > max_wandering;
    if ((result_.cycled || wanders) && qp_.K.moves())
      follow_path();
    else if (result_.cycled)
      begin_primal_method();
  }

  /** No energy falls where bounds move. A path leads to the solution, unless rounding spoils it. */
  void follow_path() {
    const auto end = result_.by_path ? std::nullopt : follow_solutions(qp_);
    result_.by_path = true;
    gives_up_ = !end;
    if (end)
      states_ = *end;
    result_.cycled = false;
  }

  void begin_primal_method() {
    if (moves_)
      x_.P = qp_.balances.P;
    visited_.clear();
    qp_.K.project(x_.P);
    states_ = states_of(qp_.K, x_.P);
  }

  void lower_energy(const Iterate &wanted) {
    settled_ = residual_of(wanted) <= std::max(qp_.rounding(), 1e-3 * options_.tolerance);
    if (!settled_ && !step_to_first_end(qp_, wanted.P, x_.P, states_))
      return;
    x_ = wanted;
    const bool ends = settled_ || !join_deepest(problem(), x_, states_);
    settled_ = ends;
    if (ends && held_)
      release();
  }

  /** Solves without springs; if these matter, they are fixed where the bodies are now. */
  void release() {
    const Iterate free = solve_on_set(qp_, states_);
    settled_ = residual_of(free) <= options_.tolerance;
    if (settled_)
      x_ = free;
    else
      held_ = held_by_springs(qp_, x_.z);
  }

  const BoundConstrainedQP &qp_;
  const IterationOptions &options_;
  /** Whether bodies may move freely. */
  const bool moves_;
  QPResult result_;
  Iterate x_;
  States states_;
  std::set<States> visited_;
  bool settled_ = false, gives_up_ = false;
  /** The problem with springs, where they are needed. */
  std::optional<BoundConstrainedQP> held_;
};
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp, const Vector &start,
                             const IterationOptions &options) {
  if (qp.K.n_discs() > 0)
    return solve_with_discs(qp, start, options);
  return ActiveSetSearch(qp, start, options).run();
}
} // namespace Signorini
