// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh as edges that carry tractions.

#include <signorini/error_control/loads/composite_cell.h>
#include <signorini/error_control/loads/edge_mesh.h>

#include <deal.II/fe/mapping.h>

namespace Signorini {
namespace {
/** The vertices of a cell of deal.II counter-clockwise, and the lines between them. */
constexpr std::array<unsigned int, 4> vertex_in_circle = {{0, 1, 3, 2}};
constexpr std::array<unsigned int, 4> line_in_circle = {{2, 1, 3, 0}};

constexpr unsigned int none = static_cast<unsigned int>(-1);

EdgeFreedom freedom_of(const Role role) {
  if (role == Role::clamped || role == Role::displacement)
    return EdgeFreedom::any;
  return role == Role::roller ? EdgeFreedom::normal : EdgeFreedom::none;
}

/** Sets the bulges of a cell. */
void find_bulges(const Mapping<2> &mapping, const Triangulation<2>::active_cell_iterator &cell,
                 EdgeCell &here) {
  const std::array<Point<2>, 5> middles = {
    {{0.5, 0.}, {1., 0.5}, {0.5, 1.}, {0., 0.5}, {0.5, 0.5}}};
  const CellShape flat(here.corners);
  const double size = here.corners[0].distance(here.corners[2]);
  for (unsigned int i = 0; i < 5; ++i) {
    here.bulges[i] = mapping.transform_unit_to_real_cell(cell, middles[i]) - here.corners[0] -
                     flat.offset(CellFunctions(middles[i]), false);
    here.is_curved = here.is_curved || here.bulges[i].norm() > 1e-12 * size;
  }
  for (unsigned int k = 0; k < 4; ++k)
    here.bulges[4] -= 0.5 * here.bulges[k];
  if (!here.is_curved)
    here.bulges = Bulges();
}
} // namespace

EdgeMesh::EdgeMesh(const DisplacementSpace<2> &space, const Scene<2> &scene)
  : stars_(space.mesh().triangulation().n_vertices())
  , dofs_(space.mesh().triangulation().n_vertices()) {
  collect_cells(space, scene);
  collect_stars();
}

void EdgeMesh::collect_cells(const DisplacementSpace<2> &space, const Scene<2> &scene) {
  const auto &triangulation = space.mesh().triangulation();
  edge_of_line_.assign(triangulation.n_raw_lines(), none);
  cells_.reserve(triangulation.n_active_cells());
  edges_.reserve(2 * triangulation.n_active_cells());
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    EdgeCell &here = cells_.emplace_back();
    for (unsigned int k = 0; k < 4; ++k) {
      const unsigned int v = vertex_in_circle[k];
      here.corners[k] = cell->vertex(v);
      here.vertices[k] = cell->vertex_index(v);
      dofs_[here.vertices[k]] = {{cell->vertex_dof_index(v, 0), cell->vertex_dof_index(v, 1)}};
    }
    if (space.mesh().is_curved())
      find_bulges(space.mesh().mapping(), cell, here);
    is_curved_ = is_curved_ || here.is_curved;
    for (unsigned int k = 0; k < 4; ++k) {
      const auto line = cell->line(line_in_circle[k]);
      unsigned int &edge = edge_of_line_[line->index()];
      here.sign[k] = edge == none ? 1. : -1.;
      if (edge == none) {
        edge = edges_.size();
        const Tensor<1, 2> d = here.edge_vector(k);
        Edge &new_edge = edges_.emplace_back(Edge{{{here.vertices[k], here.vertices[(k + 1) % 4]}},
                                                  EdgeFreedom::any,
                                                  Edge::no_side,
                                                  Tensor<1, 2>({d[1], -d[0]}) / d.norm(),
                                                  d.norm()});
        if (line->at_boundary()) {
          new_edge.side = line->boundary_id();
          new_edge.freedom = freedom_of(scene.boundary[new_edge.side].role);
        }
      }
      here.edges[k] = edge;
      here.reversed[k] = edges_[edge].vertices[0] != here.vertices[k];
    }
  }
}

void EdgeMesh::collect_stars() {
  // The corners at the first and second cell of every edge, with k its number there.
  std::vector<std::array<CellCorner, 2>> neighbours(edges_.size(), {{{none, 0}, {none, 0}}});
  std::vector<CellCorner> first(stars_.size(), {none, 0});
  for (unsigned int c = 0; c < cells_.size(); ++c)
    for (unsigned int k = 0; k < 4; ++k) {
      neighbours[cells_[c].edges[k]][cells_[c].sign[k] > 0. ? 0 : 1] = {c, k};
      // Edge k is to the right of corner k: a star at the boundary begins with a boundary edge.
      CellCorner &start = first[cells_[c].vertices[k]];
      if (start.cell == none || edges_[cells_[c].edges[k]].is_boundary())
        start = {c, k};
    }
  for (unsigned int v = 0; v < stars_.size(); ++v)
    if (first[v].cell != none)
      stars_[v] = walk(first[v], neighbours);
}

Star EdgeMesh::walk(const CellCorner &first,
                    const std::vector<std::array<CellCorner, 2>> &neighbours) const {
  Star star;
  CellCorner corner = first;
  for (;;) {
    const EdgeCell &cell = cells_[corner.cell];
    const unsigned int k = corner.number, left = (k + 3) % 4;
    star.cells.push_back(corner);
    star.spokes.push_back({cell.edges[k], cell.reversed[k] ? 1U : 0U, cell.sign[k]});
    const unsigned int edge = cell.edges[left];
    const CellCorner next = neighbours[edge][cell.sign[left] > 0. ? 1 : 0];
    if (next.cell == none) {
      star.spokes.push_back({edge, cell.reversed[left] ? 0U : 1U, -cell.sign[left]});
      return star;
    }
    // In the next cell, the edge is to the right of the vertex.
    corner = next;
    if (corner.cell == first.cell)
      return star;
  }
}

CellMoments moments_on(const EdgeCell &cell, const std::vector<double> &moments) {
  CellMoments values;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int end = 0; end < 2; ++end) {
      const unsigned int at = EdgeMesh::position(cell, k, end);
      values[4 * k + 2 * end] = cell.sign[k] * moments[at];
      values[4 * k + 2 * end + 1] = cell.sign[k] * moments[at + 1];
    }
  return values;
}

void add_moments(const EdgeCell &cell, const CellMoments &values, std::vector<double> &moments) {
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int end = 0; end < 2; ++end) {
      const unsigned int at = EdgeMesh::position(cell, k, end);
      moments[at] += cell.sign[k] * values[4 * k + 2 * end];
      moments[at + 1] += cell.sign[k] * values[4 * k + 2 * end + 1];
    }
}
} // namespace Signorini
