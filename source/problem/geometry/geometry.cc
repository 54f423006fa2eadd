// SPDX-License-Identifier: LGPL-2.1-or-later
// Omega: its sides, its bodies, and the numbers of its boundary faces.

#include <signorini/base/message.h>
#include <signorini/problem/geometry/geometry.h>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

namespace Signorini {
namespace {
/** Returns whether a face lies on one piece of a side, from end to end. */
template <typename Face>
bool lies_on(const Face &face, const Side<2> &side) {
  const double margin = 1e-8 * side.length();
  const auto has = [&](const Curve &piece, const Point<2> &x) {
    const double s = piece.arc_length(x);
    return piece.point(s).distance(x) <= margin && s >= -margin && s <= piece.length() + margin;
  };
  for (const unsigned int k : side.pieces_near(face->vertex(0), margin))
    if (has(side.piece(k), face->vertex(0)) && has(side.piece(k), face->vertex(1)))
      return true;
  return false;
}

/** Returns the number of the side that a face lies on, or sides.size(). */
template <typename Face>
unsigned int find_side_of(const Face &face, const std::vector<Side<2>> &sides) {
  unsigned int i = 0;
  while (i < sides.size() && !lies_on(face, sides[i]))
    ++i;
  return i;
}
} // namespace

bool ends_inside_a_face(const std::vector<Side<2>> &sides, const Triangulation<2> &triangulation) {
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && find_side_of(face, sides) == sides.size())
      return true;
  return false;
}

void number_boundary(const std::vector<Side<2>> &sides, Triangulation<2> &triangulation) {
  Assert(!sides.empty(), ExcMessage("A body has sides."));
  if (ends_inside_a_face(sides, triangulation))
    throw input_error("a side of this scene ends inside a face of the mesh, allowed: a finer mesh "
                      "(Coarsest level).");
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(find_side_of(face, sides));
}

template <int dim>
Point<dim> Geometry<dim>::inner_point() const {
  if (inside)
    return *inside;
  Point<dim> mean;
  for (const Side<dim> &side : sides)
    mean += side.centre() / static_cast<double>(sides.size());
  return mean;
}

template <int dim>
double Geometry<dim>::shortest_extent() const {
  const Tensor<1, dim> extents = upper - lower;
  return *std::min_element(extents.begin_raw(), extents.end_raw());
}

template <int dim>
double Geometry<dim>::longest_extent() const {
  const Tensor<1, dim> extents = upper - lower;
  return *std::max_element(extents.begin_raw(), extents.end_raw());
}

template <int dim>
bool Geometry<dim>::is_axis(const Side<dim> &side) const {
  if constexpr (dim == 2) {
    const double rounding = 1e-10 * diameter();
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
      if (std::max(side.piece(k).centre()[0], side.piece(k).end()[0]) > rounding)
        return false;
    return axisymmetric;
  } else
    return false;
}

template <int dim>
std::size_t Geometry<dim>::find_side(const std::string &name) const {
  std::size_t i = 0;
  while (i < sides.size() && sides[i].name() != name)
    ++i;
  return i;
}

template <int dim>
unsigned int Geometry<dim>::body_of_side(const unsigned int side) const {
  AssertIndexRange(side, sides.size());
  unsigned int body = 0;
  while (body + 1 < bodies.size() && bodies[body + 1].first_side <= side)
    ++body;
  return body;
}

template <int dim>
std::vector<std::string> Geometry<dim>::side_names() const {
  std::vector<std::string> names;
  for (const Side<dim> &side : sides)
    names.push_back(side.name());
  return names;
}

template <int dim>
std::vector<std::string> Geometry<dim>::described_sides() const {
  std::vector<std::string> texts;
  for (const Side<dim> &side : sides) {
    texts.push_back(side.name());
    if (std::isdigit(static_cast<unsigned char>(side.name()[0])) != 0)
      texts.back() += concatenate(" at (", side.centre(), ")");
  }
  return texts;
}

Geometry<2> bounded_by(std::vector<Side<2>> sides) {
  Geometry<2> geometry;
  BoundingBox<2> box = sides.at(0).box();
  for (const Side<2> &side : sides) {
    box.merge_with(side.box());
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
      geometry.curved = geometry.curved || !side.piece(k).is_flat();
  }
  std::tie(geometry.lower, geometry.upper) = box.get_boundary_points();
  geometry.sides = std::move(sides);
  return geometry;
}

template struct Geometry<2>;
template struct Geometry<3>;
} // namespace Signorini
