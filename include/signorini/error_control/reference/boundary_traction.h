// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/tractions.h>
#include <signorini/error_control/reference/field_works.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * The traction τn of a stress in equilibrium on the sides of a 2-D body whose tractions are not
 * given: polynomials of the arc length, without a mesh. In a pair both sides carry the traction q
 * of the shared edges.
 */
class BoundaryTraction {
public:
  /** Copies the tractions of the edges on the boundary. */
  BoundaryTraction(const Tractions &tractions, const Scene<2> &scene);

  /** Returns ∫ τn·v along a trace (force x length per thickness), exact on segments; on arcs the
   * directions are smooth functions. @param sides those of the same body. */
  double work(const BoundaryTrace &v, const std::vector<Side<2>> &sides) const;
  /** Returns the number of polynomials. */
  std::size_t size() const;

  /** A polynomial on a part of a side. */
  struct Part {
    /** The arc lengths of its ends; on a closed side one of them may lie beyond it. */
    double from, to;
    /** The coefficients of orthonormal Legendre polynomials on [0,1] of τ_n and τ_t, of the same
     * number. */
    std::array<std::vector<double>, 2> coefficients;
    /** The direction m of contact, where the components are those along m and its tangent. */
    std::optional<Tensor<1, 2>> direction;
  };
  /** Returns the parts of a side, sorted. */
  const std::vector<Part> &on_side(const unsigned int side) const {
    AssertIndexRange(side, parts_.size());
    return parts_[side];
  }

private:
  void add_edge(const TractionSpace &space, const dealii::Vector<double> &x, unsigned int number,
                const Side<2> &side);

  std::vector<std::vector<Part>> parts_;
};
} // namespace Signorini
