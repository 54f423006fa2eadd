// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the displacement of another program is from the solution, and where.

#include <signorini/discretization/space/cell_evaluator.h>
#include <signorini/error_control/verify/verification.h>
#include <signorini/postprocessing/quantities/side_forces.h>
#include <signorini/problem/scene/contact_pair.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Signorini {
namespace {
bool is_contact(const Scene<2> &scene, const unsigned int side) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [side](const auto &contact) {
    return contact.side == side || contact.opposite == side;
  });
}

/** Calls visit(edge, s) for equidistant points of the edges of a side. */
template <typename Visit>
void visit_side(const ForeignField &field, const unsigned int side, const Visit &visit) {
  constexpr unsigned int n = 32;
  for (const ForeignEdge &edge : field.edges())
    for (unsigned int k = 0; k <= n && edge.side == side; ++k)
      visit(edge, edge.from + k * (edge.to - edge.from) / n);
}

/** Sets the largest v - u_D of a support. */
void find_miss(const ForeignField &field, const Scene<2> &scene, VerifiedSide &found) {
  const Side<2> &side = scene.geometry.sides[found.side];
  const BoundaryCondition<2> &condition = scene.boundary[found.side];
  dealii::Vector<double> given(2);
  found.at = side.centre();
  visit_side(field, found.side, [&](const ForeignEdge &edge, const double s) {
    const Point<2> x = side.point(s);
    if (condition.role == Role::displacement)
      condition.data->vector_value(x, given);
    Tensor<1, 2> miss = field.on_edge(edge, s) - Tensor<1, 2>({given[0], given[1]});
    if (condition.role == Role::roller)
      miss = (miss * side.normal(s, 0.5 * (edge.from + edge.to))) *
             side.normal(s, 0.5 * (edge.from + edge.to));
    if (miss.norm() > found.miss.norm()) {
      found.miss = miss;
      found.at = x;
    }
  });
}

std::optional<Penetration> find_penetration(const ForeignField &field, const Scene<2> &scene) {
  std::optional<Penetration> deepest;
  for (const ContactPair<2> &pair : contact_pairs(scene)) {
    const Side<2> &side = scene.geometry.sides[pair.side()];
    visit_side(field, pair.side(), [&](const ForeignEdge &edge, const double s) {
      if (pair.other_side() && !pair.contains(s))
        return;
      const Point<2> x = side.point(s);
      Tensor<1, 2> v = field.on_edge(edge, s);
      if (pair.other_side()) {
        const Side<2> &other = scene.geometry.sides[*pair.other_side()];
        const double across = other.arc_length(other.across(x, side.normal(s)));
        v -= field.on_edge(field.edge_at(*pair.other_side(), across), across);
      }
      const double depth = v * pair.direction(x) - pair.gap(x);
      if (!deepest || depth > deepest->value)
        deepest = {depth, {side.name(), s, x}};
    });
  }
  return deepest;
}

/** Returns a cell with the field (w, w²): the weight w of a side is one on it, zero on the others
 * of its body, and between them 1/d by the distances d, with a sum of one. */
ForeignCell weights_on(const ForeignCell &cell, const Geometry<2> &geometry,
                       const std::vector<VerifiedSide> &sides, const VerifiedSide &of_side) {
  const double rounding = 1e-14 * geometry.diameter();
  ForeignCell weights = cell;
  for (unsigned int i = 0; i < cell.n_nodes(); ++i) {
    double own = 0., sum = 0.;
    for (const VerifiedSide &found : sides) {
      if (geometry.body_of_side(found.side) != cell.body)
        continue;
      const Side<2> &side = geometry.sides[found.side];
      const double s = side.arc_length(cell.x[i]),
                   d = side.point(side.is_closed() ? s : std::clamp(s, 0., side.length()))
                         .distance(cell.x[i]),
                   // Corners of contact sides on supports belong to these.
        weight = 1. / (d + (found.is_support ? 1e-12 * rounding : rounding));
      sum += weight;
      if (&found == &of_side)
        own = weight;
    }
    weights.v[i] = Tensor<1, 2>({own / sum, std::pow(own / sum, 2)});
  }
  weights.complete(weights.v);
  return weights;
}

/** Sets the force of a side, a(v, w e) - f(w e) - ∫ w t.e for unit vectors e. If v is a solution by
 * finite elements every w leads to the same force. Otherwise smooth weights lessen the difference,
 * and w² shows it. */
void find_force(const ForeignField &field, const Scene<2> &scene,
                const std::vector<VerifiedSide> &sides, VerifiedSide &found) {
  const QGauss<2> rule(5);
  const QGauss<1> edge_rule(10);
  dealii::Vector<double> f(2);
  const auto add = [&](const Tensor<1, 2> &force, const Tensor<1, 2> &other, const Point<2> &x) {
    found.force += force;
    found.moment += x[0] * force[1] - x[1] * force[0];
    found.other += other;
  };
  for (const ForeignCell &cell : field.cells()) {
    const ForeignCell weights = weights_on(cell, scene.geometry, sides, found);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const ForeignCell::Values at = cell.at(rule.point(q)[0], rule.point(q)[1]),
                                w = weights.at(rule.point(q)[0], rule.point(q)[1]);
      const double dx = rule.weight(q) * at.determinant;
      const SymmetricTensor<2, 2> stress = scene.material->hooke(at.x) * strain_of(at.gradient);
      if (scene.body_force != nullptr)
        scene.body_force->vector_value(at.x, f);
      const Tensor<1, 2> load({f[0], f[1]});
      add(dx * (stress * w.gradient[0] - w.v[0] * load),
          dx * (stress * w.gradient[1] - w.v[1] * load), at.x);
    }
  }
  for (const ForeignEdge &edge : field.edges()) {
    if (scene.boundary[edge.side].role != Role::traction)
      continue;
    const ForeignCell weights = weights_on(field.cells()[edge.cell], scene.geometry, sides, found);
    for (unsigned int q = 0; q < edge_rule.size(); ++q) {
      const double s = edge.from + edge_rule.point(q)[0] * (edge.to - edge.from),
                   ds = (edge.to - edge.from) * edge_rule.weight(q);
      const Point<2> x = scene.geometry.sides[edge.side].point(s);
      const Tensor<1, 2> w = weights.on_edge(edge.number, edge.position(s));
      scene.boundary[edge.side].data->vector_value(x, f);
      const Tensor<1, 2> load({f[0], f[1]});
      add(-ds * w[0] * load, -ds * w[1] * load, x);
    }
  }
}

/** u_h with its gradient at points. */
struct Samples {
  std::vector<bool> found;
  std::vector<Tensor<1, 2>> values;
  std::vector<Tensor<2, 2>> gradients;
};

Samples sample_at(const DisplacedBody<2> &body, const std::vector<Point<2>> &points) {
  const Mesh<2> &mesh = body.space.mesh();
  Samples samples = {std::vector<bool>(points.size(), false),
                     std::vector<Tensor<1, 2>>(points.size()),
                     std::vector<Tensor<2, 2>>(points.size())};
  const GridTools::Cache<2> cache(mesh.triangulation(), mesh.mapping());
  const auto found = GridTools::compute_point_locations_try_all(cache, points);
  const auto &cells = std::get<0>(found);
  CellEvaluator<2> u(body.space, {{&body.U}}, ValuesCache<2>::gauss, {}, false);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    u.reinit_once(CellEvaluator<2>::Cell(&mesh.triangulation(), cells[c]->level(),
                                         cells[c]->index(), &body.space.dofs()),
                  Quadrature<2>(std::get<1>(found)[c]));
    const std::vector<unsigned int> &numbers = std::get<2>(found)[c];
    for (unsigned int q = 0; q < numbers.size(); ++q) {
      samples.found[numbers[q]] = true;
      samples.values[numbers[q]] = u.value(q);
      samples.gradients[numbers[q]] = u.gradient(q);
    }
  }
  return samples;
}

/** Sets the norms of the cells and the differences at nodes. */
void compare(const ForeignField &field, const DisplacedBody<2> &body, Verification &result) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  // Large cells are coarse where u is singular.
  constexpr std::size_t few = 5000;
  const QGauss<2> rule(field.cells().size() < few ? 8 : 3);
  std::vector<Point<2>> points;
  std::vector<ForeignCell::Values> values;
  result.differences.resize(field.n_nodes());
  std::vector<std::size_t> point_of_node(field.n_nodes(), 0);
  for (const ForeignCell &cell : field.cells()) {
    for (const Point<2> &at : rule.get_points()) {
      values.push_back(cell.at(at[0], at[1]));
      points.push_back(values.back().x);
    }
    for (unsigned int i = 0; i < cell.n_nodes(); ++i)
      result.differences[cell.nodes[i]] = cell.v[i];
  }
  // Nodes are looked up a little inside of a cell: rounding must not lose those on the boundary.
  constexpr double inwards = 1e-6;
  for (const ForeignCell &cell : field.cells())
    for (unsigned int i = 0; i < cell.n_nodes(); ++i)
      if (std::size_t &number = point_of_node[cell.nodes[i]]; number == 0) {
        number = points.size();
        points.push_back(cell.x[i] + inwards * (cell.middle() - cell.x[i]));
      }
  const Samples u = sample_at(body, points);
  EnergyMeasure<2> measure(body.scene);
  std::size_t number = 0;
  for (std::size_t c = 0; c < field.cells().size(); ++c) {
    double square = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q, ++number) {
      const double dx = rule.weight(q) * values[number].determinant;
      result.area += dx;
      if (u.found[number])
        square += dx * measure.at(points[number])
                         .density(strain_of(values[number].gradient - u.gradients[number]));
    }
    result.cells.push_back(std::sqrt(square));
  }
  for (std::size_t node = 0; node < point_of_node.size(); ++node)
    result.differences[node] -=
      u.found[point_of_node[node]] ? u.values[point_of_node[node]] : Tensor<1, 2>({none, none});
  const auto largest = std::max_element(result.cells.begin(), result.cells.end());
  result.largest_cell = largest - result.cells.begin();
  result.middle_of_largest = field.cells()[result.largest_cell].middle();
}

void find_factor(const FieldWorks &works, const double error, const double norm,
                 Verification &result) {
  const double square = norm * norm, product = 0.5 * (works.strain + square - error * error);
  if (!(works.strain > 0.))
    return;
  result.factor = product / works.strain;
  result.factor_distance = std::sqrt(std::max(0., square - product * result.factor));
}
} // namespace

double Verification::sum_of_cells() const {
  return std::sqrt(std::inner_product(cells.begin(), cells.end(), cells.begin(), 0.));
}

Verification verify(const ForeignField &field, const DisplacedBody<2> &solution,
                    const ReferenceStress &reference) {
  Verification result;
  const Scene<2> &scene = solution.scene;
  const FieldWorks works = works_of(field, scene);
  FieldWorks rest = works;
  rest.strain = rest.load = rest.margin = 0.;
  for (BoundaryTrace &trace : rest.traces)
    std::fill(trace.values.begin(), trace.values.end(), Tensor<1, 2>());
  result.error = reference.distance(works);
  result.norm = reference.distance(rest);
  result.is_conditional = reference.is_conditional;
  result.strain = works.strain;
  result.load = works.load;
  find_factor(works, result.error.value, result.norm.value, result);
  for (unsigned int side = 0; side < scene.geometry.sides.size(); ++side)
    if (holds(scene.boundary[side].role) || is_contact(scene, side)) {
      VerifiedSide &found = result.sides.emplace_back();
      found.side = side;
      found.is_support = holds(scene.boundary[side].role);
      if (found.is_support)
        find_miss(field, scene, found);
    }
  for (VerifiedSide &side : result.sides)
    find_force(field, scene, result.sides, side);
  result.penetration = find_penetration(field, scene);
  compare(field, solution, result);
  return result;
}
} // namespace Signorini
