// SPDX-License-Identifier: LGPL-2.1-or-later
// Mesh files of bodies in space: all elements of first and second order, in any order and
// numbering, with the surfaces of their sides, against volumes and areas in closed form.

#include <signorini/problem/mesh_file/file_geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <sstream>

#include "tests.h"

using namespace Signorini;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace {
/** A point of a lattice whose even points are corners of cells. */
using LatticePoint = std::array<int, 3>;

/** A kind of element by Gmsh's manual: its number, the number of its faces' kinds, and the corners
 * in whose means the nodes behind the corners lie. */
struct Kind {
  unsigned int type, n_corners;
  std::map<std::size_t, unsigned int> face_types;
  std::vector<std::vector<unsigned int>> middles;
};

using Middles = std::vector<std::vector<unsigned int>>;

Middles operator+(Middles a, const Middles &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Middles tetrahedron_edges = {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}};
const Middles tetrahedron_faces = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
const Middles prism_edges = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4},
                             {2, 5}, {3, 4}, {3, 5}, {4, 5}};
const Middles prism_quadrilaterals = {{0, 1, 4, 3}, {0, 2, 5, 3}, {1, 2, 5, 4}};
const Middles prism_faces = Middles{{0, 1, 2}, {3, 4, 5}} + prism_quadrilaterals;
const Middles hexahedron_edges = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                  {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
const Middles hexahedron_faces = {{0, 1, 2, 3}, {0, 1, 5, 4}, {0, 3, 7, 4},
                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}};

const std::vector<Kind> kinds = {
  {5, 8, {{4, 3}}, {}},
  {17, 8, {{4, 16}}, hexahedron_edges},
  {12, 8, {{4, 10}}, hexahedron_edges + hexahedron_faces + Middles{{0, 1, 2, 3, 4, 5, 6, 7}}},
  {6, 6, {{3, 2}, {4, 3}}, {}},
  {18, 6, {{3, 9}, {4, 16}}, prism_edges},
  {13, 6, {{3, 9}, {4, 10}}, prism_edges + prism_quadrilaterals},
  {4, 4, {{3, 2}}, {}},
  {11, 4, {{3, 9}}, tetrahedron_edges}};

const Kind &kind_of_type(const unsigned int type) {
  return *std::find_if(kinds.begin(), kinds.end(),
                       [&](const Kind &kind) { return kind.type == type; });
}

const Middles &faces_of(const Kind &kind) {
  return kind.n_corners == 4   ? tetrahedron_faces
         : kind.n_corners == 6 ? prism_faces
                               : hexahedron_faces;
}

using Corners = std::vector<LatticePoint>;

/** Returns the elements with this many corners that fill a cell of the lattice. */
std::vector<Corners> elements_of_cell(const LatticePoint &cell, const unsigned int n_corners) {
  const auto corner = [&](const int i, const int j, const int k) {
    return LatticePoint{{2 * (cell[0] + i), 2 * (cell[1] + j), 2 * (cell[2] + k)}};
  };
  std::vector<Corners> elements;
  if (n_corners == 8)
    return {{corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 0, 1),
             corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)}};
  if (n_corners == 6)
    return {{corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 0, 1), corner(1, 0, 1),
             corner(1, 1, 1)},
            {corner(0, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 0, 1), corner(1, 1, 1),
             corner(0, 1, 1)}};
  std::array<unsigned int, 3> order = {{0, 1, 2}};
  do {
    LatticePoint step = {{0, 0, 0}};
    elements.emplace_back();
    elements.back().push_back(corner(0, 0, 0));
    for (const unsigned int d : order) {
      step[d] = 1;
      elements.back().push_back(corner(step[0], step[1], step[2]));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return elements;
}

/** Returns the corners in another order of the same element, perhaps that of its mirror image. */
Corners renumber(const Corners &corners, std::mt19937 &random) {
  std::vector<unsigned int> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  if (corners.size() == 4)
    std::shuffle(order.begin(), order.end(), random);
  const unsigned int half = corners.size() / 2, first = random() % half;
  const bool is_upside_down = random() % 2 == 0, is_mirror = random() % 2 == 0;
  for (unsigned int i = 0; i < half && corners.size() > 4; ++i) {
    const unsigned int from = (first + (is_mirror ? half - i : i)) % half;
    order[i] = from + (is_upside_down ? half : 0);
    order[i + half] = from + (is_upside_down ? 0 : half);
  }
  // Another pair of faces becomes the lower and the upper one.
  if (corners.size() == 8 && random() % 2 == 0)
    order = {order[0], order[3], order[7], order[4], order[1], order[2], order[6], order[5]};
  Corners renumbered;
  for (const unsigned int i : order)
    renumbered.push_back(corners[i]);
  return renumbered;
}

/** How a block of cells becomes a mesh. */
struct Block {
  LatticePoint n;
  unsigned int type;
  /** The map of the unit cube. */
  std::function<Point<3>(const Point<3> &)> map;
  /** The number of the volume in which a cell lies, and the type of its elements. */
  std::function<unsigned int(const LatticePoint &)> volume = [](const auto &) { return 1U; };
  std::function<unsigned int(const LatticePoint &)> type_of = nullptr;
};

const std::array<std::string, 6> side_names = {{"left", "right", "front", "back", "bottom", "top"}};

/** Writes a block as text of Gmsh, version 2.2. @param random shuffles it. */
class Writer {
public:
  Writer(const Block &block, std::mt19937 *const random)
    : block_(block) {
    LatticePoint cell;
    for (cell[2] = 0; cell[2] < block.n[2]; ++cell[2])
      for (cell[1] = 0; cell[1] < block.n[1]; ++cell[1])
        for (cell[0] = 0; cell[0] < block.n[0]; ++cell[0]) {
          const Kind &kind = kind_of_type(block.type_of ? block.type_of(cell) : block.type);
          for (const Corners &corners : elements_of_cell(cell, kind.n_corners))
            add_cell(kind, random == nullptr ? corners : renumber(corners, *random),
                     block.volume(cell));
        }
    std::vector<unsigned int> number(nodes_.size());
    std::iota(number.begin(), number.end(), 1);
    if (random != nullptr) {
      std::shuffle(number.begin(), number.end(), *random);
      std::shuffle(elements_.begin(), elements_.end(), *random);
    }
    text_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n8\n";
    for (unsigned int i = 0; i < 6; ++i)
      text_ << "2 " << i + 1 << " \"" << side_names[i] << "\"\n";
    text_ << "3 1 \"soft\"\n3 2 \"hard part\"\n$EndPhysicalNames\n$Nodes\n"
          << nodes_.size() << "\n";
    text_.precision(17);
    std::vector<std::pair<unsigned int, LatticePoint>> in_order;
    for (const auto &[x, index] : nodes_)
      in_order.emplace_back(number[index], x);
    std::sort(in_order.begin(), in_order.end());
    for (const auto &[tag, x] : in_order) {
      const Point<3> at = block_.map(
        {x[0] / (2. * block_.n[0]), x[1] / (2. * block_.n[1]), x[2] / (2. * block_.n[2])});
      text_ << tag << " " << at << "\n";
    }
    text_ << "$EndNodes\n$Elements\n" << elements_.size() << "\n";
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      text_ << e + 1 << elements_[e].first;
      for (const unsigned int node : elements_[e].second)
        text_ << " " << number[node];
      text_ << "\n";
    }
    text_ << "$EndElements\n";
  }

  std::string text() const {
    return text_.str();
  }

private:
  unsigned int node_at(const Corners &corners) {
    LatticePoint x = {{0, 0, 0}};
    for (const LatticePoint &corner : corners)
      for (unsigned int d = 0; d < 3; ++d)
        x[d] += corner[d];
    for (int &coordinate : x)
      coordinate /= static_cast<int>(corners.size());
    return nodes_.emplace(x, nodes_.size()).first->second;
  }

  void add(const unsigned int type, const unsigned int group, const Corners &corners,
           const Middles &middles) {
    std::vector<unsigned int> nodes;
    for (const LatticePoint &corner : corners)
      nodes.push_back(node_at({corner}));
    for (const std::vector<unsigned int> &of : middles) {
      Corners ends;
      for (const unsigned int i : of)
        ends.push_back(corners[i]);
      nodes.push_back(node_at(ends));
    }
    elements_.emplace_back(" " + std::to_string(type) + " 2 " + std::to_string(group) + " 1",
                           nodes);
  }

  void add_cell(const Kind &kind, const Corners &corners, const unsigned int volume) {
    add(kind.type, volume, corners, kind.middles);
    for (const std::vector<unsigned int> &face : faces_of(kind)) {
      Corners of_face;
      for (const unsigned int i : face)
        of_face.push_back(corners[i]);
      const unsigned int type = kind.face_types.at(face.size());
      Middles middles;
      for (unsigned int i = 0; i < face.size() && type > 3; ++i)
        middles.push_back({i, static_cast<unsigned int>((i + 1) % face.size())});
      if (type == 10)
        middles.push_back({0, 1, 2, 3});
      for (unsigned int side = 0; side < 6; ++side) {
        const unsigned int d = side / 2;
        const int at = side % 2 == 0 ? 0 : 2 * block_.n[d];
        if (std::all_of(of_face.begin(), of_face.end(),
                        [&](const LatticePoint &x) { return x[d] == at; }))
          add(type, side + 1, of_face, middles);
      }
    }
  }

  const Block &block_;
  std::map<LatticePoint, unsigned int> nodes_;
  std::vector<std::pair<std::string, std::vector<unsigned int>>> elements_;
  std::ostringstream text_;
};

SolidBody read(const Block &block, const SurfaceKinds &surfaces = {},
               std::mt19937 *const random = nullptr) {
  return make_solid(read_gmsh<3>(Writer(block, random).text(), "a.msh"), surfaces,
                    "a.prm:3: Geometry/Surfaces");
}

/** Returns the volume of the trilinear cells, which two points per direction integrate. */
double volume_of(const Solid &solid) {
  const dealii::QGauss<3> gauss(2);
  double volume = 0.;
  for (const auto &cell : solid.cells)
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      std::array<Tensor<1, 3>, 3> gradient;
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d) {
          double slope = 1.;
          for (unsigned int e = 0; e < 3; ++e) {
            const double xi = gauss.point(q)[e];
            const bool is_upper = (v >> e & 1) == 1;
            slope *= e == d ? (is_upper ? 1. : -1.) : (is_upper ? xi : 1. - xi);
          }
          gradient[d] += slope * solid.vertices[cell[v]];
        }
      const double determinant = gradient[0] * cross_product_3d(gradient[1], gradient[2]);
      volume += determinant > 0. ? gauss.weight(q) * determinant : -1e300;
    }
  return volume;
}

std::map<std::string, SurfacePart> sides_of(const Solid &solid) {
  std::vector<std::vector<FaceCorners>> faces(solid.sides.size());
  for (const Solid::Face &face : solid.faces) {
    faces[face.side].emplace_back();
    for (unsigned int i = 0; i < 4; ++i)
      faces[face.side].back()[i] = solid.vertices[face.vertices[i]];
  }
  std::map<std::string, SurfacePart> sides;
  for (std::size_t i = 0; i < faces.size(); ++i)
    sides.emplace(solid.sides[i].first, SurfacePart(solid.sides[i].second, faces[i]));
  return sides;
}

/** The sheared cube: its determinant is one, and its sides stay plane. */
Point<3> sheared(const Point<3> &x) {
  return {x[0] + 0.2 * x[1], x[1] + 0.1 * x[2], x[2]};
}

void test_kinds(Checks &checks) {
  for (const Kind &kind : kinds) {
    const LatticePoint n = {{2, 3, 2}};
    const SolidBody body = read({n, kind.type, sheared});
    const Solid &solid = body.solid;
    checks.about("elements of type " + std::to_string(kind.type));
    const unsigned int n_cells = 12 * (kind.n_corners == 8 ? 1 : kind.n_corners == 6 ? 12 : 24);
    checks.near("cells", solid.cells.size(), double(n_cells), 0.);
    checks.near("volume", volume_of(solid), 1., 1e-13);
    checks.that("note", body.note.empty() == (kind.n_corners == 8));
    Tensor<1, 3> sum;
    for (const Solid::Face &face : solid.faces) {
      FaceCorners corners;
      for (unsigned int i = 0; i < 4; ++i)
        corners[i] = solid.vertices[face.vertices[i]];
      const Tensor<1, 3> area = area_vector(corners, {0.5, 0.5});
      sum += area;
      checks.that("normals point out of the body",
                  area * solid.sides[face.side].second.axis() > 0.99 * area.norm());
    }
    checks.near("int n ds", sum.norm(), 0., 1e-14);
    const auto sides = sides_of(solid);
    checks.near("areas",
                {sides.at("bottom").area(), sides.at("top").area(), sides.at("left").area(),
                 sides.at("front").area()},
                {1., 1., std::sqrt(1. + 0.04 + 4e-4), std::sqrt(1.01)}, 1e-13);
    for (const auto &[name, side] : sides)
      checks.that("planes", side.is_flat());
    checks.that("sides", sides.size() == 6 && solid.regions.empty());
  }
}

/** A quarter of a tube about z, radii 1 and 2: its left side is the hole. */
Point<3> tube(const Point<3> &x) {
  const double r = 1. + x[0], angle = PI / 2. * x[1];
  return {r * std::cos(angle), r * std::sin(angle), x[2]};
}

/** A part of a shell about (0, 0, 1), radii 1 and 2. */
Point<3> shell(const Point<3> &x) {
  const Tensor<1, 3> d({1., std::tan(PI / 4. * (x[1] - 0.5)), std::tan(PI / 4. * (x[2] - 0.5))});
  return Point<3>(0., 0., 1.) + (1. + x[0]) / d.norm() * d;
}

Point<3> ellipse(const Point<3> &x) {
  const Point<3> round = tube(x);
  return {1.1 * round[0], round[1], round[2]};
}

/** A parabola as the lower side. */
Point<3> parabola(const Point<3> &x) {
  return {x[0], x[1], x[2] + 0.3 * x[0] * x[0]};
}

/** Three decimals. */
Point<3> rounded(const Point<3> &x) {
  Point<3> y = tube(x);
  for (unsigned int d = 0; d < 3; ++d)
    y[d] = std::round(1e3 * y[d]) / 1e3;
  return y;
}

/** All of a solid as a text. */
std::string text_of(const SolidBody &body) {
  std::ostringstream text;
  text.precision(17);
  for (const auto &x : body.solid.vertices)
    text << x << "\n";
  for (const auto &cell : body.solid.cells)
    for (const unsigned int v : cell)
      text << v << " ";
  for (const Solid::Face &face : body.solid.faces)
    text << face.vertices[0] << " " << face.vertices[1] << " " << face.vertices[2] << " "
         << face.side << "\n";
  for (const auto &[name, surface] : body.solid.sides)
    text << name << " " << surface.name() << " " << surface.point() << " " << surface.axis() << " "
         << surface.radius() << "\n";
  for (const unsigned int region : body.solid.region_of_cell)
    text << region;
  return text.str() + body.note;
}

void test_other_numbers(Checks &checks) {
  std::mt19937 random(7);
  std::vector<Block> blocks;
  for (const Kind &kind : kinds)
    for (const auto &map : {sheared, tube, shell, ellipse})
      blocks.push_back({{{2, 4, 3}}, kind.type, map});
  blocks.push_back(
    {{{3, 2, 2}}, 5, sheared, [](const LatticePoint &cell) { return cell[0] == 1 ? 2U : 1U; }});
  blocks.push_back({{{3, 2, 2}}, 5, sheared, blocks.back().volume, [](const LatticePoint &cell) {
                      return cell[0] == 1 ? 6U : 5U;
                    }});
  for (const Block &block : blocks)
    checks.that("the same digits in another order and with other numbers",
                text_of(read(block)) == text_of(read(block, {}, &random)));
  const SolidBody mixed = read(blocks.back());
  checks.near("hexahedra beside prisms are split into eight", mixed.solid.cells.size(),
              8. * 8. + 4. * 12., 0.);
  checks.near("  volume", volume_of(mixed.solid), 1., 1e-14);
  checks.that("regions", mixed.solid.regions == std::vector<std::string>({"hard part", "soft"}) &&
                           std::count(mixed.solid.region_of_cell.begin(),
                                      mixed.solid.region_of_cell.end(), 0U) == 48);
}

void check_surface(Checks &checks, const Solid &solid, const std::string &name,
                   const Surface &expected, const double tolerance) {
  const auto side = std::find_if(solid.sides.begin(), solid.sides.end(),
                                 [&](const auto &one) { return one.first == name; });
  if (side == solid.sides.end() || side->second.kind() != expected.kind()) {
    checks.that(name + " is a " + expected.name(), false);
    return;
  }
  const Surface &found = side->second;
  checks.near(name + ": radius", found.radius(), expected.radius(), tolerance);
  checks.that(name + ": the body", found.body() == expected.body());
  for (const Solid::Face &face : solid.faces)
    for (const unsigned int v : face.vertices)
      if (&solid.sides[face.side] == &*side) {
        const Point<3> &x = solid.vertices[v];
        checks.near(name + ": vertices", x, found.project(x), 1e-12);
        checks.near(name + ": place", x, expected.project(x), tolerance);
      }
}

void test_surfaces(Checks &checks) {
  const Tensor<1, 3> z({0., 0., 1.});
  const Surface hole = Surface::cylinder({0., 0., 3.}, z, 1., Body::outside),
                outside = Surface::cylinder({0., 0., 3.}, z, 2., Body::inside),
                socket = Surface::sphere({0., 0., 1.}, 1., Body::outside),
                ball = Surface::sphere({0., 0., 1.}, 2., Body::inside),
                left = Surface::plane({0., 1., 0.}, Tensor<1, 3>({-1., 0., 0.}));
  for (const Kind &kind : kinds) {
    checks.about("elements of type " + std::to_string(kind.type));
    // Facets of first order turn by 22.5 degrees, those of second order by 45.
    const bool is_linear = kind.middles.empty();
    const Solid quarter = read({{{1, is_linear ? 4 : 2, 1}}, kind.type, tube}).solid;
    check_surface(checks, quarter, "left", hole, 1e-12);
    check_surface(checks, quarter, "right", outside, 1e-12);
    check_surface(checks, quarter, "back", left, 1e-12);
    checks.near("volume", volume_of(quarter), 0.75 * PI, is_linear ? 0.07 : 0.26);
    const int n = is_linear ? 3 : 2;
    const Solid part = read({{{1, n, n}}, kind.type, shell}).solid;
    check_surface(checks, part, "left", socket, 1e-12);
    check_surface(checks, part, "right", ball, 1e-12);
    const Solid other = read({{{1, 4, 2}}, kind.type, ellipse}).solid;
    check_surface(checks, other, "left", Surface::faces(), 1e-12);
    const Solid row = read({{{1, 1, 1}}, kind.type, parabola}).solid;
    check_surface(checks, row, "bottom",
                  is_linear ? Surface::plane({0., 0., 0.}, Tensor<1, 3>({0.3, 0., -1.}))
                            : Surface::faces(),
                  1e-12);
  }
}

void test_given_kinds(Checks &checks) {
  using Kind = Surface::Kind;
  const Tensor<1, 3> z({0., 0., 1.});
  const Surface hole = Surface::cylinder({0., 0., 3.}, z, 1., Body::outside);
  const Block coarse = {{{1, 2, 1}}, 5, tube}, rough = {{{1, 4, 1}}, 5, rounded},
              other = {{{1, 4, 1}}, 5, ellipse};
  const auto sides = sides_of(read(coarse).solid);
  checks.that("facets that turn by more than 30 degrees are sides",
              sides.size() == 8 && sides.at("left.1").centre()[0] < sides.at("left.2").centre()[0]);
  check_surface(checks, read(coarse, {{"left", Kind::cylinder}}).solid, "left", hole, 1e-12);
  const SolidBody moved = read(rough, {{"left", Kind::cylinder}, {"right", Kind::faces}});
  check_surface(checks, moved.solid, "left", hole, 1e-3);
  check_surface(checks, moved.solid, "right", Surface::faces(), 2e-3);
  checks.that("the motion is told",
              moved.note.find("nodes of the sides in Geometry/Surfaces are moved onto them, by at "
                              "most 0.000") == 0 &&
                moved.note.find(';') == std::string::npos);
  // The largest product of the distance and the angle of chords of both ellipses.
  double sag = 0.;
  for (const double r : {1., 2.})
    for (unsigned int i = 1; i < 4; ++i) {
      const auto corner = [&](const unsigned int k) { return ellipse({r - 1., k / 4., 0.}); };
      const Tensor<1, 3> a = corner(i) - corner(i - 1), b = corner(i + 1) - corner(i);
      sag = std::max(sag, (a + b).norm() / 2. * std::acos(a * b / a.norm() / b.norm()) / 8.);
    }
  std::ostringstream text;
  text << sag;
  checks.that("the sag of faces is told",
              read(other).note ==
                "sides that follow no plane, sphere or cylinder keep their faces, from which a "
                "smooth surface would deviate by about " +
                  text.str() + " (left, right); Geometry/Surfaces says of which kind they are");
  const std::string where = "a.prm:3: Geometry/Surfaces: ";
  checks.refuses(where + "found the side 'lefft', allowed: back, bottom, front, left, right, top.",
                 [&] {
                   read(other, {{"lefft", Kind::faces}});
                 });
  checks.refuses(where +
                   "the side 'left' is not a cylinder, allowed: nodes on one, to 0.001 of its "
                   "radius.",
                 [&] {
                   read(other, {{"left", Kind::cylinder}});
                 });
  checks.refuses(where + "the side 'left' is not a plane, allowed: nodes on one, to 0.001 of its "
                         "extent.",
                 [&] {
                   read(other, {{"left", Kind::plane}});
                 });
  checks.refuses(where + "the nodes of the side 'left' lie on more than one sphere, allowed: a "
                         "finer mesh there, or faces.",
                 [&] {
                   read({{{1, 1, 1}}, 5, shell}, {{"left", Kind::sphere}});
                 });
}
} // namespace

int main() {
  return run_tests({test_kinds, test_other_numbers, test_surfaces, test_given_kinds});
}
