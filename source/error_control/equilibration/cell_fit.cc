// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses in equilibrium that fit the stress of u_h on a cell.

#include <signorini/base/parallel.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/mesh/smooth_parts.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/error_control/equilibration/cell_fit.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

CellShape at_unit_size(const CellShape &shape, const double size) {
  return shape.image([&](const Point<2> &z) { return Point<2>((z - shape.corners[0]) / size); });
}

using RulePoints = std::vector<std::pair<Point<2>, double>>;

/** Returns the points and weights of the rule behind edge k, an arc. */
RulePoints points_behind_arc(const CellShape &shape, const unsigned int k,
                             const unsigned int degree) {
  RulePoints points = ArcLift(shape.seen_from_crossing().edge(k), degree).points();
  for (auto &point : points)
    point.first += shape.crossing - Point<2>();
  return points;
}

/** Returns a rule on the four triangles between the edges of a cell, straight or arcs, and its
 * crossing z: x = z + t (γ(s) - z), on parts in which data is smooth. */
PlaneRule rule_on_triangles(const CellShape &shape, const BoxTree &boxes, const unsigned int n) {
  PlaneRule rule;
  for (unsigned int k = 0; k < 4; ++k) {
    const Curve edge = shape.edge(k);
    const auto image = [&](const Point<2> &at) {
      return shape.crossing + at[1] * (edge.point(at[0] * edge.length()) - shape.crossing);
    };
    for (const SquarePart &part : smooth_parts(boxes, image)) {
      const Quadrature<2> gauss = part.rule(n);
      for (unsigned int q = 0; q < gauss.size(); ++q) {
        const Point<2> at = part(gauss.point(q));
        const double s = at[0] * edge.length();
        rule.points.push_back(image(at));
        rule.weights.push_back(gauss.weight(q) * part.width * part.width * at[1] * edge.length() *
                               cross(edge.point(s) - shape.crossing, edge.tangent(s, 0.)));
      }
    }
  }
  return rule;
}

/** Returns the laws below and above those at all points of a part: where the law is not resolved,
 * energies are taken from above. */
std::pair<Law, Tensor<2, 3>> bounds_of_law(const Material<2> &material, const RulePoints &part) {
  Law softest(material.hooke(part.front().first));
  Tensor<2, 3> stiffest = softest.stiffness;
  for (auto point = part.begin() + 1; point != part.end(); ++point) {
    const Law law(material.hooke(point->first));
    softest.soften(law);
    stiffest = upper_bound(stiffest, law.stiffness);
  }
  return {softest, stiffest};
}
} // namespace

Vector CellFit::traces(const TractionSpace &space, const std::size_t number,
                       const Vector &x) const {
  // The conditions of arcs are traces, too.
  Vector y = space.traces(space.cells()[number], x);
  y.grow_or_shrink(shift.size());
  y -= shift;
  return y;
}

std::vector<Tensor<1, 2>> CellFit::force(const TractionCell &cell_data,
                                         const std::vector<Point<2>> &points) const {
  const CellShape &shape = cell_data.shape;
  std::vector<Tensor<1, 2>> f;
  f.reserve(points.size());
  for (const Point<2> &x : points)
    f.push_back(airy->value(load, airy->on_diagonals((x - shape.crossing) / size)) / size);
  return f;
}

unsigned int CellFit::load_degree() const {
  double largest = 0.;
  for (const Tensor<1, 2> &coefficient : load)
    largest = std::max(largest, coefficient.norm());
  unsigned int degree = 0;
  auto coefficient = load.begin();
  for (unsigned int i = 0; i < airy->degree(); ++i)
    for (unsigned int j = 0; i + j < airy->degree(); ++j)
      if ((coefficient++)->norm() > 1e-14 * largest)
        degree = std::max(degree, i + j);
  return degree;
}

CellFitter::CellFitter(const BoundData &data, const bool compares)
  : data_(data)
  , compares_(compares)
  , is_constant_(data.scene.material->is_constant_on_cells())
  , kinks_(data.scene.law_kinks) {}

std::array<std::vector<AiryPoint>, 4> CellFitter::make_points(const CellShape &shape,
                                                              const double size,
                                                              const unsigned int degree) const {
  const Material<2> &material = *data_.scene.material;
  // Squares of gradients of u_h have the degree 4 q - 2 on parallelograms; the part of more than
  // the degree q + 3 is small in σ(u_h) - τ. Where they are no polynomials, two degrees more.
  const bool is_polynomial = shape.affine && is_constant_;
  const unsigned int whole = std::min(4 * degree - 2, 2 * degree + 6) + (is_polynomial ? 0 : 4);
  std::map<unsigned int, Quadrature<2>> rules;
  const auto parts = triangle_parts(shape, kinks_);
  const Tensor<2, 2> inverse = invert(shape.half_diagonals());
  std::optional<Law> law;
  if (is_constant_)
    law.emplace(material.hooke(shape.crossing));
  std::array<std::vector<AiryPoint>, 4> points;
  const auto add_part = [&](const unsigned int k, const RulePoints &part, const bool is_rough) {
    std::optional<Law> softest = law;
    Tensor<2, 3> stiffest;
    if (is_rough)
      std::tie(softest, stiffest) = bounds_of_law(material, part);
    for (const auto &[at, weight] : part) {
      AiryPoint &point = points[k].emplace_back();
      point.reference = shape.reference(at - shape.corners[0]);
      point.on_diagonals = Point<2>(inverse * (at - shape.crossing));
      point.weight = weight / (size * size);
      const Law at_point = softest ? *softest : Law(material.hooke(at));
      const Tensor<2, 3> root = at_point.root();
      point.of_strain = std::sqrt(point.weight) * transpose(root);
      point.of_stress = std::sqrt(point.weight) * invert(root);
      if (is_rough)
        point.unresolved = point.weight * (stiffest - at_point.stiffness);
      point.min_eigenvalue = at_point.min_eigenvalue;
    }
  };
  for (unsigned int k = 0; k < 4; ++k) {
    if (shape.centres[k]) {
      add_part(k, points_behind_arc(shape, k, degree), false);
      continue;
    }
    for (const TrianglePart &part : parts[k]) {
      // On parts of half the size, two degrees less have the same effect.
      constexpr unsigned int least = 6;
      const unsigned int of_part = whole - std::min(whole - least, part.halvings);
      Quadrature<2> &rule = rules[of_part];
      if (rule.size() == 0)
        rule = triangle_rule(of_part);
      RulePoints rule_points;
      for (unsigned int q = 0; q < rule.size(); ++q)
        rule_points.emplace_back(point_of(part.corners, rule.point(q)),
                                 rule.weight(q) * twice_area(part.corners));
      add_part(k, rule_points, part.is_rough);
    }
  }
  return points;
}

CellFitter::Known &CellFitter::find_known(const TractionCell &cell_data, std::list<Known> &alone) {
  constexpr std::size_t max_known = 256;
  const CellShape &shape = cell_data.shape;
  const auto x = at_unit_size(shape, shape.diameter()).corners;
  const std::array<Tensor<1, 2>, 3> edges = {{x[1] - x[0], x[2] - x[0], x[3] - x[0]}};
  const SymmetricTensor<4, 2> hooke =
    is_constant_ ? data_.scene.material->hooke(shape.crossing) : SymmetricTensor<4, 2>();
  for (Known &other : known_)
    if (other.degree == cell_data.degree && other.hooke == hooke && !shape.has_arcs() &&
        std::equal(edges.begin(), edges.end(), other.edges.begin(),
                   [](const auto &a, const auto &b) { return (a - b).norm() < 1e-12; })) {
      ++other.n_cells;
      return other;
    }
  const bool is_alone = !is_constant_ || shape.has_arcs() || known_.size() == max_known;
  return (is_alone ? alone : known_).emplace_back(cell_data.degree, shape, edges, hooke);
}

Vector CellFitter::stress_of_u(const Cell &cell, const CellShape &shape, Known &known,
                               CellFit &fit) const {
  const CellField u(data_.space.dof_cell(cell), data_.U);
  std::unique_lock<std::mutex> lock(known.mutex);
  auto &[along_x, along_y] = known.tables[u.degree()];
  if (along_x.values.empty()) {
    std::array<std::vector<double>, 2> at;
    for (const auto &triangle : known.airy->points())
      for (const AiryPoint &point : triangle)
        for (unsigned int d = 0; d < 2; ++d)
          at[d].push_back(point.reference[d]);
    along_x = make_line_table(u.degree(), at[0]);
    along_y = make_line_table(u.degree(), at[1]);
  }
  lock.unlock();
  Vector values(3 * known.airy->n_points());
  unsigned int q = 0;
  for (const auto &triangle : known.airy->points())
    for (const AiryPoint &point : triangle) {
      const Tensor<2, 2> gradient =
        u.gradient(along_x, along_y, q) * invert(shape.jacobian(CellFunctions(point.reference)));
      const Components strain = components_of(strain_of(gradient)),
                       weighted = point.of_strain * strain;
      fit.unresolved += strain * (point.unresolved * strain);
      for (unsigned int c = 0; c < 3; ++c)
        values[3 * q + c] = weighted[c];
      ++q;
    }
  return values;
}

void CellFitter::project_load(const CellShape &shape, const PlaneRule &rule, CellFit &fit) const {
  std::vector<Point<2>> points;
  std::vector<double> weights;
  std::vector<Tensor<1, 2>> forces;
  std::vector<Vector> f(rule.points.size(), Vector(2));
  data_.scene.body_force->vector_value_list(rule.points, f);
  for (std::size_t q = 0; q < f.size(); ++q) {
    points.push_back(fit.airy->on_diagonals((rule.points[q] - shape.crossing) / fit.size));
    weights.push_back(rule.weights[q] / (fit.size * fit.size));
    forces.emplace_back(Tensor<1, 2>({f[q][0], f[q][1]}) * fit.size);
  }
  double rest = 0.;
  fit.load = fit.airy->project(points, weights, forces, rest);
  fit.load_rest = std::sqrt(rest);
}

PlaneRule CellFitter::load_rule(const Cell &cell, const CellShape &shape,
                                const CellFit &fit) const {
  // Products of f_K with itself, and f of as many degrees more as f_K has.
  const unsigned int n = fit.airy->degree() + 4;
  if (shape.has_arcs())
    return rule_on_triangles(shape, data_.scene.kinks.boxes(), n);
  if (needs_cuts<2>(data_.scene.kinks, cell))
    return cut_rule(data_.scene.kinks, shape.corners, n);
  // Such a rule resolves smooth data in a quarter of the body, see scan_data().
  const Geometry<2> &body = data_.scene.geometry;
  const bool is_wide =
    !is_constant(*data_.scene.body_force) && cell->diameter() > 0.4 * body.shortest_extent();
  std::unique_lock<std::mutex> lock(load_rules_mutex_);
  Quadrature<2> &plain = load_rules_[is_wide ? 4 * n : n];
  if (plain.size() == 0)
    plain = QIterated<2>(QGauss<1>(n), is_wide ? 4 : 1);
  lock.unlock();
  PlaneRule rule;
  for (unsigned int q = 0; q < plain.size(); ++q) {
    const CellFunctions functions(plain.point(q));
    rule.points.push_back(shape.point(functions));
    rule.weights.push_back(plain.weight(q) * determinant(shape.jacobian(functions)));
  }
  return rule;
}

Vector CellFitter::subtract_load(const Cell &cell, const CellShape &shape, Vector &values,
                                 CellFit &fit) const {
  if (data_.scene.body_force == nullptr)
    return Vector(fit.airy->n_traces());
  project_load(shape, load_rule(cell, shape, fit), fit);
  return fit.airy->subtract_load(fit.load, values);
}

Vector CellFitter::subtract_given(const TractionSpace &space, const TractionCell &cell_data,
                                  Vector &values, const AiryCell &airy) const {
  const CellShape &shape = cell_data.shape;
  Vector traces(airy.n_traces()), t(2);
  for (unsigned int k = 0; k < 4; ++k) {
    const unsigned int side = space.edges()[cell_data.sides[k].edge].side;
    if (!shape.centres[k] || data_.scene.boundary[side].role != Role::traction)
      continue;
    const Function<2> &given = *data_.scene.boundary[side].data;
    std::vector<Tensor<1, 2>> r;
    for (const ArcLift::Node &node : airy.lift(k)->nodes()) {
      const Tensor<1, 2> from_crossing = shape.diameter() * node.x;
      given.vector_value(shape.crossing + from_crossing, t);
      r.emplace_back(Tensor<1, 2>({t[0], t[1]}));
    }
    traces += airy.subtract_traction(k, r, values);
  }
  return traces;
}

CellFit CellFitter::fit(const Cell &cell, const TractionSpace &space, Known &known) const {
  const TractionCell &cell_data = space.cells()[cell->active_cell_index()];
  std::call_once(known.is_made, [&]() {
    const double size = known.shape.diameter();
    known.airy = std::make_shared<AiryCell>(at_unit_size(known.shape, size), known.degree,
                                            make_points(known.shape, size, known.degree));
  });
  const CellShape &shape = cell_data.shape;
  CellFit fit;
  fit.id = cell->id();
  fit.size = shape.diameter();
  fit.airy = known.airy;
  Vector values(3 * fit.airy->n_points());
  if (compares_)
    values = stress_of_u(cell, shape, known, fit);
  fit.shift = subtract_load(cell, shape, values, fit);
  fit.shift += subtract_given(space, cell_data, values, *fit.airy);
  // The second projection removes the rounding of the first.
  for (unsigned int pass = 0; pass < 2 && !values.all_zero(); ++pass)
    fit.shift += fit.airy->project(values);
  fit.rest = values.l2_norm();
  fit.min_eigenvalue = fit.airy->points()[0][0].min_eigenvalue;
  for (const auto &triangle : fit.airy->points())
    for (const AiryPoint &point : triangle)
      fit.min_eigenvalue = std::min(fit.min_eigenvalue, point.min_eigenvalue);
  if (known.n_cells == 1) {
    known.airy->forget_points();
    known.tables.clear();
  }
  return fit;
}

std::vector<CellFit> CellFitter::fit_all(const EquilibrationMesh &mesh, const TractionSpace &space,
                                         const std::vector<CellFit> &known) {
  std::map<CellId, const CellFit *> found;
  for (const CellFit &fit : known)
    found[fit.id] = &fit;
  std::vector<CellFit> fits(space.cells().size());
  std::vector<Cell> fresh;
  for (const auto &cell : mesh.triangulation().active_cell_iterators()) {
    const unsigned int number = cell->active_cell_index();
    const auto same = found.find(cell->id());
    if (same != found.end() && same->second->airy->degree() == space.cells()[number].degree)
      fits[number] = *same->second;
    else
      fresh.push_back(cell);
  }
  // Threads must not decide which cell of a shape is the first: the others share its results.
  std::list<Known> alone;
  std::vector<Known *> shared;
  shared.reserve(fresh.size());
  for (const Cell &cell : fresh)
    shared.push_back(&find_known(space.cells()[cell->active_cell_index()], alone));
  work_on_ranges(n_available_threads(), fresh.size(),
                 [&](const std::size_t begin, const std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const unsigned int number = fresh[i]->active_cell_index();
                     fits[number] = fit(fresh[i], space, *shared[i]);
                   }
                 });
  known_.remove_if([](const Known &known) { return known.n_cells == 1; });
  return fits;
}
} // namespace Signorini
