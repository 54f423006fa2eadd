// SPDX-License-Identifier: LGPL-2.1-or-later
// The distance of any displacement to a stress in equilibrium.

#include <signorini/error_control/reference/reference_stress.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
double ReferenceStress::energy(const FieldWorks &v) const {
  double work = v.load;
  for (const BoundaryTrace &trace : v.traces)
    work += traction.work(trace, sides);
  return v.strain - 2. * work;
}

WithMargin ReferenceStress::distance(const FieldWorks &v) const {
  // The terms cancel, up to rounding.
  const double difference = energy(v) - energy_of_graded.value,
               rest = v.margin + energy_of_graded.margin +
                      1e-14 * (v.strain + 2. * std::abs(v.load) + energy_norm * energy_norm);
  const auto root = [](const double square) { return std::sqrt(std::max(0., square)); };
  const double value = root(difference + misfit * misfit),
               // ω may lessen ‖σ(u_g) - τ‖ to nothing.
    lower = root(difference - rest) - stress_error,
               upper = root(difference + rest + misfit_with_rest * misfit_with_rest) + stress_error;
  return {value, std::max(value - lower, upper - value)};
}

ReferenceStress make_reference(const BoundData &data, const BestStress &best,
                               const double stress_error) {
  const StressBound &bound = best.bound;
  ReferenceStress reference = {BoundaryTraction(best.stress.tractions, data.scene),
                               data.scene.geometry.sides,
                               {0., 0.},
                               // The misfit is that of u_g + z.
                               std::sqrt(bound.square) - std::sqrt(bound.oscillation_square),
                               std::sqrt(bound.square) + bound.lift,
                               stress_error,
                               bound.energy_norm,
                               {},
                               {},
                               data.P.is_coupled()};
  const FieldWorks works = works_of(data)[0];
  reference.energy_of_graded = {reference.energy(works), works.margin};
  return reference;
}
} // namespace Signorini
