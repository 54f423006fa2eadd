// SPDX-License-Identifier: LGPL-2.1-or-later
// The body of a mesh file: sides, circles and the coarse mesh.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/arc_cell.h>
#include <signorini/problem/mesh_file/file_geometry.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include "file_sides.h"

namespace Signorini
{
namespace
{
/** The arguments from which a triangulation is made. */
struct CoarseMesh
{
  std::vector<dealii::Point<2>> vertices;
  std::vector<dealii::CellData<2>> cells;
  dealii::SubCellData edges;
  /** The manifolds; manifolds[i] has the number i. */
  std::vector<std::shared_ptr<const dealii::Manifold<2>>> manifolds;

  void make(dealii::Triangulation<2> &triangulation) const
  {
    triangulation.create_triangulation(vertices, cells, edges);
    for (unsigned int i = 0; i < manifolds.size(); ++i)
      triangulation.set_manifold(i, *manifolds[i]);
  }
};

void add_edges(const FileSides &sides, CoarseMesh &coarse)
{
  for (const FileSides::Edge &edge : sides.edges)
  {
    dealii::CellData<1> data;
    data.vertices = {edge.edge.start, edge.edge.end};
    data.boundary_id = edge.side;
    if (edge.circle >= 0)
      data.manifold_id = static_cast<unsigned int>(edge.circle);
    coarse.edges.boundary_lines.push_back(data);
  }
  for (const dealii::Point<2> &centre : sides.centres)
    coarse.manifolds.push_back(std::make_shared<dealii::SphericalManifold<2>>(centre));
}

/** Adds the cells with an edge on a circle. */
void add_arc_cells(const FileMesh &mesh, const FileSides &sides, CoarseMesh &coarse)
{
  std::map<unsigned int, std::array<std::optional<dealii::Point<2>>, 4>> centres;
  for (const FileSides::Edge &edge : sides.edges)
    if (edge.circle >= 0)
      centres[edge.edge.cell][edge.edge.edge_of_cell] = sides.centres[edge.circle];
  for (const auto &[number, centres_of_edges] : centres)
  {
    const FileMesh::Cell &cell = mesh.cells[number];
    std::array<dealii::Point<2>, 4> corners;
    for (unsigned int i = 0; i < 4; ++i)
      corners[i] = mesh.vertices[cell.corners[i]].position;
    auto manifold = std::make_shared<ArcCell>(corners, centres_of_edges);
    if (!manifold->is_valid(10, 0.))
      throw InputError(mesh.file + ": the quadrilateral " + std::to_string(cell.tag) +
                       " is turned inside out by its edge on a circle, allowed: a finer mesh "
                       "there.");
    coarse.cells[number].manifold_id = coarse.manifolds.size();
    coarse.manifolds.push_back(std::move(manifold));
  }
}

/** Computes the box around the body. Arcs lie inside of the boxes around their circles, of which
 * the parts that the arc passes count. */
void set_box(const FileMesh &mesh, const FileSides &sides, Geometry<2> &geometry)
{
  geometry.lower = geometry.upper = mesh.vertices[0].position;
  const auto include = [&](const dealii::Point<2> &x) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.lower[d] = std::min(geometry.lower[d], x[d]);
      geometry.upper[d] = std::max(geometry.upper[d], x[d]);
    }
  };
  for (const FileMesh::Vertex &vertex : mesh.vertices)
    include(vertex.position);
  for (const FileSides::Edge &edge : sides.edges)
    if (edge.circle >= 0)
    {
      // The highest point of an arc in a direction is an end, or the point of the circle there.
      const dealii::Point<2> &centre = sides.centres[edge.circle];
      const dealii::Point<2> &start = mesh.vertices[edge.edge.start].position;
      const dealii::Point<2> &end = mesh.vertices[edge.edge.end].position;
      const dealii::Point<2> middle = start + 0.5 * (end - start);
      for (unsigned int d = 0; d < 2; ++d)
        for (const double sign : {-1., 1.})
        {
          dealii::Point<2> x = centre;
          x[d] += sign * centre.distance(start);
          const dealii::Tensor<1, 2> bisector = middle - centre;
          // At an end both are equal, but for rounding.
          if ((x - centre) * bisector > (1. + 1e-12) * bisector.norm_square())
            include(x);
        }
    }
}

/** Returns the centre of the cell that is nearest to a point: a point inside of the body. */
dealii::Point<2> centre_near(const FileMesh &mesh, const dealii::Point<2> &x)
{
  dealii::Point<2> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const FileMesh::Cell &cell : mesh.cells)
  {
    dealii::Point<2> centre;
    for (const unsigned int corner : cell.corners)
      centre += 0.25 * mesh.vertices[corner].position;
    if (centre.distance(x) < distance)
    {
      distance = centre.distance(x);
      nearest = centre;
    }
  }
  return nearest;
}
} // namespace

Geometry<2> make_geometry(const FileMesh &file_mesh,
                          const std::vector<std::string> &arcs,
                          const std::string &where)
{
  FileMesh mesh = file_mesh;
  const FileSides sides = find_sides(mesh, arcs, where);
  const auto coarse = std::make_shared<CoarseMesh>();
  for (const FileMesh::Vertex &vertex : mesh.vertices)
    coarse->vertices.push_back(vertex.position);
  for (const FileMesh::Cell &cell : mesh.cells)
  {
    dealii::CellData<2> data;
    data.vertices = {cell.corners[0], cell.corners[1], cell.corners[3], cell.corners[2]};
    coarse->cells.push_back(data);
  }
  add_edges(sides, *coarse);
  add_arc_cells(mesh, sides, *coarse);
  dealii::GridTools::consistently_order_cells(coarse->cells);
  Geometry<2> geometry;
  geometry.sides = sides.sides;
  geometry.n_coarse_cells = static_cast<double>(mesh.cells.size());
  geometry.curved = !sides.centres.empty();
  geometry.make_coarse_mesh =
    [coarse = std::shared_ptr<const CoarseMesh>(coarse)](dealii::Triangulation<2> &triangulation) {
      coarse->make(triangulation);
    };
  set_box(mesh, sides, geometry);
  geometry.star_shaped = false;
  geometry.inside = centre_near(mesh, geometry.lower + 0.5 * (geometry.upper - geometry.lower));
  return geometry;
}
} // namespace Signorini
