// SPDX-License-Identifier: LGPL-2.1-or-later
// The works of the loads on the displacement of another program.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/error_control/reference/hidden_load.h>
#include <signorini/error_control/verify/foreign_works.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The numbers of points of the two rules that are compared. */
constexpr std::array<unsigned int, 2> compared_rules = {{4, 6}};

/** The share of |||v|||² by which they may differ. */
constexpr double agreement = 1e-13;

/** Returns the ends of [from, to] and the points between them at which a function changes its
 * sign; more than one of them between two of five equidistant points are not found. */
template <typename Function>
void add_sign_changes(const Function &f, const double from, const double to,
                      std::vector<double> &cuts) {
  constexpr unsigned int n = 4;
  double a = from, at_a = f(a);
  for (unsigned int k = 1; k <= n; ++k) {
    const double b = from + k * (to - from) / n, at_b = f(b);
    if (at_a * at_b < 0.) {
      std::uintmax_t steps = 100;
      cuts.push_back(boost::math::tools::toms748_solve(
                       f, a, b, at_a, at_b, boost::math::tools::eps_tolerance<double>(50), steps)
                       .first);
    }
    a = b;
    at_a = at_b;
  }
}

/** A square part of the unit square of a cell. */
struct CellPart {
  unsigned int cell, halvings;
  Point<2> corner;
  double width;
};

/** Integrates on cells. */
class CellIntegrals {
public:
  CellIntegrals(const ForeignField &field, const Scene<2> &scene)
    : field_(field)
    , scene_(scene)
    , measure_(scene) {
    for (const Kinks<2> *const kinks : {&scene.kinks, &scene.law_kinks})
      lines_.insert(lines_.end(), kinks->lines().begin(), kinks->lines().end());
  }

  /** Adds the energy and the work of the body force. */
  void add_to(FieldWorks &works) {
    const unsigned int n_cells = field_.cells().size();
    double strain = 0.;
    for (unsigned int c = 0; c < n_cells; ++c)
      strain += integrals({c, 0, {}, 1.}, compared_rules[0])[0];
    allowed_ = 0.1 * agreement * strain / n_cells;
    for (unsigned int c = 0; c < n_cells; ++c)
      add({c, 0, {}, 1.}, works);
  }

private:
  void add(const CellPart &part, FieldWorks &works) {
    // Jumps that are on no line leave 2^n parts of a cell.
    constexpr unsigned int most_halvings = 10, most_parts = 1000000;
    const auto less = integrals(part, compared_rules[0]), more = integrals(part, compared_rules[1]);
    const double rest = std::abs(more[0] - less[0]) + 2. * std::abs(more[1] - less[1]);
    const bool is_large = is_too_large(part);
    if (n_parts_ < most_parts && (is_large || (rest > allowed_ && part.halvings < most_halvings))) {
      for (const double s : {0., 0.5})
        for (const double t : {0., 0.5})
          add({part.cell, part.halvings + 1, part.corner + part.width * Tensor<1, 2>({s, t}),
               0.5 * part.width},
              works);
      return;
    }
    ++n_parts_;
    works.strain += more[0];
    works.load += more[1];
    works.margin += is_large ? HUGE_VAL : rest;
  }

  /** Returns whether a part meets more boxes than have its size. */
  bool is_too_large(const CellPart &part) const {
    constexpr unsigned int most = 4;
    if (part.halvings >= BoxTree::deepest_halvings)
      return false;
    std::vector<Point<2>> points;
    for (const double s : {0., 0.5, 1.})
      for (const double t : {0., 0.5, 1.})
        points.push_back(field_.cells()[part.cell]
                           .at(part.corner[0] + s * part.width, part.corner[1] + t * part.width)
                           .x);
    const BoundingBox<2> box(points);
    return scene_.kinks.boxes().n_met(box, most + 1) > most ||
           scene_.law_kinks.boxes().n_met(box, most + 1) > most;
  }

  std::array<double, 2> integrals(const CellPart &part, const unsigned int n) {
    std::vector<ForeignCell::Values> values;
    std::vector<double> weights;
    add_points(part, QGauss<1>(n), values, weights);
    std::array<double, 2> sums = {{0., 0.}};
    std::vector<Point<2>> points;
    for (std::size_t q = 0; q < values.size(); ++q) {
      points.push_back(values[q].x);
      sums[0] += weights[q] * measure_.at(values[q].x).density(strain_of(values[q].gradient));
    }
    if (scene_.body_force == nullptr)
      return sums;
    std::vector<dealii::Vector<double>> f(points.size(), dealii::Vector<double>(2));
    scene_.body_force->vector_value_list(points, f);
    for (std::size_t q = 0; q < values.size(); ++q)
      sums[1] += weights[q] * (f[q][0] * values[q].v[0] + f[q][1] * values[q].v[1]);
    return sums;
  }

  /** Adds the points of a rule in t between the lines, at the points of one in s between those
   * where lines cross the lower and upper edge of the part. */
  void add_points(const CellPart &part, const Quadrature<1> &rule,
                  std::vector<ForeignCell::Values> &values, std::vector<double> &weights) const {
    const ForeignCell &cell = field_.cells()[part.cell];
    const std::vector<const KinkLine<2> *> lines = lines_near(cell);
    const double s0 = part.corner[0], s1 = s0 + part.width, t0 = part.corner[1],
                 t1 = t0 + part.width;
    std::vector<double> cuts = {s0, s1};
    for (const KinkLine<2> *const line : lines)
      for (const double t : {t0, t1})
        add_sign_changes([&](const double s) { return line->signed_distance(cell.at(s, t).x); }, s0,
                         s1, cuts);
    for_each_point(rule, cuts, [&](const double s, const double ds) {
      std::vector<double> across = {t0, t1};
      for (const KinkLine<2> *const line : lines)
        add_sign_changes([&](const double t) { return line->signed_distance(cell.at(s, t).x); }, t0,
                         t1, across);
      for_each_point(rule, across, [&](const double t, const double dt) {
        values.push_back(cell.at(s, t));
        weights.push_back(ds * dt * values.back().determinant);
      });
    });
  }
  template <typename Visit>
  static void for_each_point(const Quadrature<1> &rule, std::vector<double> &cuts,
                             const Visit &visit) {
    std::sort(cuts.begin(), cuts.end());
    const Quadrature<1> points = split_quadrature(rule, cuts);
    for (unsigned int q = 0; q < points.size(); ++q)
      visit(points.point(q)[0], points.weight(q));
  }
  std::vector<const KinkLine<2> *> lines_near(const ForeignCell &cell) const {
    std::vector<const KinkLine<2> *> near;
    for (const KinkLine<2> &line : lines_) {
      double lowest = HUGE_VAL, highest = -HUGE_VAL;
      for (unsigned int k = 0; k < 2 * cell.n_corners(); ++k) {
        lowest = std::min(lowest, line.signed_distance(cell.x[k]));
        highest = std::max(highest, line.signed_distance(cell.x[k]));
      }
      // Arcs may bulge beyond the nodes.
      const double margin = highest - lowest;
      if (lowest < margin && highest > -margin)
        near.push_back(&line);
    }
    return near;
  }

  const ForeignField &field_;
  const Scene<2> &scene_;
  EnergyMeasure<2> measure_;
  /** The allowed difference of two rules on a part. */
  double allowed_ = 0.;
  unsigned int n_parts_ = 0;
  std::vector<KinkLine<2>> lines_;
};

/** Adds the work of the traction on a part of an edge, halved until two rules agree. */
void add_edge_work(const ForeignField &field, const ForeignEdge &edge, const Scene<2> &scene,
                   const double from, const double to, const unsigned int halvings,
                   FieldWorks &works) {
  constexpr unsigned int most_halvings = 20;
  const Side<2> &side = scene.geometry.sides[edge.side];
  dealii::Vector<double> t(2);
  std::array<double, 2> sums = {{0., 0.}};
  double size = 0.;
  for (unsigned int k = 0; k < 2; ++k) {
    const QGauss<1> rule(2 * compared_rules[k]);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double s = from + (to - from) * rule.point(q)[0], ds = (to - from) * rule.weight(q);
      scene.boundary[edge.side].data->vector_value(side.point(s), t);
      const Tensor<1, 2> v = field.on_edge(edge, s);
      sums[k] += ds * (t[0] * v[0] + t[1] * v[1]);
      size += ds * (std::abs(t[0] * v[0]) + std::abs(t[1] * v[1]));
    }
  }
  const double rest = std::abs(sums[1] - sums[0]);
  const double middle = 0.5 * (from + to);
  if (rest > 1e-15 * size && rest > 0.01 * agreement * works.strain / (1. + field.edges().size()) &&
      halvings < most_halvings) {
    add_edge_work(field, edge, scene, from, middle, halvings + 1, works);
    add_edge_work(field, edge, scene, middle, to, halvings + 1, works);
    return;
  }
  works.load += sums[1];
  works.margin += 2. * rest;
}

} // namespace

FieldWorks works_of(const ForeignField &field, const Scene<2> &scene) {
  FieldWorks works;
  CellIntegrals(field, scene).add_to(works);
  for (const ForeignEdge &edge : field.edges()) {
    const Side<2> &side = scene.geometry.sides[edge.side];
    const Role role = scene.boundary[edge.side].role;
    if (role != Role::traction) {
      BoundaryTrace &trace =
        works.traces.emplace_back(BoundaryTrace{edge.side, edge.from, edge.to, {}});
      for (const double r : {0., 0.5, 1.})
        trace.values.push_back(field.on_edge(edge, edge.from + r * (edge.to - edge.from)));
      continue;
    }
    const std::vector<double> cuts = scene.kinks.cut(side, edge.from, edge.to);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      add_edge_work(field, edge, scene, cuts[i], cuts[i + 1], 0, works);
  }
  if (scene.body_force != nullptr)
    works.margin += 2. * HiddenLoad(scene).force() * field.largest();
  return works;
}
} // namespace Signorini
