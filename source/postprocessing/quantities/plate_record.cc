// SPDX-License-Identifier: LGPL-2.1-or-later
// Plates as the answer has them.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/quantities/plate_record.h>

namespace Signorini {
namespace {
AnswerVector numbers_of(const double x) {
  return AnswerVector({x});
}
AnswerVector numbers_of(const Tensor<1, 3> &x) {
  return AnswerVector(x);
}
} // namespace

template <int dim>
std::vector<PlateRecord> plate_records(const Scene<dim> &scene,
                                       const std::vector<PlateMotion<dim>> &motions,
                                       const std::vector<PlateForce<dim>> &forces) {
  std::vector<PlateRecord> records;
  for (std::size_t p = 0; p < scene.plates.size(); ++p) {
    const Plate<dim> &plate = scene.plates[p];
    const PlateForce<dim> force = forces.empty() ? PlateForce<dim>() : forces[p];
    records.push_back({scene.geometry.sides[plate.side].name(), plate.direction, plate.centre,
                       plate.drifts, plate.turns, motions[p].travel, numbers_of(motions[p].drift),
                       numbers_of(motions[p].rotation), force.force, numbers_of(force.cross_force),
                       numbers_of(force.moment)});
  }
  return records;
}

INSTANTIATE_FUNCTION(plate_records);
} // namespace Signorini
