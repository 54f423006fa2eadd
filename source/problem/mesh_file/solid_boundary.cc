// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary of a mesh in space: the faces of its cells that are met once, with their names.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "solid_mesh.h"

namespace Signorini {
const SolidShape &solid_shape(const unsigned int n_corners) {
  static const std::map<unsigned int, SolidShape> shapes = {
    {4,
     {{{{0, 1}}, {{1, 2}}, {{0, 2}}, {{0, 3}}, {{2, 3}}, {{1, 3}}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {3, 1, 2}}}},
    {6,
     {{{{0, 1}}, {{0, 2}}, {{0, 3}}, {{1, 2}}, {{1, 4}}, {{2, 5}}, {{3, 4}}, {{3, 5}}, {{4, 5}}},
      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}}}},
    {8,
     {{{{0, 1}},
       {{0, 3}},
       {{0, 4}},
       {{1, 2}},
       {{1, 5}},
       {{2, 3}},
       {{2, 6}},
       {{3, 7}},
       {{4, 5}},
       {{4, 7}},
       {{5, 6}},
       {{6, 7}}},
      {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}}}};
  return shapes.at(n_corners);
}

Point<3> mean_of(std::vector<Point<3>> points) {
  std::sort(points.begin(), points.end(), lies_before);
  Point<3> sum;
  for (const Point<3> &x : points)
    sum += x;
  return sum / static_cast<double>(points.size());
}

std::string nodes_text(const FileMesh<3> &mesh, const std::vector<unsigned int> &nodes) {
  std::string text = " between nodes ";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += (i == 0                 ? ""
             : i + 1 < nodes.size() ? ", "
                                    : " and ") +
            std::to_string(mesh.nodes[nodes[i]].tag);
  return text;
}

namespace {
using SolidCell = FileMesh<3>::Element;

/** The nodes of a face in order, the last one of a triangle is none. */
using FaceKey = std::array<unsigned int, 4>;
constexpr unsigned int no_node = std::numeric_limits<unsigned int>::max();

FaceKey face_key(const std::vector<unsigned int> &nodes) {
  FaceKey key;
  key.fill(no_node);
  std::copy(nodes.begin(), nodes.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/** A face of a cell. */
struct CellFace {
  FaceKey key;
  unsigned int cell, number;

  bool operator<(const CellFace &other) const {
    return std::tie(key, cell, number) < std::tie(other.key, other.cell, other.number);
  }
};

/** Returns the nodes of a face of a cell, counter-clockwise seen from outside. */
std::vector<unsigned int> nodes_of(const SolidCell &cell, const unsigned int face) {
  std::vector<unsigned int> nodes = solid_shape(cell.n_corners).faces[face];
  for (unsigned int &node : nodes)
    node = cell.nodes[node];
  return nodes;
}

/** The ends of an edge, the smaller one first. */
using EdgeEnds = std::pair<unsigned int, unsigned int>;

EdgeEnds edge_ends(const unsigned int a, const unsigned int b) {
  return std::minmax(a, b);
}

/** Turns a cell with a negative volume round. */
void turn_outwards(const FileMesh<3> &mesh, SolidCell &cell) {
  const SolidShape &shape = solid_shape(cell.n_corners);
  double volume = 0.;
  const Point<3> &origin = mesh.nodes[cell.nodes[0]].x;
  const auto arm = [&](const unsigned int node) { return mesh.nodes[node].x - origin; };
  for (unsigned int f = 0; f < shape.faces.size(); ++f) {
    const std::vector<unsigned int> nodes = nodes_of(cell, f);
    for (std::size_t i = 2; i < nodes.size(); ++i)
      volume += arm(nodes[0]) * cross_product_3d(arm(nodes[i - 1]), arm(nodes[i]));
  }
  if (volume >= 0.)
    return;
  // Two corners of the triangles change places, and two of the quadrilaterals across their
  // diagonal.
  const unsigned int n = cell.n_corners, half = n == 4 ? 3 : n / 2;
  const auto mirror = [&](const unsigned int v) {
    return v % half == 1 ? v + half - 2 : v % half == half - 1 ? v + 2 - half : v;
  };
  const SolidCell before = cell;
  for (unsigned int v = 0; v < n; ++v)
    cell.nodes[v] = before.nodes[mirror(v)];
  for (unsigned int e = 0; cell.is_quadratic && e < shape.edges.size(); ++e)
    for (unsigned int other = 0; other < shape.edges.size(); ++other)
      if (edge_ends(mirror(shape.edges[e][0]), mirror(shape.edges[e][1])) ==
          edge_ends(shape.edges[other][0], shape.edges[other][1]))
        cell.nodes[n + e] = before.nodes[n + other];
}

/** The nodes in the middles of edges. */
using EdgeMiddles = std::map<EdgeEnds, unsigned int>;

EdgeMiddles find_middles(const FileMesh<3> &mesh) {
  EdgeMiddles middles;
  for (const SolidCell &cell : mesh.cells)
    for (unsigned int e = 0; cell.is_quadratic && e < solid_shape(cell.n_corners).edges.size();
         ++e) {
      const auto [a, b] = solid_shape(cell.n_corners).edges[e];
      middles[edge_ends(cell.nodes[a], cell.nodes[b])] = cell.nodes[cell.n_corners + e];
    }
  return middles;
}

/** Refuses a face: the message begins with it. */
[[noreturn]] void refuse_face(const FileMesh<3> &mesh, const std::size_t line,
                              const std::string &face, const std::vector<unsigned int> &nodes,
                              const std::string &reason) {
  throw input_error(mesh.location(line), "the ", face, nodes_text(mesh, nodes), " ", reason);
}

/** Returns the faces of all cells, sorted. @throws InputError if a face has three cells, or two on
 * the same side. */
std::vector<CellFace> find_faces(const FileMesh<3> &mesh) {
  std::vector<CellFace> faces;
  for (unsigned int c = 0; c < mesh.cells.size(); ++c)
    for (unsigned int f = 0; f < solid_shape(mesh.cells[c].n_corners).faces.size(); ++f)
      faces.push_back({face_key(nodes_of(mesh.cells[c], f)), c, f});
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].key != faces[i - 1].key)
      continue;
    const SolidCell &a = mesh.cells[faces[i - 1].cell], &b = mesh.cells[faces[i].cell];
    std::vector<unsigned int> of_a = nodes_of(a, faces[i - 1].number);
    const std::vector<unsigned int> of_b = nodes_of(b, faces[i].number);
    if (i > 1 && faces[i - 2].key == faces[i].key)
      refuse_face(mesh, b.line, "face", of_b,
                  "belongs to the elements " + std::to_string(mesh.cells[faces[i - 2].cell].tag) +
                    ", " + std::to_string(a.tag) + " and " + std::to_string(b.tag) +
                    ", allowed: one or two elements at a face.");
    std::rotate(of_a.begin(), std::find(of_a.begin(), of_a.end(), of_b[0]), of_a.end());
    if (of_a[1] == of_b[1])
      refuse_face(mesh, b.line, "face", of_b,
                  "has the elements " + std::to_string(a.tag) + " and " + std::to_string(b.tag) +
                    " on the same side, allowed: elements that do not lie on one another.");
  }
  return faces;
}

/** Checks that faces connect all cells. */
void check_connected(const FileMesh<3> &mesh, const std::vector<CellFace> &faces) {
  std::vector<unsigned int> leader(mesh.cells.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](unsigned int cell) {
    for (; leader[cell] != cell; cell = leader[cell])
      leader[cell] = leader[leader[cell]];
    return cell;
  };
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].key == faces[i - 1].key)
      leader[find(faces[i].cell)] = find(faces[i - 1].cell);
  for (unsigned int c = 1; c < mesh.cells.size(); ++c)
    if (find(c) != find(0))
      throw input_error(mesh.name, ": the elements ", mesh.cells[0].tag, " and ", mesh.cells[c].tag,
                        " belong to parts that no faces connect, allowed: one body.");
}

/** Returns the names of faces of the boundary. @param faces those of all cells. */
std::map<FaceKey, std::string> find_face_names(const FileMesh<3> &mesh,
                                               const std::vector<CellFace> &faces) {
  std::map<FaceKey, const SolidCell *> known;
  for (const SolidCell &face : mesh.faces) {
    const std::vector<unsigned int> nodes(face.nodes.begin(), face.nodes.begin() + face.n_corners);
    const FaceKey key = face_key(nodes);
    const auto first = std::lower_bound(faces.begin(), faces.end(), CellFace{key, 0, 0});
    const auto end =
      std::find_if(first, faces.end(), [&](const CellFace &other) { return other.key != key; });
    const auto refuse = [&](const std::string &reason) {
      refuse_face(mesh, face.line, "face " + std::to_string(face.tag), nodes, reason);
    };
    if (end - first != 1) {
      // Faces that helped to construct a body, and those between its parts, have no names.
      if (face.group != 0)
        refuse(end == first ? "is not a face of an element, allowed: faces of elements."
                            : "lies inside of the body, allowed: names of faces on its boundary.");
      continue;
    }
    const SolidCell *&same = known.emplace(key, &face).first->second;
    if (same->group == 0)
      same = &face;
    const std::string name = mesh.name_of(*same, 2), other = mesh.name_of(face, 2);
    if (face.group != 0 && name != other)
      refuse("has the physical names " + quote(name) + " and " + quote(other) + ", allowed: one.");
  }
  std::map<FaceKey, std::string> names;
  for (const auto &[key, face] : known)
    names[key] = mesh.name_of(*face, 2);
  return names;
}

/** Refuses triangles that lie on quadrilaterals: these neighbours share no face. */
void check_conforming(const FileMesh<3> &mesh, const std::vector<CellFace> &boundary) {
  std::map<FaceKey, unsigned int> parts;
  for (const CellFace &face : boundary)
    for (unsigned int i = 0; i < 4 && face.key[3] != no_node; ++i) {
      FaceKey part = face.key;
      part[i] = no_node;
      std::sort(part.begin(), part.end());
      parts[part] = face.cell;
    }
  for (const CellFace &face : boundary) {
    const auto part = parts.find(face.key);
    if (part == parts.end())
      continue;
    const SolidCell &cell = mesh.cells[face.cell];
    refuse_face(mesh, cell.line, "triangle", nodes_of(cell, face.number),
                "of the element " + std::to_string(cell.tag) +
                  " lies on a quadrilateral of the element " +
                  std::to_string(mesh.cells[part->second].tag) +
                  ", allowed: elements that share whole faces.");
  }
}
} // namespace

void turn_cells_outwards(FileMesh<3> &mesh) {
  for (SolidCell &cell : mesh.cells)
    turn_outwards(mesh, cell);
}

std::vector<BoundaryFace> find_boundary(const FileMesh<3> &mesh) {
  const EdgeMiddles middles = find_middles(mesh);
  const std::vector<CellFace> faces = find_faces(mesh);
  const std::map<FaceKey, std::string> names = find_face_names(mesh, faces);
  std::vector<CellFace> outer;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if ((i == 0 || faces[i].key != faces[i - 1].key) &&
        (i + 1 == faces.size() || faces[i].key != faces[i + 1].key))
      outer.push_back(faces[i]);
  check_conforming(mesh, outer);
  check_connected(mesh, faces);
  const auto x = [&](const unsigned int node) { return mesh.nodes[node].x; };
  std::vector<std::pair<Point<3>, BoundaryFace>> boundary;
  for (const CellFace &face : outer) {
    BoundaryFace found;
    found.corners = nodes_of(mesh.cells[face.cell], face.number);
    std::vector<unsigned int> &nodes = found.corners;
    std::rotate(nodes.begin(),
                std::min_element(nodes.begin(), nodes.end(),
                                 [&](const unsigned int a, const unsigned int b) {
                                   return lies_before(x(a), x(b));
                                 }),
                nodes.end());
    std::vector<Point<3>> corners;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const unsigned int a = nodes[i], b = nodes[(i + 1) % nodes.size()];
      const auto middle = middles.find(edge_ends(a, b));
      found.middles.push_back(middle == middles.end() ? mean_of({x(a), x(b)}) : x(middle->second));
      found.has_middle_nodes |= middle != middles.end();
      corners.push_back(x(a));
    }
    const auto name = names.find(face.key);
    found.name = name == names.end() ? unnamed : name->second;
    boundary.emplace_back(mean_of(corners), found);
  }
  std::sort(boundary.begin(), boundary.end(),
            [](const auto &a, const auto &b) { return lies_before(a.first, b.first); });
  std::vector<BoundaryFace> sorted;
  for (const auto &entry : boundary)
    sorted.push_back(entry.second);
  return sorted;
}
} // namespace Signorini
