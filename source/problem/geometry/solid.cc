// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies in space: their sides, and the coarse mesh with the surfaces that refined meshes follow.

#include <signorini/problem/geometry/inside.h>
#include <signorini/problem/geometry/solid.h>
#include <signorini/problem/geometry/solid_edges.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

namespace Signorini {
Point<3> project_on_all(const std::vector<Surface> &surfaces, Point<3> x, const double size) {
  // Surfaces that meet at five degrees need most steps.
  constexpr unsigned int max_rounds = 5000;
  constexpr double rounding = 1e-15;
  for (unsigned int round = 0; round < max_rounds; ++round) {
    const Point<3> before = x;
    for (const Surface &surface : surfaces)
      x = surface.project(x);
    if (surfaces.size() == 1 || x.distance(before) <= rounding * (size + x.norm()))
      break;
  }
  return x;
}

namespace {
/** One surface, or several that meet in an edge: new points are the projections of weighted means.
 */
class SurfaceManifold : public Manifold<3, 3> {
public:
  explicit SurfaceManifold(std::vector<Surface> surfaces)
    : surfaces_(std::move(surfaces)) {}

  std::unique_ptr<Manifold<3, 3>> clone() const override {
    return std::make_unique<SurfaceManifold>(*this);
  }

  Point<3> get_new_point(const ArrayView<const Point<3>> &points,
                         const ArrayView<const double> &weights) const override {
    Point<3> x;
    for (std::size_t i = 0; i < points.size(); ++i)
      x += weights[i] * points[i];
    return project_to_manifold(points, x);
  }

  Point<3> project_to_manifold(const ArrayView<const Point<3>> &points,
                               const Point<3> &candidate) const override {
    return project_on_all(surfaces_, candidate, points[0].distance(candidate));
  }

  Tensor<1, 3> normal_vector(const Triangulation<3>::face_iterator & /*face*/,
                             const Point<3> &x) const override {
    return surfaces_.front().normal(x);
  }

private:
  std::vector<Surface> surfaces_;
};

/** The coarse mesh: which objects follow which surfaces. */
struct CoarseSolid {
  std::vector<Point<3>> vertices;
  std::vector<CellData<3>> cells;
  SubCellData boundary;
  std::vector<SurfaceManifold> manifolds;
  /** Whether all cells have the same directions of their edges. */
  bool is_orientable = true;
};

using Edge = std::pair<unsigned int, unsigned int>;

/** Finds the sides on which edges lie. */
std::map<Edge, std::set<unsigned int>> sides_of_edges(const Solid &solid) {
  std::map<Edge, std::set<unsigned int>> sides;
  for (const Solid::Face &face : solid.faces)
    for (const auto &[first, second] : edges_of_face)
      sides[std::minmax(face.vertices[first], face.vertices[second])].insert(face.side);
  return sides;
}

/** Returns whether edges can have directions so that the four edges along each coordinate of a cell
 * are parallel. Edges that must be parallel form a class; the answer is no if an edge would be in a
 * class with both directions. */
bool can_be_ordered(const std::vector<CellData<3>> &cells) {
  std::map<Edge, std::pair<Edge, bool>> next;
  /** Returns the representative of the class of an edge, and whether it runs against that. */
  const auto class_of = [&next](Edge edge) {
    bool against = edge.second < edge.first;
    if (against)
      std::swap(edge.first, edge.second);
    for (auto link = next.find(edge); link != next.end(); link = next.find(edge)) {
      against = against != link->second.second;
      edge = link->second.first;
    }
    return std::pair(edge, against);
  };
  for (const CellData<3> &cell : cells)
    for (unsigned int v = 1; v < 8; ++v)
      for (const unsigned int d : {1U, 2U, 4U}) {
        // The edge along d that begins at v, and the first one along it.
        if ((v & d) != 0)
          continue;
        const auto [first, first_against] = class_of({cell.vertices[0], cell.vertices[d]});
        const auto [own, own_against] = class_of({cell.vertices[v], cell.vertices[v + d]});
        if (first != own)
          next[own] = {first, first_against != own_against};
        else if (first_against != own_against)
          return false;
      }
  return true;
}

CoarseSolid make_coarse_solid(const Solid &solid) {
  CoarseSolid coarse;
  coarse.vertices = solid.vertices;
  for (const auto &vertices : solid.cells) {
    coarse.cells.emplace_back(vertices.size());
    std::copy(vertices.begin(), vertices.end(), coarse.cells.back().vertices.begin());
  }
  coarse.is_orientable = can_be_ordered(coarse.cells);
  if (coarse.is_orientable)
    GridTools::consistently_order_cells(coarse.cells);
  std::map<std::set<unsigned int>, types::manifold_id> ids;
  // Means of points of planes lie on them.
  const auto id_of = [&](std::set<unsigned int> sides) {
    bool is_curved = false;
    std::vector<Surface> surfaces;
    for (auto side = sides.begin(); side != sides.end();) {
      const Surface &surface = solid.sides[*side].second;
      is_curved = is_curved || surface.is_curved();
      if (surface.has_normals())
        surfaces.push_back(surface);
      side = surface.has_normals() ? std::next(side) : sides.erase(side);
    }
    if (!is_curved)
      return numbers::flat_manifold_id;
    const auto [id, is_new] = ids.emplace(sides, coarse.manifolds.size());
    if (is_new)
      coarse.manifolds.emplace_back(surfaces);
    return id->second;
  };
  for (const Solid::Face &face : solid.faces) {
    CellData<2> quadrilateral(4);
    std::copy(face.vertices.begin(), face.vertices.end(), quadrilateral.vertices.begin());
    quadrilateral.boundary_id = face.side;
    quadrilateral.manifold_id = id_of({face.side});
    coarse.boundary.boundary_quads.push_back(quadrilateral);
  }
  for (const auto &[edge, sides] : sides_of_edges(solid)) {
    CellData<1> line(2);
    line.vertices = {edge.first, edge.second};
    line.boundary_id = numbers::internal_face_boundary_id;
    line.manifold_id = id_of(sides);
    if (line.manifold_id != numbers::flat_manifold_id)
      coarse.boundary.boundary_lines.push_back(line);
  }
  return coarse;
}

void make_mesh(const CoarseSolid &coarse, Triangulation<3> &triangulation) {
  triangulation.create_triangulation(coarse.vertices, coarse.cells, coarse.boundary);
  for (types::manifold_id id = 0; id < coarse.manifolds.size(); ++id)
    triangulation.set_manifold(id, coarse.manifolds[id]);
}

/** The cells of a coarse mesh by their positions. */
class CellFinder {
public:
  explicit CellFinder(const CoarseSolid &coarse) {
    mesh_.create_triangulation(coarse.vertices, coarse.cells, SubCellData());
    std::vector<std::pair<BoundingBox<3>, unsigned int>> boxes;
    for (const auto &cell : mesh_.active_cell_iterators())
      boxes.emplace_back(cell->bounding_box(), cell->index());
    boxes_ = pack_rtree(boxes);
  }

  /** Returns the number of the cell in which a point lies. Refined meshes are larger than the
   * coarse one where sides are convex: beyond all cells that one counts of whose faces the point is
   * least far beyond, by reference coordinates. */
  unsigned int operator()(const Point<3> &x) const {
    constexpr unsigned int n_near = 12;
    std::pair<double, unsigned int> nearest(HUGE_VAL, 0);
    for (auto entry = boxes_.qbegin(boost::geometry::index::nearest(x, n_near));
         entry != boxes_.qend() && nearest.first > 0.; ++entry)
      nearest = std::min(nearest, {distance_beyond(entry->second, x), entry->second});
    return nearest.second;
  }

private:
  double distance_beyond(const unsigned int cell, const Point<3> &x) const {
    try {
      const Point<3> xi =
        mapping_.transform_real_to_unit_cell({&mesh_, 0, static_cast<int>(cell)}, x);
      return GeometryInfo<3>::distance_to_unit_cell(xi);
    } catch (const Mapping<3>::ExcTransformationFailed &) {
      return std::numeric_limits<double>::max();
    }
  }

  Triangulation<3> mesh_;
  MappingQ1<3> mapping_;
  RTree<std::pair<BoundingBox<3>, unsigned int>> boxes_;
};

/** A face of the coarse mesh as it is: on its surface, with edges on the surfaces of two sides. */
struct TrueFace {
  const Surface *surface;
  const FaceCorners *corners;
  /** The surfaces of edges that are bent; empty where they are straight. */
  std::array<std::vector<Surface>, 4> bent;

  /** Returns how far an edge is beside its chord, at the share t. */
  Tensor<1, 3> bend(const unsigned int edge, const double t) const {
    if (bent[edge].empty())
      return {};
    const Point<3> &start = (*corners)[edges_of_face[edge][0]],
                   &end = (*corners)[edges_of_face[edge][1]];
    const Point<3> x = start + t * (end - start);
    return project_on_all(bent[edge], x, start.distance(end)) - x;
  }
  /** Returns the point of the transfinite interpolation of the edges. */
  Point<3> point(const Point<2> &xi) const {
    const double s = xi[0], t = xi[1];
    return surface->project(point_on(*corners, xi) + (1. - s) * bend(0, t) + s * bend(1, t) +
                            (1. - t) * bend(2, s) + t * bend(3, s));
  }
  /** Returns the reference coordinates of the nearest point: the best one of a grid, and of smaller
   * and smaller grids about it. */
  Point<2> nearest(const Point<3> &x) const {
    constexpr int n = 3;
    constexpr double smallest = 1e-12;
    Point<2> best(0.5, 0.5);
    for (double width = 0.5; width > smallest; width *= 0.5) {
      const Point<2> middle = best;
      double least = std::numeric_limits<double>::max();
      for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j) {
          const Point<2> xi(std::clamp(middle[0] + i * width / n, 0., 1.),
                            std::clamp(middle[1] + j * width / n, 0., 1.));
          if (const double square = x.distance_square(point(xi)); square < least) {
            least = square;
            best = xi;
          }
        }
    }
    return best;
  }
};

/** Returns all faces of a body. */
std::vector<TrueFace> true_faces(const Geometry<3> &geometry) {
  std::map<EdgeKey, std::vector<Surface>> bent;
  for (const SolidEdge &edge : solid_edges(geometry)) {
    const Surface &first = geometry.sides[edge.sides[0]].surface(),
                  &second = geometry.sides[edge.sides[1]].surface();
    if (first.is_curved() || second.is_curved())
      bent[edge_key(edge.ends[0], edge.ends[1])] = {first, second};
  }
  std::vector<TrueFace> faces;
  for (const Side<3> &side : geometry.sides)
    for (const FaceCorners &corners : side.faces()) {
      faces.push_back({&side.surface(), &corners, {}});
      for (unsigned int i = 0; i < 4; ++i)
        if (const auto edge =
              bent.find(edge_key(corners[edges_of_face[i][0]], corners[edges_of_face[i][1]]));
            edge != bent.end())
          faces.back().bent[i] = edge->second;
    }
  return faces;
}

/** Returns the middle of the cell that is nearest to the middle of the body's box. */
Point<3> point_inside(const Solid &solid, const Point<3> &middle) {
  Point<3> best;
  double least = std::numeric_limits<double>::max();
  for (const auto &cell : solid.cells) {
    Point<3> centre;
    for (const unsigned int v : cell)
      centre += solid.vertices[v] / static_cast<double>(cell.size());
    if (const double distance = centre.distance(middle); distance < least) {
      least = distance;
      best = centre;
    }
  }
  return best;
}
} // namespace

double distance_from_body(const Geometry<3> &geometry, const Point<3> &x) {
  const std::vector<TrueFace> faces = true_faces(geometry);
  std::vector<std::pair<double, const TrueFace *>> candidates;
  for (const TrueFace &face : faces) {
    const Point<3> middle = face.point({0.5, 0.5});
    double radius = 0.;
    for (const Point<3> &corner : *face.corners)
      radius = std::max(radius, middle.distance(corner));
    candidates.emplace_back(x.distance(middle) - radius, &face);
  }
  std::sort(candidates.begin(), candidates.end());
  const double rounding = 1e-10 * geometry.diameter();
  double nearest = std::numeric_limits<double>::max(), depth = 0.;
  for (const auto &[bound, face] : candidates) {
    if (bound > nearest + rounding)
      break;
    const Surface &surface = *face->surface;
    const Point<2> xi = face->nearest(x);
    const Point<3> foot = face->point(xi);
    Tensor<1, 3> normal =
      surface.has_normals() ? surface.normal(foot) : area_vector(*face->corners, xi);
    normal /= normal.norm();
    const double distance = x.distance(foot), across = normal * (x - foot);
    // At an edge the face that sees the point from the front tells.
    if (distance < nearest - rounding ||
        (distance < nearest + rounding && std::abs(across) > std::abs(depth)))
      depth = across;
    nearest = std::min(nearest, distance);
  }
  return depth <= 0. ? -nearest : nearest;
}

Geometry<3> make_geometry(Solid solid) {
  // The sides of curved surfaces reach beyond their vertices.
  constexpr unsigned int n_samples = 8;
  std::vector<std::vector<FaceCorners>> faces(solid.sides.size());
  for (const Solid::Face &face : solid.faces) {
    FaceCorners corners;
    for (unsigned int v = 0; v < 4; ++v)
      corners[v] = solid.vertices[face.vertices[v]];
    faces[face.side].push_back(corners);
  }
  Geometry<3> geometry;
  std::vector<Point<3>> points = solid.vertices;
  for (unsigned int i = 0; i < solid.sides.size(); ++i) {
    const SurfacePart part(solid.sides[i].second, std::move(faces[i]));
    if (part.surface().is_curved())
      for (const SurfacePoint<3> &sample : part.samples(n_samples))
        points.push_back(sample.x);
    geometry.curved = geometry.curved || part.surface().is_curved();
    geometry.sides.emplace_back(solid.sides[i].first, part);
  }
  const BoundingBox<3> box(points);
  std::tie(geometry.lower, geometry.upper) = box.get_boundary_points();
  geometry.n_coarse_cells = static_cast<double>(solid.cells.size());
  geometry.star_shaped = false;
  geometry.inside = point_inside(solid, box.center());
  const auto coarse = std::make_shared<const CoarseSolid>(make_coarse_solid(solid));
  geometry.can_be_shared = coarse->is_orientable;
  geometry.make_coarse_mesh = [coarse](Triangulation<3> &triangulation) {
    make_mesh(*coarse, triangulation);
  };
  geometry.regions = std::move(solid.regions);
  if (geometry.regions.size() == 1)
    geometry.region_at = [](const Point<3> &) { return 0U; };
  else if (!geometry.regions.empty())
    geometry.region_at = [finder = std::make_shared<const CellFinder>(*coarse),
                          regions = std::move(solid.region_of_cell)](const Point<3> &x) {
      return regions[(*finder)(x)];
    };
  return geometry;
}
} // namespace Signorini
