// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that move as rigid plates.

#include <signorini/scene/plate.h>

namespace Signorini
{
dealii::Tensor<1, 2> Plate::displacement(const PlateMotion &motion, const dealii::Point<2> &x) const
{
  const dealii::Tensor<1, 2> arm = x - centre;
  return motion.travel * direction + motion.rotation * dealii::Tensor<1, 2>({-arm[1], arm[0]});
}

PlateDisplacement::PlateDisplacement(const Plate &plate, const PlateMotion &motion)
  : dealii::Function<2>(2)
  , plate_(plate)
  , motion_(motion)
{
}

double PlateDisplacement::value(const dealii::Point<2> &x, const unsigned int component) const
{
  return plate_.displacement(motion_, x)[component];
}

void PlateDisplacement::vector_value(const dealii::Point<2> &x,
                                     dealii::Vector<double> &values) const
{
  const dealii::Tensor<1, 2> u = plate_.displacement(motion_, x);
  values[0] = u[0];
  values[1] = u[1];
}
} // namespace Signorini
