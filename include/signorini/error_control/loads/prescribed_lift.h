// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/bound_data.h>
#include <signorini/error_control/loads/cell_shape.h>

#include <array>
#include <functional>
#include <map>
#include <vector>

namespace Signorini {
/** Edge k of a cell, from start (corner k) to end, on a side with prescribed displacements. */
struct PrescribedEdge {
  unsigned int cell, k, side;
  Point<2> start, end;
  /** The displacement u_h at the position s in [0,1] on the edge. */
  std::function<Tensor<1, 2>(double s)> u_h;
};

/**
 * The function z with u_h + z = u_D on sides with prescribed displacements that u_h interpolates
 * along edges. On the cell behind such an edge, z = r(s) (1 - depth) in bilinear coordinates, where
 * r = u_D - u_h is a function of the position s on the edge. r is zero at the end points of the
 * edge, and z on all other edges.
 *
 * r is interpolated at nine points on each of 1, 2, 4, ... or 32 equal pieces of an edge: as many
 * as bring it within a thousandth of its size at up to 256 further points per edge (20000 on all).
 */
class PrescribedLift {
public:
  PrescribedLift(const BoundData &data, std::size_t n_cells,
                 const std::vector<PrescribedEdge> &edges);

  /** Returns for every cell whether z is not zero on it. */
  const std::vector<bool> &cells() const {
    return cells_;
  }
  /** Returns the largest difference between r and its interpolation, relative to the largest |r| on
   * the edge. */
  double max_misfit() const {
    return max_misfit_;
  }
  /** Returns the lines through the ends of the pieces of edges: z is smooth between them. */
  std::vector<KinkLine<2>> lines(unsigned int cell, const std::array<Point<2>, 4> &corners) const;
  /** Returns the strain (e11, e22, 2 e12) of z at a point of [0,1]². */
  Components strain(unsigned int cell, const CellShape &shape, const Point<2> &at) const;
  /** Returns z there. */
  Tensor<1, 2> value(unsigned int cell, const Point<2> &at) const;

private:
  /** The values of r at the points of interpolation on the equal pieces of edge k, from corner k
   * on. */
  struct EdgeRest {
    /** Returns r(s), or its derivative. */
    Tensor<1, 2> evaluate(double s, bool derivative) const;

    /** Returns the position along the edge and the depth behind it. */
    std::array<double, 2> coordinates(const Point<2> &at) const;

    unsigned int k;
    std::vector<std::vector<Tensor<1, 2>>> pieces;
  };

  std::vector<bool> cells_;
  std::map<unsigned int, std::vector<EdgeRest>> rests_;
  double max_misfit_ = 0.;
};
} // namespace Signorini
