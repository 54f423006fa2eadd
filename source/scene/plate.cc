// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that move as rigid plates.

#include <signorini/scene/field_function.h>
#include <signorini/scene/plate.h>

namespace Signorini
{
dealii::Tensor<1, 2> Plate::displacement(const PlateMotion &motion, const dealii::Point<2> &x) const
{
  const dealii::Tensor<1, 2> arm = x - centre;
  return motion.travel * direction + motion.rotation * dealii::Tensor<1, 2>({-arm[1], arm[0]});
}

std::shared_ptr<const dealii::Function<2>> plate_displacement(const Plate &plate,
                                                              const PlateMotion &motion)
{
  return std::make_shared<FieldFunction>(
    [plate, motion](const dealii::Point<2> &x) { return plate.displacement(motion, x); });
}
} // namespace Signorini
