// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/mesh_file/vtu_file.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** Nodes of a cell: the corners counter-clockwise, then the middles of the edges, then the middle
 * of a quadrilateral. */
template <typename T>
using CellNodes = std::array<T, 9>;

/** A triangle or a quadrilateral of degree two, with exact arcs on the boundary; lower degrees are
 * a special case. It is the image of the unit square; the edge t = 1 of a triangle is its corner 2.
 *
 * The polynomial map F of the nodes has edges e(r), r in [0,1] from corner k to k + 1. On an edge
 * on an arc γ(r) (equal angles for equal r) the map adds w (γ(r) - e(r)). w is the
 * sum of the linear or bilinear functions of both corners, and r the share of the second one. */
class ForeignCell {
public:
  struct Values {
    Point<2> x;
    /** dx/d(s,t), and its determinant. */
    Tensor<2, 2> jacobian;
    double determinant = 0.;
    Tensor<1, 2> v;
    /** The derivatives [i][j] = dv_i/dx_j. */
    Tensor<2, 2> gradient;
  };

  /** Returns the map, v and its gradient at (s,t) in the unit square. */
  Values at(double s, double t) const;
  /** Returns v on edge k at r. */
  Tensor<1, 2> on_edge(unsigned int k, double r) const;
  unsigned int n_corners() const {
    return is_triangle ? 3 : 4;
  }
  /** Returns the number of nodes of the file. */
  unsigned int n_nodes() const {
    return (has_middles ? 2 : 1) * n_corners() + (has_centre ? 1 : 0);
  }
  /** Returns the mean of the corners. */
  Point<2> middle() const;
  /** Gives the nodes that a lower degree lacks the values of its polynomials. */
  template <typename T>
  void complete(CellNodes<T> &nodes) const;

  bool is_triangle = false, has_middles = false, has_centre = false;
  /** The number of the cell in the file, and of its body. */
  unsigned int number = 0, body = 0;
  /** The numbers of the nodes of the file in ForeignField. */
  CellNodes<unsigned int> nodes = {};
  CellNodes<Point<2>> x;
  CellNodes<Tensor<1, 2>> v;
  /** The arcs of edges. */
  std::array<std::optional<Curve>, 4> arcs;
};

/** An edge of a cell on the boundary. */
struct ForeignEdge {
  unsigned int cell, number;
  unsigned int side;
  /** The arc lengths of its ends, from < to; around a closed side to may exceed its length. */
  double from, to;
  /** Whether r = 1 is at from. */
  bool is_reversed;

  /** Returns r at an arc length. */
  double position(const double s) const {
    const double r = (s - from) / (to - from);
    return is_reversed ? 1. - r : r;
  }
};

/**
 * A continuous displacement v of another program on its mesh of a plane body, or of several.
 *
 * Points of one body that coincide are one node. Nodes of boundary edges are moved onto the side of
 * the edge, those within the tolerance of its ends onto these; the middle of a boundary edge is
 * that of the side's part. So cells cover the body exactly.
 */
class ForeignField {
public:
  /**
   * @param factor multiplies the displacements.
   * @param tolerance how far boundary nodes may lie from their side, as a share of the body.
   * @throws InputError with a point for everything that is no such field on this body.
   */
  ForeignField(const VtuMesh &mesh, const Geometry<2> &geometry, double factor, double tolerance);

  const std::vector<ForeignCell> &cells() const {
    return cells_;
  }
  /** Returns the boundary edges, by side and arc length. */
  const std::vector<ForeignEdge> &edges() const {
    return edges_;
  }
  /** Returns v at an arc length of an edge. */
  Tensor<1, 2> on_edge(const ForeignEdge &edge, const double s) const {
    return cells_[edge.cell].on_edge(edge.number, edge.position(s));
  }
  /** Returns the edge of a side at an arc length. */
  const ForeignEdge &edge_at(unsigned int side, double s) const;
  unsigned int n_nodes() const {
    return n_nodes_;
  }
  /** Returns the largest |v| of a node (length). */
  double largest() const {
    return largest_;
  }
  /** Returns how far the farthest boundary node was moved (length). */
  double largest_motion() const {
    return largest_motion_;
  }

private:
  std::vector<ForeignCell> cells_;
  std::vector<ForeignEdge> edges_;
  unsigned int n_nodes_ = 0;
  double largest_ = 0., largest_motion_ = 0.;
};
} // namespace Signorini
