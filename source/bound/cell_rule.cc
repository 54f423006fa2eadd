// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the triangles of a composite quadrilateral, and Hooke's law as matrices.

#include <signorini/bound/cell_rule.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;
using Triangle = RulePart::Triangle;

double twice_area(const Triangle &x)
{
  const Vector2 a = x[1] - x[0], b = x[2] - x[0];
  return a[0] * b[1] - a[1] * b[0];
}

/** Barycentric coordinates with weights whose sum is one. */
struct TrianglePoint
{
  std::array<double, 3> lambda;
  double weight;
};
using TriangleRule = std::vector<TrianglePoint>;

/** The mid-points of the edges: degree two. */
TriangleRule midpoint_rule()
{
  return {{{{0., 0.5, 0.5}}, 1. / 3.}, {{{0.5, 0., 0.5}}, 1. / 3.}, {{{0.5, 0.5, 0.}}, 1. / 3.}};
}

/** Six points of degree four (Strang and Fix). */
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

/** n x n Gauss points of the square, collapsed to the triangle: degree 2 n - 2. */
TriangleRule make_collapsed_rule(const unsigned int n)
{
  const dealii::QGauss<1> gauss(n);
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

/** The same, made once for every n that is used here. */
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

/** The parts of triangles on both sides of a line, as triangles. */
std::vector<Triangle> cut(const std::vector<Triangle> &triangles, const KinkLine<2> &line)
{
  std::vector<Triangle> parts;
  for (const Triangle &x : triangles)
  {
    const double size = std::sqrt(std::abs(twice_area(x)));
    for (const double sign : {1., -1.})
    {
      std::vector<dealii::Point<2>> polygon;
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

/** The parts into which lines cut a triangle, divided further. */
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

/** x(s, t) of the bilinear map of [-1,1]^2, and its derivatives. */
struct BilinearMap
{
  BilinearMap(const CellShape &shape, const dealii::Point<2> &reference)
  {
    const double s = reference[0], t = reference[1];
    for (unsigned int c = 0; c < 4; ++c)
    {
      const double a = c == 1 || c == 2 ? 1. : -1., b = c >= 2 ? 1. : -1.;
      const Vector2 x = shape.corners[c] - shape.corners[0];
      offset += 0.25 * (1. + a * s) * (1. + b * t) * x;
      d_s += 0.25 * a * (1. + b * t) * x;
      d_t += 0.25 * b * (1. + a * s) * x;
      shape_d_s[c] = 0.25 * a * (1. + b * t);
      shape_d_t[c] = 0.25 * b * (1. + a * s);
    }
    J = d_s[0] * d_t[1] - d_s[1] * d_t[0];
  }
  Vector2 offset, d_s, d_t;
  std::array<double, 4> shape_d_s, shape_d_t;
  double J;
};

/** The reference coordinates of a point, by Newton's method: one step on parallelograms. */
dealii::Point<2> reference_coordinates(const CellShape &shape, const Vector2 &offset)
{
  dealii::Point<2> reference;
  for (unsigned int step = 0; step < 20; ++step)
  {
    const BilinearMap map(shape, reference);
    const Vector2 r = offset - map.offset;
    const double ds = (r[0] * map.d_t[1] - r[1] * map.d_t[0]) / map.J;
    const double dt = (map.d_s[0] * r[1] - map.d_s[1] * r[0]) / map.J;
    reference += Vector2({ds, dt});
    if (std::abs(ds) + std::abs(dt) < 1e-14)
      break;
  }
  return reference;
}
} // namespace

Law::Law(const dealii::SymmetricTensor<4, 2> &hooke)
{
  constexpr std::array<std::array<unsigned int, 2>, 3> pairs = {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
  dealii::Tensor<2, 3> matrix;
  dealii::SymmetricTensor<2, 3> orthonormal;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      matrix[i][j] = hooke[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
      stiffness[i][j] = matrix[i][j];
      if (j >= i)
        orthonormal[i][j] =
          matrix[i][j] * (i == 2 ? std::sqrt(2.) : 1.) * (j == 2 ? std::sqrt(2.) : 1.);
    }
  const dealii::Tensor<2, 3> inverse = dealii::invert(matrix);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      compliance[i][j] = inverse[i][j];
  smallest_eigenvalue = dealii::eigenvalues(orthonormal)[2];
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

std::array<Vector2, 4> shape_gradients(const CellShape &shape, const dealii::Point<2> &reference)
{
  const BilinearMap map(shape, reference);
  std::array<Vector2, 4> gradients;
  for (unsigned int c = 0; c < 4; ++c)
  {
    gradients[c][0] = (map.shape_d_s[c] * map.d_t[1] - map.shape_d_t[c] * map.d_s[1]) / map.J;
    gradients[c][1] = (map.shape_d_t[c] * map.d_s[0] - map.shape_d_s[c] * map.d_t[0]) / map.J;
  }
  return gradients;
}

std::array<std::array<EdgePoint, 2>, 4> edge_points(const CellShape &shape)
{
  constexpr std::array<std::array<double, 2>, 4> corners = {
    {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
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
      point.gradients = shape_gradients(shape,
                                        {(1. - s) * corners[k][0] + s * corners[next][0],
                                         (1. - s) * corners[k][1] + s * corners[next][1]});
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
  const bool exact = kind.constant_law && shape.affine && !kind.fine;
  const unsigned int least = divide ? 3 : (kind.constant_law ? 4 : kind.n_points);
  const TriangleRule rule = !exact           ? collapsed_rule(std::max(least, kind.fine ? 6U : 0U))
                            : kind.quadratic ? quartic_rule()
                                             : midpoint_rule();
  std::vector<StressPoint> points;
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
        const dealii::Point<2> x = shape.corners[0] + point.offset;
        std::array<double, 3> lambda;
        for (unsigned int v = 0; v < 3; ++v)
          lambda[v] = twice_area({{x, whole[(v + 1) % 3], whole[(v + 2) % 3]}}) / twice_area(whole);
        point.psi = midpoint_functions(lines.empty() && !divide ? at.lambda : lambda);
        point.reference = reference_coordinates(shape, point.offset);
        point.gradients = shape_gradients(shape, point.reference);
        points.push_back(point);
      }
    }
  }
  return points;
}
} // namespace Signorini
