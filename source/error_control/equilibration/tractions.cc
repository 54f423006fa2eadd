// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions that sides prescribe: those of traction sides, and the forces on plates.

#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/tractions.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns the norm of the remainder of a projection, from the squares of the norms of a traction
 * and of its projection. */
double norm_of_rest(const double square, const double of_projection) {
  // The root of rounding is not rounding.
  const double rest = square - of_projection;
  return rest > 1e-14 * square ? std::sqrt(rest) : 0.;
}
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
  rests.fill(std::vector<double>(space.edges().size(), 0.));
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
          rests[c][number] += measure_at(rule, q) * parts[c] * parts[c];
          for (unsigned int i = 0; i <= edge.degree; ++i)
            x[edge.position(c, i)] += measure_at(rule, q) / edge.length() * L[i] * parts[c];
        }
      }
    }
  for (unsigned int c = 0; c < 2; ++c)
    for (std::size_t number = 0; number < space.edges().size(); ++number)
      if (double &rest = rests[c][number]; rest > 0.) {
        double of_projection = 0.;
        for (const double coefficient : on_edge(number, c))
          of_projection += space.edges()[number].length() * coefficient * coefficient;
        rest = norm_of_rest(rest, of_projection);
      }
}

void Tractions::project_shared() {
  for (std::size_t number = 0; number < space.edges().size(); ++number)
    for (unsigned int c = 0; c < 2; ++c) {
      const std::vector<SharedPart> &parts = space.shared_parts(number);
      if (parts.empty())
        continue;
      const TractionEdge &edge = space.edges()[number];
      Vector own(edge.degree + 1);
      double square = 0.;
      for (const SharedPart &part : parts) {
        const std::vector<double> q = on_edge(part.shared, c);
        part.R.vmult_add(own, Vector(q.begin(), q.end()));
        square += part.square(q);
      }
      std::copy(own.begin(), own.end(), x.begin() + edge.position(c, 0));
      rests[c][number] = norm_of_rest(edge.length() * square, edge.length() * own.norm_sqr());
    }
}

void Tractions::add_plates(const Scene<2> &scene) {
  for (const Plate &plate : scene.plates) {
    TractionCondition force, cross_force, moment;
    for (const TractionEdge &edge : space.edges()) {
      if (edge.side != plate.side)
        continue;
      const std::vector<Tensor<1, 3>> sums = edge.resultants(scene.geometry, plate.centre);
      for (unsigned int i = 0; i < sums.size(); ++i) {
        const Tensor<1, 2> sum({sums[i][0], sums[i][1]});
        const double rounding = 1e-13 * edge.length();
        for (const auto &[condition, part] : {std::pair(&force, sum * plate.direction),
                                              std::pair(&cross_force, sum * plate.across())})
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
