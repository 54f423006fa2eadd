// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c as the mesh sees it.

#include <signorini/mesh/contact_boundary.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** The arc lengths of both ends of a face; where a closed side ends, 0 is its length. */
template <int dim, typename Face>
std::pair<double, double> arc_lengths_of(const Face &face, const Side<dim> &side)
{
  std::pair<double, double> ends = {side.arc_length(face->vertex(0)),
                                    side.arc_length(face->vertex(1))};
  if (!side.is_closed())
    return ends;
  const double middle =
    side.arc_length(face->vertex(0) + 0.5 * (face->vertex(1) - face->vertex(0)));
  for (double *const end : {&ends.first, &ends.second})
    *end += side.length() * std::round((middle - *end) / side.length());
  return ends;
}
} // namespace

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
      const auto [first, last] = arc_lengths_of(cell->face(f), side);
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
