// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Signorini {
/** The numbers from lower to upper. Either may be infinite. */
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = 0.;
};

/**
 * The closed convex set K of multipliers among which the dual problem seeks P: a product of
 * intervals, one per unknown. Contact without friction has K = {P ≤ 0}. With friction P is
 * (P_n, P_t), one of each per patch, and K(P) = {P_n ≤ 0, |P_t| ≤ s + f |P_n|}: for f = 0 (Tresca)
 * a product of intervals; else (Coulomb) the intervals of P_t move with P_n.
 *
 * P in K solves the dual problem if W = C P - F lies in the dual cone of K at P: Wᵀ(Q - P) ≥ 0 for
 * all Q in K. That is P = projection of P - W/c onto K for any c > 0, which residual() measures.
 */
class AdmissibleSet {
public:
  using Vector = dealii::Vector<double>;

  AdmissibleSet() = default;
  /** Makes the set with one interval per unknown. */
  explicit AdmissibleSet(std::vector<Interval> intervals)
    : intervals_(std::move(intervals)) {}
  /** Returns {P ≤ 0} for n unknowns. */
  static AdmissibleSet nonpositive(const unsigned int n) {
    return AdmissibleSet(std::vector<Interval>(n));
  }
  /** Returns the set of contact with friction for P_n = 0. @param s, f of every multiplier. Where a
   * polynomial that is close to one of them is negative, it is zero. */
  static AdmissibleSet with_friction(const Vector &s, const Vector &f) {
    AdmissibleSet K = nonpositive(s.size());
    for (const double bound : s)
      K.intervals_.push_back({-std::max(0., bound), std::max(0., bound)});
    if (!f.all_zero())
      for (const double coefficient : f)
        K.f_.push_back(std::max(0., coefficient));
    return K;
  }

  /** Returns whether the set moves with P. */
  bool moves() const {
    return !f_.empty();
  }
  /** Returns the set K(P), which does not move. @param P its first part P_n suffices. */
  AdmissibleSet at(const Vector &P) const {
    AdmissibleSet K(intervals_);
    for (unsigned int k = 0; k < f_.size(); ++k) {
      Interval &interval = K.intervals_[f_.size() + k];
      interval.upper += f_[k] * std::max(0., -P[k]);
      interval.lower = -interval.upper;
    }
    return K;
  }
  /** Returns f of the patch to which the unknown P_t,i belongs; 0 for others. */
  double coefficient(const unsigned int i) const {
    return i < f_.size() || f_.empty() ? 0. : f_[i - f_.size()];
  }

  unsigned int size() const {
    return intervals_.size();
  }
  const Interval &operator[](const unsigned int i) const {
    return intervals_[i];
  }
  /** Returns the admissible number that is closest to p, for unknown i. */
  double project(const unsigned int i, const double p) const {
    return std::max(intervals_[i].lower, std::min(intervals_[i].upper, p));
  }
  void project(Vector &P) const {
    for (unsigned int i = 0; i < size(); ++i)
      P[i] = project(i, P[i]);
  }
  /** Returns whether p lies inside of the interval, so that W_i must vanish: a pressing or a
   * sticking patch. */
  bool is_inside(const unsigned int i, const double p) const {
    return intervals_[i].lower < p && p < intervals_[i].upper;
  }
  /** Returns p - projection of p - step; for step = W_i/c_i it vanishes at the solution and nowhere
   * else. */
  double residual(const unsigned int i, const double p, const double step) const {
    return p - project(i, p - step);
  }
  /** Returns the part of W_i that moves p within K: all of it inside; at an end the part whose step
   * points inside. */
  double inward(const unsigned int i, const double p, const double w) const {
    if (is_inside(i, p))
      return w;
    return p >= intervals_[i].upper ? std::max(w, 0.) : std::min(w, 0.);
  }
  /** Returns Σ s_i |W_i| over the intervals from -s_i to s_i: the work of friction in the slip W.
   * With it Wᵀ P ≥ -Σ s_i |W_i| for all P in K where W_n ≤ 0, and equality means that P, W is a
   * solution. */
  double dissipation(const Vector &W) const {
    double work = 0.;
    for (unsigned int i = 0; i < size(); ++i)
      if (std::isfinite(intervals_[i].lower))
        work += intervals_[i].upper * std::abs(W[i]);
    return work;
  }
  /** Returns the set for the unknowns with these numbers. */
  AdmissibleSet restrict_to(const std::vector<unsigned int> &numbers) const {
    std::vector<Interval> part;
    part.reserve(numbers.size());
    for (const unsigned int i : numbers)
      part.push_back(intervals_[i]);
    return AdmissibleSet(part);
  }

private:
  std::vector<Interval> intervals_;
  /** Coulomb's coefficient of every patch; empty where no interval moves. */
  std::vector<double> f_;
};
} // namespace Signorini
