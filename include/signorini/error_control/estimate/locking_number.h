// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini {
/**
 * Returns the locking number K/μ (h/l)² with the largest ratio of bulk to shear modulus K =
 * I:E:I/dim² and μ, half the smallest d:E:d of a deviator d of norm one, the longest edge h and
 * the body's size l. Where bodies are nearly incompressible (K/μ > 10, Poisson's ratio above
 * 0.45), bilinear elements with the full strain need the number to be well below one: their
 * pressures exceed the true ones by about that part. Where an arc is in contact, it is K/μ h/l:
 * curved cells have no strains without dilatation, and at the ends of the arc single pressures
 * are wrong by about that part.
 * @return 0 for other bodies.
 */
template <int dim>
double locking_number(const Mesh<dim> &mesh, const Scene<dim> &scene);
} // namespace Signorini
