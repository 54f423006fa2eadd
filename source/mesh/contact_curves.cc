// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c in the plane: faces, patches and pieces are intervals of arc length.

#include <signorini/mesh/contact_surface.h>
#include <signorini/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** A contact face with the arc lengths of its ends. */
struct FaceInterval
{
  ContactFace<2> face;
  double start, end;
  /** Whether the face's own parameter runs against the arc length. */
  bool reversed;

  /** The face's own parameter of the point at arc length @p s; exactly 0 and 1 at the ends. */
  dealii::Point<1> parameter(const double s) const
  {
    const double t = s == start ? 0. : s == end ? 1. : (s - start) / (end - start);
    return dealii::Point<1>(reversed ? 1. - t : t);
  }
};

/** Where a closed side ends, its length stands for 0. */
FaceInterval interval_of(const ContactFace<2> &face, const Side<2> &side)
{
  const auto mesh_face = face.cell->face(face.face_no);
  double first = side.arc_length(mesh_face->vertex(0));
  double last = side.arc_length(mesh_face->vertex(1));
  if (side.is_closed())
  {
    const double middle =
      side.arc_length(mesh_face->vertex(0) + 0.5 * (mesh_face->vertex(1) - mesh_face->vertex(0)));
    for (double *const end : {&first, &last})
      *end += side.length() * std::round((middle - *end) / side.length());
  }
  return {face, std::min(first, last), std::max(first, last), last < first};
}

Patch<2> make_patch(const unsigned int side, const double start, const double end)
{
  return {side, dealii::Point<1>(start), dealii::Point<1>(end), end - start};
}

/** The patches of a side that has the given faces; groups of faces end at corners of the side. */
std::vector<Patch<2>> divide_side(const std::vector<FaceInterval> &faces,
                                  const std::size_t first,
                                  const std::size_t last,
                                  const Curve &curve,
                                  const Partition &partition)
{
  const unsigned int side = faces[first].face.side;
  std::vector<Patch<2>> patches;
  if (const unsigned int n = partition.patches_per_side)
  {
    const double length = faces[last - 1].end;
    for (unsigned int t = 0; t < n; ++t)
      patches.push_back(make_patch(side, t * length / n, (t + 1) * length / n));
    return patches;
  }
  for (std::size_t begin = first, end = first; begin < last; begin = end)
  {
    while (end < last && (end == begin || !curve.has_corner(faces[end].start)))
      ++end;
    const std::size_t n = std::max<std::size_t>(1, (end - begin) / partition.ratio);
    for (std::size_t t = 0; t < n; ++t)
    {
      const std::size_t from = begin + t * partition.ratio;
      const std::size_t to = t + 1 == n ? end : from + partition.ratio;
      patches.push_back(make_patch(side, faces[from].start, faces[to - 1].end));
    }
  }
  return patches;
}

/** All non-empty intersections of faces and patches; both are sorted by side and arc length. */
std::vector<Piece<2>> intersect(const std::vector<FaceInterval> &faces,
                                const std::vector<Patch<2>> &patches)
{
  std::vector<Piece<2>> pieces;
  std::size_t f = 0;
  std::size_t t = 0;
  while (f < faces.size() && t < patches.size())
  {
    const FaceInterval &face = faces[f];
    const Patch<2> &patch = patches[t];
    if (face.face.side != patch.side)
    {
      face.face.side < patch.side ? ++f : ++t;
      continue;
    }
    // Ends that differ by rounding only are the same: no slivers.
    const double sliver = 1e-10 * (face.end - face.start);
    const double start = std::max(face.start, patch.lower[0]);
    const double end = std::min(face.end, patch.upper[0]);
    if (end - start > sliver)
      pieces.push_back({static_cast<unsigned int>(f),
                        static_cast<unsigned int>(t),
                        dealii::Point<1>(start),
                        dealii::Point<1>(end),
                        face.parameter(start),
                        face.parameter(end),
                        {}});
    const bool face_ends = face.end <= patch.upper[0] + sliver;
    const bool patch_ends = patch.upper[0] <= face.end + sliver;
    f += face_ends ? 1 : 0;
    t += patch_ends ? 1 : 0;
  }
  return pieces;
}

/** With fewer, a square root between two graded positions is not integrated to 1e-8. */
constexpr unsigned int fewest_graded_points = 8;

/** In lengths of a piece: closer to a singular point, three points do not integrate a function like
 * r^{1/2} to 1e-10. */
constexpr double reach_of_singularity = 16.;

/** Inserts positions that approach both ends of every interval by factors of four. */
std::vector<double> grade(const std::vector<double> &cuts)
{
  std::vector<double> graded = cuts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    graded.push_back(cuts[i] + half);
    for (const auto &positions :
         {graded_positions(cuts[i], 0.25 * half), graded_positions(cuts[i + 1], -0.25 * half)})
      graded.insert(graded.end(), positions.begin(), positions.end());
  }
  std::sort(graded.begin(), graded.end());
  return graded;
}

/** The points of a piece with the given arc lengths, without weights. */
SurfaceRule<2> points_at(const Piece<2> &piece,
                         const Side<2> &side,
                         const std::vector<dealii::Point<1>> &arc_lengths)
{
  SurfaceRule<2> rule;
  rule.on_side = arc_lengths;
  const double middle = 0.5 * (piece.lower[0] + piece.upper[0]);
  for (const dealii::Point<1> &s : arc_lengths)
  {
    const double r = (s[0] - piece.lower[0]) / (piece.upper[0] - piece.lower[0]);
    rule.on_face.emplace_back((1. - r) * piece.lower_on_face[0] + r * piece.upper_on_face[0]);
    rule.points.push_back(side.point(s));
    rule.normals.push_back(side.normal(s[0], middle));
  }
  return rule;
}
} // namespace

template <>
void ContactSurface<2>::divide(const Partition &partition)
{
  std::vector<FaceInterval> faces;
  for (const ContactFace<2> &face : faces_)
    faces.push_back(interval_of(face, scene_.geometry.sides[face.side]));
  std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
    return a.face.side != b.face.side ? a.face.side < b.face.side : a.start < b.start;
  });
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last)
  {
    while (last < faces.size() && faces[last].face.side == faces[first].face.side)
      ++last;
    const std::vector<Patch<2>> patches =
      divide_side(faces, first, last, scene_.geometry.sides[faces[first].face.side], partition);
    patches_.insert(patches_.end(), patches.begin(), patches.end());
  }
  pieces_ = intersect(faces, patches_);
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces_[f] = faces[f].face;
}

template <>
Piece<2> ContactSurface<2>::part(const Piece<2> &piece,
                                 const unsigned int i,
                                 const unsigned int n) const
{
  const auto between = [](const dealii::Point<1> &a, const dealii::Point<1> &b, const double r) {
    return a + r * (b - a);
  };
  const double first = double(i) / n, last = (i + 1.) / n;
  return {piece.face,
          piece.patch,
          between(piece.lower, piece.upper, first),
          between(piece.lower, piece.upper, last),
          between(piece.lower_on_face, piece.upper_on_face, first),
          between(piece.lower_on_face, piece.upper_on_face, last),
          {}};
}

template <>
SurfaceRule<2> ContactSurface<2>::at(const Piece<2> &piece,
                                     const std::vector<dealii::Point<1>> &positions) const
{
  std::vector<dealii::Point<1>> arc_lengths;
  arc_lengths.reserve(positions.size());
  for (const dealii::Point<1> &r : positions)
    arc_lengths.emplace_back((1. - r[0]) * piece.lower[0] + r[0] * piece.upper[0]);
  return points_at(piece, side(patches_[piece.patch]), arc_lengths);
}

template <>
SurfaceRule<2> ContactSurface<2>::rule(const Piece<2> &piece,
                                       const unsigned int n_points,
                                       const Grading grading) const
{
  const Side<2> &side = this->side(patches_[piece.patch]);
  const double start = piece.lower[0], end = piece.upper[0];
  std::vector<double> cuts = scene_.kinks.cut(side, start, end);
  const auto singular_within = [&](const double lengths) {
    const double distance = lengths * (end - start);
    return grading == Grading::towards_kinks &&
           (scene_.kinks.touch(side, start, end) ||
            scene_.kinks.cut(side, start - distance, end + distance).size() > 2);
  };
  // A singularity less than a length away is as bad as one inside.
  if (singular_within(1.))
    cuts = grade(cuts);
  const dealii::QGauss<1> gauss(
    singular_within(reach_of_singularity) ? std::max(n_points, fewest_graded_points) : n_points);
  const dealii::Quadrature<1> quadrature = split_quadrature(gauss, cuts);
  SurfaceRule<2> rule = points_at(piece, side, quadrature.get_points());
  rule.weights = quadrature.get_weights();
  return rule;
}
} // namespace Signorini
