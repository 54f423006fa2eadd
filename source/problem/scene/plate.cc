// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that move as rigid plates.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/plate.h>

#include <algorithm>

namespace Signorini {
template <int dim>
std::array<Tensor<1, dim>, dim - 1> Plate<dim>::across() const {
  if constexpr (dim == 2)
    return {{-cross_product_2d(direction)}};
  else {
    // The axis that is farthest from d gives the first one.
    unsigned int axis = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(direction[d]) < std::abs(direction[axis]) - 1e-12)
        axis = d;
    Tensor<1, 3> first = Point<3>::unit_vector(axis);
    first -= (first * direction) * direction;
    first /= first.norm();
    return {{first, cross_product_3d(direction, first)}};
  }
}

template <int dim>
std::array<PlateMotion<dim>, n_rigid_motions<dim>> Plate<dim>::unit_motions() const {
  std::array<PlateMotion<dim>, n_rigid_motions<dim>> motions;
  motions[0].travel = 1.;
  for (unsigned int k = 1; k < dim; ++k)
    if constexpr (dim == 2)
      motions[k].drift = 1.;
    else
      motions[k].drift = across()[k - 1];
  for (unsigned int k = dim; k < motions.size(); ++k)
    component(motions[k].rotation, k - dim) = 1.;
  return motions;
}

template <int dim>
Tensor<1, dim> Plate<dim>::displacement(const PlateMotion<dim> &motion, const Point<dim> &x) const {
  Tensor<1, dim> drift;
  if constexpr (dim == 2)
    drift = motion.drift * across()[0];
  else
    drift = motion.drift;
  return motion.travel * direction + drift + cross(motion.rotation, x - centre);
}

template <int dim>
std::shared_ptr<const Function<dim>> plate_displacement(const Plate<dim> &plate,
                                                        const PlateMotion<dim> &motion) {
  // Who reads a constant knows that it is one.
  if (!plate.turns) {
    const Tensor<1, dim> u = plate.displacement(motion, plate.centre);
    return std::make_shared<Functions::ConstantFunction<dim>>(
      std::vector<double>(u.begin_raw(), u.end_raw()));
  }
  return std::make_shared<FieldFunction<dim>>(
    [plate, motion](const Point<dim> &x) { return plate.displacement(motion, x); });
}

template struct Plate<2>;
template struct Plate<3>;
INSTANTIATE_FUNCTION(plate_displacement);
} // namespace Signorini
