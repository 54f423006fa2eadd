// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace Signorini
{
/** The numbers from lower to upper. Either may be infinite. */
struct Interval
{
  double lower = -std::numeric_limits<double>::infinity();
  double upper = 0.;
};

/**
 * The closed convex set K of multipliers among which the dual problem seeks P: a product of
 * intervals, one per unknown. Each patch has c unknowns, which stand one after the other. Contact
 * without friction has c = 1 and K = {P <= 0}. A tangential unknown with a friction bound s has the
 * interval from -s to s.
 *
 * P in K solves the dual problem if W = C P - F lies in the dual cone of K at P: W.(Q - P) >= 0 for
 * all Q in K. That is P = projection of P - W/c onto K for any c > 0, which residual() measures.
 */
class AdmissibleSet
{
public:
  using Vector = dealii::Vector<double>;

  /** The same c intervals for every patch. */
  AdmissibleSet(const unsigned int n_patches, const std::vector<Interval> &components)
  {
    for (unsigned int k = 0; k < n_patches; ++k)
      intervals_.insert(intervals_.end(), components.begin(), components.end());
  }
  /** One interval per unknown. */
  explicit AdmissibleSet(std::vector<Interval> intervals)
    : intervals_(std::move(intervals))
  {
  }
  /** {P <= 0} for n unknowns. */
  static AdmissibleSet nonpositive(const unsigned int n)
  {
    return AdmissibleSet(n, {Interval()});
  }

  unsigned int size() const
  {
    return intervals_.size();
  }
  const Interval &operator[](const unsigned int i) const
  {
    return intervals_[i];
  }
  /** The admissible number that is closest to p, for unknown i. */
  double project(const unsigned int i, const double p) const
  {
    return std::max(intervals_[i].lower, std::min(intervals_[i].upper, p));
  }
  void project(Vector &P) const
  {
    for (unsigned int i = 0; i < size(); ++i)
      P[i] = project(i, P[i]);
  }
  /** Whether p is no end of the interval, so that W_i must vanish: a pressing patch, a sticking
   * one. */
  bool is_inside(const unsigned int i, const double p) const
  {
    return intervals_[i].lower < p && p < intervals_[i].upper;
  }
  /** p - projection of p - step; for step = W_i/c_i it vanishes at the solution and nowhere else.
   */
  double residual(const unsigned int i, const double p, const double step) const
  {
    return p - project(i, p - step);
  }
  /** What of W_i would move p into K: all of it inside, the part that points inside at an end. */
  double inward(const unsigned int i, const double p, const double w) const
  {
    if (is_inside(i, p))
      return w;
    return p >= intervals_[i].upper ? std::max(w, 0.) : std::min(w, 0.);
  }
  /** The set for the unknowns with these numbers. */
  AdmissibleSet restrict_to(const std::vector<unsigned int> &numbers) const
  {
    std::vector<Interval> part;
    for (const unsigned int i : numbers)
      part.push_back(intervals_[i]);
    return AdmissibleSet(part);
  }

private:
  std::vector<Interval> intervals_;
};
} // namespace Signorini
