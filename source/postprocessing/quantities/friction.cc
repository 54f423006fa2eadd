// SPDX-License-Identifier: LGPL-2.1-or-later
// Zones of stick and slip, forces and dissipation of friction.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/quantities/friction.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
Columns<TangentialSummary> TangentialSummary::columns() {
  return {{"tangential_force", &TangentialSummary::tangential_force},
          {"dissipation", &TangentialSummary::dissipation},
          {"stick_length", &TangentialSummary::stick_length},
          {"slip_length", &TangentialSummary::slip_length},
          {"open_length", &TangentialSummary::open_length},
          {"friction_carried_share", &TangentialSummary::carried_share},
          {"friction_largest_share", &TangentialSummary::largest_share},
          {"critical_friction_factor", &TangentialSummary::critical_factor},
          {"q_l2", &TangentialSummary::l2_error}};
}

namespace {
double length_of(const std::vector<ContactZone> &zones) {
  double length = 0.;
  for (const ContactZone &zone : zones)
    length += zone.length;
  return length;
}

/** Returns ∫ q_H, a sum over the tangents of all sides; in space the norm of the vector. */
template <int dim>
double tangential_force(const MultiplierSpace<dim> &space, const Multiplier &multiplier) {
  const dealii::Vector<double> measures = space.integrals();
  const unsigned int m = measures.size();
  double along = 0.;
  Tensor<1, dim> force;
  for (unsigned int k = 0; k < m; ++k) {
    const Patch<dim> &patch = space.surface().patches()[space.patch_of(k)];
    along += multiplier.values()[m + k] * measures[k];
    if constexpr (dim == 3)
      force += measures[k] * tangential_traction<dim>(space, multiplier, space.patch_of(k),
                                                      patch.lower, space.surface().middle(patch).n);
  }
  return dim == 2 ? along : force.norm();
}

/** Sets the shares of its limits that friction takes. */
template <int dim>
void add_shares(const MultiplierSpace<dim> &space, const Multiplier &multiplier,
                TangentialSummary &summary) {
  const Pressure bounds = multiplier.bounds();
  const std::vector<Pressure> q = multiplier.tangential();
  const double limit = bounds * space.integrals();
  if (!(limit > 0.))
    return;
  summary.carried_share = std::abs(summary.tangential_force) / limit;
  const double negligible = 1e-12 * bounds.linfty_norm();
  for (unsigned int k = 0; k < bounds.size(); ++k)
    if (bounds[k] > negligible)
      summary.largest_share = std::max(
        summary.largest_share, std::hypot(q[0][k], q.size() > 1 ? q[1][k] : 0.) / bounds[k]);
}
} // namespace

template <int dim>
TangentialSummary summarise_tangential_part(const MultiplierSpace<dim> &space,
                                            const Multiplier &multiplier,
                                            const dealii::Vector<double> &W) {
  const unsigned int m = space.n_multipliers();
  const dealii::Vector<double> lengths = space.lengths();
  TangentialSummary summary;
  summary.tangential_force = tangential_force(space, multiplier);
  add_shares(space, multiplier, summary);
  const AdmissibleSet &K = multiplier.set();
  summary.dissipation = K.dissipation(K.slip(multiplier.values(), W));
  // Nodes press in the states of one kind.
  std::vector<NodeState> stick(m), slip(m);
  for (unsigned int k = 0; k < m; ++k) {
    const NodeState state = multiplier.state(k);
    const bool sticks = state.slip == State::inside;
    (sticks ? stick : slip)[k].presses = state.presses;
    (!state.presses ? summary.open_length
     : sticks       ? summary.stick_length
                    : summary.slip_length) += lengths[k];
  }
  if constexpr (dim == 2) {
    summary.stick_zones = contact_zones(space, stick);
    summary.slip_zones = contact_zones(space, slip);
    if (!space.is_piecewise_constant()) {
      const double all = summary.stick_length + summary.slip_length + summary.open_length;
      summary.stick_length = length_of(summary.stick_zones);
      summary.slip_length = length_of(summary.slip_zones);
      summary.open_length = all - summary.stick_length - summary.slip_length;
    }
  }
  return summary;
}

INSTANTIATE_FUNCTION(summarise_tangential_part);
} // namespace Signorini
