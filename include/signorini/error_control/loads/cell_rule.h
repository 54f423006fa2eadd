// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/loads/composite_cell.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace Signorini
{
/** Hooke's law at a point: s = stiffness e, e = compliance s. */
struct Law
{
  explicit Law(const SymmetricTensor<4, 2> &hooke);

  Components stress(const Components &strain) const;
  Components strain(const Components &stress) const;

  std::array<Components, 3> stiffness, compliance;
  /** The smallest c with e:E:e ≥ c e:e. */
  double min_eigenvalue;
};

/** A quadrature point of a cell. Its data do not depend on the position of the cell. */
struct StressPoint
{
  /** The number of the triangle, and the functions ψ at the point (see midpoint_functions()). */
  unsigned int triangle;
  std::array<double, 3> psi;
  double weight;
  /** The vector from corner 0 to the point, or on curved cells to its image. */
  Tensor<1, 2> offset;
  /** The gradients of the shape functions of the four corners. */
  std::array<Tensor<1, 2>, 4> gradients;
  /** The reference coordinates in [-1,1]². The corners are (-1,-1), (1,-1), (1,1), (-1,1). */
  Point<2> reference;
  /** The part of the rule that the point belongs to, if the law is not resolved there; otherwise
   * the constant resolved. Points of a part follow each other. */
  unsigned int unresolved_part = resolved;

  static constexpr unsigned int resolved = static_cast<unsigned int>(-1);
};

/** The integral of a function that is not negative. Where the law is not resolved, it is taken from
 * above: the largest value in a part counts for all of the part. */
class UpperSum
{
public:
  /**
   * Begins an empty sum.
   * @param from_above false: the sum over the points is taken everywhere.
   */
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
    max_ = std::max(max_, value);
  }
  double value()
  {
    close();
    return sum_;
  }

private:
  void close()
  {
    sum_ += area_ * max_;
    area_ = max_ = 0.;
  }
  bool from_above_;
  double sum_ = 0., area_ = 0., max_ = 0.;
  unsigned int part_ = StressPoint::resolved;
};

/** Returns the strain (e11, e22, 2 e12) from gradients of the shape functions and values at the
 * corners. */
Components strain_of(const std::array<Tensor<1, 2>, 4> &gradients,
                     const std::array<Tensor<1, 2>, 4> &values);

/** A point on the edge from corner k to corner k + 1. */
struct EdgePoint
{
  /** The share of the edge between corner k and the point. */
  double position;
  /** The vector from corner 0 to the point. */
  Tensor<1, 2> offset;
  std::array<Tensor<1, 2>, 4> gradients;
};

/** Returns two Gauss points on every edge. */
std::array<std::array<EdgePoint, 2>, 4> edge_points(const CellShape &shape);

/** The properties by which a rule is chosen. */
struct RuleKind
{
  /** Whether Hooke's tensor is the same everywhere. */
  bool constant_law;
  /** Whether the stress has quadratic parts. */
  bool quadratic;
  /** The number of Gauss points per direction and triangle for laws that vary. */
  unsigned int n_points = 5;
  /** Whether displacements are more than bilinear: then there are at least six points. */
  bool fine = false;
};

/** A part of one of the triangles of a cell. */
struct RulePart
{
  /** A triangle with its corners counter-clockwise. */
  using Triangle = std::array<Point<2>, 3>;

  Triangle corners;
  /** Whether data is smooth on it. */
  bool resolved = true;
};

/** Divides a triangle into parts. */
using TriangleDivision = std::function<std::vector<RulePart>(const RulePart::Triangle &)>;

/** Makes the points on the four triangles of a cell. On curved cells they are the images of those
 * of the quadrilateral, with weights and gradients of the curved cell. With a constant law on a
 * parallelogram, squares of stresses and strains are integrated exactly, by the three mid-points
 * per triangle, or by six points where stresses are quadratic. Otherwise there are 4 x 4 Gauss
 * points per triangle for a constant law and n_points x n_points for others, on each of the parts
 * into which the lines cut a triangle. With @p divide these parts are divided further, and each
 * part has 3 x 3 points (6 x 6 if fine). */
std::vector<StressPoint> make_rule(const CellShape &shape,
                                   const RuleKind &kind,
                                   const std::vector<KinkLine<2>> &lines,
                                   const TriangleDivision &divide = {});

/** Returns s:e. */
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

/** Adds weight ψ e to @p dual: the contribution of the strain e at a point to ∫ ψ e, by
 * triangle and vertex. */
inline void add_dual(const StressPoint &point, const Components &e, CompositeCell::Stresses &dual)
{
  for (unsigned int m = 0; m < 3; ++m)
    for (unsigned int l = 0; l < 3; ++l)
      dual[9 * point.triangle + 3 * m + l] += point.weight * point.psi[m] * e[l];
}

/** Returns the law at point number @p i; a single law holds at all points. */
inline const Law &law_at(const std::vector<Law> &laws, const std::size_t i)
{
  return laws[laws.size() == 1 ? 0 : i];
}
} // namespace Signorini
