// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh on which the stress of the bound lives.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/arc_lift.h>
#include <signorini/error_control/equilibration/equilibration_mesh.h>
#include <signorini/error_control/equilibration/law.h>
#include <signorini/problem/scene/contact_pair.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace Signorini {
namespace {
/** The highest degree of stresses, for which the functions of AiryCell are independent enough. */
constexpr unsigned int max_degree = 11;
/** The degree of tractions on the largest cells of a mesh of its own. */
constexpr unsigned int most = 5;

/** Returns the points near which stresses are not smooth: ends and corners of sides, borders of
 * patches between those that press, stick or slip in one direction and others, and points where the
 * direction of contact changes. */
std::vector<Point<2>> singular_points(const BoundData &data) {
  std::vector<Point<2>> points;
  for (const Side<2> &side : data.scene.geometry.sides) {
    if (!side.is_closed())
      points.insert(points.end(), {side.start(), side.end()});
    for (const double s : side.corners())
      points.push_back(side.point(s));
  }
  for (const ContactCondition<2> &contact : data.scene.contacts)
    for (const double s : contact.directions.changes())
      points.push_back(data.scene.geometry.sides[contact.side].point(s));
  const std::vector<NodeState> states = patch_states(data.multipliers, data.P);
  const auto &patches = data.multipliers.surface().patches();
  const auto add = [&](const ContactPair<2> &pair, const double s) {
    const std::vector<Side<2>> &sides = data.scene.geometry.sides;
    const Point<2> &x = points.emplace_back(sides[pair.side()].point(s));
    if (const auto &other = pair.other_side())
      points.push_back(sides[*other].point(sides[*other].arc_length(Point<2>(x))));
  };
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const ContactPair<2> pair(data.scene, patches[i].contact);
    const bool is_last = i + 1 == patches.size() || patches[i + 1].contact != pair.number(),
               is_first = i == 0 || patches[i - 1].contact != pair.number();
    const bool is_of_bodies = pair.other_side().has_value();
    if (is_first && is_of_bodies)
      add(pair, patches[i].lower[0]);
    if (is_last ? is_of_bodies : states[i] != states[i + 1])
      add(pair, patches[i].upper[0]);
  }
  return points;
}

/** Returns the cell of another mesh with the same coarse mesh, or the active one that contains it.
 */
Triangulation<2>::cell_iterator follow(const Triangulation<2> &mesh, const CellId &id) {
  Triangulation<2>::cell_iterator cell(&mesh, 0, id.get_coarse_cell_id());
  for (const std::uint8_t child : id.get_child_indices()) {
    if (cell->is_active())
      break;
    cell = cell->child(child);
  }
  return cell;
}

/** Moves each hanging node to the middle of its edge, which is straight. Large cells come first: an
 * edge may end in nodes that hang on larger ones. All others keep the positions that manifolds give
 * them: between nodes on chords a thin curved body would have no cells. */
void straighten(Triangulation<2> &mesh) {
  for (unsigned int level = 0; level + 1 < mesh.n_levels(); ++level)
    for (const auto &cell : mesh.active_cell_iterators_on_level(level))
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          face->child(0)->vertex(1) = face->vertex(0) + 0.5 * (face->vertex(1) - face->vertex(0));
}
} // namespace

EquilibrationMesh::EquilibrationMesh(const BoundData &data)
  : data_(data)
  , finest_(data.space.mesh().level()) {
  if (is_that_of_u(data))
    return;
  own_ = std::make_unique<Triangulation<2>>();
  const bool is_graded = data.space.mesh().is_graded();
  if (is_graded) {
    const auto &[vertices, cells, edges] =
      GridTools::get_coarse_mesh_description(data.space.mesh().triangulation());
    own_->create_triangulation(vertices, cells, edges);
  } else
    data.scene.geometry.make_coarse_mesh(*own_);
  constexpr unsigned int most_generations = 4;
  constexpr double least_cells = 64.;
  double n_cells = data.space.mesh().triangulation().n_active_cells();
  unsigned int base = finest_;
  while (base > 0 && finest_ - base < most_generations && (n_cells /= 4.) >= least_cells)
    --base;
  if (is_graded)
    split_like_u();
  else
    own_->refine_global(base);
  straighten(*own_);
  constexpr unsigned int many_cells = 4096;
  lowest_ = own_->n_active_cells() > many_cells ? 1 : 2;
  const std::vector<Point<2>> singular = singular_points(data);
  for (bool changed = !is_graded; changed;) {
    std::vector<Cell> rough;
    for (const auto &cell : own_->active_cell_iterators())
      if (is_rough(cell, singular))
        rough.push_back(cell);
    changed = refine(rough, false);
  }
  if (data.scene.geometry.number_after_refinement)
    data.scene.geometry.number_after_refinement(*own_);
}

bool EquilibrationMesh::is_rough(const Cell &cell, const std::vector<Point<2>> &singular) const {
  if (static_cast<unsigned int>(cell->level()) == finest_)
    return false;
  const auto box = cell->bounding_box();
  if (std::any_of(singular.begin(), singular.end(),
                  [&](const Point<2> &x) { return box.point_inside(x, 1e-10); }))
    return true;
  if (!ArcLift::sees_arcs(shape_of(cell, data_.scene.geometry.sides)))
    return true;
  if (data_.scene.material->is_constant_on_cells())
    return false;
  return needs_cuts<2>(data_.scene.law_kinks, cell) ||
         law_varies(*data_.scene.material, corners_of(cell));
}

void EquilibrationMesh::split_like_u() {
  // Manifolds know neither distorted vertices nor those on lines of the data.
  own_->set_all_manifold_ids(numbers::flat_manifold_id);
  for (bool changed = true; changed; own_->execute_coarsening_and_refinement()) {
    changed = false;
    for (const auto &cell : own_->active_cell_iterators())
      if (follow(data_.space.mesh().triangulation(), cell->id())->has_children()) {
        cell->set_refine_flag();
        changed = true;
      }
  }
  for (const auto &cell : own_->active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      cell->vertex(v) = follow(data_.space.mesh().triangulation(), cell->id())->vertex(v);
}

bool EquilibrationMesh::refine(const std::vector<Cell> &cells, const bool by_degree) {
  bool splits = false, rises = false;
  for (const Cell &cell : cells) {
    // Tractions are integrated face by face of u_h.
    const bool can_split = own_ && !data_.space.mesh().is_graded() &&
                           static_cast<unsigned int>(cell->level()) < finest_,
               can_rise = by_degree && inner_degree(cell) + 2 <= (can_split ? 7 : max_degree);
    if (can_split && (is_aligned() || !can_rise)) {
      cell->set_refine_flag();
      splits = true;
    } else if (can_rise) {
      raised_[cell->id()] += 2;
      rises = true;
    }
  }
  if (splits) {
    own_->execute_coarsening_and_refinement();
    straighten(*own_);
  }
  return splits || rises;
}

unsigned int EquilibrationMesh::boundary_degree(const Cell &cell) const {
  const auto raised = raised_.find(cell->id());
  return degree(cell) + (raised == raised_.end() ? 0 : raised->second);
}

unsigned int EquilibrationMesh::inner_degree(const Cell &cell) const {
  return std::max(2U, degree(cell)) + boundary_degree(cell) - degree(cell);
}

unsigned int EquilibrationMesh::degree(const Cell &cell) const {
  if (!own_)
    return data_.space.element(cell).degree;
  if (data_.space.mesh().is_graded())
    return std::max(
      3U, data_.space.element(follow(data_.space.mesh().triangulation(), cell->id())).degree);
  return std::min(lowest_ + finest_ - cell->level(), most);
}

EquilibrationMesh::Cell EquilibrationMesh::find(const Cell &cell_of_u) const {
  return follow(*own_, cell_of_u->id());
}
} // namespace Signorini
