// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh on which the stress of the bound lives.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/equilibration_mesh.h>
#include <signorini/error_control/loads/law.h>

#include <algorithm>

namespace Signorini {
namespace {
/** The highest degree of stresses, for which the functions of AiryCell are independent enough. */
constexpr unsigned int max_degree = 11;
/** The degree of tractions on the largest cells of a mesh of its own. */
constexpr unsigned int most = 5;

/** Returns the points near which stresses are not smooth: ends and corners of sides, and borders
 * of patches between those that press, stick or slip in one direction and others. */
std::vector<Point<2>> singular_points(const BoundData &data) {
  std::vector<Point<2>> points;
  for (const Side<2> &side : data.scene.geometry.sides) {
    if (!side.is_closed())
      points.insert(points.end(), {side.start(), side.end()});
    for (const double s : side.corners())
      points.push_back(side.point(s));
  }
  const std::vector<NodeState> states = patch_states(data.multipliers, data.P);
  const auto &patches = data.multipliers.surface().patches();
  for (std::size_t i = 0; i + 1 < patches.size(); ++i)
    if (patches[i].side == patches[i + 1].side && states[i] != states[i + 1])
      points.push_back(data.scene.geometry.sides[patches[i].side].point(patches[i].upper[0]));
  return points;
}
} // namespace

EquilibrationMesh::EquilibrationMesh(const BoundData &data)
  : data_(data)
  , finest_(data.space.mesh().level()) {
  if (data.space.mesh().is_graded())
    return;
  own_ = std::make_unique<Triangulation<2>>();
  data.scene.geometry.make_coarse_mesh(*own_);
  // Edges are straight except on curved sides, so that nodes hang on them.
  for (const auto &cell : own_->active_cell_iterators()) {
    cell->set_manifold_id(numbers::flat_manifold_id);
    for (const unsigned int f : cell->face_indices())
      if (!is_on_curve(cell, f))
        cell->face(f)->set_manifold_id(numbers::flat_manifold_id);
  }
  constexpr unsigned int most_generations = 4;
  constexpr double least_cells = 64.;
  double n_cells = data.space.mesh().triangulation().n_active_cells();
  unsigned int base = finest_;
  while (base > 0 && finest_ - base < most_generations && (n_cells /= 4.) >= least_cells)
    --base;
  own_->refine_global(base);
  constexpr unsigned int many_cells = 4096;
  lowest_ = own_->n_active_cells() > many_cells ? 1 : 2;
  const std::vector<Point<2>> singular = singular_points(data);
  for (bool changed = true; changed;) {
    std::vector<Cell> rough;
    for (const auto &cell : own_->active_cell_iterators())
      if (is_rough(cell, singular))
        rough.push_back(cell);
    changed = refine(rough, false);
  }
  if (data.scene.geometry.number_after_refinement)
    data.scene.geometry.number_after_refinement(*own_);
}

bool EquilibrationMesh::is_on_curve(const Cell &cell, const unsigned int face_no) const {
  return data_.space.mesh().is_curved() && cell->at_boundary(face_no) &&
         !data_.scene.geometry.sides[cell->face(face_no)->boundary_id()].is_flat();
}

bool EquilibrationMesh::is_rough(const Cell &cell, const std::vector<Point<2>> &singular) const {
  if (static_cast<unsigned int>(cell->level()) == finest_)
    return false;
  const auto box = cell->bounding_box();
  if (std::any_of(singular.begin(), singular.end(),
                  [&](const Point<2> &x) { return box.point_inside(x, 1e-10); }))
    return true;
  for (const unsigned int f : cell->face_indices())
    if (is_on_curve(cell, f))
      return true;
  if (data_.scene.material->is_constant())
    return false;
  return needs_cuts<2>(data_.scene.law_kinks, cell) ||
         law_varies(*data_.scene.material, corners_of(cell));
}

bool EquilibrationMesh::refine(const std::vector<Cell> &cells, const bool by_degree) {
  bool splits = false, rises = false;
  for (const Cell &cell : cells) {
    const bool can_split = own_ && static_cast<unsigned int>(cell->level()) < finest_,
               can_rise = by_degree && inner_degree(cell) + 2 <= (can_split ? 7 : max_degree);
    if (can_split && (is_aligned() || !can_rise)) {
      cell->set_refine_flag();
      splits = true;
    } else if (can_rise) {
      raised_[cell->id()] += 2;
      rises = true;
    }
  }
  if (splits)
    own_->execute_coarsening_and_refinement();
  return splits || rises;
}

unsigned int EquilibrationMesh::inner_degree(const Cell &cell) const {
  const auto raised = raised_.find(cell->id());
  return std::max(2U, degree(cell)) + (raised == raised_.end() ? 0 : raised->second);
}

unsigned int EquilibrationMesh::degree(const Cell &cell) const {
  if (!own_)
    return data_.space.element(cell).degree;
  return std::min(lowest_ + finest_ - cell->level(), most);
}

EquilibrationMesh::Cell EquilibrationMesh::find(const Cell &cell_of_u) const {
  const CellId id = cell_of_u->id();
  Triangulation<2>::cell_iterator cell(own_.get(), 0, id.get_coarse_cell_id());
  for (const std::uint8_t child : id.get_child_indices()) {
    if (cell->is_active())
      break;
    cell = cell->child(child);
  }
  return cell;
}
} // namespace Signorini
