// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/discretization/space/resultant.h>
#include <signorini/discretization/space/trace_values.h>

#include <vector>

namespace Signorini {
/** The sides of a pair. */
enum class PairSide { first, opposite };

/** Returns the points of Γ_c at which tractions act: x on the side named first, and on the other
 * one the points across from these, x + d n, which are d as drawn away. */
template <int dim>
std::vector<Point<dim>> points_of_action(const ContactSurface<dim> &surface,
                                         const Piece<dim> &piece, PairSide side);

/** Returns the force and the moment of p_H m + q_H on a piece of Γ_c; on the opposite side of a
 * pair those of -p_H m - q_H at the points across. The forces cancel, and the moments do but for
 * the couple of q_H and d. */
template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const Multiplier &multiplier, const Piece<dim> &piece,
                                 PairSide side = PairSide::first);

/** Returns u_h.m - g at the points of a rule on a piece, positive where the body penetrates, or
 * the slip u_{h,t} - g_t; g is that of @p scene, whose contact sides are those of the surface.
 * @throws InputError where g has no value. */
template <int dim>
std::vector<double> penetration(const Scene<dim> &scene, const ContactSurface<dim> &surface,
                                const Piece<dim> &piece, const SurfaceRule<dim> &rule,
                                const Displacement &U, TraceValues<dim> &traces,
                                Component component = Component::normal);

/** Returns ∫_{Γ_c} q φ_j.m for all j, as the column of a coupling: @p values_on (piece, rule) is q
 * at the points of @p rule_on (piece). With t in the place of m if the component is tangential. */
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
