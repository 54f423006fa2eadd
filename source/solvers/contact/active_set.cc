// SPDX-License-Identifier: LGPL-2.1-or-later
// The active set method.

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
      const double here = (K.project(i, wanted[i]) - P[i]) / (wanted[i] - P[i]);
      if (leaving == P.size() || here < part) {
        part = here;
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

/** Returns random states. */
States any_states(const BoundConstrainedQP &qp, std::minstd_rand &random) {
  States states(qp.size());
  for (unsigned int i = 0; i < states.size(); ++i)
    states[i] = static_cast<State>(qp.K.coefficient(i) > 0. ? random() % 3 : 1 + random() % 2);
  return states;
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

// Discs.

namespace {
/** Performs a step of Newton's method, shorter where that decreases the residual and the whole step
 * does not. @throws LACExceptions::ExcSingular */
void newton_step(const BoundConstrainedQP &qp, Vector &P) {
  const Vector a = predict(qp, {}, {P, {}}),
               wanted = solve_on_set(qp, states_of(qp.K.at(a), a), a).P;
  const double before = qp.kkt_residual(P);
  const auto at = [&](const double part) {
    Vector there(P);
    there.sadd(1. - part, part, wanted);
    qp.K.at(there).project(there);
    return there;
  };
  const Vector whole = at(1.);
  constexpr double shortest = 1e-2;
  for (double part = 1.; part > shortest; part *= 0.5)
    if (const Vector there = at(part); qp.kkt_residual(there) < before) {
      P = there;
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
      // What is left is rounding.
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

/** Returns how many systems are tried: with bounds that move states are random after some of them,
 * and further ones of many unknowns would take long. */
unsigned int affordable_solves(const BoundConstrainedQP &qp) {
  constexpr double least = 50., most_products = 5e10, unlimited = 1e9;
  const double products = std::pow(qp.size() + 1., 3);
  return static_cast<unsigned int>(
    qp.K.moves() ? std::min(unlimited, least + most_products / products) : unlimited);
}
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp, const Vector &start,
                             const IterationOptions &options) {
  if (qp.K.n_discs() > 0)
    return solve_with_discs(qp, start, options);
  const bool moves = qp.balances.size() > 0;
  QPResult result;
  Iterate x;
  States states =
    start.size() == 0 ? States(qp.size(), State::inside) : states_of(qp.K.at(start), start);
  std::set<States> visited;
  std::minstd_rand random;
  bool has_path = false;
  std::optional<BoundConstrainedQP> held;
  // Newton's method takes some 10 systems; far from a solution it may not come back for thousands.
  constexpr unsigned int max_wandering = 20;
  // Where P and W vanish together, rounding changes the set each time, although P is the solution.
  const auto residual_of = [&qp](const Iterate &of) {
    Vector projected = of.P;
    qp.K.at(projected).project(projected);
    return qp.kkt_residual(projected, of.z, qp.gradient(projected, of.z), false);
  };
  const unsigned int max_solves =
    std::min({options.maximum_iterations, 20 * qp.size() + 100, affordable_solves(qp)});
  for (bool settled = false; !settled && result.iterations < max_solves;) {
    ++result.iterations;
    // Where a set comes back although the energy falls, it leaves bodies free.
    if (result.cycled && moves && !held && !visited.insert(states).second)
      held = held_by_springs(qp, x.z);
    Iterate wanted = solve_on_set(held ? *held : qp, states);
    const double residual = residual_of(wanted);
    if (!result.cycled) {
      x = wanted;
      visited.insert(states);
      const States next = improve(qp, states, x);
      const bool came_back = visited.count(next) > 0;
      settled = residual <= qp.rounding() ||
                (next == states && (!moves || residual <= options.tolerance)) ||
                (came_back && residual <= 1e-3 * options.tolerance);
      result.cycled = came_back && !settled;
      states = next;
      const bool wanders = !settled && !has_path && result.iterations > max_wandering;
      if ((result.cycled || wanders) && qp.K.moves()) {
        // No energy falls there. A path leads to the solution; if rounding spoils it, random states
        // are tried.
        const auto end = has_path ? std::nullopt : follow_solutions(qp);
        has_path = true;
        states = end ? *end : any_states(qp, random);
        result.cycled = false;
      } else if (result.cycled) {
        if (moves)
          x.P = qp.balances.P;
        visited.clear();
        qp.K.project(x.P);
        states = states_of(qp.K, x.P);
      }
    } else {
      settled = residual <= std::max(qp.rounding(), 1e-3 * options.tolerance);
      if (settled || step_to_first_end(qp, wanted.P, x.P, states)) {
        x = wanted;
        const bool ends = settled || !join_deepest(held ? *held : qp, x, states);
        settled = ends;
        if (ends && held) {
          // Without springs; else they are fixed where the bodies are now.
          wanted = solve_on_set(qp, states);
          settled = residual_of(wanted) <= options.tolerance;
          if (settled)
            x = wanted;
          else
            held = held_by_springs(qp, x.z);
        }
      }
    }
  }
  qp.K.at(x.P).project(x.P);
  result.P = x.P;
  result.z = x.z;
  result.kkt_residual = qp.kkt_residual(result.P, result.z);
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
}
} // namespace Signorini
