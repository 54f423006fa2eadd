// SPDX-License-Identifier: LGPL-2.1-or-later
// Zones of stick and slip, and what friction does.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/friction.h>

#include <cmath>

namespace Signorini {
std::vector<FrictionState> friction_states(const AdmissibleSet &K,
                                           const dealii::Vector<double> &P) {
  const unsigned int m = K.n_blocks() / 2;
  const AdmissibleSet K_P = K.at(P);
  const double threshold = pressing_threshold(Pressure(P));
  std::vector<FrictionState> states(m);
  for (unsigned int k = 0; k < m; ++k) {
    // Up to the tolerance of the solver: P_t of projected SOR follows P_n of the sweep before.
    const double limit = (1. - 1e-8) * K_P[m + k].upper;
    states[k] = !(P[k] < threshold)                      ? FrictionState::open
                : std::abs(K_P.length(m + k, P)) < limit ? FrictionState::stick
                                                         : FrictionState::slip;
  }
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

namespace {
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
  summary.dissipation = K.at(P).dissipation(W);
  // Patches in one state press in the place of P.
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
  }
  return summary;
}

INSTANTIATE_FUNCTION(summarise_friction);
} // namespace Signorini
