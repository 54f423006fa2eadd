// SPDX-License-Identifier: LGPL-2.1-or-later
// Zones of stick and slip, and what friction does.

#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/friction.h>

namespace Signorini {
std::vector<FrictionState> friction_states(const AdmissibleSet &K,
                                           const dealii::Vector<double> &P) {
  const unsigned int m = P.size() / 2;
  const AdmissibleSet K_P = K.at(P);
  const double threshold = pressing_threshold(Pressure(P));
  std::vector<FrictionState> states(m);
  for (unsigned int k = 0; k < m; ++k)
    states[k] = !(P[k] < threshold)              ? FrictionState::open
                : K_P.is_inside(m + k, P[m + k]) ? FrictionState::stick
                                                 : FrictionState::slip;
  return states;
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

FrictionSummary summarise_friction(const MultiplierSpace<2> &multipliers, const AdmissibleSet &K,
                                   const dealii::Vector<double> &P,
                                   const dealii::Vector<double> &W) {
  const unsigned int m = multipliers.n_multipliers();
  const std::vector<FrictionState> states = friction_states(K, P);
  const dealii::Vector<double> lengths = multipliers.integrals();
  FrictionSummary summary;
  summary.dissipation = K.at(P).dissipation(W);
  // Patches in one state press in the place of P.
  Pressure stick(m), slip(m);
  for (unsigned int k = 0; k < m; ++k) {
    summary.tangential_force += P[m + k] * lengths[k];
    stick[k] = states[k] == FrictionState::stick ? -1. : 0.;
    slip[k] = states[k] == FrictionState::slip ? -1. : 0.;
    (stick[k] < 0.  ? summary.stick_length
     : slip[k] < 0. ? summary.slip_length
                    : summary.open_length) += lengths[k];
  }
  summary.stick_zones = contact_zones(multipliers, stick);
  summary.slip_zones = contact_zones(multipliers, slip);
  return summary;
}
} // namespace Signorini
