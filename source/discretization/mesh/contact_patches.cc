// SPDX-License-Identifier: LGPL-2.1-or-later
// Γ_c in the plane: faces, patches and pieces are intervals of arc length.

#include <signorini/base/errors.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/mesh/patch_row.h>
#include <signorini/problem/scene/contact_pair.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini {
namespace {
/** A contact face with the arc lengths of its ends. */
struct FaceInterval {
  ContactFace<2> face;
  FaceSpan span;
};

/** Returns the interval between two points of a side. At the end of a closed side its length
 * replaces 0. */
FaceSpan span_of(const Point<2> &first, const Point<2> &last, const Side<2> &side) {
  double from = side.arc_length(first), to = side.arc_length(last);
  if (side.is_closed()) {
    const double middle = side.arc_length(first + 0.5 * (last - first));
    for (double *const end : {&from, &to})
      *end += side.length() * std::round((middle - *end) / side.length());
  }
  return {std::min(from, to), std::max(from, to), to < from};
}

/** Returns the interval of a face on a side: its own one, or one to which it is projected. */
FaceSpan span_of(const ContactFace<2> &face, const Side<2> &side) {
  return span_of(face.vertices[0], face.vertices[1], side);
}

double longest_of(const std::vector<FaceSpan> &spans) {
  double longest = 0.;
  for (const FaceSpan &span : spans)
    longest = std::max(longest, span.end - span.start);
  return longest;
}

/** The intervals of the faces of a side and, in a pair, those of the other one that are projected
 * to it: [lower, upper] is where both are. */
struct SideFaces {
  std::vector<FaceSpan> own, opposite;
  /** The numbers of the faces. */
  std::vector<unsigned int> own_numbers, opposite_numbers;
  double lower, upper;

  /** Returns whether the overlap is at least as long as two faces. */
  bool holds_two_faces() const {
    return upper - lower >= 2. * (1. - 1e-10) * std::max(longest_of(own), longest_of(opposite));
  }
};

/** Returns the ends of groups of @p ratio intervals within [lower, upper]. Groups end at corners of
 * the side and where directions change, and the last one is the longer one. An interval that lies
 * there in part belongs to the group of its neighbour, and a group grows until an end of the @p
 * others, if there are any, lies inside: else it had no interior node of the other mesh. */
std::vector<double> groups_of(const std::vector<FaceSpan> &spans,
                              const std::vector<FaceSpan> &others, const unsigned int ratio,
                              const double lower, const double upper, const Curve &curve,
                              const ContactDirections<2> &directions) {
  std::vector<double> ends = {lower};
  std::vector<double> starts;
  const double sliver = 1e-10 * (upper - lower);
  for (const FaceSpan &span : spans)
    if (span.start >= lower - sliver && span.end <= upper + sliver)
      starts.push_back(span.start);
  if (!starts.empty())
    starts.erase(starts.begin());
  starts.push_back(upper);
  const auto holds_node = [&](const double from, const double to) {
    return others.empty() || std::any_of(others.begin(), others.end(), [&](const FaceSpan &other) {
             return other.start > from + sliver && other.start < to - sliver;
           });
  };
  for (std::size_t begin = 0, end = 0; begin < starts.size(); begin = end) {
    // The faces begin..end-1 lie before the next corner; starts[k] is where face k ends.
    do
      ++end;
    while (
      end < starts.size() && !curve.has_corner(starts[end - 1]) &&
      !directions.change_between(starts[end - 1] - 10. * sliver, starts[end - 1] + 10. * sliver));
    for (std::size_t k = begin + ratio; k + ratio <= end; k += ratio)
      if (holds_node(ends.back(), starts[k - 1]) && holds_node(starts[k - 1], starts[end - 1]))
        ends.push_back(starts[k - 1]);
    ends.push_back(starts[end - 1]);
  }
  return ends;
}

/**
 * Returns the ends of the patches on a side. In a pair they are groups of the finer faces, if these
 * hold 4/3 of the longest face of the other side; else groups of the coarser faces.
 */
std::vector<double> ends_of_patches(const SideFaces &faces, const Curve &curve,
                                    const ContactDirections<2> &directions,
                                    const unsigned int ratio, const unsigned int n) {
  if (n > 0) {
    std::vector<double> ends;
    for (unsigned int t = 0; t <= n; ++t)
      ends.push_back(faces.lower + t * (faces.upper - faces.lower) / n);
    return ends;
  }
  const double own = longest_of(faces.own), other = longest_of(faces.opposite);
  // The side's own faces are those sought if they are both finer and fine enough, or neither.
  const bool own_is_finer = own <= other;
  const bool fine_suffices =
    3. * ratio * std::min(own, other) >= 4. * (1. - 1e-10) * std::max(own, other);
  const bool takes_own = faces.opposite.empty() || own_is_finer == fine_suffices;
  return groups_of(takes_own ? faces.own : faces.opposite, takes_own ? faces.opposite : faces.own,
                   ratio, faces.lower, faces.upper, curve, directions);
}

/** Returns the ends of the faces of the carrier in the overlap, and its own ends. A face ends where
 * the side has a corner, too. */
std::vector<double> ends_of_faces(const std::vector<FaceSpan> &of_carrier, const SideFaces &faces,
                                  const Curve &curve) {
  const double sliver = 1e-12 * (faces.upper - faces.lower);
  std::vector<double> ends = {faces.lower, faces.upper};
  const auto add = [&](const double s) {
    if (s > faces.lower + sliver && s < faces.upper - sliver)
      ends.push_back(s);
  };
  for (const FaceSpan &span : of_carrier) {
    add(span.start);
    add(span.end);
  }
  std::for_each(curve.corners().begin(), curve.corners().end(), add);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end(),
                         [&](const double a, const double b) { return b - a < sliver; }),
             ends.end());
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

Point<1> FaceSpan::parameter(const double s) const {
  constexpr double rounding = 1e-9;
  double t = (s - start) / (end - start);
  t = t < rounding ? 0. : t > 1. - rounding ? 1. : t;
  return Point<1>(reversed ? 1. - t : t);
}

namespace {
/** An interval of a face, and the number of the face. */
using NumberedSpan = std::pair<FaceSpan, unsigned int>;

/** Returns whether a face of the other side of a pair faces a side where it is projected. */
bool faces_side(const ContactFace<2> &face, const Side<2> &its_side, const Side<2> &side,
                const FaceSpan &span) {
  const Point<2> middle = face.vertices[0] + 0.5 * (face.vertices[1] - face.vertices[0]);
  return its_side.normal(its_side.arc_length(middle)) * side.normal(0.5 * (span.start + span.end)) <
         0.;
}

/** Sorts intervals by arc length. Those of a closed side come as often as its overlap, which may
 * contain its start, contains a part of them. */
void sort_into(const std::vector<NumberedSpan> &found, const Side<2> &side, const SideFaces &faces,
               std::vector<FaceSpan> &spans, std::vector<unsigned int> &numbers) {
  std::vector<NumberedSpan> sorted;
  const double length = side.length(), rounding = 1e-10 * length;
  for (const auto &[span, number] : found)
    for (const int turn : {-1, 0, 1})
      if (const FaceSpan moved = {span.start + turn * length, span.end + turn * length,
                                  span.reversed};
          side.is_closed()
            ? moved.end > faces.lower + rounding && moved.start < faces.upper - rounding
            : turn == 0)
        sorted.emplace_back(moved, number);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto &a, const auto &b) { return a.first.start < b.first.start; });
  for (const auto &[span, number] : sorted) {
    spans.push_back(span);
    numbers.push_back(number);
  }
}

/** Returns the faces of the side of a contact, and those of the side that it touches. */
SideFaces faces_of(const ContactCondition<2> &contact, const std::vector<FaceInterval> &all,
                   const Scene<2> &scene) {
  const Side<2> &side = scene.geometry.sides[contact.side];
  const std::optional<unsigned int> &opposite = contact.opposite;
  SideFaces faces;
  std::vector<NumberedSpan> own, other;
  for (unsigned int f = 0; f < all.size(); ++f)
    if (all[f].face.side == contact.side)
      own.emplace_back(all[f].span, f);
    else if (opposite && all[f].face.side == *opposite)
      if (const FaceSpan span = span_of(all[f].face, side);
          faces_side(all[f].face, scene.geometry.sides[*opposite], side, span))
        other.emplace_back(span, f);
  faces.lower = own.front().first.start;
  faces.upper = own.back().first.end;
  if (opposite) {
    faces.lower = contact.from;
    faces.upper = contact.to;
  }
  sort_into(own, side, faces, faces.own, faces.own_numbers);
  sort_into(other, side, faces, faces.opposite, faces.opposite_numbers);
  return faces;
}

/** @throws InputError where the overlap of a pair is shorter than two faces. */
void require_two_faces(const SideFaces &faces, const ContactPair<2> &pair, const Side<2> &side) {
  if (pair.other_side() && !faces.holds_two_faces())
    throw InputError("the sides '" + side.name() + "' and '" + pair.other_name() +
                     "' face each other on less than two faces of the mesh, allowed: a finer mesh "
                     "(Coarsest level), or sides that face each other on a longer part.");
}

/** Returns the ends of pieces: those of patches, of faces of both sides, and where directions
 * change. */
std::vector<double> cuts_of(const SideFaces &faces, const std::vector<double> &ends,
                            const ContactDirections<2> &directions) {
  std::vector<double> cuts = ends;
  cuts.insert(cuts.end(), directions.changes().begin(), directions.changes().end());
  for (const auto *const spans : {&faces.own, &faces.opposite})
    for (const FaceSpan &span : *spans)
      for (const double s : {span.start, span.end})
        if (s > faces.lower && s < faces.upper)
          cuts.push_back(s);
  std::sort(cuts.begin(), cuts.end());
  // Ends that differ by rounding only are the same: no slivers.
  double shortest = faces.upper - faces.lower;
  const double rounding = 1e-12 * shortest;
  for (const FaceSpan &span : faces.own)
    shortest = std::min(shortest, span.end - span.start);
  cuts.erase(std::unique(cuts.begin(), cuts.end(),
                         [sliver = std::max(1e-10 * shortest, rounding)](
                           const double a, const double b) { return b - a < sliver; }),
             cuts.end());
  return cuts;
}

/** Returns the number of the interval that contains s, beginning with @p k. */
unsigned int containing(const std::vector<FaceSpan> &spans, unsigned int k, const double s) {
  while (k + 1 < spans.size() && s > spans[k].end)
    ++k;
  return k;
}
} // namespace

template <>
void ContactSurface<2>::divide(const Partition &partition) {
  std::vector<FaceInterval> all;
  for (const ContactFace<2> &face : faces_)
    all.push_back({face, span_of(face, scene_.geometry.sides[face.side])});
  std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
    return std::tie(a.face.side, a.span.start) < std::tie(b.face.side, b.span.start);
  });
  for (const ContactPair<2> &pair : contact_pairs(scene_)) {
    const SideFaces faces = faces_of(pair.data(), all, scene_);
    const Side<2> &side = scene_.geometry.sides[pair.side()];
    const std::vector<FaceSpan> &of_carrier =
      pair.carrier() == pair.side() ? faces.own : faces.opposite;
    if (!partition.by_carrier)
      require_two_faces(faces, pair, side);
    const ContactDirections<2> &directions = pair.data().directions;
    const std::vector<double> ends =
      partition.by_carrier
        ? ends_of_faces(of_carrier, faces, side)
        : ends_of_patches(
            faces, side, directions, partition.ratio,
            partition.patches_by_contact.empty() ? 0 : partition.patches_by_contact[pair.number()]);
    const unsigned int first_patch = patches_.size();
    for (std::size_t t = 0, k = 0; t + 1 < ends.size(); ++t) {
      const double length = ends[t + 1] - ends[t], near = 1e-9 * length;
      patches_.push_back({pair.number(), pair.side(), Point<1>(ends[t]), Point<1>(ends[t + 1]),
                          length, directions.change_between(ends[t] + near, ends[t + 1] - near)});
      if (partition.by_carrier) {
        k = containing(of_carrier, k, 0.5 * (ends[t] + ends[t + 1]));
        patches_.back().share = std::min(1., length / (of_carrier[k].end - of_carrier[k].start));
      }
    }
    const std::vector<double> cuts = cuts_of(faces, ends, directions);
    for (unsigned int i = 0, own = 0, opposite = 0, t = 0; i + 1 < cuts.size(); ++i) {
      const double start = cuts[i], end = cuts[i + 1], middle = 0.5 * (start + end);
      own = containing(faces.own, own, middle);
      while (middle > ends[t + 1])
        ++t;
      const FaceSpan &span = faces.own[own];
      Piece<2> &piece = pieces_.emplace_back();
      piece.face = faces.own_numbers[own];
      piece.patch = first_patch + t;
      piece.lower = Point<1>(start);
      piece.upper = Point<1>(end);
      piece.lower_on_face = span.parameter(start);
      piece.upper_on_face = span.parameter(end);
      if (!faces.opposite.empty()) {
        opposite = containing(faces.opposite, opposite, middle);
        const unsigned int number = faces.opposite_numbers[opposite];
        piece.opposite = {number, all[number].span};
      }
    }
  }
  for (std::size_t f = 0; f < all.size(); ++f)
    faces_[f] = all[f].face;
}

template <>
void ContactSurface<2>::set_coordinates(const Piece<2> &piece, SurfaceRule<2> &rule) const {
  const Patch<2> &patch = patches_[piece.patch];
  const Side<2> &side = this->side(patch);
  for (const Point<2> &x : rule.points) {
    Point<1> s = side.coordinates(x);
    // Around a closed side those next to the patch.
    if (side.is_closed())
      s[0] += side.length() * std::round((patch.centre()[0] - s[0]) / side.length());
    rule.on_side.push_back(s);
  }
}

template <>
void ContactSurface<2>::complete(const Piece<2> &piece, SurfaceRule<2> &rule) const {
  rule.directions = rule.normals;
  const double of_part = 0.5 * (piece.lower[0] + piece.upper[0]);
  // The maps of very small cells on arcs turn their normals, and pairs of points depend on them.
  for (std::size_t q = 0; q < rule.size() && piece.opposite; ++q)
    rule.normals[q] = side(patches_[piece.patch]).normal(rule.on_side[q][0], of_part);
  for (std::size_t q = 0; q < rule.size(); ++q)
    rule.directions[q] = condition(piece).directions.at(of_part, rule.points[q], rule.normals[q]);
  if (!piece.opposite)
    return;
  const auto &[face, span] = *piece.opposite;
  const Side<2> &other = scene_.geometry.sides[faces_[face].side];
  const double middle = 0.5 * (span.start + span.end);
  for (std::size_t q = 0; q < rule.size(); ++q) {
    const Point<2> &x = rule.points[q];
    double s = other.arc_length(other.across(x, rule.normals[q]));
    if (other.is_closed())
      s += other.length() * std::round((middle - s) / other.length());
    rule.on_opposite.push_back(span.parameter(s));
  }
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
          {},
          piece.opposite};
}

template <>
SurfaceRule<2> ContactSurface<2>::at(const Piece<2> &piece,
                                     const std::vector<Point<1>> &positions) const {
  std::vector<Point<1>> arc_lengths;
  arc_lengths.reserve(positions.size());
  for (const Point<1> &r : positions)
    arc_lengths.emplace_back((1. - r[0]) * piece.lower[0] + r[0] * piece.upper[0]);
  SurfaceRule<2> rule = points_at(piece, side(patches_[piece.patch]), arc_lengths);
  complete(piece, rule);
  return rule;
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
  complete(piece, rule);
  return rule;
}

template <>
Point<2> ContactSurface<2>::point(const Patch<2> &patch, const Point<1> &s) const {
  return side(patch).point(s);
}

template <>
SurfacePoint<2> ContactSurface<2>::middle(const Patch<2> &patch) const {
  return {side(patch).point(patch.centre()), side(patch).normal(patch.centre())};
}

template <>
std::vector<Neighbours<2>> ContactSurface<2>::neighbours() const {
  std::vector<Neighbours<2>> all(patches_.size());
  for (const PatchGrid &grid : patch_grids(patches_)) {
    const Side<2> &side = scene_.geometry.sides[grid.side];
    const int n = grid.n(0);
    for (int i = 0; i < n; ++i)
      for (const int step : {-1, 1}) {
        // Beyond a corner, the pressure is that of another direction.
        const double end = grid.ends[0][step < 0 ? i : i + 1], near = 1e-9 * side.length();
        if (side.has_corner(end) ||
            scene_.contacts[grid.contact].directions.change_between(end - near, end + near))
          continue;
        int next = i + step;
        double shift = 0.;
        if (n > 1 && (next < 0 || next == n) &&
            goes_round(side, grid.ends[0].front(), grid.ends[0].back())) {
          next -= step * n;
          shift = step * side.length();
        }
        if (next >= 0 && next < n)
          all[grid.patches[i]][0][step < 0 ? 0 : 1] = {
            grid.patches[next], grid.ends[0][next] + shift, grid.ends[0][next + 1] + shift};
      }
  }
  return all;
}
} // namespace Signorini
