// SPDX-License-Identifier: LGPL-2.1-or-later
// The multiplier with the states of its nodes and patches.

#include <signorini/discretization/space/multiplier.h>

#include <algorithm>

namespace Signorini {
Pressure Multiplier::component(const unsigned int number, const unsigned int n) const {
  Assert((number + 1) * n <= values_.size(),
         ExcDimensionMismatch(values_.size(), (number + 1) * n));
  Pressure part(n);
  std::copy_n(values_.begin() + number * n, n, part.begin());
  return part;
}

Multiplier Multiplier::from_shares(const Pressure &normal, const Vector &shares,
                                   const AdmissibleSet &K) {
  constexpr double more_than_rounding = 1. + 1e-6;
  const AdmissibleSet K_P = K.at(normal);
  Vector values = join(normal, shares);
  const unsigned int m = normal.size();
  for (unsigned int k = 0; k < shares.size(); ++k)
    values[m + k] *= more_than_rounding * K_P[m + k % m].upper;
  for (unsigned int k = m; k < K_P.n_blocks(); ++k)
    K_P.project(k, values);
  return {values, K};
}

std::vector<Pressure> Multiplier::tangential() const {
  std::vector<Pressure> parts;
  for (unsigned int c = 1, m = normal_.size(); c * m < values_.size(); ++c)
    parts.push_back(component(c, m));
  return parts;
}

NodeState Multiplier::state(const unsigned int k) const {
  AssertIndexRange(k, normal_.size());
  NodeState state = {presses(k), State::inside};
  if (const unsigned int i = normal_.size() + k; has_tangential_part() && set_.slips(i, values_))
    state.slip = values_[i] >= 0. ? State::upper : State::lower;
  return state;
}

std::vector<NodeState> Multiplier::states() const {
  std::vector<NodeState> states;
  for (unsigned int k = 0; k < normal_.size(); ++k)
    states.push_back(state(k));
  return states;
}

Pressure Multiplier::bounds() const {
  Pressure bounds(has_tangential_part() ? normal_.size() : 0);
  for (unsigned int k = 0; k < bounds.size(); ++k)
    bounds[k] = set_[normal_.size() + k].upper;
  return bounds;
}

std::vector<Pressure> Multiplier::shares() const {
  const Pressure s = bounds();
  std::vector<Pressure> shares = tangential();
  for (Pressure &part : shares)
    for (unsigned int k = 0; k < part.size(); ++k)
      part[k] /= s[k] > 0. ? s[k] : 1.;
  return shares;
}

std::vector<NodeState> patch_states(const MultiplierSpace<2> &space, const Multiplier &multiplier) {
  std::vector<NodeState> states;
  for (unsigned int k = 0; k < space.n_multipliers(); ++k) {
    const NodeState of_node = multiplier.state(k);
    if (k == space.first_of(space.patch_of(k))) {
      states.push_back(of_node);
      continue;
    }
    NodeState &state = states.back();
    state.presses = state.presses && of_node.presses;
    state.slip = state.slip == of_node.slip ? of_node.slip : State::mixed;
  }
  return states;
}
} // namespace Signorini
