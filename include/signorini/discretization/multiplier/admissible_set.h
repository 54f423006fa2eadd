// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

#include <algorithm>
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
 * intervals, one per unknown. Each patch has c unknowns, which stand one after the other. Contact
 * without friction has c = 1 and K = {P ≤ 0}. A tangential unknown with a friction bound s has the
 * interval from -s to s.
 *
 * P in K solves the dual problem if W = C P - F lies in the dual cone of K at P: Wᵀ(Q - P) ≥ 0 for
 * all Q in K. That is P = projection of P - W/c onto K for any c > 0, which residual() measures.
 */
class AdmissibleSet {
public:
  using Vector = dealii::Vector<double>;

  /** Makes the set with the same c intervals for every patch. */
  AdmissibleSet(const unsigned int n_patches, const std::vector<Interval> &components) {
    for (unsigned int k = 0; k < n_patches; ++k)
      intervals_.insert(intervals_.end(), components.begin(), components.end());
  }
  /** Makes the set with one interval per unknown. */
  explicit AdmissibleSet(std::vector<Interval> intervals)
    : intervals_(std::move(intervals)) {}
  /** Returns {P ≤ 0} for n unknowns. */
  static AdmissibleSet nonpositive(const unsigned int n) {
    return AdmissibleSet(n, {Interval()});
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
};
} // namespace Signorini
