// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the pieces into which lines cut cells and faces.

#include <signorini/discretization/mesh/cut_quadrature.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Polygon = std::vector<Point<2>>;

/** Returns the part of a convex polygon on one side of a line. */
Polygon clip(const Polygon &polygon, const KinkLine<2> &line, const double sign)
{
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point<2> &a = polygon[i];
    const Point<2> &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * line.signed_distance(a);
    const double db = sign * line.signed_distance(b);
    if (da >= 0.)
      part.push_back(a);
    if ((da > 0. && db < 0.) || (da < 0. && db > 0.))
      part.push_back(a + (da / (da - db)) * (b - a));
  }
  return part;
}

/** The bilinear image of the square; with d = a it is a triangle (Duffy). */
struct Quadrilateral
{
  Point<2> a, b, c, d;

  Point<2> at(const double s, const double t) const
  {
    return a + s * (1. - t) * (b - a) + s * t * (c - a) + (1. - s) * t * (d - a);
  }
  double jacobian(const double s, const double t) const
  {
    const Tensor<1, 2> ds = (1. - t) * (b - a) + t * (c - d);
    const Tensor<1, 2> dt = (1. - s) * (d - a) + s * (c - b);
    return std::abs(ds[0] * dt[1] - ds[1] * dt[0]);
  }
  double diameter() const
  {
    return std::max(a.distance(c), b.distance(d));
  }
  /** Returns a lower bound of the distance from a point. */
  double distance(const Point<2> &x) const
  {
    return x.distance(at(0.5, 0.5)) - 0.5 * std::max(diameter(), a.distance(b));
  }
  /** Returns the image of [s, s + ds] x [t, t + dt]. */
  Quadrilateral part(const double s, const double t, const double ds, const double dt) const
  {
    return {at(s, t), at(s + ds, t), at(s + ds, t + dt), at(s, t + dt)};
  }
  /** length_s() and length_t() return the longer edges in the directions of s and t. */
  double length_s() const
  {
    return std::max(a.distance(b), d.distance(c));
  }
  double length_t() const
  {
    return std::max(a.distance(d), b.distance(c));
  }
};

/** Collects physical points and weights on convex polygons. */
class PolygonRule
{
public:
  /**
   * Makes the rules of all depths.
   * @param ends points towards which the pieces shrink.
   */
  PolygonRule(const unsigned int n_points, std::vector<Point<2>> ends)
    : ends_(std::move(ends))
  {
    for (unsigned int depth = 0; depth <= deepest; ++depth)
      gauss_.emplace_back(std::min(n_points, std::max(min_points + depth, n_points) - depth));
  }

  /** Adds a polygon: quadrilaterals are mapped from the square, other polygons split into
   * triangles. */
  void add(const Polygon &polygon)
  {
    if (polygon.size() == 4)
      add(Quadrilateral{polygon[0], polygon[1], polygon[2], polygon[3]}, 0);
    else
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        add(Quadrilateral{polygon[0], polygon[i], polygon[i + 1], polygon[0]}, 0);
  }

  std::vector<Point<2>> points;
  std::vector<double> weights;

private:
  /** The depth of the smallest pieces. A function like r^{1/2} is smooth on pieces that are small
   * compared with their distance from the end; the smallest pieces hold a share of 2^{-3 deepest}
   * of the integral of r. */
  static constexpr unsigned int deepest = 9;
  /** The number of points on the smallest pieces; where pieces are half as large, one point less
   * has the same effect. */
  static constexpr unsigned int min_points = 5;

  void add(const Quadrilateral &piece, const unsigned int depth)
  {
    for (const Point<2> &end : ends_)
      if (depth < deepest && 0.75 * piece.distance(end) < piece.diameter())
      {
        split(piece, depth);
        return;
      }
    const Quadrature<2> &gauss = gauss_[depth];
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double s = gauss.point(q)[0], t = gauss.point(q)[1];
      points.push_back(piece.at(s, t));
      weights.push_back(gauss.weight(q) * piece.jacobian(s, t));
    }
  }

  /** Splits long pieces into halves, others (and slivers, which hold next to nothing) into
   * quarters. */
  void split(const Quadrilateral &piece, const unsigned int depth)
  {
    constexpr double sliver = 1e-6;
    const double length_s = piece.length_s(), length_t = piece.length_t();
    const double longest = std::max(length_s, length_t), shortest = std::min(length_s, length_t);
    const bool is_long = longest > 2. * shortest && shortest > sliver * longest;
    if (is_long && length_s == longest)
      for (const double s : {0., 0.5})
        add_half(piece.part(s, 0., 0.5, 1.), shortest, depth);
    else if (is_long)
      for (const double t : {0., 0.5})
        add_half(piece.part(0., t, 1., 0.5), shortest, depth);
    else
      quarter(piece, depth);
  }
  /**
   * Adds a half of a long piece. The half at the tip of a triangle has its shape: like a quarter,
   * it is a level deeper.
   * @param width of the whole.
   */
  void add_half(const Quadrilateral &half, const double width, const unsigned int depth)
  {
    constexpr double half_of_width = 0.51;
    const bool is_tip = std::min(half.length_s(), half.length_t()) < half_of_width * width;
    add(half, is_tip ? depth + 1 : depth);
  }
  void quarter(const Quadrilateral &piece, const unsigned int depth)
  {
    for (const double s : {0., 0.5})
      for (const double t : {0., 0.5})
        add(piece.part(s, t, 0.5, 0.5), depth + 1);
  }

  /** The rule of every depth. */
  std::vector<QGauss<2>> gauss_;
  std::vector<Point<2>> ends_;
};

/** Returns the Jacobian determinant of the bilinear map of a cell at a reference point. */
double jacobian(const Triangulation<2>::cell_iterator &cell, const Point<2> &xi)
{
  const Tensor<1, 2> ds = (1. - xi[1]) * (cell->vertex(1) - cell->vertex(0)) +
                          xi[1] * (cell->vertex(3) - cell->vertex(2));
  const Tensor<1, 2> dt = (1. - xi[0]) * (cell->vertex(2) - cell->vertex(0)) +
                          xi[0] * (cell->vertex(3) - cell->vertex(1));
  return ds[0] * dt[1] - ds[1] * dt[0];
}

/** Returns the possible ends of contact zones that are near the cell, measured by its diameter. */
template <int dim>
std::vector<Point<dim>> ends_near(const Kinks<dim> &kinks,
                                  const typename Triangulation<dim>::cell_iterator &cell)
{
  std::vector<Point<dim>> near;
  for (const Point<dim> &end : kinks.ends())
    if (cell->center().distance(end) < 2.5 * cell->diameter())
      near.push_back(end);
  return near;
}

/** Returns the polygons into which the lines cut a cell. */
std::vector<Polygon> cut_cell(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell)
{
  std::vector<Polygon> pieces = {
    {cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)}};
  for (const KinkLine<2> &line : kinks.lines())
  {
    std::vector<Polygon> parts;
    for (const Polygon &piece : pieces)
      for (const double sign : {-1., 1.})
      {
        Polygon part = clip(piece, line, sign);
        if (part.size() > 2)
          parts.push_back(std::move(part));
      }
    pieces = std::move(parts);
  }
  return pieces;
}
} // namespace

template <int dim>
bool lines_cross(const Kinks<dim> &kinks, const typename Triangulation<dim>::cell_iterator &cell)
{
  for (const KinkLine<dim> &line : kinks.lines())
  {
    double lowest = 0., highest = 0.;
    for (const unsigned int v : cell->vertex_indices())
    {
      const double distance = line.signed_distance(cell->vertex(v));
      lowest = v == 0 ? distance : std::min(lowest, distance);
      highest = v == 0 ? distance : std::max(highest, distance);
    }
    const double margin = Kinks<dim>::tolerance * (highest - lowest);
    if (lowest < -margin && highest > margin)
      return true;
  }
  return false;
}

template <int dim>
bool needs_cuts(const Kinks<dim> &kinks, const typename Triangulation<dim>::cell_iterator &cell)
{
  return lines_cross(kinks, cell) || !ends_near(kinks, cell).empty();
}

template <>
Quadrature<2> cut_quadrature(const Kinks<2> &kinks,
                             const Triangulation<2>::cell_iterator &cell,
                             const unsigned int n_points)
{
  PolygonRule rule(n_points, ends_near(kinks, cell));
  for (const Polygon &piece : cut_cell(kinks, cell))
    rule.add(piece);
  const MappingQ1<2> mapping;
  for (std::size_t q = 0; q < rule.points.size(); ++q)
  {
    rule.points[q] = mapping.transform_real_to_unit_cell(cell, rule.points[q]);
    rule.weights[q] /= jacobian(cell, rule.points[q]);
  }
  return Quadrature<2>(rule.points, rule.weights);
}

template <>
Quadrature<3> cut_quadrature(const Kinks<3> & /*kinks*/,
                             const Triangulation<3>::cell_iterator & /*cell*/,
                             const unsigned int /*n_points*/)
{
  AssertThrow(false, ExcMessage("planes do not cut hexahedra yet"));
  return Quadrature<3>();
}

Quadrature<1> split_quadrature(const Quadrature<1> &rule, const std::vector<double> &cuts)
{
  std::vector<Point<1>> points;
  std::vector<double> weights;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double length = cuts[i + 1] - cuts[i];
      points.emplace_back(cuts[i] + length * rule.point(q)[0]);
      weights.push_back(length * rule.weight(q));
    }
  return Quadrature<1>(points, weights);
}

std::vector<double> graded_positions(const double s, const double distance)
{
  std::vector<double> positions;
  for (unsigned int k = 0; k < n_graded_layers; ++k)
    positions.push_back(s + distance * std::pow(0.25, k));
  return positions;
}

template bool lines_cross(const Kinks<2> &, const Triangulation<2>::cell_iterator &);
template bool lines_cross(const Kinks<3> &, const Triangulation<3>::cell_iterator &);
template bool needs_cuts(const Kinks<2> &, const Triangulation<2>::cell_iterator &);
template bool needs_cuts(const Kinks<3> &, const Triangulation<3>::cell_iterator &);
} // namespace Signorini
