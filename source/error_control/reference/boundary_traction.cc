// SPDX-License-Identifier: LGPL-2.1-or-later
// The traction of a stress on the boundary, and its work on displacements of any mesh.

#include <signorini/error_control/equilibration/carrier.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/reference/boundary_traction.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace Signorini {
namespace {
using Coefficients = std::array<std::vector<double>, 2>;

/** Returns the coefficients of τ_n and τ_t of an edge. */
Coefficients coefficients_of(const TractionEdge &edge, const dealii::Vector<double> &x) {
  Coefficients coefficients;
  for (unsigned int c = 0; c < 2; ++c)
    for (unsigned int i = 0; i <= edge.degree; ++i)
      coefficients[c].push_back(x[edge.position(c, i)]);
  return coefficients;
}

double sum_of(const std::vector<double> &coefficients, const std::vector<double> &values) {
  return std::inner_product(coefficients.begin(), coefficients.end(), values.begin(), 0.);
}

/** Returns the coefficients on a part of an edge, between two of its positions. */
Coefficients restricted(const Coefficients &whole, const double from, const double to) {
  const unsigned int degree = static_cast<unsigned int>(whole[0].size()) - 1;
  Coefficients part;
  for (unsigned int c = 0; c < 2; ++c)
    part[c] = legendre_projection(degree, QGauss<1>(degree + 1), [&](const double t) {
      return sum_of(whole[c], legendre_values(degree, from + t * (to - from)));
    });
  return part;
}
} // namespace

BoundaryTraction::BoundaryTraction(const Tractions &tractions, const Scene<2> &scene)
  : parts_(scene.boundary.size()) {
  const std::vector<TractionEdge> &edges = tractions.space.edges();
  for (unsigned int e = 0; e < edges.size(); ++e) {
    const TractionEdge &edge = edges[e];
    if (edge.side == TractionEdge::no_side || edge.is_shared)
      continue;
    const Role role = scene.boundary[edge.side].role;
    if (role != Role::traction && role != Role::free)
      add_edge(tractions.space, tractions.x, e, scene.geometry.sides[edge.side]);
  }
  for (std::vector<Part> &parts : parts_)
    std::sort(parts.begin(), parts.end(),
              [](const Part &a, const Part &b) { return a.from < b.from; });
}

void BoundaryTraction::add_edge(const TractionSpace &space, const dealii::Vector<double> &x,
                                const unsigned int number, const Side<2> &side) {
  const TractionEdge &edge = space.edges()[number];
  const SideSpan span(side, edge.line);
  const auto add = [&](const double from, const double to, const Coefficients &coefficients) {
    const double first = span.arc_length(from), last = span.arc_length(to);
    parts_[edge.side].push_back({std::min(first, last), std::max(first, last),
                                 first > last ? restricted(coefficients, 1., 0.) : coefficients,
                                 edge.direction});
  };
  const std::vector<SharedPart> &shared = space.shared_parts(number);
  if (shared.empty())
    add(0., 1., coefficients_of(edge, x));
  for (const SharedPart &part : shared)
    add(
      part.from, part.to,
      restricted(coefficients_of(space.edges()[part.shared], x), part.shared_from, part.shared_to));
}

double BoundaryTraction::work(const BoundaryTrace &v, const std::vector<Side<2>> &sides) const {
  AssertIndexRange(v.side, parts_.size());
  const Side<2> &side = sides[v.side];
  thread_local std::map<unsigned int, QGauss<1>> rules;
  // Directions on arcs take more points than polynomials.
  const unsigned int more = side.is_flat() ? 0 : 8;
  double work = 0.;
  for (const double shift : side.is_closed()
                              ? std::vector<double>{-side.length(), 0., side.length()}
                              : std::vector<double>{0.})
    for (const Part &part : parts_[v.side]) {
      const double length = part.to - part.from,
                   first = std::max(0., (v.from + shift - part.from) / length),
                   last = std::min(1., (v.to + shift - part.from) / length);
      if (first >= last)
        continue;
      const unsigned int degree = static_cast<unsigned int>(part.coefficients[0].size()) - 1,
                         n_points =
                           (degree + static_cast<unsigned int>(v.values.size())) / 2 + 1 + more;
      const QGauss<1> &rule = rules.try_emplace(n_points, n_points).first->second;
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const double t = first + rule.point(q)[0] * (last - first),
                     s = part.from + t * length - shift;
        const std::vector<double> L = legendre_values(degree, t);
        const Tensor<1, 2> n = side.normal(s, 0.5 * (v.from + v.to)), value = v.value(s);
        for (unsigned int c = 0; c < 2; ++c)
          work += rule.weight(q) * (last - first) * length * sum_of(part.coefficients[c], L) *
                  (direction_of(contact_components[c], part.direction.value_or(n)) * value);
      }
    }
  return work;
}

std::size_t BoundaryTraction::size() const {
  std::size_t sum = 0;
  for (const std::vector<Part> &parts : parts_)
    sum += parts.size();
  return sum;
}
} // namespace Signorini
