// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/error_control/equilibration/cell_shape.h>
#include <signorini/error_control/equilibration/equilibration_mesh.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace Signorini {
/** Returns the forces (two) and the moments about a point of Legendre's polynomials as τ_nn (first)
 * and τ_nt on a segment or an arc. @param side 1 if the body is on the left of the line, else -1.
 * @param direction that of TractionEdge.
 */
std::vector<Tensor<1, 3>> resultants(const Curve &line, double side, unsigned int degree,
                                     const Point<2> &about,
                                     const std::optional<Tensor<1, 2>> &direction = {});

/**
 * A line of the mesh that carries a traction; where a node hangs, the longer line. The traction is
 * given by its normal component τ_nn and its shear τ_nt, n outwards and t counter-clockwise. Both
 * are the same seen from either side. Each is a polynomial of the position, the share of arc
 * length from start (0) to end (1), by its coefficients of orthonormal Legendre polynomials.
 */
struct TractionEdge {
  static constexpr unsigned int no_side = static_cast<unsigned int>(-1);

  /** The segment, or on the boundary the arc. */
  Curve line;
  /** The number of the side in the geometry, on the boundary; else no_side. */
  unsigned int side = no_side;
  /** The degree of the polynomials. */
  unsigned int degree = 1;
  /** The number of the first coefficient of τ_nn; those of τ_nt follow. */
  unsigned int first = 0;
  /** Whether τ_nn and τ_nt are unknown. */
  std::array<bool, 2> is_free = {{true, true}};
  /** Whether it carries the traction of a pair of sides, see SharedPart. */
  bool is_shared = false;
  /** The direction m of contact, where that is not the normal: the components of the traction are
   * those along m and along the tangent of m, instead of τ_nn and τ_nt. */
  std::optional<Tensor<1, 2>> direction = {};
  /** Whether contact acts along several directions on the edge. Then nothing presses there: no
   * polynomials are tractions of all of them. */
  bool mixes = false;

  double length() const {
    return line.length();
  }
  /** Returns the point at a position; position_of() returns the position of a point of the edge, or
   * of its projection where the point lies beside the edge or beyond its ends. */
  Point<2> point(const double position) const {
    return line.point(position * length());
  }
  double position_of(const Point<2> &x) const {
    return line.arc_length(x) / length();
  }
  /** Returns the direction of a component of the traction, for the outward normal. */
  Tensor<1, 2> axis(const unsigned int component, const Tensor<1, 2> &n) const {
    return direction_of(component == 0 ? Component::normal : Component::tangential,
                        direction.value_or(n));
  }
  /** Returns the forces and moments of the coefficients of a boundary edge. */
  std::vector<Tensor<1, 3>> resultants(const Geometry<2> &geometry, const Point<2> &about) const {
    const Point<2> middle = point(0.5);
    const Tensor<1, 2> n = geometry.sides[side].normal_at(middle, middle);
    return Signorini::resultants(line, line.normal(0.5 * length()) * n > 0. ? 1. : -1., degree,
                                 about, direction);
  }
  unsigned int n_coefficients() const {
    return 2 * (degree + 1);
  }
  /** Returns the number of a coefficient of τ_nn (component 0) or τ_nt (1). */
  unsigned int position(const unsigned int component, const unsigned int i) const {
    return first + component * (degree + 1) + i;
  }
};

/**
 * A part of an edge on a side of a pair, and the shared edge that gives the traction q there. Edges
 * of both sides have polynomials of their own: the projection of q, which has its forces and
 * moments. Shared edges are the edges of the carrier, as far as the sides face each other.
 */
struct SharedPart {
  /** The number of the shared edge. */
  unsigned int shared;
  /** The ends of the part by their positions on the edge (from < to), and on the shared edge. */
  double from, to;
  double shared_from, shared_to;
  /** The coefficients R_ij = ∫ L_i L_j over the part, by those of the edge and of the shared one;
   * the edge is of length one. */
  FullMatrix<double> R;

  /** Returns the position on the shared edge at one on the edge. */
  double position_on_shared(const double s) const {
    return shared_from + (s - from) / (to - from) * (shared_to - shared_from);
  }
};

/** A side of a cell, a whole edge or half of it: the positions of corner k and k + 1 on the edge.
 */
struct TractionSide {
  unsigned int edge;
  double from, to;

  bool is_half() const {
    return from + to != 1.;
  }
  bool is_reversed() const {
    return from > to;
  }
};

/** A cell with its corners and sides counter-clockwise; side k runs from corner k to
 * corner k + 1. */
struct TractionCell {
  CellShape shape;
  std::array<TractionSide, 4> sides;
  /** The degree of the stresses in the cell, at least that of the edges and two. */
  unsigned int degree = 2;
};

/**
 * The tractions on the edges of a 2-D mesh with straight edges, arcs on the boundary, hanging nodes
 * and elements of any degree.
 *
 * The traces of a cell of degree q are the coefficients of τ_nn and τ_nt on its sides in its own
 * direction: entry (2 k + c)(q + 1) + i belongs to side k, component c and Legendre's degree i.
 * With the coefficients x of all edges they are E x, which restricts polynomials of edges to
 * halves. So tractions are continuous also where nodes hang.
 */
class TractionSpace {
public:
  using Vector = dealii::Vector<double>;

  /** Collects edges and cells. The scene must outlive the object. */
  TractionSpace(const EquilibrationMesh &mesh, const Scene<2> &scene);

  const std::vector<TractionCell> &cells() const {
    return cells_;
  }
  const std::vector<TractionEdge> &edges() const {
    return edges_;
  }
  void set_free(const unsigned int edge, const unsigned int component, const bool is_free) {
    edges_[edge].is_free[component] = is_free;
  }
  /** Returns the number of the edge that contains a boundary face of a mesh of the same body. */
  unsigned int edge_at(const Triangulation<2>::cell_iterator &cell, unsigned int face_no) const;
  /** Returns the number of the edge with the unknown traction of contact on a face of a carrier, or
   * of a side that touches a rigid foundation; none for others. */
  unsigned int contact_edge_at(const Triangulation<2>::cell_iterator &cell,
                               unsigned int face_no) const;
  /** Returns the parts of an edge that shared edges give; mostly none. */
  const std::vector<SharedPart> &shared_parts(const unsigned int edge) const {
    return parts_[edge];
  }
  /** Returns the edges whose coefficients an edge takes: itself, or shared ones. */
  std::vector<unsigned int> sources(unsigned int edge) const;
  /** Returns a linear functional of the tractions on edges as one of unknown tractions. */
  Vector gathered(Vector functional) const;
  unsigned int n_coefficients() const {
    return n_coefficients_;
  }
  /** An entry of E. */
  struct Entry {
    unsigned int trace, coefficient;
    double value;
  };
  /** Returns the entries of E for a cell. */
  std::vector<Entry> entries(const TractionCell &cell) const;
  /** Returns E x. */
  Vector traces(const TractionCell &cell, const Vector &x) const;

  static constexpr unsigned int none = static_cast<unsigned int>(-1);

private:
  using LineIterator = Triangulation<2>::line_iterator;

  /** Returns the number of the edge of a line, a new one if there is none. */
  unsigned int find_edge(const LineIterator &line, const Scene<2> &scene);
  TractionSide find_side(const Triangulation<2>::active_cell_iterator &cell, unsigned int face_no,
                         const Point<2> &from, const Scene<2> &scene);
  /** Makes the shared edges of a pair, by its carrier and the other side. */
  void add_shared_edges(unsigned int carrier, unsigned int other);
  void number_coefficients();

  std::vector<TractionCell> cells_;
  std::vector<TractionEdge> edges_;
  std::vector<std::vector<SharedPart>> parts_;
  std::vector<unsigned int> edge_of_line_;
  /** The boundary edges of each side by the arc length at which they start. */
  std::vector<std::map<double, unsigned int>> on_side_;
  const std::vector<Side<2>> &sides_;
  /** Whether a side belongs to a pair. */
  std::vector<bool> is_paired_;
  unsigned int n_coefficients_ = 0;
  /** The coefficients R_ij of L_j(from + s (to - from)) in L_i(s): restrictions to the first and
   * second half, and both reversed. */
  std::array<FullMatrix<double>, 4> halves_;
};

/** Returns the forces and the moment of the tractions on a cell by its traces (rows), orthonormal,
 * less the parts that ArcLift's conditions, the last traces, miss on arcs. They are those of the
 * cell at unit size. */
FullMatrix<double> balance_rows(const CellShape &shape, unsigned int degree);
} // namespace Signorini
