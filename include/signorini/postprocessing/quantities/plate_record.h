// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/problem/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini {
/** The position of a plate, and the forces that hold it there. What a plate does across its
 * direction, rotations and moments are one number in 2-D, three in 3-D. */
struct PlateRecord {
  std::string side;
  AnswerVector direction, centre;
  /** Whether forces drive the drift, and moments the rotation. */
  bool drifts = false, turns = false;
  /** The motion: along the direction, across it (length), and about the centre (radians). */
  double travel = 0.;
  AnswerVector drift, rotation;
  /** The force on the body through the plate along and across its direction, and the moment about
   * its centre. They come from the nodal forces, also if they are given. */
  double force = 0.;
  AnswerVector cross_force, moment;
};

/** Returns the records of all plates. @param forces one for each; empty: not known. */
template <int dim>
std::vector<PlateRecord> plate_records(const Scene<dim> &scene,
                                       const std::vector<PlateMotion<dim>> &motions,
                                       const std::vector<PlateForce<dim>> &forces);
} // namespace Signorini
