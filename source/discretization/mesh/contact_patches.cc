// SPDX-License-Identifier: LGPL-2.1-or-later
// Γ_c in 2-D: faces, patches and pieces are intervals of arc length.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/mesh/cut_quadrature.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace Signorini {
namespace {
/** A contact face with the arc lengths of its ends. */
struct FaceInterval {
  ContactFace<2> face;
  double start, end;
  /** Whether the face's own parameter runs against the arc length. */
  bool reversed;

  /** Returns the face's own parameter of the point at arc length @p s; exactly 0 and 1 at the ends.
   */
  Point<1> parameter(const double s) const {
    const double t = s == start ? 0. : s == end ? 1. : (s - start) / (end - start);
    return Point<1>(reversed ? 1. - t : t);
  }
};

/** Returns the interval of a face. At the end of a closed side its length replaces 0. */
FaceInterval interval_of(const ContactFace<2> &face, const Side<2> &side) {
  const auto mesh_face = face.cell->face(face.face_no);
  double first = side.arc_length(mesh_face->vertex(0));
  double last = side.arc_length(mesh_face->vertex(1));
  if (side.is_closed()) {
    const double middle =
      side.arc_length(mesh_face->vertex(0) + 0.5 * (mesh_face->vertex(1) - mesh_face->vertex(0)));
    for (double *const end : {&first, &last})
      *end += side.length() * std::round((middle - *end) / side.length());
  }
  return {face, std::min(first, last), std::max(first, last), last < first};
}

/** Returns the ends of the patches on the faces [first, last), which make up a side; groups of
 * faces end at corners of the side. */
std::vector<double> ends_of_patches(const std::vector<FaceInterval> &faces, const std::size_t first,
                                    const std::size_t last, const Curve &curve,
                                    const Partition &partition) {
  std::vector<double> ends;
  if (const unsigned int n = partition.patches_per_side) {
    for (unsigned int t = 0; t <= n; ++t)
      ends.push_back(t * faces[last - 1].end / n);
    return ends;
  }
  ends.push_back(faces[first].start);
  for (std::size_t begin = first, end = first; begin < last; begin = end) {
    while (end < last && (end == begin || !curve.has_corner(faces[end].start)))
      ++end;
    for (std::size_t k = begin + partition.ratio; k + partition.ratio <= end; k += partition.ratio)
      ends.push_back(faces[k].start);
    ends.push_back(faces[end - 1].end);
  }
  return ends;
}

/** The smallest number of points on graded parts: with fewer, a square root between two graded
 * positions is not integrated to 1e-8. */
constexpr unsigned int min_graded_points = 8;

/** The reach of a singularity in lengths of a piece: closer to it, three points do not integrate a
 * function like r^{1/2} to 1e-10. */
constexpr double reach_of_singularity = 16.;

/** Inserts positions that approach both ends of every interval by factors of four. */
std::vector<double> grade(const std::vector<double> &cuts) {
  std::vector<double> graded = cuts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    graded.push_back(cuts[i] + half);
    for (const auto &positions :
         {graded_positions(cuts[i], 0.25 * half), graded_positions(cuts[i + 1], -0.25 * half)})
      graded.insert(graded.end(), positions.begin(), positions.end());
  }
  std::sort(graded.begin(), graded.end());
  return graded;
}

/** Returns the points of a piece with the given arc lengths, without weights. */
SurfaceRule<2> points_at(const Piece<2> &piece, const Side<2> &side,
                         const std::vector<Point<1>> &arc_lengths) {
  SurfaceRule<2> rule;
  rule.on_side = arc_lengths;
  const double middle = 0.5 * (piece.lower[0] + piece.upper[0]);
  for (const Point<1> &s : arc_lengths) {
    const double r = (s[0] - piece.lower[0]) / (piece.upper[0] - piece.lower[0]);
    rule.on_face.emplace_back((1. - r) * piece.lower_on_face[0] + r * piece.upper_on_face[0]);
    rule.points.push_back(side.point(s));
    rule.normals.push_back(side.normal(s[0], middle));
  }
  return rule;
}
} // namespace

template <>
void ContactSurface<2>::divide(const Partition &partition) {
  std::vector<FaceInterval> faces;
  for (const ContactFace<2> &face : faces_)
    faces.push_back(interval_of(face, scene_.geometry.sides[face.side]));
  std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
    return std::tie(a.face.side, a.start) < std::tie(b.face.side, b.start);
  });
  for (unsigned int f = 0, last = 0; f < faces.size();) {
    const unsigned int side = faces[f].face.side;
    while (last < faces.size() && faces[last].face.side == side)
      ++last;
    const std::vector<double> ends =
      ends_of_patches(faces, f, last, scene_.geometry.sides[side], partition);
    for (std::size_t t = 0; t + 1 < ends.size(); ++t) {
      const unsigned int patch = patches_.size();
      patches_.push_back({side, Point<1>(ends[t]), Point<1>(ends[t + 1]), ends[t + 1] - ends[t]});
      for (bool face_ends = true; face_ends && f < last; f += face_ends ? 1 : 0) {
        const FaceInterval &face = faces[f];
        // Ends that differ by rounding only are the same: no slivers.
        const double sliver = 1e-10 * (face.end - face.start);
        const double start = std::max(face.start, ends[t]), end = std::min(face.end, ends[t + 1]);
        if (end - start > sliver)
          pieces_.push_back({f,
                             patch,
                             Point<1>(start),
                             Point<1>(end),
                             face.parameter(start),
                             face.parameter(end),
                             {}});
        face_ends = face.end <= ends[t + 1] + sliver;
      }
    }
    f = last;
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces_[f] = faces[f].face;
}

template <>
Piece<2> ContactSurface<2>::part(const Piece<2> &piece, const unsigned int i,
                                 const unsigned int n) const {
  const auto at = [n](const Point<1> &a, const Point<1> &b, const double k) {
    return a + k / n * (b - a);
  };
  return {piece.face,
          piece.patch,
          at(piece.lower, piece.upper, i),
          at(piece.lower, piece.upper, i + 1.),
          at(piece.lower_on_face, piece.upper_on_face, i),
          at(piece.lower_on_face, piece.upper_on_face, i + 1.),
          {}};
}

template <>
SurfaceRule<2> ContactSurface<2>::at(const Piece<2> &piece,
                                     const std::vector<Point<1>> &positions) const {
  std::vector<Point<1>> arc_lengths;
  for (const Point<1> &r : positions)
    arc_lengths.emplace_back((1. - r[0]) * piece.lower[0] + r[0] * piece.upper[0]);
  return points_at(piece, side(patches_[piece.patch]), arc_lengths);
}

template <>
SurfaceRule<2> ContactSurface<2>::rule(const Piece<2> &piece, const unsigned int n_points,
                                       const Grading grading) const {
  const Side<2> &side = this->side(patches_[piece.patch]);
  const double start = piece.lower[0], end = piece.upper[0];
  std::vector<double> cuts = scene_.kinks.cut(side, start, end);
  const auto singular_within = [&](const double lengths) {
    const double distance = lengths * (end - start);
    return grading == Grading::towards_kinks &&
           (scene_.kinks.touch(side, start, end) ||
            scene_.kinks.crossings(side, start - distance, end + distance).size() > 2);
  };
  // A singularity less than a length away needs the same grading as one inside.
  if (singular_within(1.))
    cuts = grade(cuts);
  const QGauss<1> gauss(
    singular_within(reach_of_singularity) ? std::max(n_points, min_graded_points) : n_points);
  const Quadrature<1> quadrature = split_quadrature(gauss, cuts);
  SurfaceRule<2> rule = points_at(piece, side, quadrature.get_points());
  rule.weights = quadrature.get_weights();
  for (std::size_t q = 0; q < rule.size(); ++q)
    rule.weights[q] *= scene_.geometry.circumference(rule.points[q]);
  return rule;
}

// Γ_c in 3-D: pieces are faces of a side of a box, which are equal rectangles, and patches are
// rectangles of faces.

template <>
void ContactSurface<3>::divide(const Partition &partition) {
  if (partition.patches_per_side > 0)
    throw ComputationError("In space, contact patches are groups of faces of the mesh.");
  // The number of the patch by its side, column and row.
  std::map<std::array<unsigned int, 3>, unsigned int> numbers;
  for (unsigned int f = 0; f < faces_.size(); ++f) {
    const ContactFace<3> &face = faces_[f];
    const Side<3> &side = scene_.geometry.sides[face.side];
    const auto mesh_face = face.cell->face(face.face_no);
    std::vector<Point<2>> corners;
    for (const unsigned int v : mesh_face->vertex_indices())
      corners.push_back(side.coordinates(mesh_face->vertex(v)));
    Piece<3> piece = {f, 0, {}, {}, {0., 0.}, {1., 1.}, {}};
    std::tie(piece.lower, piece.upper) = BoundingBox<2>(corners).get_boundary_points();
    std::array<unsigned int, 3> place = {{face.side, 0, 0}};
    for (unsigned int d = 0; d < 2; ++d) {
      const double edge = piece.upper[d] - piece.lower[d];
      const long n_faces = std::lround(side.lengths()[d] / edge);
      // The last patches are larger where the ratio does not divide the faces.
      place[1 + d] = std::min(std::lround(piece.lower[d] / edge) / partition.ratio,
                              std::max(n_faces / partition.ratio, 1L) - 1);
    }
    const auto [group, is_new] = numbers.emplace(place, patches_.size());
    if (is_new)
      patches_.push_back({face.side, piece.lower, piece.upper, 0.});
    piece.patch = group->second;
    Patch<3> &patch = patches_[piece.patch];
    const std::vector<Point<2>> both = {patch.lower, patch.upper, piece.lower, piece.upper};
    std::tie(patch.lower, patch.upper) = BoundingBox<2>(both).get_boundary_points();
    patch.measure += mesh_face->measure();
    pieces_.push_back(piece);
  }
}

// The vertices determine the faces, and cost less than an FEFaceValues object for each of them.
template <>
SurfaceRule<3> ContactSurface<3>::at(const Piece<3> &piece,
                                     const std::vector<Point<2>> &positions) const {
  const ContactFace<3> &face = faces_[piece.face];
  const auto mesh_face = face.cell->face(face.face_no);
  const Side<3> &side = this->side(patches_[piece.patch]);
  SurfaceRule<3> rule;
  rule.on_face = positions;
  for (const Point<2> &position : positions) {
    Point<3> x;
    for (const unsigned int v : GeometryInfo<2>::vertex_indices())
      x += GeometryInfo<2>::d_linear_shape_function(position, v) * mesh_face->vertex(v);
    rule.points.push_back(x);
    rule.on_side.push_back(side.coordinates(x));
    rule.normals.push_back(side.normal(rule.on_side.back()));
  }
  return rule;
}

template <>
SurfaceRule<3> ContactSurface<3>::rule(const Piece<3> &piece, const unsigned int n_points,
                                       const Grading /*there are no kinks in 3-D*/) const {
  const QGauss<2> gauss(n_points);
  SurfaceRule<3> rule = at(piece, gauss.get_points());
  const Tensor<1, 2> edges = piece.upper - piece.lower;
  for (const double weight : gauss.get_weights())
    rule.weights.push_back(weight * edges[0] * edges[1]);
  return rule;
}
} // namespace Signorini
