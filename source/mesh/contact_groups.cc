// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c in space: patches are groups of faces that descend from one face of a coarser level.

#include <signorini/base/exceptions.h>
#include <signorini/mesh/contact_surface.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace Signorini
{
namespace
{
/** Side, level and index of the cell to whose face a contact face belongs. */
using Group = std::tuple<unsigned int, int, int, unsigned int>;

/** The ancestor of the face's cell that lies @p n_generations back, or the coarsest one. Children
 * of a face keep its number. */
Group group_of(const ContactFace<3> &face, const unsigned int n_generations)
{
  dealii::Triangulation<3>::cell_iterator cell = face.cell;
  for (unsigned int g = 0; g < n_generations && cell->level() > 0; ++g)
    cell = cell->parent();
  return {face.side, cell->level(), cell->index(), face.face_no};
}

/** log2 of the ratio. */
unsigned int generations(const Partition &partition)
{
  unsigned int n = 0;
  while ((2U << n) <= partition.ratio)
    ++n;
  if (partition.patches_per_side > 0 || (1U << n) != partition.ratio)
    throw ComputationError(
      "In space, contact patches are groups of faces of the mesh: H/h must be a "
      "power of two, and patches that are aligned with nothing do not exist.");
  return n;
}

/** Enlarges the box between @p lower and @p upper by a point. */
void extend(dealii::Point<2> &lower, dealii::Point<2> &upper, const dealii::Point<2> &s)
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
  const unsigned int n_generations = generations(partition);
  std::map<Group, unsigned int> numbers;
  for (unsigned int f = 0; f < faces_.size(); ++f)
  {
    const ContactFace<3> &face = faces_[f];
    const Side<3> &side = scene_.geometry.sides[face.side];
    const auto mesh_face = face.cell->face(face.face_no);
    const dealii::Point<2> first = side.coordinates(mesh_face->vertex(0));
    Piece<3> piece = {f, 0, first, first, {0., 0.}, {1., 1.}, {}};
    for (unsigned int v = 1; v < mesh_face->n_vertices(); ++v)
      extend(piece.lower, piece.upper, side.coordinates(mesh_face->vertex(v)));
    const auto [group, is_new] =
      numbers.emplace(group_of(face, n_generations), static_cast<unsigned int>(patches_.size()));
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

template <>
SurfaceRule<3> ContactSurface<3>::at(const Piece<3> &piece,
                                     const std::vector<dealii::Point<2>> &positions) const
{
  const dealii::FE_Nothing<3> no_functions;
  dealii::FEFaceValues<3> values(mesh_.mapping(),
                                 no_functions,
                                 dealii::Quadrature<2>(positions),
                                 dealii::update_quadrature_points);
  values.reinit(faces_[piece.face].cell, faces_[piece.face].face_no);
  const Side<3> &side = this->side(patches_[piece.patch]);
  SurfaceRule<3> rule;
  rule.on_face = positions;
  rule.points = values.get_quadrature_points();
  for (const dealii::Point<3> &x : rule.points)
  {
    rule.on_side.push_back(side.coordinates(x));
    rule.normals.push_back(side.normal(rule.on_side.back()));
  }
  return rule;
}

template <>
SurfaceRule<3> ContactSurface<3>::rule(const Piece<3> &piece,
                                       const unsigned int n_points,
                                       const Grading /*there are no kinks in space*/) const
{
  const dealii::QGauss<2> gauss(n_points);
  const dealii::FE_Nothing<3> no_functions;
  dealii::FEFaceValues<3> values(mesh_.mapping(), no_functions, gauss, dealii::update_JxW_values);
  values.reinit(faces_[piece.face].cell, faces_[piece.face].face_no);
  SurfaceRule<3> rule = at(piece, gauss.get_points());
  rule.weights = values.get_JxW_values();
  return rule;
}
} // namespace Signorini
