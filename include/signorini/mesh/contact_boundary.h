// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/mesh/mesh.h>
#include <signorini/scene/scene.h>

#include <algorithm>
#include <vector>

namespace Signorini
{
/** A mesh face on a contact side. */
template <int dim>
struct ContactFace
{
  typename dealii::Triangulation<dim>::active_cell_iterator cell;
  unsigned int face_no;
  /** Number of the side in the geometry. */
  unsigned int side;
  /** Arc length along the side, start < end. */
  double start;
  double end;
  /** Whether the face's own parameter runs against the arc length. */
  bool reversed;

  /** The face's own parameter in [0,1] of the point at arc length @p s. */
  double parameter(const double s) const
  {
    const double t = (s - start) / (end - start);
    return reversed ? 1. - t : t;
  }
  /** The parameters, sorted, of both ends of [s0, s1]; exactly 0 and 1 for the whole face. */
  std::vector<double> parameters_between(const double s0, const double s1) const
  {
    const double first = s0 == start ? (reversed ? 1. : 0.) : parameter(s0);
    const double last = s1 == end ? (reversed ? 0. : 1.) : parameter(s1);
    return {std::min(first, last), std::max(first, last)};
  }
};

/** The faces of all contact sides, side after side, in the order of arc length. */
template <int dim>
std::vector<ContactFace<dim>> find_contact_faces(const Mesh<dim> &mesh, const Scene<dim> &scene);
} // namespace Signorini
