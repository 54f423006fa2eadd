// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>

#include <deal.II/base/symmetric_tensor.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <vector>

namespace Signorini {
/** The tractions that an edge may carry. */
enum class EdgeFreedom {
  /** The edge carries any traction: inside the body, and where displacements are prescribed. */
  any,
  /** The edge carries normal tractions: rollers, and contact edges that press once their traction
   * is free. */
  normal,
  /** The traction of the edge is given: traction, free and contact sides. */
  none
};

/** An edge of the mesh. The chord replaces a curved edge. */
struct Edge {
  /** The numbers of its end points in the mesh. */
  std::array<unsigned int, 2> vertices;
  EdgeFreedom freedom = EdgeFreedom::any;
  /** The number of the side, on the boundary; else no_side. */
  unsigned int side;
  /** The outward unit normal of the first of its cells. */
  Tensor<1, 2> normal;
  double length;

  static constexpr unsigned int no_side = static_cast<unsigned int>(-1);

  bool is_boundary() const {
    return side != no_side;
  }
  /** Returns whether displacements are prescribed on the edge. */
  bool is_held() const {
    return is_boundary() && freedom == EdgeFreedom::any;
  }
  /** Returns the projection onto the tractions that the edge may carry. */
  Tensor<2, 2> projection() const {
    Tensor<2, 2> P;
    if (freedom == EdgeFreedom::any)
      P = unit_symmetric_tensor<2>();
    else if (freedom == EdgeFreedom::normal)
      P = outer_product(normal, normal);
    return P;
  }
};

/** The difference between the biquadratic image of a cell and the bilinear one with the same
 * corners, as coefficients of the bubbles of CellFunctions. */
using Bulges = std::array<Tensor<1, 2>, 5>;

/** A quadrilateral with its corners and edges counter-clockwise; edge k runs from corner k to
 * corner k + 1. */
struct EdgeCell {
  std::array<Point<2>, 4> corners;
  std::array<unsigned int, 4> vertices;
  std::array<unsigned int, 4> edges;
  /** The sign of the traction: 1 for the first cell of an edge, -1 for the second one. */
  std::array<double, 4> sign;
  /** Whether Edge::vertices[0] is corner k + 1. */
  std::array<bool, 4> reversed;
  /** The bulges of the cell, zero unless it is curved by more than rounding. */
  Bulges bulges{};
  bool is_curved = false;

  /** Returns the vector along edge k. */
  Tensor<1, 2> edge_vector(const unsigned int k) const {
    return corners[(k + 1) % 4] - corners[k];
  }
};

/** A corner of a cell. */
struct CellCorner {
  unsigned int cell;
  unsigned int number;
};

/** An edge in the star of one of its end points, the centre. */
struct Spoke {
  unsigned int edge;
  /** The end of the edge that is the centre. */
  unsigned int end;
  /** The sign: 1 if the traction of the edge is that on the cell to the left of the way from the
   * centre outwards, else -1. */
  double sign;
};

/**
 * The cells around a vertex, counter-clockwise. Spoke j is to the right of cell j and spoke j + 1
 * to its left; inside the body the spokes close, at the boundary there is one more than cells.
 */
struct Star {
  // Most vertices have four cells: no allocations for them.
  boost::container::small_vector<CellCorner, 5> cells;
  boost::container::small_vector<Spoke, 5> spokes;

  bool is_closed() const {
    return spokes.size() == cells.size();
  }
  /** Returns the spoke to the left of cell j. */
  unsigned int left_of(const unsigned int j) const {
    return (j + 1) % spokes.size();
  }
};

/**
 * The edges, cells and stars of a 2-D mesh without hanging nodes. A curved mesh is replaced by the
 * polygon of its vertices; the cells store their bulges.
 *
 * The traction on an edge is a linear function t along it, that on the first of its cells. It is
 * stored by its moments ∫_e t φ_i with the hat functions of the two end points i, two
 * components each: entries 4 e + 2 end + component of a vector of moments. Every rank stores all of
 * them.
 */
class EdgeMesh {
public:
  EdgeMesh(const DisplacementSpace<2> &space, const Scene<2> &scene);

  const std::vector<EdgeCell> &cells() const {
    return cells_;
  }
  const std::vector<Edge> &edges() const {
    return edges_;
  }
  void set_freedom(const unsigned int edge, const EdgeFreedom freedom) {
    edges_[edge].freedom = freedom;
  }
  /** Returns the stars of all vertices. */
  const std::vector<Star> &stars() const {
    return stars_;
  }
  /** Returns the degrees of freedom of both components at each vertex. */
  const std::vector<std::array<types::global_dof_index, 2>> &dofs() const {
    return dofs_;
  }
  /** Returns the number of the edge that is a line of the triangulation. */
  unsigned int edge_of_line(const unsigned int line) const {
    return edge_of_line_[line];
  }
  bool is_curved() const {
    return is_curved_;
  }
  std::size_t n_moments() const {
    return 4 * edges_.size();
  }
  /** Returns the position in a vector of moments of the first component that edge k of a cell has
   * at its corner k (@p end 0) or k + 1 (1). */
  static unsigned int position(const EdgeCell &cell, const unsigned int k, const unsigned int end) {
    return 4 * cell.edges[k] + (cell.reversed[k] == (end == 1) ? 0 : 2);
  }

private:
  void collect_cells(const DisplacementSpace<2> &space, const Scene<2> &scene);
  void collect_stars();
  /** Walks round the vertex from the given corner, the first one on the boundary. */
  Star walk(const CellCorner &first,
            const std::vector<std::array<CellCorner, 2>> &neighbours) const;

  bool is_curved_ = false;
  std::vector<EdgeCell> cells_;
  std::vector<Edge> edges_;
  std::vector<unsigned int> edge_of_line_;
  std::vector<Star> stars_;
  std::vector<std::array<types::global_dof_index, 2>> dofs_;
};

/** Returns at position s in [0,1], times the length of the edge, the linear traction with the
 * moments moments[0] and moments[1] (components) at s = 0, and the two others at s = 1. */
inline Tensor<1, 2> linear_traction(const double *const moments, const double s) {
  const double first = 4. - 6. * s, second = 6. * s - 2.;
  return Tensor<1, 2>(
    {first * moments[0] + second * moments[2], first * moments[1] + second * moments[3]});
}

/** The 16 moments of the tractions on a cell at its edges: edge by edge, first at corner k, then at
 * corner k + 1. */
using CellMoments = std::array<double, 16>;

CellMoments moments_on(const EdgeCell &cell, const std::vector<double> &moments);
/** Adds the transpose of moments_on(), applied to @p values, to @p moments. */
void add_moments(const EdgeCell &cell, const CellMoments &values, std::vector<double> &moments);
} // namespace Signorini
