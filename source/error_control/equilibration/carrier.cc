// SPDX-License-Identifier: LGPL-2.1-or-later
// The side of a pair from which the bound sees both bodies.

#include <signorini/error_control/equilibration/carrier.h>

namespace Signorini {
namespace {
/** Returns the modulus of stretch along the normal in the middle of a side, inside of its body. */
double stiffness(const Scene<2> &scene, const unsigned int number) {
  const Side<2> &side = scene.geometry.sides[number];
  const Tensor<1, 2> n = side.normal(0.5 * side.length());
  const Point<2> inside = side.centre() - 1e-4 * side.length() * n;
  const auto nn = symmetrize(outer_product(n, n));
  return nn * (scene.material->hooke(inside) * nn);
}
} // namespace

unsigned int contact_side_of(const Scene<2> &scene, const unsigned int side) {
  for (const unsigned int first : scene.contact_sides())
    if (scene.boundary[first].opposite == side)
      return first;
  return side;
}

bool is_carrier(const Scene<2> &scene, const unsigned int side) {
  const unsigned int first = contact_side_of(scene, side);
  const auto opposite = scene.boundary[first].opposite;
  if (!opposite)
    return scene.boundary[side].role == Role::contact;
  constexpr double rounding = 1e-10;
  const bool takes_first = stiffness(scene, first) <= (1. + rounding) * stiffness(scene, *opposite);
  return (side == first) == takes_first;
}

Point<2> point_of_data(const Scene<2> &scene, const unsigned int side, const Point<2> &x) {
  const unsigned int first = contact_side_of(scene, side);
  const Side<2> &given = scene.geometry.sides[first];
  return first == side ? x : given.point(given.arc_length(x));
}

CarriedPiece seen_from_carrier(const ContactSurface<2> &surface, const Piece<2> &piece) {
  const PieceOnFace first = {piece.face, piece.lower_on_face[0], piece.upper_on_face[0]};
  if (!piece.opposite)
    return {first, {}};
  const SurfaceRule<2> ends = surface.at(piece, {Point<1>(0.), Point<1>(1.)});
  const PieceOnFace second = {piece.opposite->first, ends.on_opposite[0][0],
                              ends.on_opposite[1][0]};
  if (is_carrier(surface.scene(), surface.faces()[first.face].side))
    return {first, second};
  return {second, first};
}
} // namespace Signorini
