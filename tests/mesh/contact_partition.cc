// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact faces in the order of arc length, patches of them, and the pieces face ∩ patch.

#include <signorini/mesh/contact_partition.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;
using Faces = std::vector<ContactFace<2>>;

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

/** Distance of the point at arc length s from the point at the face's own parameter of s. */
double parameter_error(const ContactFace<2> &face, const Side<2> &side, const double s)
{
  const auto line = face.cell->face(face.face_no);
  const Point x = line->vertex(0) + face.parameter(s) * (line->vertex(1) - line->vertex(0));
  return x.distance(side.point(s));
}

/** Every side is covered by faces in the order of arc length, without holes. */
void test_faces(Checks &checks,
                const std::string &name,
                const Geometry<2> &geometry,
                const std::vector<unsigned int> &faces_per_side)
{
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Scene<2> scene = touching(geometry, all_sides(geometry));
  const Faces faces = find_contact_faces(mesh, scene);
  std::vector<unsigned int> counts(geometry.sides.size(), 0);
  std::vector<double> reached(geometry.sides.size(), 0.);
  double hole = 0., off = 0.;
  bool sorted = true, whole = true;
  unsigned int last_side = 0;
  for (const ContactFace<2> &face : faces)
  {
    const Side<2> &side = geometry.sides[face.side];
    sorted = sorted && face.side >= last_side && face.end > face.start;
    last_side = face.side;
    ++counts[face.side];
    hole = std::max(hole, std::abs(face.start - reached[face.side]));
    reached[face.side] = face.end;
    for (const double t : {0., 0.3, 1.})
      off = std::max(off, parameter_error(face, side, face.start + t * (face.end - face.start)));
    whole = whole && face.parameters_between(face.start, face.end) == std::vector<double>({0., 1.});
    const auto half = face.parameters_between(face.start, 0.5 * (face.start + face.end));
    off = std::max(off, std::abs(half[1] - half[0] - 0.5));
  }
  for (unsigned int i = 0; i < reached.size(); ++i)
    hole = std::max(hole, std::abs(reached[i] - geometry.sides[i].length()));
  checks.that(name + ": faces per side", counts == faces_per_side);
  checks.that(name + ": sorted", sorted);
  checks.near(name + ": no holes", hole, 0., 1e-14);
  checks.near(name + ": parameters of faces", off, 0., 1e-14);
  checks.that(name + ": whole faces from 0 to 1", whole);
}

/** Pieces lie in their face and patch, fill both, and are no slivers. */
void test_pieces(Checks &checks,
                 const std::string &name,
                 const Faces &faces,
                 const ContactPartition &partition)
{
  std::vector<double> in_face(faces.size(), 0.), in_patch(partition.patches.size(), 0.);
  bool inside = true, sorted = true;
  double shortest = 1., total = 0.;
  for (std::size_t i = 0; i < partition.pieces.size(); ++i)
  {
    const Piece &piece = partition.pieces[i];
    const ContactFace<2> &face = faces.at(piece.face);
    const Patch &patch = partition.patches.at(piece.patch);
    inside = inside && face.side == patch.side &&
             piece.start >= std::max(face.start, patch.start) &&
             piece.end <= std::min(face.end, patch.end);
    sorted = sorted && (i == 0 || (piece.face >= partition.pieces[i - 1].face &&
                                   piece.patch >= partition.pieces[i - 1].patch));
    in_face[piece.face] += piece.end - piece.start;
    in_patch[piece.patch] += piece.end - piece.start;
    shortest = std::min(shortest, (piece.end - piece.start) / (face.end - face.start));
    total += piece.end - piece.start;
  }
  double difference = 0., length = 0.;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    difference = std::max(difference, std::abs(in_face[f] - (faces[f].end - faces[f].start)));
    length += faces[f].end - faces[f].start;
  }
  for (std::size_t t = 0; t < in_patch.size(); ++t)
    difference = std::max(difference, std::abs(in_patch[t] - partition.patches[t].length()));
  checks.that(name + ": pieces in face and patch", inside && sorted);
  checks.near(name + ": pieces fill both", difference, 0., 1e-14);
  checks.near(name + ": pieces cover the side", total, length, 1e-13);
  checks.that(name + ": no slivers", shortest > 1e-4);
}

std::vector<double> lengths(const ContactPartition &partition)
{
  std::vector<double> list;
  for (const Patch &patch : partition.patches)
    list.push_back(patch.length());
  return list;
}

void compare(Checks &checks,
             const std::string &name,
             const std::vector<double> &found,
             const std::vector<double> &expected)
{
  double difference = found.size() == expected.size() ? 0. : 1.;
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    difference = std::max(difference, std::abs(found[i] - expected[i]));
  checks.near(name + ": lengths of patches", difference, 0., 1e-14);
}

/** The bottom of a rectangle 3 x 1 with 8 faces of length 3/8, and its left side with 4. */
void test_ratios(Checks &checks)
{
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const double h = 0.375;
  const Faces bottom = find_contact_faces(mesh, touching(geometry, {2}));
  checks.near("only contact sides are found", bottom.size(), 8, 0);
  struct Row
  {
    unsigned int ratio;
    std::vector<double> expected;
    bool unstable;
  };
  const std::vector<Row> rows = {{1, std::vector<double>(8, h), true},
                                 {2, {2 * h, 2 * h, 2 * h, 2 * h}, false},
                                 {3, {3 * h, 5 * h}, false},
                                 {4, {4 * h, 4 * h}, false},
                                 {5, {8 * h}, false},
                                 {8, {8 * h}, false},
                                 {100, {8 * h}, false}};
  for (const Row &row : rows)
  {
    const std::string name = "ratio " + std::to_string(row.ratio);
    const ContactPartition partition = partition_by_ratio(bottom, row.ratio);
    compare(checks, name, lengths(partition), row.expected);
    checks.near(name + ": H", partition.longest_patch(), row.expected.back(), 1e-14);
    checks.near(name + ": one piece per face", partition.pieces.size(), 8, 0);
    checks.that(name + ": stability", partition.has_unstable_patch() == row.unstable);
    test_pieces(checks, name, bottom, partition);
  }
  const Faces both = find_contact_faces(mesh, touching(geometry, {0, 2}));
  const ContactPartition partition = partition_by_ratio(both, 3);
  compare(checks, "two sides, ratio 3", lengths(partition), {1., 3 * h, 5 * h});
  checks.that("two sides: numbers of the sides",
              partition.patches[0].side == 0 && partition.patches[1].side == 2);
  test_pieces(checks, "two sides, ratio 3", both, partition);
  const Mesh<2> coarse(make_rectangle(Point(0., 0.), Point(1., 1.), {1, 1}), 0, 0, MPI_COMM_WORLD);
  checks.that("one face on a side is unstable",
              partition_by_ratio(find_contact_faces(coarse, touching(geometry, {2})), 2)
                .has_unstable_patch());
}

/** n equal patches on the 8 faces of the bottom and the 4 of the left side. */
void test_equal_patches(Checks &checks)
{
  const Geometry<2> geometry = make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1});
  const Mesh<2> mesh(geometry, 0, 2, MPI_COMM_WORLD);
  const Faces bottom = find_contact_faces(mesh, touching(geometry, {2}));
  // Ends of patches inside of faces add one piece each.
  const std::vector<std::pair<unsigned int, unsigned int>> n_and_pieces = {
    {1, 8}, {2, 8}, {3, 10}, {4, 8}, {5, 12}, {6, 12}, {7, 14}, {8, 8}, {9, 16}, {16, 16}};
  for (const auto &row : n_and_pieces)
  {
    const std::string name = std::to_string(row.first) + " equal patches";
    const ContactPartition partition = partition_equally(bottom, row.first);
    compare(checks, name, lengths(partition), std::vector<double>(row.first, 3. / row.first));
    checks.near(name + ": number of pieces", partition.pieces.size(), row.second, 0);
    checks.that(name + ": unstable from H = h on",
                partition.has_unstable_patch() == (row.first >= 8));
    checks.near(
      name + ": the middle of the first", partition.patches[0].middle(), 1.5 / row.first, 1e-15);
    test_pieces(checks, name, bottom, partition);
  }
  const Faces both = find_contact_faces(mesh, touching(geometry, {0, 2}));
  const ContactPartition partition = partition_equally(both, 3);
  compare(checks,
          "equal patches on two sides",
          lengths(partition),
          {1. / 3., 1. / 3., 1. / 3., 1., 1., 1.});
  test_pieces(checks, "equal patches on two sides", both, partition);

  // Lengths that are no binary fractions: ends that differ by rounding make no pieces.
  const Geometry<2> odd = make_polygon({Point(0.1, 0.), Point(0.8, 0.3), Point(0.3, 0.9)});
  const Mesh<2> odd_mesh(odd, 0, 3, MPI_COMM_WORLD);
  const Faces faces = find_contact_faces(odd_mesh, touching(odd, all_sides(odd)));
  for (const unsigned int n : {2, 4, 8, 16})
    checks.near("aligned with 16 faces, n = " + std::to_string(n),
                partition_equally(faces, n).pieces.size(),
                48,
                0);
  test_pieces(checks, "5 patches on a triangle", faces, partition_equally(faces, 5));
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  test_faces(
    checks, "rectangle", make_rectangle(Point(-1., 0.), Point(2., 1.), {2, 1}), {4, 4, 8, 8});
  test_faces(checks,
             "quadrilateral",
             make_polygon({Point(0., 0.), Point(3., 0.), Point(2., 2.), Point(0., 1.)}),
             {4, 4, 4, 4});
  test_faces(
    checks, "triangle", make_polygon({Point(0., 0.), Point(4., 0.), Point(4., 3.)}), {8, 8, 8});
  test_faces(
    checks,
    "pentagon",
    make_polygon({Point(0., 0.), Point(2., -1.), Point(4., 0.), Point(4., 3.), Point(1., 2.)}),
    {8, 8, 8, 8, 8});
  test_ratios(checks);
  test_equal_patches(checks);
  return checks.exit_code();
}
