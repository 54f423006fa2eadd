// SPDX-License-Identifier: LGPL-2.1-or-later
// The reactions of plates.

#include <signorini/postprocess/plate_forces.h>

namespace Signorini
{
template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space,
                                     const Scene<dim> &scene,
                                     const NodalForces &forces)
{
  std::vector<PlateForce> result;
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
  {
    const auto work_on = [&](const PlateMotion &motion) {
      std::vector<PlateMotion> motions(scene.plates.size());
      motions[p] = motion;
      return space.prescribed(with_only_plates_moved(scene, motions)) * forces.residual;
    };
    result.push_back({work_on({1., 0.}), work_on({0., 1.})});
  }
  return result;
}

template std::vector<PlateForce> plate_forces(const DisplacementSpace<2> &,
                                              const Scene<2> &,
                                              const NodalForces &);
template std::vector<PlateForce> plate_forces(const DisplacementSpace<3> &,
                                              const Scene<3> &,
                                              const NodalForces &);
} // namespace Signorini
