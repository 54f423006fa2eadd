// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls, cylinders, tubes and their parts between planes of symmetry.

#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/geometry/solid.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace Signorini {
namespace {
using Hexahedron = std::array<Point<3>, 8>;
using Quadrilateral = std::array<Point<2>, 4>;
using Map = std::function<Point<3>(const Point<3> &)>;

/** Puts hexahedra together. */
class SolidBuilder {
public:
  /** Adds the image of a hexahedron under a map, which may be a reflection. */
  void add(Hexahedron cell, const Map &map) {
    for (Point<3> &x : cell)
      x = map(x);
    const double determinant =
      cross_product_3d(cell[1] - cell[0], cell[2] - cell[0]) * (cell[4] - cell[0]);
    if (determinant < 0.)
      for (unsigned int v = 0; v < 8; v += 2)
        std::swap(cell[v], cell[v + 1]);
    std::array<unsigned int, 8> numbers;
    for (unsigned int v = 0; v < 8; ++v) {
      const auto [vertex, is_new] = numbers_.emplace(
        std::array<double, 3>{{cell[v][0], cell[v][1], cell[v][2]}}, solid_.vertices.size());
      if (is_new)
        solid_.vertices.push_back(cell[v]);
      numbers[v] = vertex->second;
    }
    solid_.cells.push_back(numbers);
  }

  /** Returns the body. Faces are on the first of the surfaces on which all their vertices lie and
   * that has their normals; these are the given ones, and the planes through two points with the
   * coordinate directions as normals. */
  Geometry<3> finish(std::vector<std::pair<std::string, Surface>> surfaces, const Point<3> &lower,
                     const Point<3> &upper) {
    const char *const names[] = {"left", "right", "front", "back", "bottom", "top"};
    for (unsigned int i = 0; i < 6; ++i)
      surfaces.emplace_back(names[i],
                            Surface::plane(i % 2 == 0 ? lower : upper,
                                           (i % 2 == 0 ? -1. : 1.) * Point<3>::unit_vector(i / 2)));
    auto faces = boundary_faces();
    for (const auto &[name, surface] : surfaces) {
      const auto others =
        std::partition(faces.begin(), faces.end(),
                       [&, &on = surface](const auto &face) { return !lies_on(face, on); });
      for (auto face = others; face != faces.end(); ++face)
        solid_.faces.push_back({*face, static_cast<unsigned int>(solid_.sides.size())});
      if (others != faces.end())
        solid_.sides.emplace_back(name, surface);
      faces.erase(others, faces.end());
    }
    return make_geometry(std::move(solid_));
  }

private:
  using Face = std::array<unsigned int, 4>;

  bool lies_on(const Face &face, const Surface &surface) const {
    const auto &x = solid_.vertices;
    const Tensor<1, 3> first = x[face[1]] - x[face[0]], second = x[face[2]] - x[face[0]];
    return cross_product_3d(first, second) * surface.normal(x[face[0]]) > 0. &&
           std::all_of(face.begin(), face.end(), [&](const unsigned int v) {
             return x[v].distance(surface.project(x[v])) < 1e-10 * first.norm();
           });
  }

  /** Returns the faces of one cell only, round the outward normal. */
  std::vector<Face> boundary_faces() const {
    constexpr Face corners[] = {{{0, 4, 2, 6}}, {{1, 3, 5, 7}}, {{0, 1, 4, 5}},
                                {{2, 6, 3, 7}}, {{0, 2, 1, 3}}, {{4, 5, 6, 7}}};
    std::map<Face, unsigned int> times_met;
    std::vector<Face> faces;
    const auto sorted = [](Face face) {
      std::sort(face.begin(), face.end());
      return face;
    };
    for (const auto &cell : solid_.cells)
      for (const Face &face : corners) {
        faces.push_back({{cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]}});
        ++times_met[sorted(faces.back())];
      }
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [&](const Face &face) { return times_met[sorted(face)] > 1; }),
                faces.end());
    return faces;
  }

  Solid solid_;
  std::map<std::array<double, 3>, unsigned int> numbers_;
};

/** The quarter of a disc of radius one: a square, and two cells outside of it. */
std::vector<Quadrilateral> quarter_disc() {
  constexpr double edge = 0.5, diagonal = 0.45, half = numbers::SQRT1_2;
  const std::array<Point<2>, 7> x = {
    {{0., 0.}, {edge, 0.}, {diagonal, diagonal}, {0., edge}, {1., 0.}, {half, half}, {0., 1.}}};
  return {{{x[0], x[1], x[3], x[2]}}, {{x[1], x[4], x[2], x[5]}}, {{x[3], x[2], x[6], x[5]}}};
}

/** The quarter of a ring with the outer radius one, in cells that are about as long as wide. */
std::vector<Quadrilateral> quarter_ring(const double inner) {
  constexpr double max_number = 8.;
  const double arc = 0.25 * numbers::PI * (1. + inner), width = 1. - inner;
  const auto n_around =
    static_cast<unsigned int>(std::clamp(std::round(arc / width), 2., max_number));
  const auto n_across =
    static_cast<unsigned int>(std::clamp(std::round(width * n_around / arc), 1., max_number));
  const auto at = [&](const unsigned int i, const unsigned int j) {
    const double angle = 0.5 * numbers::PI * i / n_around, r = inner + width * j / n_across;
    return Point<2>(i == n_around ? 0. : r * std::cos(angle), r * std::sin(angle));
  };
  std::vector<Quadrilateral> cells;
  for (unsigned int i = 0; i < n_around; ++i)
    for (unsigned int j = 0; j < n_across; ++j)
      cells.push_back({{at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)}});
  return cells;
}
} // namespace

Geometry<3> make_ball(const double radius, const Point<3> &centre, const Sector sector) {
  constexpr double edge = 0.5, face = 0.45, inner = 0.4, half = numbers::SQRT1_2;
  const double third = 1. / std::sqrt(3.);
  // The vertices of a cube in one corner, and their images on the sphere.
  const Hexahedron cube = {{{0., 0., 0.},
                            {edge, 0., 0.},
                            {0., edge, 0.},
                            {face, face, 0.},
                            {0., 0., edge},
                            {face, 0., face},
                            {0., face, face},
                            {inner, inner, inner}}};
  const Hexahedron outer = {{{0., 0., 0.},
                             {1., 0., 0.},
                             {0., 1., 0.},
                             {half, half, 0.},
                             {0., 0., 1.},
                             {half, 0., half},
                             {0., half, half},
                             {third, third, third}}};
  std::vector<Hexahedron> cells = {cube};
  for (const std::array<unsigned int, 4> &corners :
       {std::array<unsigned int, 4>{{1, 3, 5, 7}}, {{2, 3, 6, 7}}, {{4, 5, 6, 7}}}) {
    cells.emplace_back();
    for (unsigned int v = 0; v < 4; ++v) {
      cells.back()[v] = cube[corners[v]];
      cells.back()[v + 4] = outer[corners[v]];
    }
  }
  const std::vector<double> one = {1.}, both = {1., -1.};
  SolidBuilder builder;
  for (const double x : sector >= Sector::quarter ? one : both)
    for (const double y : sector >= Sector::octant ? one : both)
      for (const double z : sector >= Sector::half ? one : both)
        for (const Hexahedron &cell : cells)
          builder.add(cell, [&](const Point<3> &p) {
            return centre + radius * Tensor<1, 3>({x * p[0], y * p[1], -z * p[2]});
          });
  return builder.finish({{"round", Surface::sphere(centre, radius, Body::inside)}}, centre, centre);
}

Geometry<3> make_cylinder(const double inner_radius, const double radius, const double length,
                          const Point<3> &centre, const Axis axis, const Sector sector) {
  constexpr double longest = 0.6, max_layers = 1000.;
  const auto direction = static_cast<unsigned int>(axis);
  const bool is_tube = inner_radius > 0.;
  const std::vector<Quadrilateral> quarter =
    is_tube ? quarter_ring(inner_radius / radius) : quarter_disc();
  const double width = is_tube ? std::max(longest * (radius - inner_radius),
                                          quarter[0][0].distance(quarter[0][2]) * radius)
                               : longest * radius;
  const auto n_layers =
    static_cast<unsigned int>(std::clamp(std::round(length / width), 1., max_layers));
  // Across the axis: x and y, x and -z, or y and -z.
  const unsigned int first = direction == 0 ? 1 : 0, second = direction == 2 ? 1 : 2;
  const double down = second == 2 ? -1. : 1.;
  const std::vector<double> one = {1.}, both = {1., -1.};
  const bool is_half = sector >= Sector::half, is_quarter = sector >= Sector::quarter;
  SolidBuilder builder;
  for (const double a : is_quarter || (is_half && second == 1) ? one : both)
    for (const double b : is_quarter || (is_half && second == 2) ? one : both)
      for (unsigned int k = 0; k < n_layers; ++k)
        for (const Quadrilateral &cell : quarter) {
          Hexahedron unit;
          for (unsigned int v = 0; v < 8; ++v)
            unit[v] = Point<3>(cell[v % 4][0], cell[v % 4][1], double(k + v / 4) / n_layers);
          builder.add(unit, [&](const Point<3> &p) {
            Point<3> x = centre;
            x[first] += a * radius * p[0];
            x[second] += down * b * radius * p[1];
            x[direction] += length * p[2];
            return x;
          });
        }
  const Point<3> along = Point<3>::unit_vector(direction);
  std::vector<std::pair<std::string, Surface>> surfaces = {
    {is_tube ? "outer" : "round", Surface::cylinder(centre, along, radius, Body::inside)}};
  if (is_tube)
    surfaces.emplace_back("inner", Surface::cylinder(centre, along, inner_radius, Body::outside));
  return builder.finish(std::move(surfaces), centre, centre + length * along);
}
} // namespace Signorini
