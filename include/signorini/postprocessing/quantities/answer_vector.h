// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** The components of a point, a force or a moment: records hold answers of 2-D and 3-D bodies. */
struct AnswerVector : std::vector<double> {
  using std::vector<double>::vector;
  template <int dim>
  AnswerVector(const Tensor<1, dim> &x)
    : std::vector<double>(x.begin_raw(), x.end_raw()) {}

  /** Returns the Euclidean norm. */
  double norm() const {
    return std::sqrt(std::inner_product(begin(), end(), begin(), 0.));
  }
  double distance(const AnswerVector &other) const {
    return (*this - other).norm();
  }
  friend AnswerVector operator-(AnswerVector a, const AnswerVector &b) {
    AssertDimension(a.size(), b.size());
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::minus<>());
    return a;
  }
};

/** The cell or patch of a graded mesh on which a value was found: it shows whether a later mesh is
 * finer there. Nested meshes are finer everywhere, and leave it zero. */
struct MeshAt {
  /** The diameter of the cell, or the length of the patch (length). */
  double size = 0.;
  /** The degree of the polynomials. */
  unsigned int degree = 0;
};

/** A point of a body's boundary. */
struct BoundaryPoint {
  std::string side;
  /** The arc length from the start of the side (length); for 2-D only. */
  double arc_length = 0.;
  AnswerVector point;
};

/** The trend of a number from level to level. */
struct Trend {
  enum class Kind {
    /** There is no level before. */
    unknown,
    settled,
    /** The number still changes, by more than refinement would let it if it converged. */
    not_settled,
    /** The mesh was not refined at the point of the number. */
    not_refined,
    /** The exact number is infinite. */
    unlimited
  };
  Kind kind = Kind::unknown;
  /** The change (v_L - v_{L-1})/|v_L|; empty where there is no level before or v_L vanishes. */
  std::optional<double> change;
};

/** Returns the trend of v_0, ..., v_L, levels without a value left out. Settled means: the last
 * change is at most 1 % of v_L; or it is at most 10 % and at most 3/4 of the change before, which
 * itself is not above the one before it, or where there is none 20 %: numbers that jump show no
 * trend.
 * Convergence of order one halves changes. Under a punch, at a facet or at a sharp corner stresses
 * grow by a constant factor or by a constant amount, and that never settles at 10 %. */
Trend trend_of(const std::vector<std::optional<double>> &values);

/** Returns "settled", "not settled", "one level only", "mesh around it unchanged" or "grows
 * without limit". */
std::string word_for(Trend::Kind kind);
} // namespace Signorini
