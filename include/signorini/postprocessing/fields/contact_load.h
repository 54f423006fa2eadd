// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/discretization/space/trace_values.h>

#include <vector>

namespace Signorini {
/** Returns ∫_{Γ_c} q φ_j.m for all j, as the column of a coupling: @p values_on (piece, rule) is q
 * at the points of @p rule_on (piece). With t instead of m if the component is tangential. */
template <int dim, typename RuleOn, typename ValuesOn>
Coupling::Column contact_load(const DisplacementSpace<dim> &space,
                              const ContactSurface<dim> &surface, const RuleOn &rule_on,
                              const ValuesOn &values_on,
                              const Component component = Component::normal) {
  TraceValues<dim> traces(space);
  Coupling::Column load;
  for (const Piece<dim> &piece : surface.pieces()) {
    const SurfaceRule<dim> &rule = rule_on(piece);
    const std::vector<double> q = values_on(piece, rule);
    for (const auto &[face, points, sign] : surface.faces_at(piece, rule)) {
      const auto &values = traces.reinit(face, points);
      const auto indices = space.cell_dofs(face.cell);
      for (std::size_t k = 0; k < rule.size(); ++k)
        for (unsigned int j = 0; j < indices.size(); ++j)
          load[indices[j]] += sign * q[k] * rule.weights[k] *
                              (values[FEValuesExtractors::Vector(0)].value(j, k) *
                               direction_of(component, rule.directions[k]));
    }
  }
  return load;
}
} // namespace Signorini
