// SPDX-License-Identifier: LGPL-2.1-or-later
// From a plan to a mesh with degrees: the cells that meet a corner, or the bracket of an end of
// contact, are split.

#include <signorini/discretization/mesh/mesh_plan.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns whether the part [from, to] of a side meets a face on it. */
bool meets_face(const Side<2> &side, const double from, const double to,
                const Triangulation<2>::face_iterator &face) {
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
                          const Triangulation<2>::active_cell_iterator &cell) const {
  if (scene.geometry.body_of(cell) != body)
    return false;
  if (kind == Kind::corner) {
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

const Singularity *nearest(const std::vector<Singularity> &singularities, const Point<2> &x,
                           const unsigned int body) {
  const auto closer = [&x](const Singularity &a, const Singularity &b) {
    return a.point.distance_square(x) < b.point.distance_square(x);
  };
  const Singularity *found = nullptr;
  for (const Singularity &singularity : singularities)
    if (singularity.layers > 0. && singularity.body == body &&
        (found == nullptr || closer(singularity, *found)))
      found = &singularity;
  return found;
}

namespace {
/** The deepest level. The numbers of cells (CellId) end at level 30; coordinates in double
 * precision hardly resolve more vertices. */
constexpr int max_cell_level = 29;

/** Returns the lowest degree that demands require of a cell, or of a cell that it is a part of. */
unsigned int demanded_degree(const MeshPlan &plan,
                             const Triangulation<2>::active_cell_iterator &cell) {
  if (plan.demands.empty())
    return 0;
  unsigned int degree = 0;
  for (Triangulation<2>::cell_iterator ancestor = cell;; ancestor = ancestor->parent()) {
    const auto found = plan.demands.find(ancestor->id());
    if (found != plan.demands.end())
      degree = std::max(degree, found->second.degree);
    if (ancestor->level() == 0)
      return degree;
  }
}

/** Raises degrees until those of neighbours differ by one at most. */
void level_out(const Mesh<2> &mesh, std::vector<unsigned int> &degrees) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      for (const unsigned int f : cell->face_indices()) {
        if (cell->at_boundary(f) || !cell->neighbor(f)->is_active())
          continue;
        unsigned int &mine = degrees[cell->active_cell_index()];
        unsigned int &other = degrees[cell->neighbor(f)->active_cell_index()];
        unsigned int &lower = mine < other ? mine : other;
        const unsigned int wanted = std::max(mine, other) - 1;
        changed = changed || lower < wanted;
        lower = std::max(lower, wanted);
      }
  }
}
} // namespace

bool is_deepest(const Triangulation<2>::active_cell_iterator &cell) {
  return cell->level() >= max_cell_level;
}

bool MeshPlan::must_split(const Scene<2> &scene, const Triangulation<2>::active_cell_iterator &cell,
                          const unsigned int n_splits) const {
  if (is_deepest(cell))
    return false;
  for (const Singularity &singularity : singularities)
    if (n_splits + 0.5 < singularity.layers && singularity.touches(scene, cell))
      return true;
  if (demands.empty())
    return false;
  const auto found = demands.find(cell->id());
  return found != demands.end() && found->second.split;
}

Mesh<2> make_mesh(const MeshPlan &plan, const Scene<2> &scene) {
  const unsigned int mapping_degree =
    std::min(plan.max_element_degree, 2 + static_cast<unsigned int>(plan.rise));
  return Mesh<2>(
    scene.geometry, plan.base_level, plan.guides,
    [&](const Triangulation<2>::active_cell_iterator &cell, const unsigned int n_splits) {
      return plan.must_split(scene, cell, n_splits);
    },
    mapping_degree);
}

unsigned int planned_degree(const MeshPlan &plan, const Mesh<2> &mesh, const unsigned int body,
                            const Triangulation<2>::active_cell_iterator &cell) {
  double share = 1.;
  if (const Singularity *const singularity = nearest(plan.singularities, cell->center(), body)) {
    // The layers that a graded mesh has at this distance; demands may have split the cell further.
    const double distance = cell->center().distance(singularity->point);
    const double size = plan.size_in(body);
    const double by_distance =
      std::max(0., 1. + std::log2(size / std::max(distance, 1e-30 * size)));
    const double layer = std::min<double>(mesh.splits(cell), by_distance);
    share = std::max(0., 1. - layer / singularity->layers);
  }
  const auto degree = 2 + static_cast<unsigned int>(plan.rise * share + 1e-9);
  return std::min(plan.max_element_degree, std::max(degree, demanded_degree(plan, cell)));
}

std::vector<unsigned int> plan_degrees(const MeshPlan &plan, const Scene<2> &scene,
                                       const Mesh<2> &mesh) {
  std::vector<unsigned int> degrees(mesh.triangulation().n_active_cells());
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    degrees[cell->active_cell_index()] =
      planned_degree(plan, mesh, scene.geometry.body_of(cell), cell);
  level_out(mesh, degrees);
  return degrees;
}
} // namespace Signorini
