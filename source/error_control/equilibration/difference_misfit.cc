// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfit on the mesh of u_h itself.

#include <signorini/error_control/equilibration/difference_misfit.h>
#include <signorini/error_control/equilibration/law.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
DifferenceMisfit::DifferenceMisfit(const BoundData &data)
  : data_(data)
  , lift_(data)
  , lift_norms_(data.space.mesh().triangulation().n_active_cells()) {
  lift_.visit_cells(
    data, ExactMaps(data.space.mesh(), data.scene.geometry.sides), [&](const LiftedCell &lifted) {
      lift_norms_[lifted.u.cell()->active_cell_index()] = std::sqrt(lifted.energy());
    });
}

double DifferenceMisfit::expected(const EquilibratedStress &stress) const {
  double square = 0.;
  for (const CellFit &fit : stress.fits)
    square += std::pow(least(fit), 2);
  return std::sqrt(square);
}

double DifferenceMisfit::allowed_load(const EquilibratedStress &stress,
                                      const Works & /*works*/) const {
  return std::sqrt(stress.distance_square());
}

StressBound DifferenceMisfit::bound(const EquilibratedStress &stress,
                                    const Works & /*works*/) const {
  StressBound result;
  result.energy_norm = data_.scale.norm;
  result.lift_misfit = lift_.max_misfit();
  result.lift = lift_norms_.l2_norm();
  double smallest_square = 0., given_square = 0.;
  for (std::size_t c = 0; c < stress.fits.size(); ++c) {
    // The misfit is that of u_h, which is at most |||z|||_K away from that of u_h + z.
    const CellFit &fit = stress.fits[c];
    const double fitted = stress.distance(c), rest = stress.oscillation(c) + lift_norms_[c],
                 mesh = std::hypot(fitted, fit.size * std::sqrt(std::max(0., fit.unresolved)));
    result.misfit.push_back(mesh);
    result.oscillation.push_back(rest);
    result.square += std::pow(mesh + rest, 2);
    result.oscillation_square += rest * rest;
    smallest_square += std::pow(std::max(0., fitted - rest), 2);
    given_square += std::pow(stress.oscillation(c, false), 2);
  }
  // With η² = 2 J(u_h) + 2 J*(τ) - 2 ∫ τ_n d, J* loses no digits. J(u_h) must be that of a function
  // with the boundary values of u, under loads that are resolved.
  const double J = data_.energies.J_without_plates();
  if (result.lift <= 1e-10 * result.energy_norm && given_square <= 0.01 * result.square)
    result.complementary_energy = {0.5 * smallest_square - J, 0.5 * result.square - J};
  return result;
}
} // namespace Signorini
