// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/grid/tria.h>

#include <ostream>
#include <string>
#include <vector>

namespace Signorini {
/** Points on a side with the data that belongs to its role there: the gap, or the components of
 * a traction or a displacement; empty where the role has none. */
template <int dim>
struct SideSamples {
  std::vector<Point<dim>> points;
  std::vector<Tensor<1, dim>> normals;
  std::vector<std::vector<double>> values;
};

/** Returns points at equal distances along a side; in space a grid of points on it. */
template <int dim>
SideSamples<dim> sample_side(const Scene<dim> &scene, unsigned int side);

/** The loads of the whole body. */
struct SceneNotes {
  /** Sentences for the picture. */
  std::vector<std::string> lines;
  /** The mean body force (force per volume); empty without one. */
  std::vector<double> body_force;
};

/** Writes scene.json: sides with names, roles, points, normals and data; the corners of the first
 * mesh's cells; the notes. In space sides have the faces of the first mesh instead. */
void write_scene_json(std::ostream &stream, const Scene<2> &scene,
                      const Triangulation<2> &first_mesh, const SceneNotes &notes);
void write_scene_json(std::ostream &stream, const Scene<3> &scene,
                      const Triangulation<3> &first_mesh, const SceneNotes &notes);
} // namespace Signorini
