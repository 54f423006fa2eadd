// SPDX-License-Identifier: LGPL-2.1-or-later
// The sides of a body in space: parts of its boundary with one name, and the surfaces they follow.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/surface_fit.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "solid_mesh.h"

namespace Signorini {
namespace {
/** The cosine of the angle by which faces of one side turn at most: 30 degrees and rounding. */
constexpr double smooth_cosine = 0.866025;

/** The share of the radius, or of a plane's extent, by which nodes may lie off a surface of a kind
 * that is given, and how well the nodes must tell it (SurfaceFit::condition). */
constexpr double declared_surface_tolerance = 1e-3, min_declared_condition = 1e-5;

/** The share of the extent above which a motion of nodes is told. */
constexpr double small_motion = 1e-8;

/** The first of the two faces at an edge and the number of the edge in it, and those of the second
 * one. */
using EdgeFaces = std::vector<std::pair<unsigned int, unsigned int>>;

/** Returns the faces at all edges of the boundary. @throws InputError if an edge has more than two.
 */
std::vector<EdgeFaces> find_boundary_edges(const FileMesh<3> &mesh,
                                           const std::vector<BoundaryFace> &faces) {
  std::map<std::pair<unsigned int, unsigned int>, EdgeFaces> edges;
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (unsigned int i = 0, n = faces[f].corners.size(); i < n; ++i)
      edges[std::minmax(faces[f].corners[i], faces[f].corners[(i + 1) % n])].emplace_back(f, i);
  std::vector<EdgeFaces> found;
  for (const auto &[ends, at_edge] : edges) {
    if (at_edge.size() != 2)
      throw input_error(mesh.name, ": the body touches itself at the edge",
                        nodes_text(mesh, {ends.first, ends.second}),
                        ", allowed: a body whose parts share faces.");
    found.push_back(at_edge);
  }
  return found;
}

/** A face of the boundary as a polynomial of degree two. */
class FaceShape {
public:
  FaceShape(const FileMesh<3> &mesh, const BoundaryFace &face)
    : middles(face.middles)
    , n(middles.size()) {
    for (const unsigned int node : face.corners)
      corners.push_back(mesh.nodes[node].x);
  }

  Point<3> middle() const {
    const auto sum = [](const std::vector<Point<3>> &points) {
      return std::accumulate(points.begin(), points.end(), Tensor<1, 3>());
    };
    return Point<3>(n == 3 ? (4. * sum(middles) - sum(corners)) / 9.
                           : 0.5 * sum(middles) - 0.25 * sum(corners));
  }

  /** Returns the normal in the middle of the face between its corners; its norm is the area. */
  Tensor<1, 3> area_vector() const {
    return 0.5 * (n == 3 ? cross_product_3d(corners[1] - corners[0], corners[2] - corners[0])
                         : cross_product_3d(corners[2] - corners[0], corners[3] - corners[1]));
  }

  /** Returns the unit normal in the middle of an edge. */
  Tensor<1, 3> normal_at_edge(const unsigned int i) const {
    const Point<3> &a = corners[i], &b = corners[(i + 1) % n];
    const Tensor<1, 3> m = middles[i], next = middles[(i + 1) % n], last = middles[(i + n - 1) % n];
    // The derivative into the face at the middle of the edge.
    const Tensor<1, 3> inwards =
      n == 3 ? 2. * (next - m + last) - 0.5 * (Tensor<1, 3>(a) + b) - corners[(i + 2) % n]
             : 2. * Tensor<1, 3>(middle()) - 1.5 * m - 0.5 * middles[(i + 2) % n];
    const Tensor<1, 3> normal = cross_product_3d(b - a, inwards);
    return normal / normal.norm();
  }

  std::vector<Point<3>> corners, middles;

private:
  unsigned int n;
};

/** A part of the boundary that becomes a side. */
struct SidePart {
  std::string name;
  std::vector<unsigned int> faces;
  Tensor<1, 3> centre;
  double area = 0.;
};

/** Returns the kind that a list gives to one of these names, if it does. */
std::optional<Surface::Kind> kind_of(const SurfaceKinds &kinds,
                                     const std::vector<std::string> &names) {
  for (const auto &[side, kind] : kinds)
    if (std::count(names.begin(), names.end(), side) > 0)
      return kind;
  return {};
}

/** Returns the parts that edges connect, by name and from left to right. */
std::vector<SidePart> find_side_parts(const std::vector<BoundaryFace> &faces,
                                      const std::vector<FaceShape> &shapes,
                                      const std::vector<EdgeFaces> &edges,
                                      const SurfaceKinds &kinds) {
  std::vector<unsigned int> leader(faces.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](unsigned int face) {
    for (; leader[face] != face; face = leader[face])
      leader[face] = leader[leader[face]];
    return face;
  };
  for (const EdgeFaces &edge : edges) {
    const unsigned int a = edge[0].first, b = edge[1].first;
    if (faces[a].name != faces[b].name)
      continue;
    const auto kind = kind_of(kinds, {faces[a].name});
    if ((kind && *kind != Surface::Kind::plane) ||
        shapes[a].normal_at_edge(edge[0].second) * shapes[b].normal_at_edge(edge[1].second) >=
          smooth_cosine)
      leader[find(a)] = find(b);
  }
  std::map<unsigned int, SidePart> part_of;
  std::vector<Point<3>> corners;
  for (unsigned int f = 0; f < faces.size(); ++f) {
    SidePart &part = part_of[find(f)];
    const double area = shapes[f].area_vector().norm();
    part.name = faces[f].name;
    part.faces.push_back(f);
    part.centre += area * shapes[f].middle();
    part.area += area;
    corners.insert(corners.end(), shapes[f].corners.begin(), shapes[f].corners.end());
  }
  std::vector<SidePart> parts;
  for (auto &[first, part] : part_of) {
    part.centre /= part.area;
    parts.push_back(std::move(part));
  }
  // Centres that are equal but for rounding and digits of the file are equal.
  const BoundingBox<3> box(corners);
  const double unit =
    1e-6 * (box.get_boundary_points().first - box.get_boundary_points().second).norm();
  const auto rank = [unit](const SidePart &part) {
    const auto step = [&](const unsigned int d) { return std::round(part.centre[d] / unit); };
    return std::make_tuple(part.name, step(0), step(1), step(2), part.area);
  };
  std::sort(parts.begin(), parts.end(),
            [&](const SidePart &a, const SidePart &b) { return rank(a) < rank(b); });
  return parts;
}

/** Returns the points and the normals of a part. */
SurfaceSamples samples_of(const SidePart &part, const std::vector<BoundaryFace> &faces,
                          const std::vector<FaceShape> &shapes) {
  SurfaceSamples samples;
  for (const unsigned int f : part.faces) {
    const auto add = [&](const std::vector<Point<3>> &points) {
      samples.points.insert(samples.points.end(), points.begin(), points.end());
    };
    add(shapes[f].corners);
    if (faces[f].has_middle_nodes)
      add(shapes[f].middles);
    const Tensor<1, 3> normal = shapes[f].area_vector();
    samples.faces.push_back({shapes[f].middle(), normal / normal.norm()});
  }
  std::sort(samples.points.begin(), samples.points.end(), lies_before);
  samples.points.erase(std::unique(samples.points.begin(), samples.points.end()),
                       samples.points.end());
  return samples;
}

/** Returns the surface of a given kind through samples. @throws InputError if they have none. */
Surface declared_surface(const SurfaceSamples &samples, const Surface::Kind kind,
                         const std::string &side, const std::string &where) {
  if (kind == Surface::Kind::faces)
    return Surface::faces();
  const SurfaceFit fit = fit_surface(samples, kind);
  const std::string name = Surface::name(kind);
  const auto box = BoundingBox<3>(samples.points).get_boundary_points();
  const double unit =
    kind == Surface::Kind::plane ? box.first.distance(box.second) : fit.surface.radius();
  if (!(fit.condition >= min_declared_condition))
    throw input_error(where, ": the nodes of the side ", quote(side), " lie on more than one ",
                      name, ", allowed: a finer mesh there, or faces.");
  if (!(fit.residual <= declared_surface_tolerance * unit) || !fit.follows_normals)
    throw input_error(where, ": the side ", quote(side), " is not a ", name,
                      ", allowed: nodes on one, to ", declared_surface_tolerance, " of its ",
                      kind == Surface::Kind::plane ? "extent." : "radius.");
  return fit.surface;
}

/** Returns how far smooth surfaces deviate from the faces of sides without one, about: the largest
 * distance of neighbours times the angle between them, over 8 (length). */
double largest_sag(const std::vector<BoundaryFace> &faces, const std::vector<FaceShape> &shapes,
                   const std::vector<EdgeFaces> &edges, const std::vector<unsigned int> &sides) {
  double sag = 0.;
  for (const EdgeFaces &edge : edges) {
    const unsigned int a = edge[0].first, b = edge[1].first;
    if (faces[a].side != faces[b].side ||
        std::count(sides.begin(), sides.end(), faces[a].side) == 0)
      continue;
    const Tensor<1, 3> m = shapes[a].area_vector(), n = shapes[b].area_vector();
    const double angle = std::atan2(cross_product_3d(m, n).norm(), m * n);
    sag = std::max(sag, shapes[a].middle().distance(shapes[b].middle()) * angle / 8.);
  }
  return sag;
}
} // namespace

SolidSides find_sides(const FileMesh<3> &mesh, std::vector<BoundaryFace> &faces,
                      const SurfaceKinds &kinds, const std::string &where) {
  std::vector<FaceShape> shapes;
  for (const BoundaryFace &face : faces)
    shapes.emplace_back(mesh, face);
  const std::vector<EdgeFaces> edges = find_boundary_edges(mesh, faces);
  const std::vector<SidePart> parts = find_side_parts(faces, shapes, edges, kinds);
  std::vector<std::string> names;
  for (const SidePart &part : parts)
    names.push_back(part.name);
  const std::vector<std::string> given = names;
  names = number_names(names, mesh.name);
  for (const auto &[side, kind] : kinds)
    if (std::count(names.begin(), names.end(), side) +
          std::count(given.begin(), given.end(), side) ==
        0)
      throw input_error(where, ": found the side ", quote(side), ", allowed: ", join(names), ".");
  SolidSides found;
  std::vector<unsigned int> faceted;
  double motion = 0., extent = 0.;
  for (unsigned int i = 0; i < parts.size(); ++i) {
    const SurfaceSamples samples = samples_of(parts[i], faces, shapes);
    const auto kind = kind_of(kinds, {names[i], given[i]});
    const Surface surface =
      kind ? declared_surface(samples, *kind, names[i], where) : fit_surface(samples).surface;
    for (const unsigned int f : parts[i].faces) {
      faces[f].side = i;
      for (const Point<3> &x : shapes[f].corners) {
        motion = std::max(motion, kind ? x.distance(surface.project(x)) : 0.);
        extent = std::max(extent, x.distance(shapes[0].corners[0]));
      }
    }
    if (!kind && !surface.has_normals())
      faceted.push_back(i);
    found.sides.emplace_back(names[i], surface);
  }
  std::vector<std::string> notes, called;
  for (const unsigned int i : faceted)
    called.push_back(names[i]);
  if (motion > small_motion * extent)
    notes.push_back("nodes of the sides in Geometry/Surfaces are moved onto them, by at most " +
                    number_text(motion));
  if (!faceted.empty())
    notes.push_back("sides that follow no plane, sphere or cylinder keep their faces, from which a "
                    "smooth surface would deviate by about " +
                    number_text(largest_sag(faces, shapes, edges, faceted)) + " (" + join(called) +
                    "); Geometry/Surfaces says of which kind they are");
  found.note = join(notes, "; ");
  return found;
}
} // namespace Signorini
