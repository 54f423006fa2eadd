// SPDX-License-Identifier: LGPL-2.1-or-later
// Means of u_h and of its stress by integrals over lines.

#include <signorini/discretization/mesh/arc_mapping.h>
#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/reference/probe_mean.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
using Cell = DoFHandler<2>::active_cell_iterator;

/** Adds the roots in [from, to] of a polynomial, one of a cluster, by its coefficients of Bernstein
 * there: where all have one sign, by more than @p rounding, it has none. */
void add_roots(std::vector<double> b, const double from, const double to, const double rounding,
               std::vector<double> &roots) {
  constexpr double width = 1e-9, of_cluster = 1e-7;
  const auto [least, largest] = std::minmax_element(b.begin(), b.end());
  if (*least > rounding || *largest < -rounding)
    return;
  const double middle = 0.5 * (from + to);
  if (to - from < width) {
    if (roots.empty() || middle - roots.back() > of_cluster)
      roots.push_back(middle);
    return;
  }
  std::vector<double> first;
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    first.push_back(b[0]);
    for (std::size_t i = 0; i + 1 < n - k; ++i)
      b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  add_roots(first, from, middle, rounding, roots);
  // The rest are the coefficients of the second half.
  add_roots(b, middle, to, rounding, roots);
}

/** A part of a line on which functions of a cell are smooth: of edge @p face of the cell, or of a
 * curve in it. */
struct LinePart {
  Cell cell;
  const Curve *curve;
  unsigned int face;
  double from, to;
};

class LineIntegrals {
public:
  /** The sums of u_i n_j, u_i and n over lines, x·n/2 and the length. */
  struct Sums {
    Tensor<2, 2> gradient;
    Tensor<1, 2> u, n;
    double area = 0., length = 0.;
    /** Whether all points lie in the cells of their parts. */
    bool is_inside = true;
  };

  explicit LineIntegrals(const DisplacedBody<2> &body)
    : body_(body)
    , maps_(body.space.mesh(), body.scene.geometry.sides)
    , rounding_(1e-12 * body.scene.geometry.diameter()) {}

  /** Collects the edges of cells on a side. */
  void add_side(const unsigned int side) {
    for (const Cell &cell : cells())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() == side)
          parts_.push_back({cell, nullptr, f, 0., 1.});
  }
  /** Collects the edges of cells around a region. */
  void add_region(const unsigned int region) {
    const auto is_in = [&](const Triangulation<2>::cell_iterator &cell) {
      return body_.scene.geometry.region_at(cell->center()) == region;
    };
    for (const Cell &cell : cells())
      for (const unsigned int f : cell->face_indices())
        if (is_in(cell) && (cell->at_boundary(f) || !is_in(cell->neighbor(f))))
          parts_.push_back({cell, nullptr, f, 0., 1.});
  }
  /** Collects the parts of a contour in the body, and of the body's boundary in the contour. */
  void add_contour(const Probe<2> &probe, const std::vector<Curve> &contour) {
    std::vector<std::vector<double>> cuts;
    for (const Curve &curve : contour)
      for (unsigned int k = 0; k <= n_first_parts; ++k)
        (k == 0 ? cuts.emplace_back() : cuts.back()).push_back(k * curve.length() / n_first_parts);
    for (const Cell &cell : cells())
      for (const unsigned int f : cell->face_indices()) {
        std::vector<double> on_face = {0., 1.};
        for (std::size_t i = 0; i < contour.size(); ++i)
          for (const double t : crossings(contour[i], cell, f)) {
            on_face.push_back(t);
            const double s = contour[i].arc_length(point(cell, f, t));
            cuts[i].push_back(std::clamp(s, 0., contour[i].length()));
          }
        if (cell->at_boundary(f))
          add_parts(on_face, [&](const double from, const double to) {
            if (is_inside(probe, contour, point(cell, f, 0.5 * (from + to))))
              parts_.push_back({cell, nullptr, f, from, to});
          });
      }
    for (std::size_t i = 0; i < contour.size(); ++i)
      add_parts(cuts[i], [&](const double from, const double to) {
        const double s = 0.5 * (from + to);
        const Cell cell = cell_at(contour[i].point(s) - rounding_ * contour[i].normal(s));
        if (cell != body_.space.dofs().end())
          parts_.push_back({cell, &contour[i], 0, from, to});
      });
  }

  /** Returns cells that a probe contains or that its boundary meets, one for each part. */
  std::vector<Cell> touched(const Probe<2> &probe) const {
    std::vector<Cell> found;
    for (const LinePart &part : parts_)
      found.push_back(part.cell);
    for (const Cell &cell : cells())
      if (!probe.region && probe.contains(cell->center()))
        found.push_back(cell);
    return found;
  }
  /** Returns the sums by rules with @p more points than a cell's degree. */
  Sums sums(const unsigned int more) const {
    CellEvaluator<2> u(body_.space, {{&body_.U}}, ValuesCache<2>::gauss,
                       [this](const Cell &cell) -> const Mapping<2> & { return maps_.of(cell); });
    Sums sums;
    // A translation has no part in the gradient.
    std::optional<Tensor<1, 2>> first;
    for (const LinePart &part : parts_) {
      const QGauss<1> rule(part.cell->get_fe().degree + more);
      std::vector<Point<2>> points;
      std::vector<double> weights;
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const double s = part.from + (part.to - part.from) * rule.point(q)[0];
        points.push_back(part.curve == nullptr ? on_reference_cell(part.face, s)
                                               : maps_.of(part.cell).transform_real_to_unit_cell(
                                                   part.cell, part.curve->point(s)));
        sums.is_inside =
          sums.is_inside && GeometryInfo<2>::distance_to_unit_cell(points.back()) < 1e-3;
        weights.push_back((part.to - part.from) * rule.weight(q));
      }
      u.reinit_once(part.cell, Quadrature<2>(points, weights));
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const Tensor<1, 2> n = normal(part, u, q, rule.point(q)[0], weights[q]);
        if (!first)
          first = u.value(q);
        sums.gradient += outer_product(u.value(q) - *first, n);
        sums.area += 0.5 * (u.points()[q] - body_.scene.geometry.lower) * n;
        sums.n += n;
        sums.u += n.norm() * u.value(q);
        sums.length += n.norm();
      }
    }
    return sums;
  }

private:
  static constexpr unsigned int n_first_parts = 8;

  std::vector<Cell> cells() const {
    const auto range = body_.space.dofs().active_cell_iterators();
    return std::vector<Cell>(range.begin(), range.end());
  }
  static Point<2> on_reference_cell(const unsigned int f, const double t) {
    return f < 2 ? Point<2>(f, t) : Point<2>(t, f - 2.);
  }
  Point<2> point(const Cell &cell, const unsigned int f, const double t) const {
    return maps_.of(cell).transform_unit_to_real_cell(cell, on_reference_cell(f, t));
  }
  /** Returns n ds: of an edge of a cell J^{-T} n det J dt. */
  static Tensor<1, 2> normal(const LinePart &part, const CellEvaluator<2> &u, const unsigned int q,
                             const double position, const double weight) {
    if (part.curve != nullptr)
      return weight * part.curve->normal(part.from + (part.to - part.from) * position);
    Tensor<2, 2> row;
    row[0][part.face / 2] = part.face % 2 == 0 ? -1. : 1.;
    return u.measure(q) * u.in_body(row, q)[0];
  }
  /** Returns the positions on an edge at which it meets the circle or line of a curve. */
  std::vector<double> crossings(const Curve &curve, const Cell &cell, const unsigned int f) const {
    std::vector<double> found;
    const Point<2> centre = cell->center();
    const double s = std::clamp(curve.arc_length(centre), 0., curve.length());
    if (curve.point(s).distance(centre) > cell->diameter())
      return found;
    const unsigned int degree = 2 * maps_.degree();
    const auto value = [&](const double t) {
      const Point<2> x = point(cell, f, t);
      if (curve.is_flat())
        return (x - curve.start()) * curve.normal(0.);
      const double distance = x.distance(curve.centre_of_circle()) - curve.radius();
      return distance * (distance / curve.radius() + 2.);
    };
    const std::vector<double> b =
      bernstein_coefficients(legendre_projection(degree, QGauss<1>(degree + 1), value));
    double size = 0.;
    for (const double coefficient : b)
      size = std::max(size, std::abs(coefficient));
    if (size > rounding_)
      add_roots(b, 0., 1., 1e-13 * size + 1e-3 * rounding_, found);
    return found;
  }
  /** Calls @p use for consecutive cuts. */
  static void add_parts(std::vector<double> cuts, const std::function<void(double, double)> &use) {
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (cuts[i + 1] - cuts[i] > 1e-12 * cuts.back())
        use(cuts[i], cuts[i + 1]);
  }
  /** Returns whether a point is inside of a contour, and not on it: there the contour counts. */
  bool is_inside(const Probe<2> &probe, const std::vector<Curve> &contour,
                 const Point<2> &x) const {
    return probe.contains(x) &&
           std::none_of(contour.begin(), contour.end(), [&](const Curve &curve) {
             const double s = std::clamp(curve.arc_length(x), 0., curve.length());
             return curve.point(s).distance(x) <= rounding_;
           });
  }
  /** Returns the cell that contains a point; the end outside of the body. */
  Cell cell_at(const Point<2> &x) const {
    Cell found = body_.space.dofs().end();
    double nearest = 1e-10;
    for (const Cell &cell : body_.space.dofs().active_cell_iterators()) {
      if (cell->center().distance(x) > cell->diameter())
        continue;
      try {
        const double distance = GeometryInfo<2>::distance_to_unit_cell(
          maps_.of(cell).transform_real_to_unit_cell(cell, x));
        if (distance < nearest) {
          nearest = distance;
          found = cell;
        }
      } catch (const Mapping<2>::ExcTransformationFailed &) {
        // The point is far outside of the cell.
      }
    }
    return found;
  }

  const DisplacedBody<2> &body_;
  const ExactMaps maps_;
  /** The size of differences of positions that count as none. */
  const double rounding_;
  std::vector<LinePart> parts_;
};

/** Returns the boundary of a disc or a box, counter-clockwise; nothing for a region. */
std::vector<Curve> contour_of(const Probe<2> &probe) {
  if (probe.region)
    return {};
  if (!probe.box) {
    const Point<2> start = probe.centre + Point<2>(probe.radius, 0.);
    return {Curve::arc_between(start, start, probe.centre, true)};
  }
  const auto &[a, b] = probe.box->get_boundary_points();
  const Point<2> c(b[0], a[1]), d(a[0], b[1]);
  return {Curve(a, c), Curve(c, b), Curve(b, d), Curve(d, a)};
}

/** Returns the margin of a mean by two rules. */
Tensor<2, 2> margin_of(const Tensor<2, 2> &first, const Tensor<2, 2> &second) {
  constexpr double rounding = 1e-9;
  Tensor<2, 2> margin;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      margin[i][j] = std::abs(first[i][j] - second[i][j]) + rounding * second.norm();
  return margin;
}

constexpr unsigned int few = 6, more = 12;
} // namespace

ProbeMean mean_stress(const DisplacedBody<2> &body, const Probe<2> &probe) {
  ProbeMean mean;
  const std::vector<Curve> contour = contour_of(probe);
  LineIntegrals lines(body);
  if (probe.region)
    lines.add_region(*probe.region);
  else
    lines.add_contour(probe, contour);
  const Material<2> &material = *body.scene.material;
  if (!material.is_constant_on_cells())
    mean.missing = "the moduli vary in it";
  for (const Cell &cell : lines.touched(probe)) {
    const SymmetricTensor<4, 2> hooke = material.hooke(cell->center());
    if (mean.hooke.norm() == 0.)
      mean.hooke = hooke;
    else if ((hooke - mean.hooke).norm() > 1e-12 * hooke.norm())
      mean.missing = "the moduli vary in it";
  }
  const LineIntegrals::Sums a = lines.sums(few), b = lines.sums(more);
  mean.measure = b.area;
  if (!(b.area > 0.))
    mean.missing = "nothing of the body lies in it";
  if (!a.is_inside || !b.is_inside || b.n.norm() > 1e-9 * b.length)
    mean.missing = "its boundary in the mesh is not closed";
  if (!mean.missing.empty())
    return mean;
  const auto stress = [&](const LineIntegrals::Sums &sums) {
    return Tensor<2, 2>(mean.hooke * symmetrize(sums.gradient) / sums.area);
  };
  mean.value = stress(b);
  mean.margin = margin_of(stress(a), mean.value);
  return mean;
}

ProbeMean mean_displacement(const DisplacedBody<2> &body, const unsigned int side) {
  LineIntegrals lines(body);
  lines.add_side(side);
  const LineIntegrals::Sums a = lines.sums(few), b = lines.sums(more);
  ProbeMean mean;
  Tensor<2, 2> first;
  first[0] = a.u / a.length;
  mean.value[0] = b.u / b.length;
  mean.margin = margin_of(first, mean.value);
  mean.measure = b.length;
  return mean;
}
} // namespace Signorini
