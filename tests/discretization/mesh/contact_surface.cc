// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact faces in the order of arc length, patches of them, and the pieces face ∩ patch.

#include <signorini/discretization/mesh/contact_surface.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;
using S = dealii::Point<1>;

/** Every face is a patch and a piece. */
constexpr Partition by_faces = {1, 0};

Partition by_ratio(const unsigned int ratio)
{
  return {ratio, 0};
}

Partition equally(const unsigned int patches_per_side)
{
  return {2, patches_per_side};
}

/** A body that may touch on the sides of these numbers. */
Scene<2> touching(const Geometry<2> &geometry, const std::vector<unsigned int> &sides)
{
  Scene<2> scene;
  scene.geometry = geometry;
  scene.boundary.resize(geometry.sides.size());
  for (const unsigned int side : sides)
    scene.boundary[side].role = Role::contact;
  return scene;
}

std::vector<unsigned int> all_sides(const Geometry<2> &geometry)
{
  std::vector<unsigned int> sides;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    sides.push_back(i);
  return sides;
}

/** The arc lengths at which a face of the mesh begins and ends. */
struct Interval
{
  double start, end;
};

Interval interval_of(const ContactFace<2> &face, const Side<2> &side)
{
  const auto line = face.cell->face(face.face_no);
  const double a = side.arc_length(line->vertex(0)), b = side.arc_length(line->vertex(1));
  return {std::min(a, b), std::max(a, b)};
}

/** The largest distance of the points of a rule from the points of the face at their own
 * parameters, and from the points of the side at their arc lengths. */
double parameter_error(const ContactFace<2> &face, const Side<2> &side, const SurfaceRule<2> &rule)
{
  const auto line = face.cell->face(face.face_no);
  double largest = 0.;
  for (std::size_t q = 0; q < rule.size(); ++q)
  {
    const Point x = line->vertex(0) + rule.on_face[q][0] * (line->vertex(1) - line->vertex(0));
    largest = std::max({largest,
                        x.distance(side.point(rule.on_side[q])),
                        x.distance(rule.points[q]),
                        (rule.normals[q] - side.normal(0.)).norm()});
  }
  return largest;
}

/** Every side is covered by faces in the order of arc length, without holes. */
void test_faces(Checks &checks,
                const std::string &name,
                const Geometry<2> &geometry,
                const std::vector<unsigned int> &faces_per_side)
{
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Scene<2> scene = touching(geometry, all_sides(geometry));
  const ContactSurface<2> surface(mesh, scene, by_faces);
  std::vector<unsigned int> counts(geometry.sides.size(), 0);
  std::vector<double> reached(geometry.sides.size(), 0.);
  double hole = 0., off = 0.;
  bool sorted = true, whole = surface.pieces().size() == surface.faces().size();
  unsigned int last_side = 0;
  for (std::size_t i = 0; i < surface.faces().size() && whole; ++i)
  {
    const ContactFace<2> &face = surface.faces()[i];
    const Piece<2> &piece = surface.pieces()[i];
    const Side<2> &side = geometry.sides[face.side];
    const Interval interval = interval_of(face, side);
    sorted = sorted && face.side >= last_side && piece.upper[0] > piece.lower[0];
    last_side = face.side;
    ++counts[face.side];
    hole = std::max(hole, std::abs(interval.start - reached[face.side]));
    reached[face.side] = interval.end;
    off = std::max(off, parameter_error(face, side, surface.at(piece, {S(0.), S(0.3), S(1.)})));
    whole = whole && piece.face == i && piece.patch == i && piece.lower[0] == interval.start &&
            piece.upper[0] == interval.end &&
            std::min(piece.lower_on_face[0], piece.upper_on_face[0]) == 0. &&
            std::max(piece.lower_on_face[0], piece.upper_on_face[0]) == 1.;
    const Piece<2> half = surface.part(piece, 0, 2);
    off =
      std::max({off,
                std::abs(std::abs(half.upper_on_face[0] - half.lower_on_face[0]) - 0.5),
                std::abs(half.upper[0] - half.lower[0] - 0.5 * (interval.end - interval.start))});
  }
  for (unsigned int i = 0; i < reached.size(); ++i)
    hole = std::max(hole, std::abs(reached[i] - geometry.sides[i].length()));
  checks.that(name + ": faces per side", counts == faces_per_side);
  checks.that(name + ": sorted", sorted);
  checks.near(name + ": no holes", hole, 0., 1e-14);
  checks.near(name + ": parameters of faces", off, 0., 1e-14);
  checks.that(name + ": whole faces from 0 to 1", whole);
}

/** Pieces lie in their face and patch, fill both, and are no slivers; their points on the mesh
 * integrate s and s^2 along the side. */
void test_pieces(Checks &checks,
                 const std::string &name,
                 const Geometry<2> &geometry,
                 const ContactSurface<2> &surface)
{
  const auto &faces = surface.faces();
  const auto &patches = surface.patches();
  const auto interval = [&](const ContactFace<2> &face) {
    return interval_of(face, geometry.sides[face.side]);
  };
  std::vector<double> in_face(faces.size(), 0.), in_patch(patches.size(), 0.);
  bool inside = true, sorted = true;
  double shortest = 1., total = 0., off = 0., integrals = 0.;
  for (std::size_t i = 0; i < surface.pieces().size(); ++i)
  {
    const Piece<2> &piece = surface.pieces()[i];
    const ContactFace<2> &face = faces.at(piece.face);
    const Patch<2> &patch = patches.at(piece.patch);
    const Interval whole = interval(face);
    const double start = piece.lower[0], end = piece.upper[0];
    inside = inside && face.side == patch.side && start >= std::max(whole.start, patch.lower[0]) &&
             end <= std::min(whole.end, patch.upper[0]);
    sorted = sorted && (i == 0 || (piece.face >= surface.pieces()[i - 1].face &&
                                   piece.patch >= surface.pieces()[i - 1].patch));
    in_face[piece.face] += end - start;
    in_patch[piece.patch] += end - start;
    shortest = std::min(shortest, (end - start) / (whole.end - whole.start));
    total += end - start;
    const Side<2> &side = geometry.sides[face.side];
    off = std::max({off,
                    parameter_error(face, side, piece.on_mesh),
                    parameter_error(face, side, surface.at(piece, {S(0.), S(0.3), S(1.)}))});
    for (unsigned int k = 0; k <= 2; ++k)
    {
      double sum = 0.;
      for (std::size_t q = 0; q < piece.on_mesh.size(); ++q)
        sum += std::pow(piece.on_mesh.on_side[q][0], k) * piece.on_mesh.weights[q];
      integrals = std::max(
        integrals, std::abs(sum - (std::pow(end, k + 1) - std::pow(start, k + 1)) / (k + 1)));
    }
  }
  double difference = 0., length = 0.;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Interval whole = interval(faces[f]);
    difference = std::max(difference, std::abs(in_face[f] - (whole.end - whole.start)));
    length += whole.end - whole.start;
  }
  for (std::size_t t = 0; t < in_patch.size(); ++t)
    difference = std::max({difference,
                           std::abs(in_patch[t] - patches[t].measure),
                           std::abs(in_patch[t] - patches[t].diameter())});
  checks.that(name + ": pieces in face and patch", inside && sorted);
  checks.near(name + ": pieces fill both", difference, 0., 1e-14);
  checks.near(name + ": pieces cover the side", total, length, 1e-13);
  checks.that(name + ": no slivers", shortest > 1e-4);
  checks.near(name + ": points of pieces on faces and sides", off, 0., 1e-14);
  checks.near(name + ": points on the mesh integrate s^k", integrals, 0., 1e-13);
}

void compare(Checks &checks,
             const std::string &name,
             const ContactSurface<2> &surface,
             const std::vector<double> &expected)
{
  const auto &patches = surface.patches();
  double difference = patches.size() == expected.size() ? 0. : 1.;
  for (std::size_t i = 0; i < std::min(patches.size(), expected.size()); ++i)
    difference = std::max(difference, std::abs(patches[i].measure - expected[i]));
  checks.near(name + ": lengths of patches", difference, 0., 1e-14);
}

/** The bottom of a rectangle 3 x 1 with 8 faces of length 3/8, and its left side with 4. */
void test_ratios(Checks &checks)
{
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const double h = 0.375;
  const Scene<2> bottom = touching(geometry, {2});
  checks.near(
    "only contact sides are found", ContactSurface<2>(mesh, bottom, by_faces).faces().size(), 8, 0);
  struct Row
  {
    unsigned int ratio;
    std::vector<double> expected;
    bool unstable;
  };
  const std::vector<Row> rows = {{1, std::vector<double>(8, h), true},
                                 {2, {2 * h, 2 * h, 2 * h, 2 * h}, false},
                                 {3, {3 * h, 5 * h}, false},
                                 {5, {8 * h}, false},
                                 {100, {8 * h}, false}};
  for (const Row &row : rows)
  {
    const std::string name = "ratio " + std::to_string(row.ratio);
    const ContactSurface<2> surface(mesh, bottom, by_ratio(row.ratio));
    compare(checks, name, surface, row.expected);
    checks.near(name + ": H", surface.longest_patch(), row.expected.back(), 1e-14);
    checks.near(name + ": one piece per face", surface.pieces().size(), 8, 0);
    checks.that(name + ": stability", surface.has_unstable_patch() == row.unstable);
    test_pieces(checks, name, geometry, surface);
  }
  const Scene<2> both = touching(geometry, {0, 2});
  const ContactSurface<2> surface(mesh, both, by_ratio(3));
  compare(checks, "two sides, ratio 3", surface, {1., 3 * h, 5 * h});
  checks.that("two sides: numbers of the sides",
              surface.patches()[0].side == 0 && surface.patches()[1].side == 2);
  checks.that("two sides: sides and conditions of patches and pieces",
              surface.side(surface.patches()[0]).name() == "left" &&
                surface.side(surface.patches()[1]).name() == "bottom" &&
                &surface.condition(surface.pieces().front()) == &both.boundary[0] &&
                &surface.condition(surface.pieces().back()) == &both.boundary[2]);
  test_pieces(checks, "two sides, ratio 3", geometry, surface);
  const Geometry<2> square = make_rectangle(Point(0., 0.), Point(1., 1.), {1, 1});
  const Mesh<2> coarse(square, 0, 0, MPI_COMM_WORLD);
  const Scene<2> below = touching(square, {2});
  checks.that("one face on a side is unstable",
              ContactSurface<2>(coarse, below, by_ratio(2)).has_unstable_patch());
}

/** n equal patches on the 8 faces of the bottom and the 4 of the left side. */
void test_equal_patches(Checks &checks)
{
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Scene<2> bottom = touching(geometry, {2});
  // Ends of patches inside of faces add one piece each.
  const std::vector<std::pair<unsigned int, unsigned int>> n_and_pieces = {
    {1, 8}, {2, 8}, {3, 10}, {4, 8}, {5, 12}, {6, 12}, {7, 14}, {8, 8}, {9, 16}, {16, 16}};
  for (const auto &row : n_and_pieces)
  {
    const std::string name = std::to_string(row.first) + " equal patches";
    const ContactSurface<2> surface(mesh, bottom, equally(row.first));
    compare(checks, name, surface, std::vector<double>(row.first, 3. / row.first));
    checks.near(name + ": number of pieces", surface.pieces().size(), row.second, 0);
    checks.that(name + ": unstable from H = h on",
                surface.has_unstable_patch() == (row.first >= 8));
    checks.near(
      name + ": the middle of the first", surface.patches()[0].centre()[0], 1.5 / row.first, 1e-15);
    test_pieces(checks, name, geometry, surface);
  }
  const Scene<2> both = touching(geometry, {0, 2});
  const ContactSurface<2> surface(mesh, both, equally(3));
  compare(checks, "equal patches on two sides", surface, {1. / 3., 1. / 3., 1. / 3., 1., 1., 1.});
  test_pieces(checks, "equal patches on two sides", geometry, surface);

  // Lengths that are no binary fractions: ends that differ by rounding make no pieces.
  const Geometry<2> odd = make_polygon({Point(0.1, 0.), Point(0.8, 0.3), Point(0.3, 0.9)});
  const Mesh<2> odd_mesh(odd, 0, 3, MPI_COMM_WORLD);
  const Scene<2> around = touching(odd, all_sides(odd));
  for (const unsigned int n : {2, 4, 8, 16})
    checks.near("aligned with 16 faces, n = " + std::to_string(n),
                ContactSurface<2>(odd_mesh, around, equally(n)).pieces().size(),
                48,
                0);
  test_pieces(
    checks, "5 patches on a triangle", odd, ContactSurface<2>(odd_mesh, around, equally(5)));
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  test_faces(
    checks, "rectangle", make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1}), {4, 4, 8, 8});
  test_faces(
    checks,
    "pentagon",
    make_polygon({Point(0., 0.), Point(2., -1.), Point(4., 0.), Point(4., 3.), Point(1., 2.)}),
    {8, 8, 8, 8, 8});
  test_ratios(checks);
  test_equal_patches(checks);
  return checks.exit_code();
}
