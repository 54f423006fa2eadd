// SPDX-License-Identifier: LGPL-2.1-or-later
// Γ_c in 2-D: faces, patches and pieces are intervals of arc length.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/mesh/cut_quadrature.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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

  /** Returns the face's own parameter of the point at arc length @p s; exactly 0 and 1 at the ends.
   */
  Point<1> parameter(const double s) const
  {
    const double t = s == start ? 0. : s == end ? 1. : (s - start) / (end - start);
    return Point<1>(reversed ? 1. - t : t);
  }
};

/** Returns the interval of a face. At the end of a closed side its length replaces 0. */
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
  return {side, Point<1>(start), Point<1>(end), end - start};
}

/** Returns the patches of a side that has the given faces; groups of faces end at corners of the
 * side. */
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

/** Returns all non-empty intersections of faces and patches; both are sorted by side and arc
 * length. */
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
                        Point<1>(start),
                        Point<1>(end),
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

/** The smallest number of points on graded parts: with fewer, a square root between two graded
 * positions is not integrated to 1e-8. */
constexpr unsigned int min_graded_points = 8;

/** The reach of a singularity in lengths of a piece: closer to it, three points do not integrate a
 * function like r^{1/2} to 1e-10. */
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

/** Returns the points of a piece with the given arc lengths, without weights. */
SurfaceRule<2> points_at(const Piece<2> &piece,
                         const Side<2> &side,
                         const std::vector<Point<1>> &arc_lengths)
{
  SurfaceRule<2> rule;
  rule.on_side = arc_lengths;
  const double middle = 0.5 * (piece.lower[0] + piece.upper[0]);
  for (const Point<1> &s : arc_lengths)
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
  const auto between = [](const Point<1> &a, const Point<1> &b, const double r) {
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
                                     const std::vector<Point<1>> &positions) const
{
  std::vector<Point<1>> arc_lengths;
  arc_lengths.reserve(positions.size());
  for (const Point<1> &r : positions)
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
  // A singularity less than a length away needs the same grading as one inside.
  if (singular_within(1.))
    cuts = grade(cuts);
  const QGauss<1> gauss(
    singular_within(reach_of_singularity) ? std::max(n_points, min_graded_points) : n_points);
  const Quadrature<1> quadrature = split_quadrature(gauss, cuts);
  SurfaceRule<2> rule = points_at(piece, side, quadrature.get_points());
  rule.weights = quadrature.get_weights();
  return rule;
}

// Γ_c in 3-D: patches are squares of faces of a rectangular side.

namespace
{
/** The side, and the place of a patch among those of the side in both directions. */
using Group = std::array<unsigned int, 3>;

/** Returns the lines between the faces of a side in one direction, from its start, without the last
 * one. */
std::vector<double> lines(std::vector<double> starts, const double length)
{
  // Neighbouring faces agree but for rounding.
  const double rounding = 1e-9 * length;
  std::sort(starts.begin(), starts.end());
  std::vector<double> distinct;
  for (const double s : starts)
    if (distinct.empty() || s > distinct.back() + rounding)
      distinct.push_back(s);
  return distinct;
}

/** Returns the smallest step of a sorted list; zero for a single line. */
double min_step(const std::vector<double> &lines)
{
  double smallest = 0.;
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (const double step = lines[i] - lines[i - 1]; smallest == 0. || step < smallest)
      smallest = step;
  return smallest;
}

/** The faces of a side, which is a rectangle, in rows and columns. */
class FaceGrid
{
public:
  FaceGrid(const Side<3> &side, const std::vector<Point<2>> &corners)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      std::vector<double> starts;
      for (const Point<2> &corner : corners)
        starts.push_back(corner[d]);
      lines_[d] = lines(std::move(starts), side.lengths()[d]);
      steps_[d] = min_step(lines_[d]);
    }
  }

  /** Returns the place of the patch of ratio × ratio faces to which the face belongs. The last
   * patches are larger where the ratio does not divide the faces. */
  std::array<unsigned int, 2> patch_of(const Point<2> &corner, const unsigned int ratio) const
  {
    std::array<unsigned int, 2> place;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const auto n_faces = static_cast<unsigned int>(lines_[d].size());
      const auto nearest = std::lower_bound(
        lines_[d].begin(),
        lines_[d].end(),
        corner[d],
        [this, d](const double line, const double s) { return line < s - 0.5 * steps_[d]; });
      const auto number = static_cast<unsigned int>(nearest - lines_[d].begin());
      place[d] = std::min(number / ratio, std::max(n_faces / ratio, 1U) - 1);
    }
    return place;
  }

private:
  std::array<std::vector<double>, 2> lines_;
  std::array<double, 2> steps_ = {};
};

/** Returns the corner with the smaller coordinates of the box around a face in the coordinates of
 * its side. */
Point<2> first_corner(const ContactFace<3> &face, const Side<3> &side)
{
  const auto mesh_face = face.cell->face(face.face_no);
  Point<2> corner = side.coordinates(mesh_face->vertex(0));
  for (unsigned int v = 1; v < mesh_face->n_vertices(); ++v)
  {
    const Point<2> s = side.coordinates(mesh_face->vertex(v));
    for (unsigned int d = 0; d < 2; ++d)
      corner[d] = std::min(corner[d], s[d]);
  }
  return corner;
}

/** Returns the grids of the faces by side. */
std::map<unsigned int, FaceGrid> face_grids(const std::vector<ContactFace<3>> &faces,
                                            const Geometry<3> &geometry)
{
  std::map<unsigned int, std::vector<Point<2>>> corners;
  for (const ContactFace<3> &face : faces)
    corners[face.side].push_back(first_corner(face, geometry.sides[face.side]));
  std::map<unsigned int, FaceGrid> grids;
  for (const auto &[side, side_data] : corners)
    grids.emplace(side, FaceGrid(geometry.sides[side], side_data));
  return grids;
}

/** Enlarges the box between @p lower and @p upper by a point. */
void extend(Point<2> &lower, Point<2> &upper, const Point<2> &s)
{
  for (unsigned int d = 0; d < 2; ++d)
  {
    lower[d] = std::min(lower[d], s[d]);
    upper[d] = std::max(upper[d], s[d]);
  }
}
} // namespace

template <>
void ContactSurface<3>::divide(const Partition &partition)
{
  if (partition.patches_per_side > 0)
    throw ComputationError("In space, contact patches are groups of faces of the mesh.");
  const std::map<unsigned int, FaceGrid> grids = face_grids(faces_, scene_.geometry);
  std::map<Group, unsigned int> numbers;
  for (unsigned int f = 0; f < faces_.size(); ++f)
  {
    const ContactFace<3> &face = faces_[f];
    const Side<3> &side = scene_.geometry.sides[face.side];
    const auto mesh_face = face.cell->face(face.face_no);
    const Point<2> first = side.coordinates(mesh_face->vertex(0));
    Piece<3> piece = {f, 0, first, first, {0., 0.}, {1., 1.}, {}};
    for (unsigned int v = 1; v < mesh_face->n_vertices(); ++v)
      extend(piece.lower, piece.upper, side.coordinates(mesh_face->vertex(v)));
    const auto place = grids.at(face.side).patch_of(first_corner(face, side), partition.ratio);
    const auto [group, is_new] = numbers.emplace(Group{face.side, place[0], place[1]},
                                                 static_cast<unsigned int>(patches_.size()));
    if (is_new)
      patches_.push_back({face.side, piece.lower, piece.upper, 0.});
    piece.patch = group->second;
    Patch<3> &patch = patches_[piece.patch];
    extend(patch.lower, patch.upper, piece.lower);
    extend(patch.lower, patch.upper, piece.upper);
    patch.measure += mesh_face->measure();
    pieces_.push_back(piece);
  }
}

// Faces are plane quadrilaterals with bilinear maps: their vertices determine them, and cost less
// than an FEFaceValues object for each of them.
template <>
SurfaceRule<3> ContactSurface<3>::at(const Piece<3> &piece,
                                     const std::vector<Point<2>> &positions) const
{
  const ContactFace<3> &face = faces_[piece.face];
  const auto mesh_face = face.cell->face(face.face_no);
  const Side<3> &side = this->side(patches_[piece.patch]);
  SurfaceRule<3> rule;
  rule.on_face = positions;
  for (const Point<2> &position : positions)
  {
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
SurfaceRule<3> ContactSurface<3>::rule(const Piece<3> &piece,
                                       const unsigned int n_points,
                                       const Grading /*there are no kinks in 3-D*/) const
{
  const QGauss<2> gauss(n_points);
  const ContactFace<3> &face = faces_[piece.face];
  const auto mesh_face = face.cell->face(face.face_no);
  SurfaceRule<3> rule = at(piece, gauss.get_points());
  for (unsigned int q = 0; q < gauss.size(); ++q)
  {
    std::array<Tensor<1, 3>, 2> tangents;
    for (const unsigned int v : GeometryInfo<2>::vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
        tangents[d] += GeometryInfo<2>::d_linear_shape_function_gradient(gauss.point(q), v)[d] *
                       mesh_face->vertex(v);
    rule.weights.push_back(gauss.weight(q) * cross_product_3d(tangents[0], tangents[1]).norm());
  }
  return rule;
}
} // namespace Signorini
