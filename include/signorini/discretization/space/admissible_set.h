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

/** How a multiplier lies in its interval or disc: at an end, where it is open or slips, or inside,
 * where it presses or sticks. A patch with nodes in several states is mixed. */
enum class State : char { lower, inside, upper, mixed };

/**
 * The closed convex set K of multipliers among which the dual problem seeks P: a product over
 * blocks of unknowns. Contact without friction has K = {P ≤ 0}. With friction P is (P_n, P_t), one
 * of each per patch, and K(P) = {P_n ≤ 0, |P_t| ≤ s + f |P_n|}: for f = 0 (Tresca) it stays where
 * it is; else (Coulomb) the bounds of P_t move with P_n.
 *
 * A block is one unknown in an interval. In space P_t = (P_t1, P_t2) has two components: there the
 * block of a P_t is a pair of unknowns, in the disc whose diameter is the interval.
 *
 * P in K solves the dual problem if W = C P - F lies in the dual cone of K at P: Wᵀ(Q - P) ≥ 0 for
 * all Q in K. That is P = projection of P - W/c onto K for any c > 0, which residual() measures.
 */
class AdmissibleSet {
public:
  using Vector = dealii::Vector<double>;

  AdmissibleSet() = default;
  /** Makes the set with one interval per unknown; all blocks are of size one. */
  explicit AdmissibleSet(std::vector<Interval> intervals)
    : intervals_(std::move(intervals))
    , n_normal_(intervals_.size()) {}
  /** Returns {P ≤ 0} for n unknowns. */
  static AdmissibleSet nonpositive(const unsigned int n) {
    return AdmissibleSet(std::vector<Interval>(n));
  }
  /** Returns the set of contact with friction for P_n = 0. @param s, f of every multiplier. Where a
   * polynomial that is close to one of them is negative, it is zero. @param n_tangents the number
   * of components of P_t, one or two. */
  static AdmissibleSet with_tangential_part(const Vector &s, const Vector &f,
                                            const unsigned int n_tangents = 1) {
    AdmissibleSet K = nonpositive(s.size());
    for (const double bound : s)
      K.intervals_.push_back({-std::max(0., bound), std::max(0., bound)});
    K.n_discs_ = n_tangents == 1 ? 0 : s.size();
    if (!f.all_zero())
      for (const double coefficient : f)
        K.f_.push_back(std::max(0., coefficient));
    return K;
  }

  /** Returns the number of P_n, the first unknowns. */
  unsigned int n_normal() const {
    return n_normal_;
  }
  bool has_tangential_part() const {
    return n_normal_ < n_blocks();
  }
  /** Returns whether this is {P ≤ 0}. */
  bool is_nonpositive() const {
    return std::all_of(intervals_.begin(), intervals_.end(),
                       [](const Interval &i) { return std::isinf(i.lower) && i.upper == 0.; });
  }
  /** Returns whether the set moves with P. */
  bool moves() const {
    return !f_.empty();
  }
  /** Returns the set K(P), which does not move. @param P its first part P_n suffices. */
  AdmissibleSet at(const Vector &P) const {
    AdmissibleSet K(*this);
    K.f_.clear();
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
    return intervals_.size() + n_discs_;
  }
  /** Returns the number of blocks. The first unknown of block i is i. */
  unsigned int n_blocks() const {
    return intervals_.size();
  }
  /** Returns the number of the last blocks, which are pairs: block i has the unknowns i and
   * i + n_discs(). */
  unsigned int n_discs() const {
    return n_discs_;
  }
  bool is_disc(const unsigned int i) const {
    return i + n_discs_ >= intervals_.size();
  }
  /** Returns the interval of block i; that of a disc is its diameter. */
  const Interval &operator[](const unsigned int i) const {
    return intervals_[i];
  }
  /** Returns P_i, or the length of a pair. */
  double length(const unsigned int i, const Vector &P) const {
    return is_disc(i) ? std::hypot(P[i], P[i + n_discs_]) : P[i];
  }
  /** Takes the mean of a positive vector over each block, so that P and P - W/c lie on one ray
   * where they should. */
  void average(Vector &c) const {
    for (unsigned int i = n_blocks() - n_discs_; i < n_blocks(); ++i)
      c[i] = c[i + n_discs_] = 0.5 * (c[i] + c[i + n_discs_]);
  }
  /** Returns the admissible number that is closest to p, for a block of one unknown. */
  double project(const unsigned int i, const double p) const {
    return std::max(intervals_[i].lower, std::min(intervals_[i].upper, p));
  }
  /** Projects block i of P. */
  void project(const unsigned int i, Vector &P) const {
    if (!is_disc(i))
      P[i] = project(i, P[i]);
    else if (const double size = length(i, P); size > intervals_[i].upper) {
      P[i] *= intervals_[i].upper / size;
      P[i + n_discs_] *= intervals_[i].upper / size;
    }
  }
  void project(Vector &P) const {
    for (unsigned int i = 0; i < n_blocks(); ++i)
      project(i, P);
  }
  /** Returns whether p lies inside of the interval, so that W_i must vanish: a pressing or a
   * sticking patch. @param p the unknown, or the length of a pair. */
  bool is_inside(const unsigned int i, const double p) const {
    // Lengths are rounded.
    const double margin =
      is_disc(i) ? 4. * std::numeric_limits<double>::epsilon() * intervals_[i].upper : 0.;
    return intervals_[i].lower < p && p < intervals_[i].upper - margin;
  }
  /** Returns the state of a value p of block i. */
  State state(const unsigned int i, const double p) const {
    return is_inside(i, p) ? State::inside : p >= intervals_[i].upper ? State::upper : State::lower;
  }
  /** Returns whether P_t of block i is as large as its bound, so that the patch slips: up to the
   * tolerance of the solvers, because P_t of projected SOR follows P_n of the sweep before. */
  bool slips(const unsigned int i, const Vector &P) const {
    constexpr double almost = 1. - 1e-8;
    return std::abs(length(i, P)) >= almost * intervals_[i].upper;
  }
  /** Returns P - projection of P - step; for step = W_i/c_i it vanishes at the solution and nowhere
   * else, if c is the same for both unknowns of a pair. */
  Vector residual(const Vector &P, const Vector &step) const {
    Vector r(P);
    if (r.size() == 0)
      return r;
    r -= step;
    project(r);
    r.sadd(-1., 1., P);
    return r;
  }
  /** Returns the part of W_i that moves p within K: all of it inside; at an end the part whose step
   * points inside. */
  double inward(const unsigned int i, const double p, const double w) const {
    if (is_inside(i, p))
      return w;
    return p >= intervals_[i].upper ? std::max(w, 0.) : std::min(w, 0.);
  }
  /** Returns W_i of the blocks of P_t that slip, and zero elsewhere: W_i of a block that sticks is
   * rounding, which a large s_i must not multiply. */
  Vector slip(const Vector &P, const Vector &W) const {
    Vector slip(W);
    for (unsigned int i = 0; i < n_blocks(); ++i)
      if (std::isinf(intervals_[i].lower) || !slips(i, P))
        slip[i] = slip[is_disc(i) ? i + n_discs_ : i] = 0.;
    return slip;
  }
  /** Returns Σ s_i |W_i| over the blocks of P_t: the work of friction in the slip W.
   * With it Wᵀ P ≥ -Σ s_i |W_i| for all P in K where W_n ≤ 0, and equality means that P, W is a
   * solution. */
  double dissipation(const Vector &W) const {
    double work = 0.;
    for (unsigned int i = 0; i < n_blocks(); ++i)
      if (std::isfinite(intervals_[i].lower))
        work += intervals_[i].upper * std::abs(length(i, W));
    return work;
  }

private:
  /** One interval per block. */
  std::vector<Interval> intervals_;
  unsigned int n_normal_ = 0;
  /** The number of pairs among the blocks, which are the last ones. */
  unsigned int n_discs_ = 0;
  /** Coulomb's coefficient of every patch; empty where no interval moves. */
  std::vector<double> f_;
};
} // namespace Signorini
