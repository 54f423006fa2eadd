// SPDX-License-Identifier: LGPL-2.1-or-later
// The active set method, in intervals and in discs.

#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/** Returns the problem of bodies that weak springs hold at the motions z: it determines where a
 * body goes that no patch of a set holds. */
BoundConstrainedQP held_by_springs(const BoundConstrainedQP &qp, const Vector &z) {
  BoundConstrainedQP held(qp);
  const double spring = weak_spring(qp);
  held.balances.K.diagadd(spring);
  held.balances.b.add(spring, z);
  return held;
}

/** Searches the states. Each attempt goes on from the states and the P at which the one before has
 * ended. */
class ActiveSetSearch {
public:
  ActiveSetSearch(const BoundConstrainedQP &qp, const Vector &start,
                  const IterationOptions &options)
    : qp_(qp)
    , options_(options)
    , turns_(qp.K.n_discs() > 0)
    , moves_(qp.balances.size() > 0)
    , most_systems_(std::min(options.maximum_iterations, 20 * qp.size() + 100))
    , states_(start.size() == 0 ? States(qp.size(), State::inside)
                                : states_of(qp.K.at(start), start)) {
    x_.P = start.size() > 0 ? start : Vector(qp.size());
  }

  QPResult run() {
    // Newton's method takes some 10 systems; far from a solution it may not come back for
    // thousands.
    constexpr unsigned int most_before_path = 21;
    if (turns_)
      sweep_and_turn();
    else
      take_newton_steps(qp_.K.moves() ? std::min(most_before_path, most_systems_) : most_systems_);
    if (may_go_on() && qp_.K.moves())
      follow_path();
    else if (may_go_on())
      lower_energy();
    qp_.K.at(x_.P).project(x_.P);
    result_.P = x_.P;
    result_.z = x_.z;
    result_.kkt_residual = qp_.kkt_residual(result_.P, result_.z);
    result_.converged = result_.kkt_residual <= options_.tolerance;
    return result_;
  }

private:
  bool may_go_on() const {
    return !settled_ && !turns_ && result_.iterations < most_systems_;
  }
  /** Returns the problem whose sets are solved. */
  const BoundConstrainedQP &problem() const {
    return held_ ? *held_ : qp_;
  }
  /** Where P and W vanish together, rounding changes the set each time, although P is the solution.
   */
  double residual_of(const Iterate &of) const {
    Vector projected = of.P;
    qp_.K.at(projected).project(projected);
    return qp_.kkt_residual(projected, of.z);
  }

  /** Sets the states that x predicts. @param solved see predict(). */
  void predict_states(const States &solved) {
    a_ = predict(qp_, solved, x_);
    states_ = states_of(qp_.K.at(a_), a_);
    if (x_.stopping)
      states_[*x_.stopping] = State::inside;
  }

  /** Returns the P of a step to the wanted one, shorter where that decreases the residual and the
   * whole step does not. */
  Vector shortened(const Vector &wanted) const {
    constexpr double shortest = 1e-2;
    const auto at = [&](const double part) {
      Vector P(x_.P);
      P.sadd(1. - part, part, wanted);
      qp_.K.at(P).project(P);
      return P;
    };
    const double before = qp_.kkt_residual(x_.P);
    for (double part = 1.; part > shortest; part *= 0.5)
      if (const Vector P = at(part); qp_.kkt_residual(P) < before)
        return P;
    return at(1.);
  }

  /** Remembers P where its residual is clearly smaller than all before. @return whether it is. */
  bool remember(const double residual) {
    const bool falls = residual < 0.9 * smallest_;
    if (falls) {
      smallest_ = residual;
      best_ = x_.P;
    }
    return falls;
  }

  /** Takes steps of Newton's method until they settle, or go around: until a set comes back, or
   * with discs, where slip turns in each step, until the residual does not fall in four steps. */
  void take_newton_steps(const unsigned int most_systems) {
    constexpr unsigned int patience = 4;
    unsigned int idle = 0;
    bool goes_around = false;
    while (!settled_ && !goes_around && result_.iterations < most_systems) {
      ++result_.iterations;
      const States solved = states_;
      const Iterate wanted = solve_on_set(qp_, solved, a_);
      x_ = turns_ ? Iterate{shortened(wanted.P), {}} : wanted;
      const double residual = residual_of(x_);
      const bool falls = remember(residual);
      idle = falls ? 0 : idle + 1;
      visited_.insert(solved);
      predict_states(turns_ ? States() : solved);
      goes_around = turns_ ? idle == patience : visited_.count(states_) > 0;
      const bool stays = turns_ ? !falls : states_ == solved;
      const bool is_exact = !turns_ && !moves_;
      settled_ = residual <= qp_.rounding() ||
                 (stays && (is_exact || residual <= options_.tolerance)) ||
                 (goes_around && residual <= 1e-3 * options_.tolerance);
    }
  }

  /** With discs: sweeps of projected SOR, more each time, then Newton's method; with Coulomb's law
   * it may also begin at a random P (a fixed sequence of numbers). */
  void sweep_and_turn() {
    std::minstd_rand random;
    std::uniform_real_distribution<double> share(-1., 1.);
    for (unsigned int n_sweeps = 10, all = 0;
         smallest_ > options_.tolerance && all < options_.maximum_iterations;
         n_sweeps += 10, all += n_sweeps) {
      const double size = best_.size() > 0 ? best_.linfty_norm() : 0.;
      if (all > 0)
        x_.P = best_;
      if (all > 0 && qp_.K.moves() && random() % 2 == 0)
        for (double &p : x_.P)
          p = size * share(random);
      else
        for (unsigned int i = 0; i < n_sweeps; ++i)
          psor_sweep(qp_, 1., x_.P);
      qp_.K.at(x_.P).project(x_.P);
      remember(residual_of(x_));
      settled_ = smallest_ <= qp_.rounding();
      predict_states({});
      try {
        take_newton_steps(most_systems_);
      } catch (const LACExceptions::ExcSingular &) {
        // The states after more sweeps are others.
      }
    }
    x_.P = best_;
  }

  /** No energy falls where bounds move. A path leads to the solution, unless rounding spoils it. */
  void follow_path() {
    const auto end = follow_solutions(qp_);
    result_.by_path = true;
    if (!end)
      return;
    states_ = *end;
    take_newton_steps(most_systems_);
  }

  /** Searches by a primal method, whose energy falls in every step. */
  void lower_energy() {
    result_.cycled = true;
    if (moves_)
      x_.P = qp_.balances.P;
    visited_.clear();
    qp_.K.project(x_.P);
    states_ = states_of(qp_.K, x_.P);
    while (may_go_on()) {
      ++result_.iterations;
      // Where a set comes back although the energy falls, it leaves bodies free.
      if (moves_ && !held_ && !visited_.insert(states_).second)
        held_ = held_by_springs(qp_, x_.z);
      step_down(solve_on_set(problem(), states_));
    }
  }

  void step_down(const Iterate &wanted) {
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
  /** Whether slip may turn, and whether bodies may move freely. */
  const bool turns_, moves_;
  const unsigned int most_systems_;
  QPResult result_;
  Iterate x_;
  States states_;
  /** The point P - W/diag C that has the states, with discs. */
  Vector a_;
  std::set<States> visited_;
  /** The smallest residual so far, and its P. */
  double smallest_ = std::numeric_limits<double>::infinity();
  Vector best_;
  bool settled_ = false;
  /** The problem with springs, where they are needed. */
  std::optional<BoundConstrainedQP> held_;
};
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp, const Vector &start,
                             const IterationOptions &options) {
  return ActiveSetSearch(qp, start, options).run();
}
} // namespace Signorini
