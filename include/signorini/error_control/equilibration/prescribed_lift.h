// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/equilibration/bound_data.h>
#include <signorini/error_control/equilibration/cell_shape.h>

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Signorini {
/** Returns an evaluator on cells with exact arcs. */
inline CellEvaluator<2> evaluator_of(const BoundData &data, std::vector<EvaluatedField> fields,
                                     const ExactMaps &maps) {
  return CellEvaluator<2>(
    data.space, std::move(fields), ValuesCache<2>::gauss,
    [&maps](const auto &cell) -> const Mapping<2> & { return maps.of(cell); });
}

/** A cell on which a lift z is not zero, with the points of a rule for it. */
struct LiftedCell {
  struct RulePoint {
    double weight;
    Tensor<1, 2> z;
    /** ε(z) and σ(z). */
    Components strain, stress;
  };

  /** Returns the square of |||z|||_K. */
  double energy() const {
    double sum = 0.;
    for (const RulePoint &point : points)
      sum += point.weight * (point.strain * point.stress);
    return sum;
  }

  /** u_h at the points. */
  const CellEvaluator<2> &u;
  std::vector<RulePoint> points;
};

/**
 * The function z with u_h + z = u_D on sides with prescribed displacements that u_h interpolates
 * along edges. On the cell behind such an edge, z = r(s) (1 - depth) in reference coordinates,
 * where r = u_D - u_h is a function of the position s on the edge. r is zero at the end points of
 * the edge, and z on all other edges. On arcs s is the share of the angle, as in ExactMaps: u_D is
 * that on the arc itself.
 *
 * r is interpolated at nine points on each of 1, 2, 4, ... or 32 equal pieces of an edge: as many
 * as bring it within a thousandth of its size at up to 256 further points per edge (20000 on all).
 */
class PrescribedLift {
public:
  /** Interpolates r. */
  explicit PrescribedLift(const BoundData &data);

  /** Returns the largest difference between r and its interpolation, relative to the largest |r| on
   * the edge. */
  double max_misfit() const {
    return max_misfit_;
  }
  /** Visits all cells on which z is not zero. */
  void visit_cells(const BoundData &data, const ExactMaps &maps,
                   const std::function<void(const LiftedCell &)> &visit) const;

private:
  /** The values of r at the points of interpolation on the equal pieces of edge k, from corner k
   * on. */
  struct EdgeRest {
    /** Returns r(s), or its derivative. */
    Tensor<1, 2> evaluate(double s, bool derivative) const;

    /** Returns the position along the edge and the depth behind it. */
    std::array<double, 2> coordinates(const Point<2> &at) const;

    /** Fills the pieces on a face of a cell. */
    void interpolate(const BoundData &data, const DoFHandler<2>::active_cell_iterator &cell,
                     unsigned int face, std::size_t n_scanned);

    unsigned int k;
    std::vector<std::vector<Tensor<1, 2>>> pieces;
    /** The largest |r|, and the largest difference between r and its interpolation. */
    double size = 0., misfit = 0.;
  };

  /** Returns the lines through the ends of the pieces of edges: z is smooth between them. */
  static std::vector<KinkLine<2>> lines(const std::vector<EdgeRest> &rests, const CellShape &shape);

  /** The rests by active cell. */
  std::map<unsigned int, std::vector<EdgeRest>> rests_;
  double max_misfit_ = 0.;
};
} // namespace Signorini
