// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the pieces into which lines cut cells and faces.

#include <signorini/mesh/kinks.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** Closer than this share of an edge, a line touches an end and cuts nothing. */
constexpr double tolerance = 1e-10;

using Polygon = std::vector<dealii::Point<2>>;

/** The part of a convex polygon with sign * (x_d - position) >= 0. */
Polygon clip(const Polygon &polygon, const unsigned int d, const double position, const double sign)
{
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const dealii::Point<2> &a = polygon[i];
    const dealii::Point<2> &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[d] - position);
    const double db = sign * (b[d] - position);
    if (da >= 0.)
      part.push_back(a);
    if ((da > 0. && db < 0.) || (da < 0. && db > 0.))
      part.push_back(a + (da / (da - db)) * (b - a));
  }
  return part;
}

/** Collects physical points and weights on convex polygons. */
class PolygonRule
{
public:
  explicit PolygonRule(const unsigned int n_points)
    : gauss_(n_points)
  {
  }

  /** Quadrilaterals are mapped from the square, other polygons split into triangles. */
  void add(const Polygon &polygon)
  {
    if (polygon.size() == 4)
      add_quadrilateral(polygon[0], polygon[1], polygon[2], polygon[3]);
    else
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        add_quadrilateral(polygon[0], polygon[i], polygon[i + 1], polygon[0]);
  }

  std::vector<dealii::Point<2>> points;
  std::vector<double> weights;

private:
  /** Bilinear image of the square; with d = a it collapses to a triangle (Duffy). */
  void add_quadrilateral(const dealii::Point<2> &a,
                         const dealii::Point<2> &b,
                         const dealii::Point<2> &c,
                         const dealii::Point<2> &d)
  {
    for (unsigned int q = 0; q < gauss_.size(); ++q)
    {
      const double s = gauss_.point(q)[0], t = gauss_.point(q)[1];
      const dealii::Tensor<1, 2> ds = (1. - t) * (b - a) + t * (c - d);
      const dealii::Tensor<1, 2> dt = (1. - s) * (d - a) + s * (c - b);
      points.push_back(a + s * (1. - t) * (b - a) + s * t * (c - a) + (1. - s) * t * (d - a));
      weights.push_back(gauss_.weight(q) * std::abs(ds[0] * dt[1] - ds[1] * dt[0]));
    }
  }

  dealii::QGauss<2> gauss_;
};

/** Jacobian determinant of the bilinear map of a cell at a reference point. */
double jacobian(const dealii::Triangulation<2>::cell_iterator &cell, const dealii::Point<2> &xi)
{
  const dealii::Tensor<1, 2> ds = (1. - xi[1]) * (cell->vertex(1) - cell->vertex(0)) +
                                  xi[1] * (cell->vertex(3) - cell->vertex(2));
  const dealii::Tensor<1, 2> dt = (1. - xi[0]) * (cell->vertex(2) - cell->vertex(0)) +
                                  xi[0] * (cell->vertex(3) - cell->vertex(1));
  return ds[0] * dt[1] - ds[1] * dt[0];
}

/** Lowest and highest coordinate of the cell's vertices. */
std::pair<double, double> extent(const dealii::Triangulation<2>::cell_iterator &cell,
                                 const unsigned int d)
{
  double lowest = cell->vertex(0)[d], highest = lowest;
  for (const unsigned int v : cell->vertex_indices())
  {
    lowest = std::min(lowest, cell->vertex(v)[d]);
    highest = std::max(highest, cell->vertex(v)[d]);
  }
  return {lowest, highest};
}
} // namespace

template <int dim>
Kinks<dim>::Kinks(const std::array<std::vector<double>, dim> &positions)
  : positions_(positions)
{
}

template <int dim>
std::vector<double> Kinks<dim>::cut(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const
{
  std::vector<double> cuts = {0., 1.};
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions_[d])
    {
      const double t = (position - a[d]) / (b[d] - a[d]);
      if (t > tolerance && t < 1. - tolerance)
        cuts.push_back(t);
    }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

template <int dim>
bool Kinks<dim>::touch(const dealii::Point<dim> &a, const dealii::Point<dim> &b) const
{
  const double margin = tolerance * a.distance(b);
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions_[d])
      if (std::abs(position - a[d]) < margin || std::abs(position - b[d]) < margin)
        return true;
  return false;
}

template <int dim>
bool Kinks<dim>::cross(const typename dealii::Triangulation<dim>::cell_iterator &cell) const
{
  for (unsigned int d = 0; d < dim; ++d)
  {
    if (positions_[d].empty())
      continue;
    const auto range = extent(cell, d);
    const double margin = tolerance * (range.second - range.first);
    for (const double position : positions_[d])
      if (position > range.first + margin && position < range.second - margin)
        return true;
  }
  return false;
}

template <int dim>
dealii::Quadrature<dim>
Kinks<dim>::quadrature(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                       const unsigned int n_points) const
{
  std::vector<Polygon> pieces = {
    {cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)}};
  for (unsigned int d = 0; d < dim; ++d)
    for (const double position : positions_[d])
    {
      std::vector<Polygon> parts;
      for (const Polygon &piece : pieces)
        for (const double sign : {-1., 1.})
        {
          Polygon part = clip(piece, d, position, sign);
          if (part.size() > 2)
            parts.push_back(std::move(part));
        }
      pieces = std::move(parts);
    }
  PolygonRule rule(n_points);
  for (const Polygon &piece : pieces)
    rule.add(piece);
  const dealii::MappingQ1<dim> mapping;
  for (std::size_t q = 0; q < rule.points.size(); ++q)
  {
    rule.points[q] = mapping.transform_real_to_unit_cell(cell, rule.points[q]);
    rule.weights[q] /= jacobian(cell, rule.points[q]);
  }
  return dealii::Quadrature<dim>(rule.points, rule.weights);
}

dealii::Quadrature<1> split_quadrature(const dealii::Quadrature<1> &rule,
                                       const std::vector<double> &cuts)
{
  std::vector<dealii::Point<1>> points;
  std::vector<double> weights;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double length = cuts[i + 1] - cuts[i];
      points.emplace_back(cuts[i] + length * rule.point(q)[0]);
      weights.push_back(length * rule.weight(q));
    }
  return dealii::Quadrature<1>(points, weights);
}

template class Kinks<2>;
} // namespace Signorini
