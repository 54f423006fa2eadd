// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/grid/tria.h>

#include <ostream>
#include <vector>

namespace Signorini {
/** Points along a side with the data that belongs to its role there: the gap, or the components of
 * a traction or a displacement; empty where the role has none. */
struct SideSamples {
  std::vector<Point<2>> points;
  std::vector<Tensor<1, 2>> normals;
  std::vector<std::vector<double>> values;
};

/** Returns points at equal distances along a side. */
SideSamples sample_side(const Scene<2> &scene, unsigned int side);

/** Writes scene.json: sides with names, roles, points, normals and data; the corners of the first
 * mesh's cells. */
void write_scene_json(std::ostream &stream, const Scene<2> &scene,
                      const Triangulation<2> &first_mesh);
} // namespace Signorini
