// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that move as rigid plates.

#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/plate.h>

namespace Signorini {
Tensor<1, 2> Plate::displacement(const PlateMotion &motion, const Point<2> &x) const {
  const Tensor<1, 2> arm = x - centre;
  return motion.travel * direction + motion.drift * across() +
         motion.rotation * Tensor<1, 2>({-arm[1], arm[0]});
}

std::shared_ptr<const Function<2>> plate_displacement(const Plate &plate,
                                                      const PlateMotion &motion) {
  // Who reads a constant knows that it is one.
  if (!plate.turns) {
    const Tensor<1, 2> u = plate.displacement(motion, plate.centre);
    return std::make_shared<Functions::ConstantFunction<2>>(std::vector<double>{u[0], u[1]});
  }
  return std::make_shared<FieldFunction<2>>(
    [plate, motion](const Point<2> &x) { return plate.displacement(motion, x); });
}

} // namespace Signorini
