// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure, as a point value and not as a mean.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/recovered_pressure.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>

#include <deal.II/physics/transformations.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace Signorini {
namespace {
/** A position on one axis, and a value there. */
struct ValueAt {
  double s, value;
};

/** Returns the maximum in the middle one of three intervals, which follow one another, of the
 * parabola with given means over them; its value in the middle where the parabola is monotone, as
 * a neighbour has a larger value then, or constant up to rounding. */
ValueAt max_of_parabola(const std::array<double, 4> &ends, const std::array<double, 3> &means) {
  // With the primitive's divided differences over the four ends e_0 < ... < e_3, from e_1:
  // p = d/ds of (s-e0) m0 + (s-e0)(s-e1) first + (s-e0)(s-e1)(s-e2) second.
  const double from = ends[1], to = ends[2];
  const std::array<double, 4> e = {{ends[0] - from, 0., to - from, ends[3] - from}};
  const double first = (means[1] - means[0]) / (e[2] - e[0]);
  const double second = ((means[2] - means[1]) / (e[3] - e[1]) - first) / (e[3] - e[0]);
  const double curvature = 3. * second;
  const double slope = 2. * first - 2. * second * (e[0] + e[1] + e[2]);
  const double constant =
    means[0] - first * (e[0] + e[1]) + second * (e[0] * e[1] + e[0] * e[2] + e[1] * e[2]);
  // Between mirror images the maximum lies at an end, up to rounding.
  const double top = curvature < 0. ? -slope / (2. * curvature) : -e[2], slack = 1e-9 * e[2];
  const bool is_flat = -curvature * e[2] * e[2] <= 1e-9 * std::abs(means[1]);
  const double t =
    !is_flat && top > -slack && top < e[2] + slack ? std::clamp(top, 0., e[2]) : 0.5 * e[2];
  return {from + t, constant + t * (slope + t * curvature)};
}

/** Returns whether a material is its own mirror image in a plane with the unit normal n. */
bool is_symmetric(const SymmetricTensor<4, 3> &E, const Tensor<1, 3> &n) {
  Tensor<2, 3> mirror = unit_symmetric_tensor<3>();
  mirror -= 2. * outer_product(n, n);
  const SymmetricTensor<4, 3> image = Physics::Transformations::basis_transformation(E, mirror);
  return (image - E).norm() <= 1e-12 * E.norm();
}

/** Returns whether a roller meets the contact side at a point of its edge. Then the body with its
 * mirror image is a body of twice the size, and the pressure goes on symmetrically. */
bool is_mirror(const Scene<3> &scene, const Point<3> &x) {
  const double rounding = 1e-9 * scene.geometry.diameter();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const Side<3> &side = scene.geometry.sides[i];
    if (scene.boundary[i].role == Role::roller && side.is_flat() &&
        x.distance(side.project(x)) <= rounding)
      return is_symmetric(scene.material->relative_hooke(x), side.surface().axis());
  }
  return false;
}

/** A candidate for the peak on a patch. */
template <int dim>
struct PressureAt {
  Point<dim - 1> s;
  double value;
};

/** Finds candidates for the peak, patch by patch. */
template <int dim>
class PeakCandidates {
public:
  PeakCandidates(const MultiplierSpace<dim> &multipliers, const Pressure &P)
    : multipliers_(multipliers)
    , surface_(multipliers.surface())
    , P_(P)
    , threshold_(pressing_threshold(P))
    , recovered_(multipliers, P)
    , neighbours_(surface_.neighbours()) {
    const dealii::Vector<double> integrals = multipliers.integrals();
    for (unsigned int tau = 0; tau < neighbours_.size(); ++tau) {
      const Patch<dim> &patch = surface_.patches()[tau];
      double force = 0., measure = 0.;
      for (unsigned int k = multipliers.first_of(tau); k < multipliers.first_of(tau + 1); ++k) {
        force -= P[k] * integrals[k];
        measure += integrals[k];
      }
      means_.push_back(multipliers.is_piecewise_constant()
                         ? -multipliers.value(P, tau, patch.centre())
                         : force / measure);
    }
  }

  /** Returns the mean of -p_H over a patch. */
  double mean(const unsigned int tau) const {
    return means_[tau];
  }
  bool presses(const unsigned int tau) const {
    bool any = false;
    for (unsigned int k = multipliers_.first_of(tau); k < multipliers_.first_of(tau + 1); ++k)
      any = any || P_[k] < threshold_;
    return any;
  }

  /** Returns candidates where multipliers are constants: the maximum of the sum of parabolas, less
   * the mean where there are two; where a neighbour is missing or does not press, values of
   * RecoveredPressure. */
  std::vector<PressureAt<dim>> of_means(const unsigned int tau) const {
    const Patch<dim> &patch = surface_.patches()[tau];
    PressureAt<dim> top = {{}, (2 - dim) * means_[tau]};
    bool has_parabolas = true;
    // Positions in each coordinate; in 2-D the second one does not exist.
    std::array<std::vector<double>, 2> positions = {{{}, {0.}}};
    for (unsigned int d = 0; d < dim - 1; ++d) {
      const double lower = patch.lower[d], upper = patch.upper[d], length = upper - lower;
      std::array<std::optional<Neighbour>, 2> next = neighbours_[tau][d];
      positions[d] = {patch.centre()[d]};
      for (const unsigned int end : {0, 1}) {
        Point<dim - 1> s = patch.centre();
        s[d] = end == 0 ? lower : upper;
        // A line that is continued to a mirror would have a kink there: this end is left out.
        if (!next[end] && is_mirror_at(patch, s))
          next[end] = {tau, s[d] - (end == 0 ? length : 0.), s[d] + (end == 0 ? 0. : length)};
        else
          positions[d].push_back(s[d]);
        has_parabolas = has_parabolas && next[end] && presses(next[end]->patch);
      }
      if (!has_parabolas)
        continue;
      const ValueAt along =
        max_of_parabola({{next[0]->lower, lower, upper, next[1]->upper}},
                        {{means_[next[0]->patch], means_[tau], means_[next[1]->patch]}});
      top.s[d] = along.s;
      top.value += along.value;
    }
    if (has_parabolas)
      return {top};
    std::vector<PressureAt<dim>> found;
    for (const double t : positions[1])
      for (const double r : positions[0]) {
        Point<dim - 1> s;
        s[dim - 2] = t;
        s[0] = r;
        found.push_back({s, -recovered_(tau, s)});
      }
    return found;
  }

  /** Returns the maximum of the polynomial -p_H among the points that @p is_wanted: the best of
   * many points, then between its neighbours. */
  template <typename Predicate>
  std::vector<PressureAt<2>> of_polynomial(const unsigned int tau,
                                           const Predicate &is_wanted) const {
    const Patch<2> &patch = surface_.patches()[tau];
    const auto pressure = [&](const double s) { return -multipliers_.value(P_, tau, Point<1>(s)); };
    const unsigned int n_unknowns = multipliers_.n_of(tau);
    if (n_unknowns == 1)
      return {{patch.centre(), pressure(patch.centre()[0])}};
    const unsigned int n_intervals = 16 * n_unknowns;
    const double step = patch.measure / n_intervals;
    std::vector<PressureAt<2>> best;
    const auto compare = [&](const double s) {
      if ((best.empty() || pressure(s) > best[0].value) && is_wanted(Point<1>(s)))
        best = {{Point<1>(s), pressure(s)}};
    };
    for (unsigned int i = 0; i <= n_intervals; ++i)
      compare(i == n_intervals ? patch.upper[0] : patch.lower[0] + i * step);
    if (!best.empty())
      compare(boost::math::tools::brent_find_minima([&](const double s) { return -pressure(s); },
                                                    std::max(best[0].s[0] - step, patch.lower[0]),
                                                    std::min(best[0].s[0] + step, patch.upper[0]),
                                                    std::numeric_limits<double>::digits)
                .first);
    return best;
  }

private:
  /** Returns whether the body ends with a mirror at a point of the edge of a side, in 3-D. */
  bool is_mirror_at(const Patch<dim> &patch, const Point<dim - 1> &s) const {
    if constexpr (dim == 3)
      return is_mirror(surface_.scene(), surface_.point(patch, s));
    return false;
  }

  const MultiplierSpace<dim> &multipliers_;
  const ContactSurface<dim> &surface_;
  const Pressure &P_;
  double threshold_;
  RecoveredPressure<dim> recovered_;
  std::vector<Neighbours<dim>> neighbours_;
  std::vector<double> means_;
};
} // namespace

template <int dim>
std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<dim> &multipliers,
                                             const Pressure &P,
                                             const std::vector<SingularEdge<dim>> &outside_of,
                                             const std::function<bool(unsigned int)> &belong) {
  // Of equal peaks (a symmetric body may have two) the first one is taken, independent of rounding.
  constexpr double larger = 1. + 1e-9;
  const bool is_polynomial = !multipliers.is_piecewise_constant();
  const ContactSurface<dim> &surface = multipliers.surface();
  const PeakCandidates<dim> candidates(multipliers, P);
  std::optional<PressureMaximum> peak;
  for (unsigned int tau = 0; tau < surface.patches().size(); ++tau) {
    if (!candidates.presses(tau) || (belong && !belong(tau)))
      continue;
    const Patch<dim> &patch = surface.patches()[tau];
    const auto is_wanted = [&](const Point<dim - 1> &s) {
      return !any_contains(outside_of, surface.point(patch, s));
    };
    std::vector<PressureAt<dim>> found;
    if constexpr (dim == 2)
      if (is_polynomial)
        found = candidates.of_polynomial(tau, is_wanted);
    if (!is_polynomial)
      found = candidates.of_means(tau);
    for (const auto &[s, value] : found)
      if ((!peak || value > larger * peak->value) && is_wanted(s))
        peak = {value,
                {surface.side(patch).name(), dim == 2 ? s[0] : 0., surface.point(patch, s)},
                candidates.mean(tau),
                is_polynomial ? MeshAt{patch.measure, multipliers.n_of(tau)} : MeshAt()};
  }
  return peak;
}

INSTANTIATE_FUNCTION(peak_pressure);
} // namespace Signorini
