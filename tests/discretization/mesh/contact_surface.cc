// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact faces in the order of arc length, patches of them, and the pieces face ∩ patch.

#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;
using S = dealii::Point<1>;

/** Every face is a patch and a piece. */
const Partition by_faces = {1};

/** A body that may touch on the sides of these numbers. */
Scene<2> touching(const Geometry<2> &geometry, const std::vector<unsigned int> &sides) {
  Scene<2> scene;
  scene.geometry = geometry;
  scene.boundary.resize(geometry.sides.size());
  for (const unsigned int side : sides) {
    scene.boundary[side].role = Role::contact;
    scene.contacts.emplace_back().side = side;
  }
  return scene;
}

std::vector<unsigned int> all_sides(const Geometry<2> &geometry) {
  std::vector<unsigned int> sides;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    sides.push_back(i);
  return sides;
}

/** The arc lengths at which a face of the mesh begins and ends. */
struct Interval {
  double start, end;
};

Interval interval_of(const ContactFace<2> &face, const Side<2> &side) {
  const auto line = face.cell->face(face.face_no);
  const double a = side.arc_length(line->vertex(0)), b = side.arc_length(line->vertex(1));
  return {std::min(a, b), std::max(a, b)};
}

/** The largest distance of the points of a rule from the points of the face at their own
 * parameters, and from the points of the side at their arc lengths. */
double parameter_error(const ContactFace<2> &face, const Side<2> &side,
                       const SurfaceRule<2> &rule) {
  const auto line = face.cell->face(face.face_no);
  double largest = 0.;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    const Point x = line->vertex(0) + rule.on_face[q][0] * (line->vertex(1) - line->vertex(0));
    largest = std::max({largest, x.distance(side.point(rule.on_side[q])),
                        x.distance(rule.points[q]), (rule.normals[q] - side.normal(0.)).norm()});
  }
  return largest;
}

/** Pieces lie in their face and patch, in the order of arc length, fill both, and are no slivers;
 * their points on the mesh integrate s and s^2 along the side. */
void test_pieces(Checks &checks, const Geometry<2> &geometry, const ContactSurface<2> &surface) {
  const auto &faces = surface.faces();
  const auto &patches = surface.patches();
  std::vector<double> in_face(faces.size(), 0.), in_patch(patches.size(), 0.);
  double reached = 0., off = 0.;
  for (std::size_t i = 0; i < surface.pieces().size(); ++i) {
    const Piece<2> &piece = surface.pieces()[i];
    const ContactFace<2> &face = faces.at(piece.face);
    const Patch<2> &patch = patches.at(piece.patch);
    const Side<2> &side = geometry.sides[face.side];
    const Interval whole = interval_of(face, side);
    const double start = piece.lower[0], end = piece.upper[0];
    checks.that("pieces in face and patch", face.side == patch.side &&
                                              start >= std::max(whole.start, patch.lower[0]) &&
                                              end <= std::min(whole.end, patch.upper[0]));
    if (i > 0)
      checks.that("sorted", piece.face >= surface.pieces()[i - 1].face &&
                              piece.patch >= surface.pieces()[i - 1].patch);
    const bool is_first = i == 0 || faces[surface.pieces()[i - 1].face].side != face.side;
    checks.near("no holes", start, is_first ? 0. : reached, 1e-14);
    if (i + 1 == surface.pieces().size() || faces[surface.pieces()[i + 1].face].side != face.side)
      checks.near("up to the end", end, side.length(), 1e-14);
    reached = end;
    in_face[piece.face] += (end - start) / (whole.end - whole.start);
    in_patch[piece.patch] += (end - start) / patch.measure;
    checks.that("no slivers", end - start > 1e-4 * (whole.end - whole.start));
    const Piece<2> half = surface.part(piece, 0, 2);
    checks.near("half a piece", half.upper[0] - half.lower[0], 0.5 * (end - start), 1e-14);
    off = std::max({off, parameter_error(face, side, piece.on_mesh),
                    parameter_error(face, side, surface.at(half, {S(0.), S(0.3), S(1.)})),
                    parameter_error(face, side, surface.at(piece, {S(0.), S(0.3), S(1.)}))});
    for (unsigned int k = 0; k <= 2; ++k) {
      double sum = 0.;
      for (std::size_t q = 0; q < piece.on_mesh.size(); ++q)
        sum += std::pow(piece.on_mesh.on_side[q][0], k) * piece.on_mesh.weights[q];
      checks.near("points on the mesh integrate s^k", sum,
                  (std::pow(end, k + 1) - std::pow(start, k + 1)) / (k + 1), 1e-13);
    }
  }
  checks.near("pieces fill faces", in_face, std::vector<double>(faces.size(), 1.), 1e-13);
  checks.near("pieces fill patches", in_patch, std::vector<double>(patches.size(), 1.), 1e-13);
  checks.near("points of pieces on faces and sides", off, 0., 1e-14);
}

/** Every side is covered by so many faces. */
void test_faces(Checks &checks, const Geometry<2> &geometry,
                const std::vector<double> &faces_per_side) {
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Scene<2> scene = touching(geometry, all_sides(geometry));
  const ContactSurface<2> surface(mesh, scene, by_faces);
  std::vector<double> counts(geometry.sides.size(), 0.);
  for (const auto &face : surface.faces())
    ++counts[face.side];
  checks.near("faces per side", counts, faces_per_side, 0.);
  checks.that("whole faces", surface.pieces().size() == surface.faces().size());
  test_pieces(checks, geometry, surface);
}

void compare(Checks &checks, const ContactSurface<2> &surface,
             const std::vector<double> &expected) {
  std::vector<double> lengths;
  for (const auto &patch : surface.patches())
    lengths.push_back(patch.measure);
  checks.near("lengths of patches", lengths, expected, 1e-14);
}

/** The bottom of a rectangle 3 x 1 with 8 faces of length 3/8, and its left side with 4. */
void test_ratios(Checks &checks) {
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const double h = 0.375;
  const Scene<2> bottom = touching(geometry, {2});
  checks.near("only contact sides are found",
              ContactSurface<2>(mesh, bottom, by_faces).faces().size(), 8, 0);
  struct Row {
    unsigned int ratio;
    std::vector<double> expected;
    bool unstable;
  };
  const std::vector<Row> rows = {{1, std::vector<double>(8, h), true},
                                 {2, {2 * h, 2 * h, 2 * h, 2 * h}, false},
                                 {3, {3 * h, 5 * h}, false},
                                 {5, {8 * h}, false},
                                 {100, {8 * h}, false}};
  for (const Row &row : rows) {
    checks.about("ratio " + std::to_string(row.ratio));
    const ContactSurface<2> surface(mesh, bottom, Partition{row.ratio});
    compare(checks, surface, row.expected);
    checks.near("H", surface.longest_patch(), row.expected.back(), 1e-14);
    checks.near("one piece per face", surface.pieces().size(), 8, 0);
    checks.that("stability", surface.has_unstable_patch() == row.unstable);
    test_pieces(checks, geometry, surface);
  }
  checks.about("two sides");
  const Scene<2> both = touching(geometry, {0, 2});
  const ContactSurface<2> surface(mesh, both, Partition{3});
  compare(checks, surface, {1., 3 * h, 5 * h});
  checks.that("numbers of the sides",
              surface.patches()[0].side == 0 && surface.patches()[1].side == 2);
  checks.that("sides and conditions of patches and pieces",
              surface.side(surface.patches()[0]).name() == "left" &&
                surface.side(surface.patches()[1]).name() == "bottom" &&
                &surface.condition(surface.pieces().front()) == &both.contacts[0] &&
                &surface.condition(surface.pieces().back()) == &both.contacts[1]);
  test_pieces(checks, geometry, surface);
  const Geometry<2> square = make_rectangle(Point(0., 0.), Point(1., 1.), {1, 1});
  const Mesh<2> coarse(square, 0, 0, MPI_COMM_WORLD);
  const Scene<2> below = touching(square, {2});
  checks.that("one face on a side is unstable",
              ContactSurface<2>(coarse, below, Partition{2}).has_unstable_patch());
}

/** n equal patches on the 8 faces of the bottom and the 4 of the left side. */
void test_equal_patches(Checks &checks) {
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Scene<2> bottom = touching(geometry, {2});
  for (const unsigned int n : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 16U}) {
    checks.about(std::to_string(n) + " equal patches");
    const ContactSurface<2> surface(mesh, bottom, Partition{2, std::vector<unsigned int>(9, n)});
    compare(checks, surface, std::vector<double>(n, 3. / n));
    // Ends of patches inside of faces add one piece each.
    checks.near("number of pieces", surface.pieces().size(), 8 + n - std::gcd(8U, n), 0);
    checks.that("unstable from H = h on", surface.has_unstable_patch() == (n >= 8));
    checks.near("the middle of the first", surface.patches()[0].centre()[0], 1.5 / n, 1e-15);
    test_pieces(checks, geometry, surface);
  }
  checks.about("two sides");
  const Scene<2> both = touching(geometry, {0, 2});
  const ContactSurface<2> surface(mesh, both, Partition{2, std::vector<unsigned int>(9, 3)});
  compare(checks, surface, {1. / 3., 1. / 3., 1. / 3., 1., 1., 1.});
  test_pieces(checks, geometry, surface);

  // Lengths that are no binary fractions: ends that differ by rounding make no pieces.
  const Geometry<2> odd = make_polygon({Point(0.1, 0.), Point(0.8, 0.3), Point(0.3, 0.9)});
  const Mesh<2> odd_mesh(odd, 0, 3, MPI_COMM_WORLD);
  const Scene<2> around = touching(odd, all_sides(odd));
  for (const unsigned int n : {2, 4, 8, 16})
    checks.near("aligned with 16 faces",
                ContactSurface<2>(odd_mesh, around, Partition{2, std::vector<unsigned int>(9, n)})
                  .pieces()
                  .size(),
                48, 0);
  test_pieces(checks, odd,
              ContactSurface<2>(odd_mesh, around, Partition{2, std::vector<unsigned int>(9, 5)}));
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv,
    {[](Checks &checks) {
       test_faces(checks, make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1}), {4., 4., 8., 8.});
       test_faces(
         checks,
         make_polygon({Point(0., 0.), Point(2., -1.), Point(4., 0.), Point(4., 3.), Point(1., 2.)}),
         std::vector<double>(5, 8.));
     },
     test_ratios, test_equal_patches});
}
