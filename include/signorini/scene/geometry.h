// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/side.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The body before it is meshed. */
template <int dim>
struct Geometry
{
  /** The boundary; the faces of sides[i] carry i as their boundary id in the coarse mesh. */
  std::vector<Side<dim>> sides;
  /** The number of cells on level 0. */
  double n_coarse_cells = 1.;
  /** Makes the coarse mesh (level 0), with the manifolds of a curved body. */
  std::function<void(dealii::Triangulation<dim> &)> make_coarse_mesh;
  /**
   * Makes a mesh of a rectangle with 2^level times the coarse cells in each direction, in which
   * the lines x_d = lines[d][k] are lines of the mesh: the nearest one moves there, or one is
   * added. Empty for other bodies.
   */
  std::function<void(dealii::Triangulation<dim> &,
                     unsigned int level,
                     const std::array<std::vector<double>, dim> &lines)>
    make_mesh_with_lines;
  /** Whether cells are curved. */
  bool curved = false;
  /** Whether the segments from inner_point() to the boundary lie in the body. */
  bool star_shaped = true;
  /** A point inside of the body; none: inner_point() is the mean of the sides. */
  std::optional<dealii::Point<dim>> inside;
  /** Numbers the boundary faces of a refined mesh, where sides end inside coarse faces; else empty.
   */
  std::function<void(dealii::Triangulation<dim> &)> number_after_refinement;
  /** A corner of the bounding box, and the opposite one. */
  dealii::Point<dim> lower;
  dealii::Point<dim> upper;
  /** Share of h by which interior vertices of the coarsest level are moved. */
  double distortion = 0.;
  /** How a message about the distortion begins. */
  std::string where_distortion = "the distortion of the mesh";

  double diameter() const
  {
    return lower.distance(upper);
  }
  /** A point inside of the body: the given one, or the mean of the centres of the sides, which is
   * inside of a convex body. */
  dealii::Point<dim> inner_point() const;
  /** The shortest edge of the box around the body (length). */
  double shortest_extent() const;
  /** The longest one. */
  double longest_extent() const;
  /** @return the number of the side, or sides.size() if there is none of this name. */
  std::size_t find_side(const std::string &name) const;
  /** All names, for messages. */
  std::vector<std::string> side_names() const;
};

/** Whether a side ends inside a boundary face, so that faces cannot be numbered. */
bool ends_inside_a_face(const std::vector<Side<2>> &sides,
                        const dealii::Triangulation<2> &triangulation);

/** Gives every boundary face the number of the side on which it lies. @throws InputError if a side
 * ends inside a face. */
void number_boundary(const std::vector<Side<2>> &sides, dealii::Triangulation<2> &triangulation);

/** Rectangle with @p cells coarse cells per direction; sides left, right, bottom, top. */
Geometry<2> make_rectangle(const dealii::Point<2> &lower_left,
                           const dealii::Point<2> &upper_right,
                           const std::vector<unsigned int> &cells);

/** Box with @p cells coarse cells per direction; sides left and right (x), front and back (y),
 * bottom and top (z). */
Geometry<3> make_box(const dealii::Point<3> &lower,
                     const dealii::Point<3> &upper,
                     const std::vector<unsigned int> &cells);

/**
 * Convex polygon, vertices counter-clockwise; side i joins vertex i with the next. Four vertices
 * make one coarse cell; otherwise there is one per vertex, from the centroid of the vertices and
 * the mid-points of the sides.
 */
Geometry<2> make_polygon(const std::vector<dealii::Point<2>> &vertices);

/**
 * The ring between two circles about a point; sides inner and outer. Eight coarse cells, in polar
 * coordinates.
 */
Geometry<2> make_ring(double inner_radius,
                      double outer_radius,
                      const dealii::Point<2> &centre = {});

/**
 * The half disc below a point; sides flat (from left to right) and arc (from (-R, 0) by (0, -R) to
 * (R, 0), seen from the centre). Inside of the four coarse cells the mesh is the transfinite
 * interpolation of their edges.
 */
Geometry<2> make_half_disc(double radius, const dealii::Point<2> &centre = {});

/** The disc about a point; one side, arc, from the angle -pi. Five coarse cells, with the mesh of
 * make_half_disc() inside of them. */
Geometry<2> make_disc(double radius, const dealii::Point<2> &centre = {});
} // namespace Signorini
