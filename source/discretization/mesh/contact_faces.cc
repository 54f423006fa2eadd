// SPDX-License-Identifier: LGPL-2.1-or-later
// Γ_c in space: pieces are faces of the mesh, and patches are faces of a coarser one.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace Signorini {
namespace {
/** A cell that is the ancestor of another one, and the position of the first child of that on its
 * face, in steps of the descendants. */
struct Ancestor {
  CellId cell;
  std::array<unsigned int, 2> position = {{0, 0}};
};

/** Returns the ancestor of the cell of a face @p n_generations before. @throws ComputationError
 * where the mesh is too coarse. */
Ancestor ancestor_of(const ContactFace<3> &face, const unsigned int n_generations) {
  const auto children = face.identity.get_child_indices();
  if (children.size() < n_generations)
    throw ComputationError(
      "The mesh is too coarse for contact: a patch is a face of a coarser mesh.");
  const auto *const end = children.end() - n_generations;
  // The directions of a face as deal.II orders them: y z, z x, x y.
  const unsigned int normal = face.face_no / 2, along[] = {(normal + 1) % 3, (normal + 2) % 3};
  Ancestor ancestor = {Signorini::ancestor_of(face.identity, n_generations)};
  for (const auto *child = end; child != children.end(); ++child)
    for (unsigned int d = 0; d < 2; ++d)
      ancestor.position[d] = 2 * ancestor.position[d] + ((*child >> along[d]) & 1U);
  return ancestor;
}

/** Returns the outward unit normal of a bilinear face of a cell. */
Tensor<1, 3> normal_of(const FaceCorners &corners, const unsigned int face_no, const Point<2> &xi) {
  const Tensor<1, 3> n = (face_no % 2 == 0 ? -1. : 1.) * area_vector(corners, xi);
  return n / n.norm();
}
} // namespace

template <>
void ContactSurface<3>::divide(const Partition &partition) {
  unsigned int n_generations = 0;
  while ((1U << n_generations) < partition.ratio)
    ++n_generations;
  const bool is_given =
    std::any_of(partition.patches_by_contact.begin(), partition.patches_by_contact.end(),
                [](const unsigned int n) { return n > 0; });
  if (1U << n_generations != partition.ratio || is_given)
    throw ComputationError("Patches in space are faces of coarser meshes.");
  std::map<unsigned int, unsigned int> contacts;
  for (unsigned int i = 0; i < scene_.contacts.size(); ++i)
    contacts[scene_.contacts[i].side] = i;
  std::map<std::pair<CellId, unsigned int>, unsigned int> numbers;
  for (unsigned int f = 0; f < faces_.size(); ++f) {
    const ContactFace<3> &face = faces_[f];
    const Ancestor ancestor = ancestor_of(face, n_generations);
    const auto [patch, is_new] =
      numbers.emplace(std::pair(ancestor.cell, face.face_no), patches_.size());
    if (is_new) {
      patches_.push_back({contacts.at(face.side), face.side, {0., 0.}, {1., 1.}, 0.});
      patches_.back().face = {ancestor.cell, face.face_no, {}};
    }
    Patch<3> &group = patches_[patch->second];
    group.measure += area_of(face.vertices);
    for (unsigned int v = 0; v < 4; ++v)
      if (ancestor.position[0] == (v % 2) * (partition.ratio - 1) &&
          ancestor.position[1] == (v / 2) * (partition.ratio - 1))
        group.face.corners[v] = face.vertices[v];
    Piece<3> piece = {f, patch->second, {}, {}, {0., 0.}, {1., 1.}, {}};
    for (unsigned int d = 0; d < 2; ++d) {
      piece.lower[d] = double(ancestor.position[d]) / partition.ratio;
      piece.upper[d] = double(ancestor.position[d] + 1) / partition.ratio;
    }
    pieces_.push_back(piece);
  }
}

template <>
void ContactSurface<3>::set_coordinates(const Piece<3> &piece, SurfaceRule<3> &rule) const {
  for (const Point<2> &xi : rule.on_face) {
    Point<2> s;
    for (unsigned int d = 0; d < 2; ++d)
      s[d] = piece.lower[d] + xi[d] * (piece.upper[d] - piece.lower[d]);
    rule.on_side.push_back(s);
  }
}

template <>
void ContactSurface<3>::complete(const Piece<3> &piece, SurfaceRule<3> &rule) const {
  // D with the normals of facets would hold a ball that is free to spin.
  const Side<3> &side = this->side(patches_[piece.patch]);
  if (side.surface().has_normals())
    for (std::size_t q = 0; q < rule.size(); ++q)
      rule.normals[q] = side.normal_at(rule.points[q]);
  const ContactDirections<3> &directions = condition(piece).directions;
  rule.directions = rule.normals;
  for (std::size_t q = 0; q < rule.size() && !directions.are_normals(); ++q)
    rule.directions[q] = directions.at(side.project(rule.points[q]), rule.normals[q]);
}

// The vertices determine the faces, and cost less than an FEFaceValues object for each of them.
template <>
SurfaceRule<3> ContactSurface<3>::at(const Piece<3> &piece,
                                     const std::vector<Point<2>> &positions) const {
  const ContactFace<3> &face = faces_[piece.face];
  const Side<3> &side = this->side(patches_[piece.patch]);
  SurfaceRule<3> rule;
  rule.on_face = positions;
  for (const Point<2> &xi : positions) {
    rule.points.push_back(side.project(point_on(face.vertices, xi)));
    rule.normals.push_back(normal_of(face.vertices, face.face_no, xi));
  }
  set_coordinates(piece, rule);
  complete(piece, rule);
  return rule;
}

template <>
SurfaceRule<3> ContactSurface<3>::rule(const Piece<3> &piece, const unsigned int n_points,
                                       const Grading /*there are no kinks in 3-D*/) const {
  const QGauss<2> gauss(n_points);
  SurfaceRule<3> rule = at(piece, gauss.get_points());
  const FaceCorners &corners = faces_[piece.face].vertices;
  for (unsigned int q = 0; q < gauss.size(); ++q)
    rule.weights.push_back(gauss.weight(q) * area_vector(corners, gauss.point(q)).norm());
  return rule;
}

template <>
Point<3> ContactSurface<3>::point(const Patch<3> &patch, const Point<2> &s) const {
  return side(patch).project(point_on(patch.face.corners, s));
}

template <>
SurfacePoint<3> ContactSurface<3>::middle(const Patch<3> &patch) const {
  const Point<3> x = point(patch, patch.centre());
  return {x, side(patch).surface().has_normals()
               ? side(patch).normal_at(x)
               : normal_of(patch.face.corners, patch.face.face_no, patch.centre())};
}

template <>
std::vector<Neighbours<3>> ContactSurface<3>::neighbours() const {
  /** A patch at an edge, and the direction across the edge. */
  using PatchAtEdge = std::pair<unsigned int, unsigned int>;
  const auto corner = [&](const unsigned int patch, const unsigned int edge,
                          const unsigned int end) -> const Point<3> & {
    return patches_[patch].face.corners[edges_of_face[edge][end]];
  };
  const auto width = [&](const unsigned int patch, const unsigned int d) {
    return (0.5 * ((corner(patch, 2 * d + 1, 0) - corner(patch, 2 * d, 0)) +
                   (corner(patch, 2 * d + 1, 1) - corner(patch, 2 * d, 1))))
      .norm();
  };
  const auto key_of = [&](const unsigned int patch, const unsigned int edge) {
    return std::pair(patches_[patch].contact,
                     edge_key(corner(patch, edge, 0), corner(patch, edge, 1)));
  };
  std::map<std::pair<unsigned int, EdgeKey>, std::vector<PatchAtEdge>> patches_at;
  for (unsigned int patch = 0; patch < patches_.size(); ++patch)
    for (unsigned int edge = 0; edge < 4; ++edge)
      patches_at[key_of(patch, edge)].emplace_back(patch, edge / 2);
  std::vector<Neighbours<3>> all(patches_.size());
  for (unsigned int patch = 0; patch < patches_.size(); ++patch)
    for (unsigned int edge = 0; edge < 4; ++edge)
      for (const auto &[other, across] : patches_at.at(key_of(patch, edge)))
        if (other != patch) {
          const double ratio = width(other, across) / width(patch, edge / 2);
          const bool is_before = edge % 2 == 0;
          all[patch][edge / 2][edge % 2] = {other, is_before ? -ratio : 1.,
                                            is_before ? 0. : 1. + ratio};
        }
  return all;
}
} // namespace Signorini
