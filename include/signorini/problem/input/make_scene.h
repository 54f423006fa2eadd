// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/named_scene.h>
#include <signorini/problem/scene/scene.h>

#include <string>

namespace Signorini {
/** Returns the dimension, 2 or 3, that the parameters give or that the named scene has. */
unsigned int dimension_of(const Parameters &parameters, const NamedScenes &known = {});

/** Returns the text of the mesh file that Geometry/File names, or that Gmsh makes of it.
 * @throws InputError */
std::string read_mesh_file(const GeometryParameters &given, unsigned int dim);

/** Returns the scene that the parameters name or describe. @throws InputError */
template <int dim>
Scene<dim> make_scene(const Parameters &parameters, const NamedScenes &known = {});
template <>
Scene<2> make_scene(const Parameters &parameters, const NamedScenes &known);
template <>
Scene<3> make_scene(const Parameters &parameters, const NamedScenes &known);

/** Returns the scene that a parameter file describes by expressions. @throws InputError */
template <int dim>
Scene<dim> make_described_scene(const Parameters &parameters);
} // namespace Signorini
