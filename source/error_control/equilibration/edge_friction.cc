// SPDX-License-Identifier: LGPL-2.1-or-later
// The shear on contact edges, within the bound of friction, and polynomials between bounds.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/bernstein.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/postprocessing/fields/forces.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
std::vector<double> bernstein_coefficients(const std::vector<double> &legendre) {
  const unsigned int n = legendre.size() - 1;
  std::vector<double> sum(n + 1, 0.);
  for (unsigned int k = 0; k <= n; ++k) {
    // P_k has the coefficients (-1)^{k-i} (k choose i); then the degree is raised to n.
    std::vector<double> b = {k % 2 == 0 ? 1. : -1.};
    for (unsigned int i = 1; i <= k; ++i)
      b.push_back(-b.back() * (k - i + 1) / i);
    for (unsigned int degree = k; degree < n; ++degree) {
      std::vector<double> raised(degree + 2);
      for (unsigned int i = 0; i <= degree + 1; ++i)
        raised[i] = (i > 0 ? b[i - 1] * i / (degree + 1.) : 0.) +
                    (i <= degree ? b[i] * (degree + 1. - i) / (degree + 1.) : 0.);
      b = std::move(raised);
    }
    for (unsigned int i = 0; i <= n; ++i)
      sum[i] += std::sqrt(2. * k + 1.) * legendre[k] * b[i];
  }
  return sum;
}

namespace {
double bernstein_value(std::vector<double> b, const double s) {
  for (; b.size() > 1; b.pop_back())
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      b[i] = (1. - s) * b[i] + s * b[i + 1];
  return b[0];
}

/** Returns the projection of a function on [0,1], by the rule @p gauss. */
template <typename Function>
std::vector<double> project(const unsigned int degree, const Quadrature<1> &gauss,
                            const Function &function) {
  std::vector<double> sum(degree + 1, 0.);
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const double s = gauss.point(q)[0], value = gauss.weight(q) * function(s);
    const auto L = legendre_values(degree, s);
    for (unsigned int i = 0; i <= degree; ++i)
      sum[i] += value * L[i];
  }
  return sum;
}
} // namespace

std::vector<double> legendre_coefficients(const std::vector<double> &bernstein) {
  return project(bernstein.size() - 1, QGauss<1>(bernstein.size()),
                 [&](const double s) { return bernstein_value(bernstein, s); });
}

double BestStress::friction_bound(const unsigned int number, const double s) const {
  const TractionEdge &edge = mesh_->edges()[number];
  const double given =
    data_.scene.boundary[edge.side].friction->value(edge.start + s * (edge.end - edge.start));
  if (!data_.P.is_coupled())
    return given;
  return given * std::abs(bernstein_value(bernstein_coefficients(coefficients(number, 0)), s));
}

std::vector<double> BestStress::lower_friction_bound(const unsigned int number) {
  const TractionEdge &edge = mesh_->edges()[number];
  const std::vector<double> cuts = data_.scene.kinks.cut(edge.start, edge.end);
  // About 20000 points on all edges; at a jump, on both sides of it.
  const unsigned int degree = edge.degree, n = std::clamp<std::size_t>(
                                             20000 / contact_edges_.size() / cuts.size(), 16, 256);
  constexpr double inside = 1e-9;
  std::vector<double> positions, samples;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
    for (unsigned int i = 0; i <= n; ++i)
      positions.push_back(cuts[k] + (cuts[k + 1] - cuts[k]) *
                                      std::clamp(static_cast<double>(i) / n, inside, 1. - inside));
  for (const double s : positions)
    samples.push_back(friction_bound(number, s));
  std::vector<double> b =
    bernstein_coefficients(project(degree, split_quadrature(QGauss<1>(2 * degree + 1), cuts),
                                   [&](const double s) { return friction_bound(number, s); }));
  constexpr double rounding = 1e-13;
  const auto [least, largest] = std::minmax_element(samples.begin(), samples.end());
  double share = 1.;
  for (double &value : b)
    if (value < 0.) {
      share = value < -rounding * *largest ? 0. : share;
      value = 0.;
    }
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (const double here = bernstein_value(b, positions[i]); here > (1. + rounding) * samples[i])
      share = std::min(share, samples[i] / here);
  const double mean = std::accumulate(b.begin(), b.end(), 0.) / b.size();
  constexpr double far_below = 0.98;
  if (std::max(share * mean, *least) < far_below * mean)
    unresolved_friction_.insert(number);
  if (share * mean < *least)
    return std::vector<double>(degree + 1, *least);
  for (double &value : b)
    value *= share;
  return b;
}

void BestStress::give_friction() {
  const std::vector<NodeState> of_patches = patch_states(data_.multipliers, data_.P);
  slips_.clear();
  friction_bounds_.clear();
  unresolved_friction_.clear();
  for (const Piece<2> &piece : data_.multipliers.surface().pieces()) {
    const State state = of_patches[piece.patch].slip;
    State &on_edge = slips_.emplace(contact_edges_[piece.face], state).first->second;
    on_edge = on_edge == state ? state : State::mixed;
  }
  std::map<unsigned int, bool> is_free;
  for (const auto &[edge, state] : slips_)
    is_free[edge] = state == State::inside;
  // Next to an edge that slips the best shear would exceed the bound.
  for (std::size_t i = 0; i + 1 < contact_edges_.size(); ++i)
    if (const unsigned int here = contact_edges_[i], next = contact_edges_[i + 1];
        mesh_->edges()[here].side == mesh_->edges()[next].side &&
        (slips_[here] != State::inside || slips_[next] != State::inside))
      is_free[here] = is_free[next] = false;
  for (const auto &[edge, free] : is_free) {
    friction_bounds_[edge] = lower_friction_bound(edge);
    rub_by_multipliers(edge);
    mesh_->set_free(edge, 1, free);
  }
}

void BestStress::rub_by_multipliers(const unsigned int number) {
  const std::vector<double> &bound = friction_bounds_.at(number);
  std::vector<double> b = bernstein_coefficients(projection_of(data_.P.tangential()[0], number));
  const State state = slips_.at(number);
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = state == State::upper   ? bound[i]
           : state == State::lower ? -bound[i]
                                   : std::clamp(b[i], -bound[i], bound[i]);
  fix_edge(number, 1, legendre_coefficients(b));
}

bool BestStress::resolve_friction() {
  std::vector<StressMesh::Cell> unresolved;
  for (std::size_t c = 0; c < cells_.size() && stress_mesh_.is_own(); ++c)
    for (const TractionSide &side : mesh_->cells()[c].sides)
      if (unresolved_friction_.count(side.edge) > 0)
        unresolved.push_back(cells_[c]);
  return stress_mesh_.refine(unresolved, false);
}

bool BestStress::is_within_friction(const unsigned int number) const {
  const std::vector<double> &bound = friction_bounds_.at(number),
                            b = bernstein_coefficients(coefficients(number, 1));
  for (std::size_t i = 0; i < b.size(); ++i)
    if (std::abs(b[i]) > bound[i])
      return false;
  return true;
}
} // namespace Signorini
