// SPDX-License-Identifier: LGPL-2.1-or-later
// Tractions on contact edges that do not pull, and shears within the bound of friction.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/error_control/equilibration/carrier.h>
#include <signorini/error_control/equilibration/contact_tractions.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
ContactTractions::ContactTractions(const BoundData &data, Tractions &tractions)
  : data_(data)
  , tractions_(tractions) {
  for (const ContactFace<2> &face : data_.multipliers.surface().faces())
    edges_.push_back(tractions_.space.contact_edge_at(face.cell, face.face_no));
  for (const Piece<2> &piece : data_.multipliers.surface().pieces())
    pieces_.push_back(
      {piece, edges_[seen_from_carrier(data_.multipliers.surface(), piece).own.face]});
  const std::vector<NodeState> states = patch_states(data_.multipliers, data_.P);
  for (const auto &[edge, presses] : edges_inside(states, Component::normal)) {
    press_by_multipliers(edge);
    // With Coulomb's law the bound of friction needs a τ_n that is known.
    tractions_.space.set_free(edge, 0, presses && !data_.P.is_coupled());
  }
  if (data_.has_tangential_part())
    give_tangential_part(states);
  tractions_.project_shared();
}

std::map<unsigned int, bool> ContactTractions::edges_inside(const std::vector<NodeState> &states,
                                                            const Component component) const {
  std::map<unsigned int, bool> inside;
  for (const auto &[piece, edge] : pieces_) {
    if (tractions_.space.edges()[edge].mixes)
      continue;
    bool &on_edge = inside.emplace(edge, true).first->second;
    on_edge = on_edge && follows(states[piece.patch], component);
  }
  const std::map<unsigned int, bool> whole = inside;
  for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
    if (const unsigned int edge = edges_[i], next = edges_[i + 1];
        whole.count(edge) > 0 && whole.count(next) > 0 &&
        tractions_.space.edges()[edge].side == tractions_.space.edges()[next].side &&
        !(whole.at(edge) && whole.at(next)))
      inside[edge] = inside[next] = false;
  return inside;
}

std::vector<double> ContactTractions::projection_of(const unsigned int number,
                                                    const unsigned int component) const {
  const TractionEdge &edge = tractions_.space.edges()[number];
  std::vector<double> sum(edge.degree + 1, 0.);
  for (const PieceOfEdge &of_edge : pieces_) {
    if (of_edge.edge != number)
      continue;
    const Piece<2> &piece = of_edge.piece;
    const ContactSurface<2> &surface = data_.multipliers.surface();
    const Side<2> &side = surface.side(surface.patches()[piece.patch]);
    const double from = edge.position_of(side.point(piece.lower[0])),
                 to = edge.position_of(side.point(piece.upper[0]));
    const std::vector<double> part = legendre_projection(
      edge.degree,
      split_quadrature(QGauss<1>(edge.degree + 1), {std::min(from, to), std::max(from, to)}),
      [&](const double s) {
        const double share = (s - from) / (to - from);
        return data_.multipliers.value(data_.P.values(), piece.patch,
                                       piece.lower + share * (piece.upper - piece.lower),
                                       component);
      });
    std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

void ContactTractions::press_by_multipliers(const unsigned int number) {
  std::vector<double> p = projection_of(number, 0), b = bernstein_coefficients(p);
  if (*std::max_element(b.begin(), b.end()) > 0.) {
    // The same force, where it presses: the mean of the coefficients is that of the polynomial.
    const double force = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value = std::min(0., value);
    const double pressing = std::accumulate(b.begin(), b.end(), 0.);
    for (double &value : b)
      value *= force < 0. ? force / pressing : 0.;
    p = legendre_coefficients(b);
  }
  tractions_.fix(number, 0, p);
}

double ContactTractions::tangential_bound(const unsigned int number, const double s) const {
  const TractionEdge &edge = tractions_.space.edges()[number];
  return tangential_bound_at(
    data_.scene, edge.side, edge.point(s),
    bernstein_value(bernstein_coefficients(tractions_.on_edge(number, 0)), s));
}

std::vector<double> ContactTractions::lower_tangential_bound(const unsigned int number) {
  const TractionEdge &edge = tractions_.space.edges()[number];
  const std::vector<double> cuts =
    data_.scene.kinks.cut(point_of_data(data_.scene, edge.side, edge.line.start()),
                          point_of_data(data_.scene, edge.side, edge.line.end()));
  // About 20000 points on all edges; at a jump, on both sides of it.
  const unsigned int degree = edge.degree,
                     n = std::clamp<std::size_t>(20000 / edges_.size() / cuts.size(), 16, 256);
  constexpr double inside = 1e-9;
  std::vector<double> positions, samples;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
    for (unsigned int i = 0; i <= n; ++i)
      positions.push_back(cuts[k] + (cuts[k + 1] - cuts[k]) *
                                      std::clamp(static_cast<double>(i) / n, inside, 1. - inside));
  for (const double s : positions)
    samples.push_back(tangential_bound(number, s));
  std::vector<double> b = bernstein_coefficients(
    legendre_projection(degree, split_quadrature(QGauss<1>(2 * degree + 1), cuts),
                        [&](const double s) { return tangential_bound(number, s); }));
  constexpr double rounding = 1e-13;
  const auto [least, largest] = std::minmax_element(samples.begin(), samples.end());
  double share = 1.;
  for (double &value : b)
    if (value < 0.) {
      share = value < -rounding * *largest ? 0. : share;
      value = 0.;
    }
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (const double value = bernstein_value(b, positions[i]); value > (1. + rounding) * samples[i])
      share = std::min(share, samples[i] / value);
  const double mean = std::accumulate(b.begin(), b.end(), 0.) / b.size();
  constexpr double far_below = 0.98;
  if (std::max(share * mean, *least) < far_below * mean)
    unresolved_.insert(number);
  if (share * mean < *least)
    return std::vector<double>(degree + 1, *least);
  for (double &value : b)
    value *= share;
  return b;
}

void ContactTractions::give_tangential_part(const std::vector<NodeState> &of_patches) {
  for (const auto &[piece, edge] : pieces_) {
    const State state = of_patches[piece.patch].slip;
    State &on_edge = slips_.emplace(edge, state).first->second;
    on_edge = on_edge == state ? state : State::mixed;
  }
  for (const auto &[edge, is_free] : edges_inside(of_patches, Component::tangential)) {
    bounds_[edge] = lower_tangential_bound(edge);
    rub_by_multipliers(edge);
    tractions_.space.set_free(edge, 1, is_free);
  }
}

void ContactTractions::rub_by_multipliers(const unsigned int number) {
  const std::vector<double> &bound = bounds_.at(number);
  std::vector<double> b = bernstein_coefficients(projection_of(number, 1));
  const State state = slips_.at(number);
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = state == State::upper   ? bound[i]
           : state == State::lower ? -bound[i]
                                   : std::clamp(b[i], -bound[i], bound[i]);
  tractions_.fix(number, 1, legendre_coefficients(b));
}

bool ContactTractions::is_admissible(const unsigned int number,
                                     const unsigned int component) const {
  const std::vector<double> b = bernstein_coefficients(tractions_.on_edge(number, component));
  for (std::size_t i = 0; i < b.size(); ++i)
    if (component == 0 ? b[i] > 0. : std::abs(b[i]) > bounds_.at(number)[i])
      return false;
  return true;
}

bool ContactTractions::fix_pulling_edges() {
  bool fixed = false;
  for (const unsigned int number : edges_)
    for (unsigned int c = 0; c < 2 && number != TractionSpace::none; ++c)
      if (tractions_.space.edges()[number].is_free[c] && !is_admissible(number, c)) {
        if (c == 0)
          press_by_multipliers(number);
        else
          rub_by_multipliers(number);
        fixed = true;
      }
  return fixed;
}
} // namespace Signorini
