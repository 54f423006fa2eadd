// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/box_tree.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * A plane rectangle on the boundary of a 3-D body. Its coordinates are the distances from a corner
 * along the two edges that begin there.
 */
class Rectangle {
public:
  /** @param first, second the edges from @p corner, at right angles. @param normal the outward unit
   * normal. */
  Rectangle(const Point<3> &corner, const Tensor<1, 3> &first, const Tensor<1, 3> &second,
            const Tensor<1, 3> &normal)
    : corner_(corner)
    , edges_{first, second}
    , normal_(normal) {}

  bool is_flat() const {
    return true;
  }
  /** Returns x(s), also beyond the edges. */
  Point<3> point(const Point<2> &s) const {
    return corner_ + s[0] * edges_[0] / edges_[0].norm() + s[1] * edges_[1] / edges_[1].norm();
  }
  Tensor<1, 3> normal(const Point<2> & /*s*/) const {
    return normal_;
  }
  Point<2> coordinates(const Point<3> &x) const {
    return {(x - corner_) * edges_[0] / edges_[0].norm(),
            (x - corner_) * edges_[1] / edges_[1].norm()};
  }
  /** Returns the lengths of the edges. */
  std::array<double, 2> lengths() const {
    return {{edges_[0].norm(), edges_[1].norm()}};
  }
  Point<3> centre() const {
    return corner_ + 0.5 * (edges_[0] + edges_[1]);
  }

private:
  Point<3> corner_;
  std::array<Tensor<1, 3>, 2> edges_;
  Tensor<1, 3> normal_;
};

/** A smooth piece of the boundary with coordinates of its own: point(s), normal(s), coordinates(x).
 */
template <int dim>
using SideManifold = std::conditional_t<dim == 2, Curve, Rectangle>;

/** A named piece of the boundary: a name and the manifold that the piece is. */
template <int dim>
class Side : public SideManifold<dim> {
public:
  Side(std::string name, SideManifold<dim> manifold)
    : SideManifold<dim>(std::move(manifold))
    , name_(std::move(name)) {}

  const std::string &name() const {
    return name_;
  }

private:
  std::string name_;
};

/** One of several bodies: a component of the mesh that no edges connect to others. */
template <int dim>
struct ElasticBody {
  std::string name;
  /** The number of its first side; those that follow are its own up to the next body's. */
  unsigned int first_side = 0;
  /** The lower corner of its bounding box, and the opposite one. */
  Point<dim> lower, upper;
};

/** The body before it is meshed, or several bodies. */
template <int dim>
struct Geometry {
  /** The boundary; the faces of sides[i] carry i as their boundary id in the coarse mesh. */
  std::vector<Side<dim>> sides;
  /** The number of cells on level 0. */
  double n_coarse_cells = 1.;
  /** Makes the coarse mesh (level 0), with the manifolds of a curved body. */
  std::function<void(Triangulation<dim> &)> make_coarse_mesh;
  /**
   * Makes a mesh of a rectangle with 2^level times the coarse cells in each direction, in which
   * the lines x_d = lines[d][k] are lines of the mesh: the nearest one moves there, or one is
   * added. Empty for other bodies.
   */
  std::function<void(Triangulation<dim> &, unsigned int level,
                     const std::array<std::vector<double>, dim> &lines)>
    make_mesh_with_lines;
  /** Whether cells are curved. */
  bool curved = false;
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

/** Returns the lines x_d = positions[d][k] for all d and k. */
template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions);

/**
 * Where data is not smooth: the lines on which it has kinks or jumps, the points where they meet
 * contact sides, and where it varies too fast for the plain rules: breaks on sides and boxes in the
 * body. Contact may end where a line meets a contact side, and derivatives of the solution may be
 * unbounded there.
 */
template <int dim>
class Kinks {
public:
  /** The share of an edge within which a line touches an end and cuts nothing. */
  static constexpr double tolerance = 1e-10;
  /** The smallest distance of two lines, as a share of the body, that meshes and rules are graded
   * to. Closer ones cut off slivers, each of which would be graded. */
  static constexpr double min_distance = 1e-3;

  /**
   * @param breaks points of sides between which a few points show their data.
   * @param boxes the same in the body.
   */
  Kinks(std::vector<KinkLine<dim>> lines = {}, std::vector<Point<dim>> breaks = {},
        BoxTree boxes = {});

  /** Finds the points where the lines meet a contact side. */
  void add_ends_on(const Side<dim> &contact_side);

  /** Returns the same lines without their ends. Meshes that are graded to the ends of contact need
   * no quadrature rules that are graded there. */
  Kinks without_ends() const;
  /** Returns the same with more lines. */
  Kinks with_lines(const std::vector<KinkLine<dim>> &more) const;

  const std::vector<KinkLine<dim>> &lines() const {
    return lines_;
  }
  /** Returns the possible ends of contact zones. */
  const std::vector<Point<dim>> &ends() const {
    return ends_;
  }
  const BoxTree &boxes() const {
    return *boxes_;
  }

  /** Returns whether there are breaks inside of the segment between two points of a side. */
  bool has_breaks(const Point<dim> &a, const Point<dim> &b) const {
    return !breaks_on(a, b).empty();
  }

  /**
   * Returns the parameters t in [0,1], sorted, at which the segment from @p a to @p b is cut: 0,
   * the crossings and breaks, 1.
   */
  std::vector<double> cut(const Point<dim> &a, const Point<dim> &b) const;

  /**
   * Returns the arc lengths, sorted, at which the part [from, to] of a side (or of its
   * continuation) is cut: from, the crossings and breaks, to.
   */
  std::vector<double> cut(const Side<dim> &side, double from, double to) const;

  /** Returns the same without breaks. */
  std::vector<double> crossings(const Side<dim> &side, double from, double to) const;

  /** Returns the crossings inside of a side that are not too close to each other. */
  std::vector<double> separate_crossings(const Side<dim> &side) const;

  /** Returns whether a line passes through an end of the part [from, to] of a side. */
  bool touch(const Side<dim> &side, double from, double to) const;

private:
  /** Returns the parameters of the breaks inside of a segment. */
  std::vector<double> breaks_on(const Point<dim> &a, const Point<dim> &b) const;

  std::vector<KinkLine<dim>> lines_;
  std::vector<Point<dim>> ends_, breaks_;
  std::shared_ptr<const BoxTree> boxes_;
};
} // namespace Signorini
