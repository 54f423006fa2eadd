// SPDX-License-Identifier: LGPL-2.1-or-later
// Zones of stick and slip, and what friction does.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/friction.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
std::vector<FrictionState> friction_states(const AdmissibleSet &K,
                                           const dealii::Vector<double> &P) {
  const unsigned int m = K.n_blocks() / 2;
  const AdmissibleSet K_P = K.at(P);
  const double threshold = pressing_threshold(Pressure(P));
  std::vector<FrictionState> states(m);
  for (unsigned int k = 0; k < m; ++k) {
    states[k] = !(P[k] < threshold)   ? FrictionState::open
                : K_P.slips(m + k, P) ? FrictionState::slip
                                      : FrictionState::stick;
  }
  return states;
}

std::vector<int> zone_states(const AdmissibleSet &K, const Pressure &P, const Pressure &P_t) {
  std::vector<int> states = pressing_states(P);
  const dealii::Vector<double> all = join(P, P_t);
  const AdmissibleSet K_P = K.at(all);
  for (unsigned int k = 0, m = P.size(); k < P_t.size(); ++k)
    states[k] += !K_P.slips(m + k, all) ? 2 : P_t[k] >= 0. ? 4 : 6;
  return states;
}

std::vector<bool> sticking_patches(const MultiplierSpace<2> &multipliers, const AdmissibleSet &K,
                                   const Pressure &P, const Pressure &P_t) {
  std::vector<bool> sticks;
  for (const SlipState state : slip_states(multipliers, K, P, P_t))
    sticks.push_back(P_t.size() > 0 && state == SlipState::none);
  return sticks;
}

Pressure friction_shares(const AdmissibleSet &K, const Pressure &P, const Pressure &P_t) {
  const AdmissibleSet K_P = K.at(P);
  Pressure shares = P_t;
  for (unsigned int k = 0, m = P.size(); k < P_t.size(); ++k) {
    const double bound = K_P[m + k % m].upper;
    shares[k] /= bound > 0. ? bound : 1.;
  }
  return shares;
}

Pressure friction_of_shares(const AdmissibleSet &K, const Pressure &P, const Pressure &shares) {
  constexpr double more_than_rounding = 1. + 1e-6;
  const AdmissibleSet K_P = K.at(P);
  dealii::Vector<double> all = join(P, shares);
  const unsigned int m = P.size();
  for (unsigned int k = 0; k < shares.size(); ++k)
    all[m + k] *= more_than_rounding * K_P[m + k % m].upper;
  for (unsigned int k = m; k < K_P.n_blocks(); ++k)
    K_P.project(k, all);
  Pressure P_t(shares.size());
  std::copy(all.begin() + m, all.end(), P_t.begin());
  return P_t;
}

Columns<FrictionSummary> FrictionSummary::columns() {
  return {{"tangential_force", &FrictionSummary::tangential_force},
          {"dissipation", &FrictionSummary::dissipation},
          {"stick_length", &FrictionSummary::stick_length},
          {"slip_length", &FrictionSummary::slip_length},
          {"open_length", &FrictionSummary::open_length},
          {"critical_friction_factor", &FrictionSummary::critical_factor},
          {"q_l2", &FrictionSummary::l2_error}};
}

namespace {
double length_of(const std::vector<ContactZone> &zones) {
  double length = 0.;
  for (const ContactZone &zone : zones)
    length += zone.length;
  return length;
}

/** Returns ∫ p_t, a sum over the tangents of all sides; in space the norm of the vector. */
template <int dim>
double tangential_force(const MultiplierSpace<dim> &multipliers, const dealii::Vector<double> &P) {
  const dealii::Vector<double> measures = multipliers.integrals();
  const unsigned int m = measures.size();
  double along = 0.;
  Tensor<1, dim> force;
  for (unsigned int k = 0; k < m; ++k) {
    const Patch<dim> &patch = multipliers.surface().patches()[multipliers.patch_of(k)];
    along += P[m + k] * measures[k];
    if constexpr (dim == 3)
      for (unsigned int c = 0; c < 2; ++c)
        force +=
          P[(c + 1) * m + k] * measures[k] *
          direction_of(tangents<dim>()[c], multipliers.surface().side(patch).normal(patch.lower));
  }
  return dim == 2 ? along : force.norm();
}
} // namespace

template <int dim>
FrictionSummary summarise_friction(const MultiplierSpace<dim> &multipliers, const AdmissibleSet &K,
                                   const dealii::Vector<double> &P,
                                   const dealii::Vector<double> &W) {
  const unsigned int m = multipliers.n_multipliers();
  const std::vector<FrictionState> states = friction_states(K, P);
  const dealii::Vector<double> lengths = multipliers.integrals();
  FrictionSummary summary;
  summary.tangential_force = tangential_force(multipliers, P);
  const AdmissibleSet K_P = K.at(P);
  summary.dissipation = K_P.dissipation(K_P.slip(P, W));
  // Nodes in one state press in the place of P.
  Pressure stick(m), slip(m);
  for (unsigned int k = 0; k < m; ++k) {
    stick[k] = states[k] == FrictionState::stick ? -1. : 0.;
    slip[k] = states[k] == FrictionState::slip ? -1. : 0.;
    (stick[k] < 0.  ? summary.stick_length
     : slip[k] < 0. ? summary.slip_length
                    : summary.open_length) += lengths[k];
  }
  if constexpr (dim == 2) {
    summary.stick_zones = contact_zones(multipliers, stick);
    summary.slip_zones = contact_zones(multipliers, slip);
    if (!multipliers.is_piecewise_constant()) {
      const double all = summary.stick_length + summary.slip_length + summary.open_length;
      summary.stick_length = length_of(summary.stick_zones);
      summary.slip_length = length_of(summary.slip_zones);
      summary.open_length = all - summary.stick_length - summary.slip_length;
    }
  }
  return summary;
}

INSTANTIATE_FUNCTION(summarise_friction);
} // namespace Signorini
