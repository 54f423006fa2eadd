// SPDX-License-Identifier: LGPL-2.1-or-later
// The side of a pair from which the bound sees both bodies.

#include <signorini/error_control/equilibration/carrier.h>

namespace Signorini {
bool is_carrier(const Scene<2> &scene, const unsigned int side) {
  AssertIndexRange(side, scene.boundary.size());
  return scene.boundary[side].role == Role::contact && pair_with(scene, side).carrier() == side;
}

Point<2> point_of_data(const Scene<2> &scene, const unsigned int side, const Point<2> &x) {
  const ContactPair<2> pair = pair_with(scene, side);
  const Side<2> &given = scene.geometry.sides[pair.side()];
  return pair.side() == side ? x : given.point(given.arc_length(x));
}

double tangential_bound_at(const Scene<2> &scene, const unsigned int side, const Point<2> &x,
                           const double tau_n) {
  return pair_with(scene, side).bound(point_of_data(scene, side, x), tau_n);
}

CarriedPiece seen_from_carrier(const ContactSurface<2> &surface, const Piece<2> &piece) {
  const PieceOnFace first = {piece.face, piece.lower_on_face[0], piece.upper_on_face[0]};
  const SurfaceRule<2> ends = surface.at(piece, {Point<1>(0.), Point<1>(1.)});
  const auto faces = surface.faces_at(piece, ends);
  if (faces.size() == 1)
    return {first, {}};
  const PieceOnFace second = {static_cast<unsigned int>(&faces[1].face - surface.faces().data()),
                              faces[1].points[0][0], faces[1].points[1][0]};
  if (is_carrier(surface.scene(), surface.faces()[first.face].side))
    return {first, second};
  return {second, first};
}
} // namespace Signorini
