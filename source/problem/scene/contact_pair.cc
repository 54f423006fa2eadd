// SPDX-License-Identifier: LGPL-2.1-or-later
// The side of a pair on which the traction of both bodies is given.

#include <signorini/problem/scene/contact_pair.h>

namespace Signorini {
namespace {
/** Returns 1/(nn : C⁻¹ : nn) in the middle of a side, inside of its body: the modulus of a strip
 * that is pressed along its normal n and free across, E/(1 - ν²) in plane strain. */
double stiffness(const Scene<2> &scene, const unsigned int number) {
  const Side<2> &side = scene.geometry.sides[number];
  const Tensor<1, 2> n = side.normal(0.5 * side.length());
  const Point<2> inside = side.centre() - 1e-4 * side.length() * n;
  const auto nn = symmetrize(outer_product(n, n));
  return 1. / (nn * (invert(scene.material->hooke(inside)) * nn));
}
} // namespace

template <int dim>
unsigned int ContactPair<dim>::carrier() const {
  constexpr double rounding = 1e-10;
  if constexpr (dim == 2)
    if (const auto &other = other_side();
        other && stiffness(scene_, side()) > (1. + rounding) * stiffness(scene_, *other))
      return *other;
  return side();
}

template <int dim>
bool ContactPair<dim>::contains(const Point<dim> &x) const {
  if constexpr (dim == 2)
    return contains(scene_.geometry.sides[side()].arc_length(x));
  return !other_side();
}

template <int dim>
bool ContactPair<dim>::contains(const double s) const {
  const Side<dim> &on = scene_.geometry.sides[side()];
  if constexpr (dim == 2)
    for (const int turn : {-1, 0, 1})
      if (const double moved = s + turn * on.length();
          (turn == 0 || on.is_closed()) && moved >= data().from && moved <= data().to)
        return true;
  return false;
}

template class ContactPair<2>;
template class ContactPair<3>;
} // namespace Signorini
