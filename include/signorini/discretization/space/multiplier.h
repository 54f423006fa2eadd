// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/multiplier_space.h>

#include <vector>

namespace Signorini {
/** The state of the multiplier at a node: whether p_H presses, and how q_H lies in its interval. */
struct NodeState {
  bool presses = false;
  /** Inside it sticks; at the lower or upper end it slips. Without friction it is inside. */
  State slip = State::inside;

  friend bool operator==(const NodeState &a, const NodeState &b) {
    return a.presses == b.presses && a.slip == b.slip;
  }
  friend bool operator!=(const NodeState &a, const NodeState &b) {
    return !(a == b);
  }
};

/** The multiplier (p_H, q_H) by the values P_n and P_t at the nodes of Q^H, with the set K(P) in
 * which it lies. Without friction P_t is empty; in space P_t = (P_t1, P_t2). */
class Multiplier {
public:
  using Vector = dealii::Vector<double>;

  Multiplier() = default;
  /** Stores the values (P_n, P_t). @param K the set of the level, which may move with P_n. */
  Multiplier(Vector values, const AdmissibleSet &K)
    : values_(std::move(values))
    , normal_(component(0, K.n_normal()))
    , threshold_(pressing_threshold(normal_))
    , is_coupled_(K.moves())
    , set_(K.at(values_)) {
    AssertDimension(values_.size(), K.size());
  }
  /** Makes a multiplier without friction. */
  Multiplier(const Pressure &P) // NOLINT(google-explicit-constructor)
    : Multiplier(P, AdmissibleSet::nonpositive(P.size())) {}
  /** Makes the multiplier whose P_t are the given shares of the bounds that belong to @p normal. A
   * share of a slipping node is slightly lengthened, so that an active set begins with its state.
   */
  static Multiplier from_shares(const Pressure &normal, const Vector &shares,
                                const AdmissibleSet &K);

  /** Returns (P_n, P_t), the vector that D, G and C belong to. */
  const Vector &values() const {
    return values_;
  }
  const Pressure &normal() const {
    return normal_;
  }
  /** Returns the components of P_t, one in the plane and two in space; none without friction. */
  std::vector<Pressure> tangential() const;
  bool has_tangential_part() const {
    return values_.size() > normal_.size();
  }
  /** Returns K(P), which does not move. */
  const AdmissibleSet &set() const {
    return set_;
  }
  /** Returns whether the bounds of P_t follow P_n: Coulomb's law. */
  bool is_coupled() const {
    return is_coupled_;
  }

  /** Returns whether P_n,k presses: whether it is below pressing_threshold(). */
  bool presses(const unsigned int k) const {
    return normal_[k] < threshold_;
  }
  NodeState state(unsigned int k) const;
  std::vector<NodeState> states() const;
  /** Returns the bounds of |P_t| at all nodes; empty without friction. */
  Pressure bounds() const;
  /** Returns the shares of P_t in its bounds by components; none without friction. */
  std::vector<Pressure> shares() const;

private:
  /** Returns n values of a component. */
  Pressure component(unsigned int number, unsigned int n) const;

  Vector values_;
  Pressure normal_;
  double threshold_ = 0.;
  bool is_coupled_ = false;
  AdmissibleSet set_;
};

/** Returns the vector q_H at a point of a patch, along the tangents that belong to @p normal; zero
 * without friction (force/length^{dim-1}). */
template <int dim>
Tensor<1, dim> tangential_traction(const MultiplierSpace<dim> &space, const Multiplier &multiplier,
                                   const unsigned int patch, const Point<dim - 1> &s,
                                   const Tensor<1, dim> &normal) {
  Tensor<1, dim> q;
  for (unsigned int c = 0; multiplier.has_tangential_part() && c < dim - 1; ++c)
    q +=
      space.value(multiplier.values(), patch, s, c + 1) * direction_of(tangents<dim>()[c], normal);
  return q;
}

/** Returns the states of all patches: one presses where all of its nodes do, and its slip is mixed
 * where its nodes differ. */
std::vector<NodeState> patch_states(const MultiplierSpace<2> &space, const Multiplier &multiplier);
} // namespace Signorini
