// SPDX-License-Identifier: LGPL-2.1-or-later
// Maps of cells with exact arcs.

#include <signorini/discretization/mesh/arc_mapping.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <cmath>

namespace Signorini {
ArcCentres arc_centres(const std::vector<Side<2>> &sides,
                       const Triangulation<2>::cell_iterator &cell) {
  ArcCentres centres;
  // Where sides end inside of coarse faces, which are straight, these have no number yet.
  for (const unsigned int f : cell->face_indices())
    if (const auto face = cell->face(f); cell->at_boundary(f) && face->boundary_id() < sides.size())
      centres[f] = sides[face->boundary_id()].centre_at(face->vertex(0) +
                                                        0.5 * (face->vertex(1) - face->vertex(0)));
  return centres;
}

ArcMapping::ArcMapping(const Mapping<2> &mapping, const std::vector<Side<2>> &sides)
  : MappingQ<2>(exact_degree)
  , mapping_(mapping)
  , sides_(sides)
  , nodes_(FE_Q<2>(get_degree()).get_unit_support_points()) {}

std::vector<Point<2>>
ArcMapping::compute_mapping_support_points(const Triangulation<2>::cell_iterator &cell) const {
  std::vector<Point<2>> points;
  for (const Point<2> &node : nodes_)
    points.push_back(mapping_.transform_unit_to_real_cell(cell, node));
  const ArcCentres centres = arc_centres(sides_, cell);
  for (const unsigned int f : cell->face_indices()) {
    if (!centres[f])
      continue;
    const unsigned int across = f / 2;
    const Curve arc =
      Curve::between(cell->face(f)->vertex(0), cell->face(f)->vertex(1), centres[f]);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Point<2> on_face = nodes_[i];
      on_face[across] = f % 2;
      points[i] += (1. - std::abs(nodes_[i][across] - on_face[across])) *
                   (arc.point(on_face[1 - across] * arc.length()) -
                    mapping_.transform_unit_to_real_cell(cell, on_face));
    }
  }
  return points;
}

ExactMaps::ExactMaps(const Mesh<2> &mesh, const std::vector<Side<2>> &sides)
  : mesh_(mesh)
  , sides_(sides) {
  if (mesh.is_curved() && mesh.is_graded()) {
    auto cached = std::make_unique<MappingQCache<2>>(ArcMapping::exact_degree);
    cached->initialize(MappingQ<2>(ArcMapping::exact_degree), mesh.triangulation());
    exact_ = std::move(cached);
  } else if (mesh.is_curved())
    exact_ = std::make_unique<ArcMapping>(mesh.mapping(), sides);
}
} // namespace Signorini
