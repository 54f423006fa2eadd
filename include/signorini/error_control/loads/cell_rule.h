// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/error_control/loads/composite_cell.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace Signorini
{
/** Hooke's law at a point: s = stiffness e, e = compliance s. */
struct Law
{
  explicit Law(const dealii::SymmetricTensor<4, 2> &hooke);

  Components stress(const Components &strain) const;
  Components strain(const Components &stress) const;

  std::array<Components, 3> stiffness, compliance;
  /** The smallest c with e:E:e >= c e:e. */
  double smallest_eigenvalue;
};

/** A quadrature point of a cell with what does not depend on the place of the cell. */
struct StressPoint
{
  /** The triangle, and psi there (see midpoint_functions()). */
  unsigned int triangle;
  std::array<double, 3> psi;
  double weight;
  /** From corner 0, on curved cells that of the image. */
  dealii::Tensor<1, 2> offset;
  /** Of the shape functions of the four corners. */
  std::array<dealii::Tensor<1, 2>, 4> gradients;
  /** Reference coordinates in [-1,1]^2: corners are (-1,-1), (1,-1), (1,1), (-1,1). */
  dealii::Point<2> reference;
  /** The part of the rule that the point belongs to, if the law is not resolved there; else
   * resolved. Points of a part follow each other. */
  unsigned int unresolved_part = resolved;

  static constexpr unsigned int resolved = static_cast<unsigned int>(-1);
};

/** The integral of a function that is not negative; where the law is not resolved, from above: the
 * largest value in a part counts for all of it. */
class UpperSum
{
public:
  /** @param from_above false: the sum over the points, everywhere. */
  explicit UpperSum(const bool from_above = true)
    : from_above_(from_above)
  {
  }
  void add(const StressPoint &point, const double value)
  {
    if (!from_above_ || point.unresolved_part == StressPoint::resolved)
    {
      sum_ += point.weight * value;
      return;
    }
    if (point.unresolved_part != part_)
      close();
    part_ = point.unresolved_part;
    area_ += point.weight;
    largest_ = std::max(largest_, value);
  }
  double value()
  {
    close();
    return sum_;
  }

private:
  void close()
  {
    sum_ += area_ * largest_;
    area_ = largest_ = 0.;
  }
  bool from_above_;
  double sum_ = 0., area_ = 0., largest_ = 0.;
  unsigned int part_ = StressPoint::resolved;
};

/** Strain (e11, e22, 2 e12) from gradients of the shape functions and values at the corners. */
Components strain_of(const std::array<dealii::Tensor<1, 2>, 4> &gradients,
                     const std::array<dealii::Tensor<1, 2>, 4> &values);

/** A point on the edge from corner k to corner k + 1. */
struct EdgePoint
{
  /** Share of the edge between corner k and the point. */
  double position;
  /** From corner 0. */
  dealii::Tensor<1, 2> offset;
  std::array<dealii::Tensor<1, 2>, 4> gradients;
};

/** Two Gauss points on every edge. */
std::array<std::array<EdgePoint, 2>, 4> edge_points(const CellShape &shape);

/** How a rule is chosen. */
struct RuleKind
{
  /** Hooke's tensor is the same everywhere. */
  bool constant_law;
  /** The stress has quadratic parts. */
  bool quadratic;
  /** Gauss points per direction and triangle for laws that vary. */
  unsigned int n_points = 5;
  /** Displacements are more than bilinear: six points at least. */
  bool fine = false;
};

/** A part of one of the triangles of a cell. */
struct RulePart
{
  /** Counter-clockwise. */
  using Triangle = std::array<dealii::Point<2>, 3>;

  Triangle corners;
  /** Whether data is smooth on it. */
  bool resolved = true;
};

/** The parts of a triangle. */
using TriangleDivision = std::function<std::vector<RulePart>(const RulePart::Triangle &)>;

/**
 * Points on the four triangles of a cell. On curved cells they are the images of those of the
 * quadrilateral, with weights and gradients of the curved cell. With a constant law on a
 * parallelogram squares of stresses and strains are integrated exactly: with the three mid-points
 * per triangle, six points where stresses are quadratic. Otherwise 4 x 4 Gauss points per triangle
 * for a constant law and n_points x n_points for others, on each of the parts into which the lines
 * cut a triangle. With @p divide these parts are divided further, and each part has 3 x 3 points
 * (6 x 6 if fine).
 */
std::vector<StressPoint> make_rule(const CellShape &shape,
                                   const RuleKind &kind,
                                   const std::vector<KinkLine<2>> &lines,
                                   const TriangleDivision &divide = {});

/** s:e. */
inline double contraction(const Components &a, const Components &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Components difference(const Components &a, const Components &b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

inline Components sum(const Components &a, const Components &b)
{
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}

/** dual += weight psi e: what the strain e at a point adds to int psi e, by triangle and vertex. */
inline void add_dual(const StressPoint &point, const Components &e, CompositeCell::Stresses &dual)
{
  for (unsigned int m = 0; m < 3; ++m)
    for (unsigned int l = 0; l < 3; ++l)
      dual[9 * point.triangle + 3 * m + l] += point.weight * point.psi[m] * e[l];
}

/** The law at point number @p i; one law is that of all points. */
inline const Law &law_at(const std::vector<Law> &laws, const std::size_t i)
{
  return laws[laws.size() == 1 ? 0 : i];
}
} // namespace Signorini
