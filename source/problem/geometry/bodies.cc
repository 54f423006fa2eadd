// SPDX-License-Identifier: LGPL-2.1-or-later
// Several bodies: one mesh with a component for each of them.

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/inside.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <limits>

namespace Signorini {
double signed_distance(const std::vector<Side<2>> &sides, const std::size_t first,
                       const std::size_t last, const Point<2> &x) {
  AssertIndexRange(first, last);
  AssertIndexRange(last, sides.size() + 1);
  double nearest = std::numeric_limits<double>::max(), depth = 0., size = 0.;
  for (std::size_t i = first; i < last; ++i)
    size = std::max(size, sides[i].length());
  const double rounding = 1e-12 * size;
  for (std::size_t i = first; i < last; ++i) {
    const double length = sides[i].length(), s = std::clamp(sides[i].arc_length(x), 0., length);
    const Tensor<1, 2> arm = x - sides[i].point(s);
    for (const double towards : {s - length, s + length}) {
      const double across = arm * sides[i].normal(s, towards);
      // At a corner the side that sees the point from the front tells.
      if (arm.norm() < nearest - rounding ||
          (arm.norm() < nearest + rounding && std::abs(across) > std::abs(depth))) {
        nearest = std::min(nearest, arm.norm());
        depth = across;
      }
    }
  }
  return depth <= 0. ? -nearest : nearest;
}

double distance_from_body(const Geometry<2> &geometry, const Point<2> &x) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < geometry.n_bodies(); ++k) {
    const bool is_last = k + 1 >= geometry.bodies.size();
    least = std::min(
      least,
      signed_distance(geometry.sides, geometry.bodies.empty() ? 0 : geometry.bodies[k].first_side,
                      is_last ? geometry.sides.size() : geometry.bodies[k + 1].first_side, x));
  }
  return least;
}

namespace {
/** Returns the number of the body in which a point lies; the box of most bodies tells. */
unsigned int body_at(const std::vector<Geometry<2>> &bodies, const Point<2> &x) {
  std::vector<unsigned int> candidates;
  for (unsigned int k = 0; k < bodies.size(); ++k)
    if (BoundingBox<2>({bodies[k].lower, bodies[k].upper}).point_inside(x))
      candidates.push_back(k);
  if (candidates.empty())
    return 0;
  const auto found =
    candidates.size() == 1
      ? candidates.begin()
      : std::find_if(candidates.begin(), candidates.end(), [&](const unsigned int k) {
          return signed_distance(bodies[k].sides, 0, bodies[k].sides.size(), x) <= 0.;
        });
  return found == candidates.end() ? candidates.front() : *found;
}

/** Makes the meshes of all bodies side by side; the material id of a cell is the number of its
 * body. Vertices at the same point stay apart. @param make_mesh makes a mesh without refined cells
 * of one body. */
template <typename MakeMesh>
void make_meshes(const std::vector<Geometry<2>> &bodies,
                 const std::vector<unsigned int> &first_side, const MakeMesh &make_mesh,
                 Triangulation<2> &triangulation) {
  std::vector<Point<2>> vertices;
  std::vector<CellData<2>> cells;
  SubCellData edges;
  std::map<types::manifold_id, std::unique_ptr<Manifold<2>>> manifolds;
  types::manifold_id first_manifold = 0;
  for (unsigned int k = 0; k < bodies.size(); ++k) {
    Triangulation<2> part;
    make_mesh(bodies[k], part);
    auto [points, part_cells, part_edges] = GridTools::get_coarse_mesh_description(part);
    types::manifold_id next = first_manifold;
    const auto renumber = [&](auto &object) {
      for (unsigned int &v : object.vertices)
        v += vertices.size();
      if (object.manifold_id == numbers::flat_manifold_id)
        return;
      const auto &manifold = part.get_manifold(object.manifold_id);
      object.manifold_id += first_manifold;
      next = std::max(next, object.manifold_id + 1);
      if (manifolds.count(object.manifold_id) == 0)
        manifolds[object.manifold_id] =
          dynamic_cast<const TransfiniteInterpolationManifold<2> *>(&manifold) != nullptr
            ? nullptr
            : manifold.clone();
    };
    for (CellData<2> &cell : part_cells) {
      renumber(cell);
      cell.material_id = k;
      cells.push_back(cell);
    }
    for (CellData<1> &edge : part_edges.boundary_lines) {
      renumber(edge);
      if (edge.boundary_id != numbers::internal_face_boundary_id)
        edge.boundary_id += first_side[k];
      edges.boundary_lines.push_back(edge);
    }
    vertices.insert(vertices.end(), points.begin(), points.end());
    first_manifold = next;
  }
  triangulation.create_triangulation(vertices, cells, edges);
  for (const auto &[id, manifold] : manifolds)
    if (manifold != nullptr)
      triangulation.set_manifold(id, *manifold);
  // A transfinite interpolation looks for its points in all cells of a mesh.
  for (const auto &[id, manifold] : manifolds)
    if (manifold == nullptr) {
      TransfiniteInterpolationManifold<2> transfinite;
      transfinite.initialize(triangulation);
      triangulation.set_manifold(id, transfinite);
    }
}
} // namespace

Geometry<2> unite(const std::vector<std::string> &names, const std::vector<Geometry<2>> &bodies) {
  AssertDimension(names.size(), bodies.size());
  std::vector<Side<2>> sides;
  std::vector<unsigned int> first_side;
  Geometry<2> all;
  std::vector<unsigned int> first_region;
  std::vector<std::string> regions;
  double n_cells = 0., n_graded_cells = 0.;
  std::vector<ElasticBody<2>> parts;
  for (unsigned int k = 0; k < bodies.size(); ++k) {
    first_side.push_back(sides.size());
    first_region.push_back(regions.size());
    for (const Side<2> &side : bodies[k].sides)
      sides.emplace_back(names[k] + "." + side.name(), side);
    if (bodies[k].regions.size() > 1)
      for (const std::string &region : bodies[k].regions)
        regions.push_back(names[k] + "." + region);
    else
      regions.push_back(names[k]);
    parts.push_back(
      {names[k], first_side.back(), bodies[k].lower, bodies[k].upper, bodies[k].n_graded_cells()});
    n_cells += bodies[k].n_coarse_cells;
    n_graded_cells += parts.back().n_graded_cells;
  }
  all = bounded_by(std::move(sides));
  all.bodies = std::move(parts);
  all.n_coarse_cells = n_cells;
  all.division = n_graded_cells / n_cells;
  all.star_shaped = false;
  all.inside = bodies.front().inner_point();
  all.regions = std::move(regions);
  all.region_at = [bodies, first_region](const Point<2> &x) {
    const unsigned int k = body_at(bodies, x);
    return first_region[k] + (bodies[k].regions.empty() ? 0 : bodies[k].region_at(x));
  };
  all.make_coarse_mesh = [bodies, first_side](Triangulation<2> &triangulation) {
    const auto coarse = [](const Geometry<2> &body, Triangulation<2> &part) {
      body.make_coarse_mesh(part);
    };
    make_meshes(bodies, first_side, coarse, triangulation);
  };
  all.make_guided_mesh = [bodies, first_side](Triangulation<2> &triangulation,
                                              const unsigned int level,
                                              const MeshGuides<2> &guides) {
    const bool all_guided = std::all_of(bodies.begin(), bodies.end(), [](const Geometry<2> &body) {
      return static_cast<bool>(body.make_guided_mesh);
    });
    unsigned int k = 0;
    const auto guided = [&](const Geometry<2> &body, Triangulation<2> &part) {
      MeshGuides<2> own = {guides.lines, {}};
      for (const auto &[side, point] : guides.vertices)
        if (side >= first_side[k] && side < first_side[k] + body.sides.size())
          own.vertices.emplace_back(side - first_side[k], point);
      if (body.make_guided_mesh)
        body.make_guided_mesh(part, all_guided ? level : 0, own);
      else
        body.make_coarse_mesh(part);
      ++k;
    };
    make_meshes(bodies, first_side, guided, triangulation);
    return all_guided ? 0 : level;
  };
  return all;
}
} // namespace Signorini
