// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c as the mesh sees it.

#include <signorini/mesh/contact_boundary.h>

#include <algorithm>

namespace Signorini
{
template <int dim>
std::vector<ContactFace<dim>> find_contact_faces(const Mesh<dim> &mesh, const Scene<dim> &scene)
{
  std::vector<ContactFace<dim>> faces;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->face(f)->at_boundary())
        continue;
      const unsigned int number = cell->face(f)->boundary_id();
      if (scene.boundary[number].role != Role::contact)
        continue;
      const Side<dim> &side = scene.geometry.sides[number];
      const double first = side.arc_length(cell->face(f)->vertex(0));
      const double last = side.arc_length(cell->face(f)->vertex(1));
      faces.push_back(
        {cell, f, number, std::min(first, last), std::max(first, last), last < first});
    }
  std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
    return a.side != b.side ? a.side < b.side : a.start < b.start;
  });
  return faces;
}

template std::vector<ContactFace<2>> find_contact_faces(const Mesh<2> &, const Scene<2> &);
} // namespace Signorini
