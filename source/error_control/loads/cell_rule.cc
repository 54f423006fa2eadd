// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the triangles of a composite quadrilateral, and Hooke's law as matrices.

#include <signorini/error_control/loads/cell_rule.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;
using Triangle = RulePart::Triangle;

double twice_area(const Triangle &x)
{
  const Vector2 a = x[1] - x[0], b = x[2] - x[0];
  return a[0] * b[1] - a[1] * b[0];
}

/** A point in barycentric coordinates with its weight; the weights of a rule have the sum one. */
struct TrianglePoint
{
  std::array<double, 3> lambda;
  double weight;
};
using TriangleRule = std::vector<TrianglePoint>;

/** Returns the rule with the mid-points of the edges, of degree two. */
TriangleRule midpoint_rule()
{
  return {{{{0., 0.5, 0.5}}, 1. / 3.}, {{{0.5, 0., 0.5}}, 1. / 3.}, {{{0.5, 0.5, 0.}}, 1. / 3.}};
}

/** Returns the rule with six points, of degree four (Strang and Fix). */
TriangleRule quartic_rule()
{
  const double root = std::sqrt(10.), inner = std::sqrt(38. - 44. * std::sqrt(0.4));
  const double spread = std::sqrt(213125. - 53320. * root);
  TriangleRule rule;
  for (const double sign : {1., -1.})
  {
    const double a = (8. - root + sign * inner) / 18., weight = (620. + sign * spread) / 3720.;
    for (unsigned int v = 0; v < 3; ++v)
    {
      TrianglePoint point = {{{a, a, a}}, weight};
      point.lambda[v] = 1. - 2. * a;
      rule.push_back(point);
    }
  }
  return rule;
}

/** Makes the rule with n x n Gauss points of the square, collapsed to the triangle, of degree 2 n -
 * 2. */
TriangleRule make_collapsed_rule(const unsigned int n)
{
  const QGauss<1> gauss(n);
  TriangleRule rule;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const double s = gauss.point(i)[0], t = gauss.point(j)[0];
      rule.push_back({{{(1. - s) * (1. - t), s * (1. - t), t}},
                      2. * (1. - t) * gauss.weight(i) * gauss.weight(j)});
    }
  return rule;
}

/** Returns the same rule, made once for every n that is used here. */
const TriangleRule &collapsed_rule(const unsigned int n)
{
  static const std::vector<TriangleRule> rules = []() {
    std::vector<TriangleRule> all;
    for (unsigned int i = 0; i <= 12; ++i)
      all.push_back(i == 0 ? TriangleRule() : make_collapsed_rule(i));
    return all;
  }();
  return rules.at(n);
}

/** Returns the parts of triangles on both sides of a line, as triangles. */
std::vector<Triangle> cut(const std::vector<Triangle> &triangles, const KinkLine<2> &line)
{
  std::vector<Triangle> parts;
  for (const Triangle &x : triangles)
  {
    const double size = std::sqrt(std::abs(twice_area(x)));
    for (const double sign : {1., -1.})
    {
      std::vector<Point<2>> polygon;
      for (unsigned int i = 0; i < 3; ++i)
      {
        const auto &a = x[i], &b = x[(i + 1) % 3];
        const double da = sign * line.signed_distance(a), db = sign * line.signed_distance(b);
        if (da >= 0.)
          polygon.push_back(a);
        if ((da > 0. && db < 0.) || (da < 0. && db > 0.))
          polygon.push_back(a + (da / (da - db)) * (b - a));
      }
      for (unsigned int i = 2; i < polygon.size(); ++i)
      {
        const Triangle part = {{polygon[0], polygon[i - 1], polygon[i]}};
        if (std::abs(twice_area(part)) > 1e-14 * size * size)
          parts.push_back(part);
      }
    }
  }
  return parts;
}

/** Returns the parts into which lines cut a triangle, divided further. */
std::vector<RulePart> parts_of(const Triangle &whole,
                               const std::vector<KinkLine<2>> &lines,
                               const TriangleDivision &divide)
{
  std::vector<Triangle> triangles = {whole};
  for (const KinkLine<2> &line : lines)
    triangles = cut(triangles, line);
  std::vector<RulePart> parts;
  for (Triangle &triangle : triangles)
    if (divide)
    {
      if (twice_area(triangle) < 0.)
        std::swap(triangle[1], triangle[2]);
      const std::vector<RulePart> finer = divide(triangle);
      parts.insert(parts.end(), finer.begin(), finer.end());
    }
    else
      parts.push_back({triangle});
  return parts;
}

/** Returns the barycentric coordinates of a point in a triangle. */
std::array<double, 3> barycentric(const Triangle &triangle, const Point<2> &x)
{
  std::array<double, 3> lambda;
  for (unsigned int v = 0; v < 3; ++v)
    lambda[v] =
      twice_area({{x, triangle[(v + 1) % 3], triangle[(v + 2) % 3]}}) / twice_area(triangle);
  return lambda;
}

/** The derivatives of a map along s and t. */
struct Jacobian
{
  Vector2 d_s, d_t;

  double determinant() const
  {
    return cross(d_s, d_t);
  }
};

/** quadratics() returns the values of the quadratic functions on [-1,1] that are one at -1, 0 and
 * 1, quadratic_slopes() their derivatives. */
std::array<double, 3> quadratics(const double s)
{
  return {{0.5 * s * (s - 1.), 1. - s * s, 0.5 * s * (s + 1.)}};
}
std::array<double, 3> quadratic_slopes(const double s)
{
  return {{s - 0.5, -2. * s, s + 0.5}};
}

/** The maps of [-1,1]² to the cell, relative to corner 0: the bilinear one x(s, t) = centre + e s +
 * f t + g s t, and the biquadratic one of curved cells. */
struct CellMap
{
  explicit CellMap(const CellShape &shape)
    : bulges(shape.bulges)
    , is_curved(shape.is_curved)
  {
    const Vector2 a = shape.corners[1] - shape.corners[0], b = shape.corners[2] - shape.corners[0];
    const Vector2 c = shape.corners[3] - shape.corners[0];
    centre = 0.25 * (a + b + c);
    e = 0.25 * (a + b - c);
    f = 0.25 * (c + b - a);
    g = 0.25 * (b - a - c);
  }
  /** Returns the reference coordinates of a point, by Newton's method: one step on parallelograms.
   */
  Point<2> inverse(const Vector2 &offset) const
  {
    double s = 0., t = 0.;
    for (unsigned int step = 0; step < 20; ++step)
    {
      const Vector2 r = offset - (centre + s * e + t * f + s * t * g);
      const Vector2 d_s = e + t * g, d_t = f + s * g;
      const double J = cross(d_s, d_t);
      const double ds = cross(r, d_t) / J, dt = cross(d_s, r) / J;
      s += ds;
      t += dt;
      if (std::abs(ds) + std::abs(dt) < 1e-14)
        break;
    }
    return {s, t};
  }
  /** Returns the gradients of the shape functions of the corners. */
  std::array<Vector2, 4> gradients(const Point<2> &reference, const Jacobian &jacobian) const
  {
    const double s = reference[0], t = reference[1];
    const Vector2 &d_s = jacobian.d_s, &d_t = jacobian.d_t;
    const double J = jacobian.determinant();
    // grad s and grad t, divided by four.
    const Vector2 grad_s({0.25 * d_t[1] / J, -0.25 * d_t[0] / J});
    const Vector2 grad_t({-0.25 * d_s[1] / J, 0.25 * d_s[0] / J});
    std::array<Vector2, 4> result;
    for (unsigned int c = 0; c < 4; ++c)
    {
      const double a = c == 1 || c == 2 ? 1. : -1., b = c >= 2 ? 1. : -1.;
      for (unsigned int i = 0; i < 2; ++i)
        result[c][i] = a * (1. + b * t) * grad_s[i] + b * (1. + a * s) * grad_t[i];
    }
    return result;
  }

  Jacobian bilinear(const Point<2> &reference) const
  {
    return {e + reference[1] * g, f + reference[0] * g};
  }
  /** Returns the Jacobian of the curved cell. */
  Jacobian biquadratic(const Point<2> &reference) const
  {
    Jacobian sum = bilinear(reference);
    const auto a = quadratics(reference[0]), b = quadratics(reference[1]);
    const auto da = quadratic_slopes(reference[0]), db = quadratic_slopes(reference[1]);
    for (unsigned int i = 0; i < bulges.size(); ++i)
    {
      sum.d_s += da[along_s[i]] * b[along_t[i]] * bulges[i];
      sum.d_t += a[along_s[i]] * db[along_t[i]] * bulges[i];
    }
    return sum;
  }
  /** Returns the vector from the point of the quadrilateral to that of the curved cell. */
  Vector2 bulge(const Point<2> &reference) const
  {
    Vector2 sum;
    const auto a = quadratics(reference[0]), b = quadratics(reference[1]);
    for (unsigned int i = 0; i < bulges.size(); ++i)
      sum += a[along_s[i]] * b[along_t[i]] * bulges[i];
    return sum;
  }

  /** The indices of the factors of the shape functions of the bulges. */
  static constexpr std::array<unsigned int, 5> along_s = {{1, 2, 1, 0, 1}};
  static constexpr std::array<unsigned int, 5> along_t = {{0, 1, 2, 1, 1}};
  Vector2 centre, e, f, g;
  Bulges bulges;
  bool is_curved;
};

/** Takes a point of the quadrilateral to the curved cell. */
void bend(const CellMap &map, StressPoint &point)
{
  const Jacobian curved = map.biquadratic(point.reference);
  point.weight *= curved.determinant() / map.bilinear(point.reference).determinant();
  point.offset += map.bulge(point.reference);
  point.gradients = map.gradients(point.reference, curved);
}

/** Returns the smallest eigenvalue of Hooke's law in the orthonormal components (s11, s22, sqrt(2)
 * s12). */
double min_eigenvalue_of(const Tensor<2, 3> &matrix)
{
  if (matrix[0][2] == 0. && matrix[1][2] == 0.)
  {
    const double mean = 0.5 * (matrix[0][0] + matrix[1][1]);
    const double radius = std::hypot(0.5 * (matrix[0][0] - matrix[1][1]), matrix[0][1]);
    return std::min(mean - radius, 2. * matrix[2][2]);
  }
  SymmetricTensor<2, 3> orthonormal;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      orthonormal[i][j] =
        matrix[i][j] * (i == 2 ? std::sqrt(2.) : 1.) * (j == 2 ? std::sqrt(2.) : 1.);
  return eigenvalues(orthonormal)[2];
}
} // namespace

Law::Law(const SymmetricTensor<4, 2> &hooke)
{
  constexpr std::array<std::array<unsigned int, 2>, 3> pairs = {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
  Tensor<2, 3> matrix;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      stiffness[i][j] = matrix[i][j] = hooke[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
  const Tensor<2, 3> inverse = invert(matrix);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      compliance[i][j] = inverse[i][j];
  min_eigenvalue = min_eigenvalue_of(matrix);
}

Components Law::stress(const Components &strain) const
{
  Components s;
  for (unsigned int i = 0; i < 3; ++i)
    s[i] = stiffness[i][0] * strain[0] + stiffness[i][1] * strain[1] + stiffness[i][2] * strain[2];
  return s;
}

Components Law::strain(const Components &stress) const
{
  Components e;
  for (unsigned int i = 0; i < 3; ++i)
    e[i] =
      compliance[i][0] * stress[0] + compliance[i][1] * stress[1] + compliance[i][2] * stress[2];
  return e;
}

std::array<std::array<EdgePoint, 2>, 4> edge_points(const CellShape &shape)
{
  constexpr std::array<std::array<double, 2>, 4> corners = {
    {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
  const CellMap map(shape);
  std::array<std::array<EdgePoint, 2>, 4> points;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int i = 0; i < 2; ++i)
    {
      EdgePoint &point = points[k][i];
      const unsigned int next = (k + 1) % 4;
      const double s = 0.5 + (i == 0 ? -0.5 : 0.5) / std::sqrt(3.);
      point.position = s;
      point.offset = (1. - s) * (shape.corners[k] - shape.corners[0]) +
                     s * (shape.corners[next] - shape.corners[0]);
      const Point<2> reference((1. - s) * corners[k][0] + s * corners[next][0],
                               (1. - s) * corners[k][1] + s * corners[next][1]);
      point.gradients = map.gradients(reference, map.bilinear(reference));
    }
  return points;
}

Components strain_of(const std::array<Vector2, 4> &gradients, const std::array<Vector2, 4> &values)
{
  Components e{};
  for (unsigned int c = 0; c < 4; ++c)
  {
    e[0] += gradients[c][0] * values[c][0];
    e[1] += gradients[c][1] * values[c][1];
    e[2] += gradients[c][1] * values[c][0] + gradients[c][0] * values[c][1];
  }
  return e;
}

std::vector<StressPoint> make_rule(const CellShape &shape,
                                   const RuleKind &kind,
                                   const std::vector<KinkLine<2>> &lines,
                                   const TriangleDivision &divide)
{
  const bool exact = kind.constant_law && shape.affine && !kind.fine && !shape.is_curved;
  const unsigned int least = divide ? 3 : (kind.constant_law ? 4 : kind.n_points);
  const TriangleRule rule = !exact           ? collapsed_rule(std::max(least, kind.fine ? 6U : 0U))
                            : kind.quadratic ? quartic_rule()
                                             : midpoint_rule();
  const CellMap map(shape);
  std::vector<StressPoint> points;
  points.reserve(4 * rule.size());
  unsigned int n_parts = 0;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Triangle whole = {{shape.corners[k], shape.corners[(k + 1) % 4], shape.crossing}};
    for (const RulePart &part : parts_of(whole, lines, divide))
    {
      ++n_parts;
      for (const TrianglePoint &at : rule)
      {
        StressPoint point;
        point.triangle = k;
        if (!part.resolved)
          point.unresolved_part = n_parts;
        point.weight = 0.5 * std::abs(twice_area(part.corners)) * at.weight;
        for (unsigned int v = 0; v < 3; ++v)
          point.offset += at.lambda[v] * (part.corners[v] - shape.corners[0]);
        point.psi = midpoint_functions(lines.empty() && !divide
                                         ? at.lambda
                                         : barycentric(whole, shape.corners[0] + point.offset));
        point.reference = map.inverse(point.offset);
        point.gradients = map.gradients(point.reference, map.bilinear(point.reference));
        if (shape.is_curved)
          bend(map, point);
        points.push_back(point);
      }
    }
  }
  return points;
}
} // namespace Signorini
