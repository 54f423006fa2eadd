// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions that sides prescribe: those of traction sides, and the forces on plates.

#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/tractions.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
namespace {
/** Returns the norm of the remainder of a projection, from the squares of the norms of a traction
 * and of its projection. */
double norm_of_rest(const double square, const double of_projection) {
  // The root of rounding is not rounding.
  const double rest = square - of_projection;
  return rest > 1e-14 * square ? std::sqrt(rest) : 0.;
}

/** A polynomial on an interval by its coefficients of Legendre's P_k. */
struct LocalPolynomial {
  /** Returns its integral, which has the value @p start at the start. */
  LocalPolynomial integral(const double start) const {
    LocalPolynomial result = {width, std::vector<double>(legendre.size() + 1)};
    for (std::size_t k = 0; k < legendre.size(); ++k) {
      const double part = 0.5 * width * legendre[k] / (2. * k + 1.);
      result.legendre[k + 1] += part;
      if (k > 0)
        result.legendre[k - 1] -= part;
    }
    result.legendre[0] = start;
    for (std::size_t k = 1; k < result.legendre.size(); ++k)
      result.legendre[0] -= (k % 2 == 0 ? 1. : -1.) * result.legendre[k];
    return result;
  }
  double end() const {
    return std::accumulate(legendre.begin(), legendre.end(), 0.);
  }
  double square() const {
    double sum = 0.;
    for (std::size_t k = 0; k < legendre.size(); ++k)
      sum += width * legendre[k] * legendre[k] / (2. * k + 1.);
    return sum;
  }

  double width;
  std::vector<double> legendre;
};
} // namespace

Tractions::Tractions(const BoundData &data, const EquilibrationMesh &mesh)
  : space(mesh, data.scene)
  , x(space.n_coefficients()) {
  project_given(data);
  add_plates(data.scene);
}

std::vector<double> Tractions::on_edge(const unsigned int edge,
                                       const unsigned int component) const {
  AssertIndexRange(edge, space.edges().size());
  const auto first = x.begin() + space.edges()[edge].position(component, 0);
  return {first, first + space.edges()[edge].degree + 1};
}

void Tractions::fix(const unsigned int edge, const unsigned int component,
                    const std::vector<double> &legendre) {
  AssertIndexRange(edge, space.edges().size());
  space.set_free(edge, component, false);
  std::copy(legendre.begin(), legendre.end(),
            x.begin() + space.edges()[edge].position(component, 0));
}

void Tractions::project_given(const BoundData &data) {
  // About 20000 points on all faces, unless t is constant: narrow tractions are seen.
  const auto is_loaded = [&data](const auto &face) {
    return face->at_boundary() && data.scene.boundary[face->boundary_id()].role == Role::traction;
  };
  unsigned int n_faces = 0;
  for (const auto &face : data.space.mesh().triangulation().active_face_iterators())
    if (is_loaded(face) && !is_constant(*data.scene.boundary[face->boundary_id()].data))
      ++n_faces;
  const unsigned int n_points = n_faces > 0 ? std::clamp(20000 / n_faces, 6U, 96U) : 6;
  FaceValues<2> values(StaticMappingQ1<2>::mapping, data.space, data.scene.kinks, n_points,
                       update_quadrature_points | update_JxW_values | update_normal_vectors);
  Vector t(2);
  std::array<std::vector<double>, 2> squares;
  squares.fill(std::vector<double>(space.edges().size(), 0.));
  rests.fill(std::vector<TractionRest>(space.edges().size()));
  for (const auto &cell : data.space.mesh().triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      if (!is_loaded(cell->face(f)))
        continue;
      const unsigned int number = space.edge_at(cell, f);
      const TractionEdge &edge = space.edges()[number];
      // On arcs cells lift the traction itself.
      if (!edge.line.is_flat())
        continue;
      const FEFaceValues<2> &rule = values.reinit(cell, f, data.scene.geometry.sides[edge.side]);
      for (const unsigned int q : rule.quadrature_point_indices()) {
        data.scene.boundary[edge.side].data->vector_value(rule.quadrature_point(q), t);
        const Tensor<1, 2> &n = rule.normal_vector(q);
        const std::array<double, 2> parts = {
          {n[0] * t[0] + n[1] * t[1], n[0] * t[1] - n[1] * t[0]}};
        const auto L = legendre_values(edge.degree, edge.position_of(rule.quadrature_point(q)));
        for (unsigned int c = 0; c < 2; ++c) {
          squares[c][number] += measure_at(rule, q) * parts[c] * parts[c];
          for (unsigned int i = 0; i <= edge.degree; ++i)
            x[edge.position(c, i)] += measure_at(rule, q) / edge.length() * L[i] * parts[c];
        }
      }
    }
  for (unsigned int c = 0; c < 2; ++c)
    for (std::size_t number = 0; number < space.edges().size(); ++number)
      if (const double square = squares[c][number]; square > 0.) {
        const double length = space.edges()[number].length();
        double of_projection = 0.;
        for (const double coefficient : on_edge(number, c))
          of_projection += length * coefficient * coefficient;
        rests[c][number] = TractionRest::of_norm(norm_of_rest(square, of_projection), length);
      }
}

TractionRest Tractions::rest_of_pair(const unsigned int number, const unsigned int c) const {
  const std::vector<double> own = on_edge(number, c);
  const std::vector<SharedPart> &parts = space.shared_parts(number);
  std::vector<double> cuts = {0., 1.};
  unsigned int degree = own.size() - 1;
  for (const SharedPart &part : parts) {
    cuts.insert(cuts.end(), {part.from, part.to});
    degree = std::max(degree, space.edges()[part.shared].degree);
  }
  std::sort(cuts.begin(), cuts.end());
  const QGauss<1> gauss(degree + 1);
  double size = 0., norm = 0., slope = 0., primitive = 0., first = 0., second = 0.;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double from = cuts[i], width = cuts[i + 1] - from, middle = from + 0.5 * width;
    if (width == 0.)
      continue;
    const auto part = std::find_if(parts.begin(), parts.end(), [middle](const SharedPart &part) {
      return part.from < middle && middle < part.to;
    });
    const std::vector<double> q =
      part == parts.end() ? std::vector<double>(1, 0.) : on_edge(part->shared, c);
    LocalPolynomial r = {width, legendre_projection(degree, gauss, [&](const double s) {
                           const double at = from + s * width;
                           const double on_shared =
                             part == parts.end() ? 0. : part->position_on_shared(at);
                           const std::vector<double> L = legendre_values(own.size() - 1, at),
                                                     M = legendre_values(q.size() - 1, on_shared);
                           return std::inner_product(M.begin(), M.end(), q.begin(), 0.) -
                                  std::inner_product(L.begin(), L.end(), own.begin(), 0.);
                         })};
    for (std::size_t k = 0; k < r.legendre.size(); ++k)
      r.legendre[k] *= std::sqrt(2. * k + 1.);
    const LocalPolynomial F_1 = r.integral(first), F = F_1.integral(second);
    first = F_1.end();
    second = F.end();
    norm += r.square();
    slope += F_1.square();
    primitive += F.square();
    size += width * std::inner_product(q.begin(), q.end(), q.begin(), 0.);
  }
  const double length = space.edges()[number].length();
  constexpr double rounding = 1e-13;
  if (norm <= rounding * rounding * size)
    return {};
  return {std::sqrt(length * norm), std::pow(length, 1.5) * std::sqrt(slope),
          std::pow(length, 2.5) * std::sqrt(primitive)};
}

void Tractions::project_shared() {
  for (std::size_t number = 0; number < space.edges().size(); ++number)
    for (unsigned int c = 0; c < 2; ++c) {
      const std::vector<SharedPart> &parts = space.shared_parts(number);
      if (parts.empty())
        continue;
      const TractionEdge &edge = space.edges()[number];
      Vector own(edge.degree + 1);
      for (const SharedPart &part : parts) {
        const std::vector<double> q = on_edge(part.shared, c);
        part.R.vmult_add(own, Vector(q.begin(), q.end()));
      }
      std::copy(own.begin(), own.end(), x.begin() + edge.position(c, 0));
      rests[c][number] = rest_of_pair(number, c);
    }
}

void Tractions::add_plates(const Scene<2> &scene) {
  for (const Plate<2> &plate : scene.plates) {
    TractionCondition force, cross_force, moment;
    for (const TractionEdge &edge : space.edges()) {
      if (edge.side != plate.side)
        continue;
      const std::vector<Tensor<1, 3>> sums = edge.resultants(scene.geometry, plate.centre);
      for (unsigned int i = 0; i < sums.size(); ++i) {
        const Tensor<1, 2> sum({sums[i][0], sums[i][1]});
        const double rounding = 1e-13 * edge.length();
        for (const auto &[condition, part] : {std::pair(&force, sum * plate.direction),
                                              std::pair(&cross_force, sum * plate.across()[0])})
          if (std::abs(part) > rounding)
            condition->row.emplace_back(edge.first + i, part);
        if (std::abs(sums[i][2]) > rounding * sums[0].norm())
          moment.row.emplace_back(edge.first + i, sums[i][2]);
      }
    }
    const auto add = [this](TractionCondition condition, const double value) {
      double square = 0.;
      for (const auto &entry : condition.row)
        square += entry.second * entry.second;
      for (auto &entry : condition.row)
        entry.second /= std::sqrt(square);
      condition.value = value / std::sqrt(square);
      conditions.push_back(std::move(condition));
    };
    if (plate.is_pushed)
      add(std::move(force), plate.force);
    if (plate.drifts)
      add(std::move(cross_force), plate.cross_force);
    if (plate.turns)
      add(std::move(moment), plate.moment);
  }
}
} // namespace Signorini
