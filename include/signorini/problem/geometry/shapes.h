// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/sector.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini {
/** Returns a rectangle with @p cells coarse cells per direction; sides left, right, bottom, top. */
Geometry<2> make_rectangle(const Point<2> &lower_left, const Point<2> &upper_right,
                           const std::vector<unsigned int> &cells);

/** Returns a box with @p cells coarse cells per direction; sides left and right (x), front and back
 * (y), bottom and top (z). */
Geometry<3> make_box(const Point<3> &lower, const Point<3> &upper,
                     const std::vector<unsigned int> &cells);

/**
 * Returns a convex polygon, vertices counter-clockwise; side i joins vertex i with the next. Four
 * vertices make one coarse cell; otherwise there is one per vertex, from the centroid of the
 * vertices and the mid-points of the sides.
 */
Geometry<2> make_polygon(const std::vector<Point<2>> &vertices);

/**
 * Returns the ring between two circles about a point; sides inner and outer. It has eight coarse
 * cells, in polar coordinates.
 */
Geometry<2> make_ring(double inner_radius, double outer_radius, const Point<2> &centre = {});

/**
 * Returns the half disc below a point; sides flat (from left to right) and arc (from (-R, 0) by (0,
 * -R) to (R, 0), seen from the centre). Inside of the four coarse cells the mesh is the transfinite
 * interpolation of their edges.
 */
Geometry<2> make_half_disc(double radius, const Point<2> &centre = {});

/** Returns the disc about a point; one side, arc, from the angle -pi. It has five coarse cells,
 * with the mesh of make_half_disc() inside of them. */
Geometry<2> make_disc(double radius, const Point<2> &centre = {});

/**
 * Returns a ball; sides round and, of its parts, the planes through the centre by the names of a
 * box's sides: half is z < 0 (side top), quarter x > 0, too (left), and octant y > 0 (front). An
 * octant has four coarse cells.
 */
Geometry<3> make_ball(double radius, const Point<3> &centre = {}, Sector sector = Sector::whole);

/**
 * Returns a cylinder, or a tube if @p inner_radius is positive, along the coordinate axis
 * @p axis, from the plane through @p centre; sides round, or inner and outer, and the planes
 * by the names of a box's sides. half is z < 0, or x > 0 where the axis is the z-axis; quarter is
 * the part of it with x > 0, or y > 0 where that cannot be. Coarse cells are about as long as wide.
 */
Geometry<3> make_cylinder(double inner_radius, double radius, double length,
                          const Point<3> &centre = {}, Axis axis = Axis::z,
                          Sector sector = Sector::whole);
} // namespace Signorini
