// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/side.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** One of several bodies: a component of the mesh that no edges connect to others. */
template <int dim>
struct ElasticBody {
  std::string name;
  /** The number of its first side; those that follow are its own up to the next body's. */
  unsigned int first_side = 0;
  /** The lower corner of its bounding box, and the opposite one. */
  Point<dim> lower, upper;
  /** The number of cells of its graded meshes before they are refined. */
  double n_graded_cells = 1.;
};

/** Lines and points that the first mesh of a graded sequence follows. */
template <int dim>
struct MeshGuides {
  /** In rectangles the lines x_d = lines[d][k] are lines of the mesh; in other bodies vertices of
   * straight sides lie on them. */
  std::array<std::vector<double>, dim> lines;
  /** Points of straight sides that are vertices, with the numbers of these sides. */
  std::vector<std::pair<unsigned int, Point<dim>>> vertices;
};

/** The body before it is meshed, or several bodies. */
template <int dim>
struct Geometry {
  /** The boundary; the faces of sides[i] carry i as their boundary id in the coarse mesh. */
  std::vector<Side<dim>> sides;
  /** The number of cells on level 0. */
  double n_coarse_cells = 1.;
  /** The number of cells into which graded meshes divide each of these (mean): those of long
   * rectangles are divided until they are nearly square. */
  double division = 1.;
  /** Returns the number of cells of graded meshes before they are refined. */
  double n_graded_cells() const {
    return n_coarse_cells * division;
  }
  /** Makes the coarse mesh (level 0), with the manifolds of a curved body. */
  std::function<void(Triangulation<dim> &)> make_coarse_mesh;
  /**
   * Makes the first mesh of a graded sequence where it has other cells than the coarse one: those
   * of rectangles are nearly square, with lines through all guides. Empty for other bodies.
   * @return how many of the @p level refinements are still to be made.
   */
  std::function<unsigned int(Triangulation<dim> &, unsigned int level, const MeshGuides<dim> &)>
    make_guided_mesh;
  /** Whether cells are curved. */
  bool curved = false;
  /** Whether ranks can share the mesh: p4est needs coarse cells in space whose edges have the same
   * directions in all of them. */
  bool can_be_shared = true;
  /** Whether the body is one of revolution: x is the distance from its axis, and integrals are
   * those over the whole circumference. For 2-D only. */
  bool axisymmetric = false;
  /** The length of a plane body across its plane, for which forces are told; computed
   * forces are per unit of it. */
  double thickness = 1.;
  /** Whether the segments from inner_point() to the boundary lie in the body. */
  bool star_shaped = true;
  /** A point inside of the body. If it is empty, inner_point() is the mean of the sides. */
  std::optional<Point<dim>> inside;
  /** Numbers the boundary faces of a refined mesh, where sides end inside coarse faces; otherwise
   * empty. */
  std::function<void(Triangulation<dim> &)> number_after_refinement;
  /** The names of the parts with moduli of their own; empty if the body has none. */
  std::vector<std::string> regions;
  /** Returns the index of the region at a point; empty without regions. */
  std::function<unsigned int(const Point<dim> &)> region_at;
  /** A remark on the mesh for the user; mostly empty. */
  std::string note;
  /** The lower corner of the bounding box, and the opposite one. */
  Point<dim> lower;
  Point<dim> upper;
  /** The bodies, where there are several. The material id of a cell is the number of its body. */
  std::vector<ElasticBody<dim>> bodies;
  /** The share of h by which interior vertices of the coarsest level are moved. */
  double distortion = 0.;
  /** The beginning of a message about the distortion. */
  std::string where_distortion = "the distortion of the mesh";

  double diameter() const {
    return lower.distance(upper);
  }
  unsigned int n_bodies() const {
    return bodies.empty() ? 1 : bodies.size();
  }
  /** Returns the number of the body to which a side belongs. */
  unsigned int body_of_side(unsigned int side) const;
  /** Returns the number of the body to which a cell belongs. */
  template <typename Cell>
  unsigned int body_of(const Cell &cell) const {
    return bodies.empty() ? 0 : cell->material_id();
  }
  /** Returns the factor of dx and ds: the circumference 2 pi x of a body of revolution, otherwise
   * 1. */
  double circumference(const Point<dim> &x) const {
    return axisymmetric ? 2. * numbers::PI * x[0] : 1.;
  }
  /** Returns whether a side lies on the axis of a body of revolution. */
  bool is_axis(const Side<dim> &side) const;
  /** Returns a point inside of the body: the given one, or the mean of the centres of the sides,
   * which is inside of a convex body. */
  Point<dim> inner_point() const;
  /** Returns the shortest edge of the box around the body (length). */
  double shortest_extent() const;
  /** Returns the longest edge of the box around the body (length). */
  double longest_extent() const;
  /** @return the number of the side, or sides.size() if there is none of this name. */
  std::size_t find_side(const std::string &name) const;
  /** Returns the names of all sides. */
  std::vector<std::string> side_names() const;
  /** Returns the names of all sides for messages; those of sides that have numbers for names with
   * the points in their middles. */
  std::vector<std::string> described_sides() const;
};

/** Returns several bodies as one: the sides of the body "upper" are upper.bottom, ..., and bodies
 * are regions. */
Geometry<2> unite(const std::vector<std::string> &names, const std::vector<Geometry<2>> &bodies);

/** Returns whether a side ends inside a boundary face, so that faces cannot be numbered. */
bool ends_inside_a_face(const std::vector<Side<2>> &sides, const Triangulation<2> &triangulation);

/** Gives every boundary face the number of the side on which it lies. @throws InputError if a side
 * ends inside a face. */
void number_boundary(const std::vector<Side<2>> &sides, Triangulation<2> &triangulation);

/** Returns the body between these sides without a mesh: its box, and whether sides are curved. */
Geometry<2> bounded_by(std::vector<Side<2>> sides);

} // namespace Signorini
