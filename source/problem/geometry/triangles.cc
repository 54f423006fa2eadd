// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles between closed loops of segments, by CGAL; the only file that includes it.

#include "triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <deque>
#include <limits>
#include <set>
#include <utility>

namespace Signorini {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr unsigned int unnumbered = std::numeric_limits<unsigned int>::max();

/** The data of a vertex: its number. */
struct Number {
  unsigned int value = unnumbered;
};

using VertexBase =
  CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel,
                                              CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Delaunay>;
using Mesher = CGAL::Delaunay_mesher_2<Delaunay, Criteria>;

/** Marks the faces that a path from far away reaches by crossing an odd number of edges. */
void mark_body(Delaunay &delaunay) {
  std::set<Delaunay::Face_handle> seen = {delaunay.infinite_face()};
  // Faces that are reached across an edge wait behind those of their own region.
  std::deque<Delaunay::Face_handle> waiting = {delaunay.infinite_face()};
  while (!waiting.empty()) {
    const Delaunay::Face_handle face = waiting.front();
    waiting.pop_front();
    for (int i = 0; i < 3; ++i) {
      const Delaunay::Face_handle next = face->neighbor(i);
      if (!seen.insert(next).second)
        continue;
      const bool crosses = face->is_constrained(i);
      next->set_in_domain(face->is_in_domain() != crosses);
      if (crosses)
        waiting.push_back(next);
      else
        waiting.push_front(next);
    }
  }
}
} // namespace

Triangles triangulate(const std::vector<Point<2>> &points,
                      const std::vector<CoarseMesh::Edge> &edges, const double mesh_size,
                      const std::size_t max_points) {
  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> vertices;
  for (const Point<2> &x : points) {
    vertices.push_back(delaunay.insert(Kernel::Point_2(x[0], x[1])));
    vertices.back()->info().value = vertices.size() - 1;
  }
  try {
    for (const CoarseMesh::Edge &edge : edges)
      delaunay.insert_constraint(vertices[edge.start], vertices[edge.end]);
  } catch (const Delaunay::Intersection_of_constraints_exception &) {
    return {};
  }
  // Points on a line have no triangles between them.
  if (delaunay.dimension() < 2)
    return {};
  // sin²(20.7 degrees): Ruppert's method ends for angles up to that.
  Mesher mesher(delaunay, Criteria(0.125, mesh_size));
  mark_body(delaunay);
  mesher.init(/*domain_specified=*/true);
  Triangles result = {points, {}, {}, false};
  while (mesher.try_one_step_refine_mesh())
    if (delaunay.number_of_vertices() > max_points) {
      result.too_many = true;
      return result;
    }
  for (const Delaunay::Vertex_handle vertex : delaunay.finite_vertex_handles())
    if (vertex->info().value == unnumbered) {
      vertex->info().value = result.points.size();
      result.points.emplace_back(vertex->point().x(), vertex->point().y());
    }
  for (const Delaunay::Face_handle face : delaunay.finite_face_handles()) {
    const auto number = [&](const int i) { return face->vertex(i)->info().value; };
    if (face->is_in_domain())
      result.triangles.push_back({number(0), number(1), number(2)});
    for (int i = 0; i < 3 && face->is_in_domain(); ++i)
      if (!face->neighbor(i)->is_in_domain())
        result.boundary.push_back({{number(Delaunay::ccw(i)), number(Delaunay::cw(i))}});
  }
  return result;
}
} // namespace Signorini
