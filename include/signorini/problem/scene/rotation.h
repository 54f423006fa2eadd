// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <type_traits>

namespace Signorini {
/** A rotation or a moment: a number in the plane, counter-clockwise, a vector in space. */
template <int dim>
using Rotation = std::conditional_t<dim == 2, double, Tensor<1, 3>>;

/** The translations and rotations of a body as a whole. */
template <int dim>
constexpr unsigned int n_rigid_motions = dim *(dim + 1) / 2;

/** Returns omega × arm. */
inline Tensor<1, 2> cross(const double omega, const Tensor<1, 2> &arm) {
  return omega * Tensor<1, 2>({-arm[1], arm[0]});
}
inline Tensor<1, 3> cross(const Tensor<1, 3> &omega, const Tensor<1, 3> &arm) {
  return cross_product_3d(omega, arm);
}

/** Returns |omega|. */
inline double size_of(const double omega) {
  return std::abs(omega);
}
inline double size_of(const Tensor<1, 3> &omega) {
  return omega.norm();
}

/** Returns a component of a rotation, of which the plane has one. */
inline double &component(double &omega, const unsigned int /*k*/) {
  return omega;
}
inline double &component(Tensor<1, 3> &omega, const unsigned int k) {
  return omega[k];
}
} // namespace Signorini
