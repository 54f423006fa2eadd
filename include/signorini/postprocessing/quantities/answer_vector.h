// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The components of a point, a force or a moment: records hold answers of 2-D and 3-D bodies. */
class AnswerVector
{
public:
  AnswerVector() = default;
  AnswerVector(const std::initializer_list<double> values)
    : values_(values)
  {
  }
  template <int dim>
  AnswerVector(const Tensor<1, dim> &x)
  {
    for (unsigned int d = 0; d < dim; ++d)
      values_.push_back(x[d]);
  }

  std::size_t size() const
  {
    return values_.size();
  }
  double operator[](const std::size_t d) const
  {
    return values_[d];
  }
  const std::vector<double> &values() const
  {
    return values_;
  }
  /** Returns the Euclidean norm. */
  double norm() const
  {
    double square = 0.;
    for (const double x : values_)
      square += x * x;
    return std::sqrt(square);
  }
  double distance(const AnswerVector &other) const
  {
    return (*this - other).norm();
  }
  friend AnswerVector operator-(AnswerVector a, const AnswerVector &b)
  {
    AssertDimension(a.size(), b.size());
    for (std::size_t d = 0; d < a.size(); ++d)
      a.values_[d] -= b.values_[d];
    return a;
  }

private:
  std::vector<double> values_;
};

/** The cell or patch of a graded mesh on which a value was found: it shows whether a later mesh is
 * finer there. Nested meshes are finer everywhere, and leave it zero. */
struct MeshAt
{
  /** The diameter of the cell, or the length of the patch (length). */
  double size = 0.;
  /** The degree of the polynomials. */
  unsigned int degree = 0;
};

/** A point of a body's boundary. */
struct BoundaryPlace
{
  std::string side;
  /** The arc length from the start of the side (length); for 2-D only. */
  double arc_length = 0.;
  AnswerVector point;
};

/** The trend of a number from level to level. */
struct Trend
{
  enum class Kind
  {
    /** There is no level before. */
    unknown,
    settled,
    /** The number still changes, by more than refinement would let it if it converged. */
    not_settled,
    /** The mesh was not refined at the place of the number. */
    not_refined,
    /** The exact number is infinite. */
    unlimited
  };
  Kind kind = Kind::unknown;
  /** The change (v_L - v_{L-1})/|v_L|; empty where there is no level before or v_L vanishes. */
  std::optional<double> change;
};

/** Returns the trend of v_0, ..., v_L, levels without a value left out. Settled means: the last
 * change is at most 1 % of v_L; or it is at most 10 % and at most 3/4 of the change before.
 * Convergence of order one halves changes. Under a punch, at a facet or at a sharp corner stresses
 * grow by a constant factor or by a constant amount, and that never settles at 10 %. */
Trend trend_of(const std::vector<std::optional<double>> &values);

/** Returns "settled", "not settled", "one level only", "not refined there" or "grows without
 * limit". */
std::string word_for(Trend::Kind kind);
} // namespace Signorini
