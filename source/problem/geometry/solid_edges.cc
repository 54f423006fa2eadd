// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges of bodies in space, from the corners that faces of two sides share.

#include <signorini/problem/geometry/solid_edges.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Signorini {
namespace {
using PointPair = std::array<Point<3>, 2>;

/** An edge of one face. */
struct EdgeOfFace {
  unsigned int side;
  /** Across the edge into the face, and the outward normal. */
  Tensor<1, 3> tangent, normal;
};

EdgeOfFace edge_of(const Side<3> &side, const unsigned int number, const FaceCorners &face,
                   const PointPair &ends) {
  const Point<2> centre(0.5, 0.5);
  const Point<3> middle = ends[0] + 0.5 * (ends[1] - ends[0]);
  Tensor<1, 3> n =
    side.surface().has_normals() ? side.normal_at(middle) : area_vector(face, centre);
  n /= n.norm();
  Tensor<1, 3> into = cross_product_3d(n, ends[1] - ends[0]);
  into *= (into * (point_on(face, centre) - middle) > 0. ? 1. : -1.) / into.norm();
  return {number, into, n};
}
} // namespace

Point<3> SolidEdge::point(const Geometry<3> &geometry, const double share) const {
  const Point<3> x = ends[0] + share * (ends[1] - ends[0]);
  return geometry.sides[sides[1]].project(geometry.sides[sides[0]].project(x));
}

std::vector<SolidEdge> solid_edges(const Geometry<3> &geometry) {
  constexpr unsigned int corners_of_edges[4][2] = {{0, 1}, {0, 2}, {1, 3}, {2, 3}};
  // Faces that turn by less belong to one smooth side.
  constexpr double smooth = 1e-6;
  std::map<EdgeKey, EdgeOfFace> open;
  std::vector<SolidEdge> found;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (const FaceCorners &face : geometry.sides[i].faces())
      for (const auto &corners : corners_of_edges) {
        PointPair ends = {{face[corners[0]], face[corners[1]]}};
        if (lies_before(ends[1], ends[0]))
          std::swap(ends[0], ends[1]);
        const EdgeOfFace own = edge_of(geometry.sides[i], i, face, ends);
        const auto [other, is_new] = open.emplace(edge_key(ends[0], ends[1]), own);
        if (is_new)
          continue;
        const EdgeOfFace first = other->second;
        open.erase(other);
        const double cosine = std::clamp(first.tangent * own.tangent, -1., 1.);
        const double angle = own.tangent * first.normal < 0. ? std::acos(cosine)
                                                             : 2. * numbers::PI - std::acos(cosine);
        if (first.side != i ||
            (!geometry.sides[i].surface().has_normals() && std::abs(angle - numbers::PI) > smooth))
          found.push_back({ends, {{first.side, i}}, angle, first.tangent, first.normal});
      }
  return found;
}
} // namespace Signorini
