// SPDX-License-Identifier: LGPL-2.1-or-later
// Which cells meet a corner, or the bracket of an end of contact.

#include <signorini/refinement/singularity.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** Whether the part [from, to] of a side meets a face on it. */
bool meets_face(const Side<2> &side,
                const double from,
                const double to,
                const dealii::Triangulation<2>::face_iterator &face)
{
  double first = side.arc_length(face->vertex(0)), last = side.arc_length(face->vertex(1));
  const double middle = 0.5 * (from + to);
  if (side.is_closed())
    for (double *const end : {&first, &last})
      *end += side.length() * std::round((middle - *end) / side.length());
  const double tolerance = 1e-6 * std::abs(last - first);
  // Around a closed side the ends of a face opposite to the bracket may be one turn apart.
  if (std::abs(last - first) > 0.5 * side.length() && side.is_closed())
    return false;
  return std::max(std::min(first, last), from) <= std::min(std::max(first, last), to) + tolerance;
}
} // namespace

bool Singularity::touches(const Scene<2> &scene,
                          const dealii::Triangulation<2>::active_cell_iterator &cell) const
{
  if (kind == Kind::corner)
  {
    const double tolerance = 1e-3 * cell->diameter();
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex(v).distance(point) < tolerance)
        return true;
    return false;
  }
  if (!cell->at_boundary())
    return false;
  for (const auto &face : cell->face_iterators())
    if (face->at_boundary() && face->boundary_id() == side &&
        meets_face(scene.geometry.sides[side], from, to, face))
      return true;
  return false;
}

const Singularity *nearest(const std::vector<Singularity> &singularities, const dealii::Point<2> &x)
{
  const auto closer = [&x](const Singularity &a, const Singularity &b) {
    return a.point.distance_square(x) < b.point.distance_square(x);
  };
  const Singularity *found = nullptr;
  for (const Singularity &singularity : singularities)
    if (singularity.layers > 0. && (found == nullptr || closer(singularity, *found)))
      found = &singularity;
  return found;
}
} // namespace Signorini
