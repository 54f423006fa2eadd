// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma_c in space: patches are squares of faces of a rectangular side.

#include <signorini/base/exceptions.h>
#include <signorini/mesh/contact_surface.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <map>

namespace Signorini
{
namespace
{
/** Side, and the place of a patch among those of the side in both directions. */
using Group = std::array<unsigned int, 3>;

/** The lines between the faces of a side in one direction, from its start, without the last one. */
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

/** Of a sorted list; zero for a single line. */
double smallest_step(const std::vector<double> &lines)
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
  FaceGrid(const Side<3> &side, const std::vector<dealii::Point<2>> &corners)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      std::vector<double> starts;
      for (const dealii::Point<2> &corner : corners)
        starts.push_back(corner[d]);
      lines_[d] = lines(std::move(starts), side.lengths()[d]);
      steps_[d] = smallest_step(lines_[d]);
    }
  }

  /** The place of the patch of ratio × ratio faces to which the face belongs. The last patches take
   * what is left. */
  std::array<unsigned int, 2> patch_of(const dealii::Point<2> &corner,
                                       const unsigned int ratio) const
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

/** The corner of the box around a face in the coordinates of its side with the smaller ones. */
dealii::Point<2> first_corner(const ContactFace<3> &face, const Side<3> &side)
{
  const auto mesh_face = face.cell->face(face.face_no);
  dealii::Point<2> corner = side.coordinates(mesh_face->vertex(0));
  for (unsigned int v = 1; v < mesh_face->n_vertices(); ++v)
  {
    const dealii::Point<2> s = side.coordinates(mesh_face->vertex(v));
    for (unsigned int d = 0; d < 2; ++d)
      corner[d] = std::min(corner[d], s[d]);
  }
  return corner;
}

/** By side. */
std::map<unsigned int, FaceGrid> face_grids(const std::vector<ContactFace<3>> &faces,
                                            const Geometry<3> &geometry)
{
  std::map<unsigned int, std::vector<dealii::Point<2>>> corners;
  for (const ContactFace<3> &face : faces)
    corners[face.side].push_back(first_corner(face, geometry.sides[face.side]));
  std::map<unsigned int, FaceGrid> grids;
  for (const auto &[side, of_side] : corners)
    grids.emplace(side, FaceGrid(geometry.sides[side], of_side));
  return grids;
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
  if (partition.patches_per_side > 0)
    throw ComputationError("In space, contact patches are groups of faces of the mesh.");
  const std::map<unsigned int, FaceGrid> grids = face_grids(faces_, scene_.geometry);
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

// Faces are plane quadrilaterals with bilinear maps: their vertices say all, and cost less than an
// FEFaceValues object for each of them.
template <>
SurfaceRule<3> ContactSurface<3>::at(const Piece<3> &piece,
                                     const std::vector<dealii::Point<2>> &positions) const
{
  const ContactFace<3> &face = faces_[piece.face];
  const auto mesh_face = face.cell->face(face.face_no);
  const Side<3> &side = this->side(patches_[piece.patch]);
  SurfaceRule<3> rule;
  rule.on_face = positions;
  for (const dealii::Point<2> &position : positions)
  {
    dealii::Point<3> x;
    for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
      x += dealii::GeometryInfo<2>::d_linear_shape_function(position, v) * mesh_face->vertex(v);
    rule.points.push_back(x);
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
  const ContactFace<3> &face = faces_[piece.face];
  const auto mesh_face = face.cell->face(face.face_no);
  SurfaceRule<3> rule = at(piece, gauss.get_points());
  for (unsigned int q = 0; q < gauss.size(); ++q)
  {
    std::array<dealii::Tensor<1, 3>, 2> tangents;
    for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
        tangents[d] +=
          dealii::GeometryInfo<2>::d_linear_shape_function_gradient(gauss.point(q), v)[d] *
          mesh_face->vertex(v);
    rule.weights.push_back(gauss.weight(q) *
                           dealii::cross_product_3d(tangents[0], tangents[1]).norm());
  }
  return rule;
}
} // namespace Signorini
