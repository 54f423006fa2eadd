// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displaced_body.h>
#include <signorini/discretization/space/resultant.h>
#include <signorini/discretization/space/trace_values.h>
#include <signorini/problem/scene/contact_pair.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini {
/** The two bodies of a pair. */
enum class PairSide { first, second };

/** Returns whether a component of u follows the partner in a state of contact: u.m where p_H
 * presses, u_t where it sticks. */
inline bool follows(const NodeState &state, const Component component) {
  return component == Component::normal ? state.presses : state.slip == State::inside;
}

/** A piece of Γ_c as a part of a ContactPair: its faces, the points across, closing and slip, and
 * the tractions on both bodies. */
template <int dim>
class PairedPiece {
public:
  /** The arguments must outlive the object. */
  PairedPiece(const ContactSurface<dim> &surface, const Piece<dim> &piece)
    : surface_(surface)
    , piece_(piece) {}

  /** Returns the face of the other body; null where the foundation is rigid. */
  const ContactFace<dim> *other_face() const {
    return piece_.opposite ? &surface_.faces()[piece_.opposite->first] : nullptr;
  }
  /** Returns the pair in a scene with the same contacts, such as a load case. */
  ContactPair<dim> in(const Scene<dim> &scene) const {
    return {scene, surface_.patches()[piece_.patch].contact};
  }
  ContactPair<dim> pair() const {
    return in(surface_.scene());
  }
  /** Returns the points of a rule at which tractions act: on the second body the points across,
   * x + d n, which are d as drawn away. */
  std::vector<Point<dim>> points(const SurfaceRule<dim> &rule, PairSide side) const;
  /** Returns |n + n_2| at a point of a rule, n_2 the normal of the other body across; of an
   * obstacle |m + n_2|; 0 where it touches neither, or the gap is an expression. */
  double turn_of_normals(const SurfaceRule<dim> &rule, std::size_t q) const;

  /** Returns u_h of both bodies at the points of a rule: that of the first one, and less that of
   * the second one. */
  std::array<std::vector<Tensor<1, dim>>, 2> displacements(const SurfaceRule<dim> &rule,
                                                           const Displacement &U,
                                                           TraceValues<dim> &traces) const;
  /** Returns the closing u_h.m - g at the points of a rule, positive where the bodies penetrate, or
   * the slip u_{h,t} - g_t; g is that of the body's scene. @throws InputError where g has no value.
   */
  std::vector<double> closing(const DisplacedBody<dim> &body, const SurfaceRule<dim> &rule,
                              TraceValues<dim> &traces,
                              Component component = Component::normal) const;

  /** Returns the force and the moment of p_H m + q_H on the first body; on the second one those of
   * -p_H m - q_H at the points across. The forces cancel, and the moments do but for the couple of
   * q_H and d. */
  Resultant<dim> resultant(const MultiplierSpace<dim> &multipliers, const Multiplier &multiplier,
                           PairSide side = PairSide::first) const;

private:
  const ContactSurface<dim> &surface_;
  const Piece<dim> &piece_;
};
} // namespace Signorini
