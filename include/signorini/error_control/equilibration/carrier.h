// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/problem/scene/contact_pair.h>

#include <array>
#include <optional>

namespace Signorini {
/** The components of displacements and tractions on contact sides, in the order of arrays. */
constexpr std::array<Component, 2> contact_components = {
  {Component::normal, Component::tangential}};

/**
 * The bound sees a pair of sides from its softer side, the carrier: the traction q of both bodies
 * lives on the carrier's edges, and u.n is u_c.n_c + u_o.n_o for the carrier c and the other side
 * o, with n_o = -n_c and t_o = -t_c. A side that touches a rigid foundation is its own carrier.
 */
bool is_carrier(const Scene<2> &scene, unsigned int side);

/** Returns the point of the contact side at a point of a carrier: where data of contact is given.
 */
Point<2> point_of_data(const Scene<2> &scene, unsigned int side, const Point<2> &x);

/** Returns the bound of |τ_t| at a point of a carrier with the normal traction @p tau_n. */
double tangential_bound_at(const Scene<2> &scene, unsigned int side, const Point<2> &x,
                           double tau_n);

/** A piece on a face of the mesh: the number of the face, and its own parameters at
 * Piece::lower and Piece::upper. */
struct PieceOnFace {
  unsigned int face;
  double lower, upper;
};

/** A piece on the face of the carrier, and on that of the other body, if there is one. */
struct CarriedPiece {
  PieceOnFace own;
  std::optional<PieceOnFace> other;
};
CarriedPiece seen_from_carrier(const ContactSurface<2> &surface, const Piece<2> &piece);
} // namespace Signorini
