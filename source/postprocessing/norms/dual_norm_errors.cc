// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (15), (25) and (32).

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/discretization/space/trace_values.h>
#include <signorini/postprocessing/fields/contact_load.h>
#include <signorini/postprocessing/norms/cosine_norm.h>
#include <signorini/postprocessing/norms/dual_norm_errors.h>
#include <signorini/postprocessing/norms/errors.h>
#include <signorini/postprocessing/norms/inf_sup.h>
#include <signorini/postprocessing/norms/slobodeckij_norm.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace Signorini {
namespace {
/** A function at quadrature points of a side, by value times weight. */
struct SampledFunction {
  std::vector<double> arc_lengths;
  std::vector<double> weighted_values;
};

/** Samples a function f(s) between consecutive @p cuts, sorted arc lengths, with n points on each
 * interval. */
template <typename Values>
SampledFunction sample(const std::vector<double> &cuts, const unsigned int n_points,
                       const Values &f) {
  const Quadrature<1> rule = split_quadrature(QGauss<1>(n_points), cuts);
  SampledFunction samples;
  for (unsigned int q = 0; q < rule.size(); ++q) {
    samples.arc_lengths.push_back(rule.point(q)[0]);
    samples.weighted_values.push_back(f(rule.point(q)[0]) * rule.weight(q));
  }
  return samples;
}

/** Returns the ends of n equal intervals of a side and of its pieces, with the kinks and intervals
 * that shrink towards them. */
std::vector<double> cut_side(const Side<2> &side, const Kinks<2> &kinks,
                             const unsigned int n_intervals) {
  std::vector<double> cuts;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    cuts.push_back(i * side.length() / n_intervals);
  for (unsigned int k = 1; k < side.n_pieces(); ++k)
    cuts.push_back(side.start_of(k));
  for (const double s : kinks.crossings(side, 0., side.length())) {
    cuts.push_back(s);
    for (const double sign : {-1., 1.})
      for (const double near : graded_positions(s, sign * side.length() / n_intervals))
        if (near > 0. && near < side.length())
          cuts.push_back(near);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/** Returns the root of the sum of squares, none if one of them is unknown. */
std::optional<double> hypot(const std::optional<double> &a, const std::optional<double> &b) {
  return a && b ? std::optional<double>(std::hypot(*a, *b)) : std::nullopt;
}

/** Returns the exact pressure at the points of a rule. */
template <int dim>
std::vector<double> pressure_on(const ContactSurface<dim> &surface, const Piece<dim> &piece,
                                const SurfaceRule<dim> &rule) {
  std::vector<double> p(rule.size());
  surface.condition(piece).exact_pressure->value_list(rule.points, p);
  return p;
}

/** The number of patches above which a side does not get the paper's norm: its cost grows like m³.
 */
constexpr unsigned int max_slobodeckij_patches = 128;

/** Returns Richardson's extrapolation of the error's h² on grids of 8 m and 16 m cells. */
double extrapolate(const std::array<double, 2> &norms) {
  return norms[1] + (norms[1] - norms[0]) / 3.;
}

CosineNorm<2>::Modes coefficients_on(const Scene<2> &scene, const unsigned int number) {
  const Side<2> &side = scene.geometry.sides[number];
  const Function<2> &exact = *scene.boundary[number].exact_pressure;
  const SampledFunction p = sample(cut_side(side, scene.kinks, 4096), 8,
                                   [&](const double s) { return exact.value(side.point(s)); });
  return CosineNorm<2>(side).coefficients(p.arc_lengths, p.weighted_values);
}

FullMatrix<double> coefficients_on(const Scene<3> &scene, const unsigned int number) {
  const Side<3> &side = scene.geometry.sides[number];
  // Two points for the half of a period of the highest mode.
  const QIterated<1> rule(QGauss<1>(8), CosineNorm<3>::n_modes / 4);
  const std::array<double, 2> lengths = side.lengths();
  std::array<std::vector<double>, 2> positions;
  for (unsigned int d = 0; d < 2; ++d)
    for (const Point<1> &s : rule.get_points())
      positions[d].push_back(lengths[d] * s[0]);
  FullMatrix<double> weighted(rule.size(), rule.size());
  std::vector<Point<3>> points(rule.size());
  std::vector<double> values(rule.size());
  for (unsigned int a = 0; a < rule.size(); ++a) {
    for (unsigned int b = 0; b < rule.size(); ++b)
      points[b] = side.point({positions[0][a], positions[1][b]});
    scene.boundary[number].exact_pressure->value_list(points, values);
    for (unsigned int b = 0; b < rule.size(); ++b)
      weighted(a, b) = values[b] * lengths[0] * rule.weight(a) * lengths[1] * rule.weight(b);
  }
  return CosineNorm<3>(lengths).coefficients(positions, weighted);
}

/** Adds the paper's norm on a side with few patches. @param differences those between the means of
 * the exact pressure and P. */
void add_slobodeckij(const Scene<2> &scene, const PatchGrid &grid, const Pressure &P,
                     const dealii::Vector<double> &differences, DualNormErrors &errors) {
  const unsigned int m = grid.n(0);
  const Side<2> &side = scene.geometry.sides[grid.side];
  const std::vector<double> &ends = grid.ends[0];
  if (m > max_slobodeckij_patches || !side.is_flat())
    return;
  const Function<2> &exact = *scene.boundary[grid.side].exact_pressure;
  const auto on_patch = [&](const dealii::Vector<double> &values, const double s) {
    return values[grid.patches[std::lower_bound(ends.begin() + 1, ends.end() - 1, s) -
                               ends.begin() - 1]];
  };
  std::array<double, 2> norms, superclose_norms;
  for (unsigned int g = 0; g < 2; ++g) {
    // Points on every patch and on every cell of the grid.
    const SlobodeckijNorm uniform(side.length(), (g + 1) * 8 * m);
    std::vector<double> cuts = cut_side(side, scene.kinks, uniform.n_cells());
    cuts.insert(cuts.end(), ends.begin() + 1, ends.end());
    std::sort(cuts.begin(), cuts.end());
    const SampledFunction error =
      sample(cuts, 6, [&](const double s) { return exact.value(side.point(s)) - on_patch(P, s); });
    const SampledFunction superclose =
      sample(cuts, 2, [&](const double s) { return on_patch(differences, s); });
    norms[g] = uniform.dual_norm(error.arc_lengths, error.weighted_values);
    superclose_norms[g] = uniform.dual_norm(superclose.arc_lengths, superclose.weighted_values);
  }
  errors.slobodeckij = extrapolate(norms);
  errors.superclose_slobodeckij = extrapolate(superclose_norms);
}
} // namespace

template <int dim>
dealii::Vector<double> ExactPressure<dim>::project(const MultiplierSpace<dim> &space) const {
  constexpr unsigned int n_points = dim == 2 ? 10 : 4;
  return space.project(integrate_against_multipliers(
    space, n_points, Grading::towards_kinks, [&](const auto &piece, const auto &rule) {
      return pressure_on(space.surface(), piece, rule);
    }));
}

template <int dim>
ExactPressure<dim>::ExactPressure(const Scene<dim> &scene)
  : scene_(scene) {
  for (const unsigned int number : scene.contact_sides())
    coefficients_[number] = coefficients_on(scene, number);
}

template <int dim>
DualNormErrors ExactPressure<dim>::errors(const MultiplierSpace<dim> &space,
                                          const Pressure &P) const {
  dealii::Vector<double> differences = project(space);
  differences -= P;
  DualNormErrors sum = {0., 0., 0., 0.};
  for (const PatchGrid &grid : patch_grids(space.surface().patches())) {
    const CosineNorm<dim> norm(scene_.geometry.sides[grid.side]);
    DualNormErrors side;
    side.spectral = norm.distance(coefficients_.at(grid.side), grid, P);
    side.superclose_spectral = norm.distance(typename CosineNorm<dim>::Modes(), grid, differences);
    if constexpr (dim == 2)
      add_slobodeckij(scene_, grid, P, differences, side);
    sum.spectral = std::hypot(sum.spectral, side.spectral);
    sum.superclose_spectral = std::hypot(sum.superclose_spectral, side.superclose_spectral);
    sum.slobodeckij = hypot(sum.slobodeckij, side.slobodeckij);
    sum.superclose_slobodeckij = hypot(sum.superclose_slobodeckij, side.superclose_slobodeckij);
  }
  return sum;
}
template class ExactPressure<2>;
template class ExactPressure<3>;

Columns<DualNormErrors> DualNormErrors::columns() {
  return {{"p_dual", &DualNormErrors::slobodeckij},
          {"p_dual_spectral", &DualNormErrors::spectral},
          {"p_superclose_dual", &DualNormErrors::superclose_slobodeckij},
          {"p_superclose_dual_spectral", &DualNormErrors::superclose_spectral}};
}

// Lemmas 2, 3 and 5 and the bounds (26), (27) and (30) as numbers.

namespace {
/** Returns ∫_{Γ_c} q φ_j.n for all j; @p values_on (piece, rule) is q at the points of a
 * rule. */
template <typename Function>
DualVector test_on_contact(const DisplacementSpace<2> &space, const MultiplierSpace<2> &multipliers,
                           const unsigned int n_points, const Function &values_on) {
  const ContactSurface<2> &surface = multipliers.surface();
  const auto rule_on = [&](const Piece<2> &piece) {
    return surface.rule(piece, n_points, Grading::towards_kinks);
  };
  DualVector b = space.make_vector();
  sum_columns(space, {contact_load(space, surface, rule_on, values_on)})
    .add_product(dealii::Vector<double>{1.}, b);
  return b;
}

/** Returns u.n of the exact displacement at the points of a rule. */
std::vector<double> exact_normal_displacement(const Scene<2> &scene, const SurfaceRule<2> &rule) {
  std::vector<double> u_n(rule.size(), 0.);
  for (std::size_t k = 0; k < rule.size(); ++k)
    for (unsigned int d = 0; d < 2; ++d)
      u_n[k] += scene.exact_displacement->value(rule.points[k], d) * rule.directions[k][d];
  return u_n;
}

/** Returns sup_v b(v)/‖v‖_1 over V^h: the functional is condensed like a right-hand side. */
double dual_norm(const DisplacementSpace<2> &space, const StiffnessInverse &inverse,
                 const DualVector &b) {
  const DualVector right_hand_side = space.condense(b);
  Displacement v = space.zero();
  inverse.solve(v, right_hand_side);
  return std::sqrt(std::max(v * right_hand_side, 0.));
}

/** Returns |||(u - I^h u).n|||_{1/2,Γ_c}, the root of the sum of squares over the sides. The
 * difference is smooth on every face and vanishes at the nodes. */
double interpolation_trace(const DisplacementSpace<2> &space, const Scene<2> &scene,
                           const ContactSurface<2> &surface, const Displacement &interpolant) {
  // 8 points on the length of one period of the highest of 8192 modes.
  constexpr unsigned int n_intervals = 4096, n_points = 8;
  struct SideSamples {
    std::vector<double> arc_lengths, weighted_values;
    std::set<unsigned int> faces;
  };
  std::map<unsigned int, SideSamples> sides;
  TraceValues<2> traces(space);
  for (const Piece<2> &piece : surface.pieces()) {
    const Patch<2> &patch = surface.patches()[piece.patch];
    SideSamples &samples = sides[patch.side];
    samples.faces.insert(piece.face);
    const double share = (piece.upper[0] - piece.lower[0]) / surface.side(patch).length();
    const auto n_parts = static_cast<unsigned int>(std::ceil(n_intervals * share));
    for (unsigned int i = 0; i < n_parts; ++i) {
      const SurfaceRule<2> rule =
        surface.rule(surface.part(piece, i, n_parts), n_points, Grading::towards_kinks);
      const auto u_n = exact_normal_displacement(scene, rule);
      const auto interpolated = traces.displacement(surface, piece, rule, interpolant);
      for (std::size_t k = 0; k < rule.size(); ++k) {
        samples.arc_lengths.push_back(rule.on_side[k][0]);
        samples.weighted_values.push_back((u_n[k] - interpolated[k] * rule.directions[k]) *
                                          rule.weights[k]);
      }
    }
  }
  double norm = 0.;
  for (const auto &[number, samples] : sides) {
    const CosineNorm<2> side_norm(scene.geometry.sides[number]);
    const auto w = side_norm.coefficients(samples.arc_lengths, samples.weighted_values);
    norm = std::hypot(norm, side_norm.primal_norm(w, samples.faces.size()));
  }
  return norm;
}

/** Returns (bᵀ S⁻¹ b)^{1/2} with b_tau = ∫_tau (I^h u - u).n. */
double trace_defect(const Scene<2> &scene, const MultiplierSpace<2> &multipliers, const Coupling &D,
                    const Displacement &interpolant, const unsigned int n_points) {
  dealii::Vector<double> b = D.transpose_product(interpolant);
  b -= integrate_against_multipliers(multipliers, n_points, Grading::towards_kinks,
                                     [&](const Piece<2> & /*piece*/, const SurfaceRule<2> &rule) {
                                       return exact_normal_displacement(scene, rule);
                                     });
  const auto gram = dual_gram_matrix(multipliers.surface());
  LAPACKFullMatrix<double> S(gram.m(), gram.n());
  S = gram;
  S.set_property(LAPACKSupport::symmetric);
  S.compute_cholesky_factorization();
  dealii::Vector<double> x = b;
  S.solve(x);
  return std::sqrt(std::max(b * x, 0.));
}
} // namespace

LemmaNumbers compute_lemma_numbers(const DisplacementSpace<2> &space, const Scene<2> &scene,
                                   const MultiplierSpace<2> &multipliers, const Coupling &D,
                                   const ExactPressure<2> &pressure, const DualVector &loads,
                                   const LinearSolver linear_solver, const unsigned int n_points) {
  const Pressure projected_p(pressure.project(multipliers));
  const Displacement interpolant = interpolate_at_nodes(space, *scene.exact_displacement);
  const auto exact_p = [&](const Piece<2> &piece, const SurfaceRule<2> &rule) {
    return pressure_on(multipliers.surface(), piece, rule);
  };
  const auto projection_error = [&](const Piece<2> &piece, const SurfaceRule<2> &rule) {
    std::vector<double> difference = exact_p(piece, rule);
    for (std::size_t k = 0; k < rule.size(); ++k)
      difference[k] -= multipliers.value(projected_p, piece.patch, rule.on_side[k]);
    return difference;
  };

  LemmaNumbers numbers;
  numbers.projection_l2 = compute_pressure_errors(multipliers, projected_p, n_points).l2;
  numbers.projection_dual = pressure.errors(multipliers, projected_p).spectral;
  const DisplacedBody body(space, scene, interpolant);
  const DisplacementErrors errors = compute_displacement_errors(body, n_points);
  numbers.interpolation_h1 = errors.h1;
  numbers.interpolation_trace =
    interpolation_trace(space, scene, multipliers.surface(), interpolant);
  numbers.bound_30 = errors.post_h1;

  const TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver);
  // a(u, φ_j) = f(φ_j) + [p, B φ_j].
  DualVector defect = test_on_contact(space, multipliers, n_points, exact_p);
  defect += loads;
  defect -= internal_forces(body).forces;
  numbers.consistency = dual_norm(space, *inverse, defect);
  numbers.bound_26 =
    dual_norm(space, *inverse, test_on_contact(space, multipliers, n_points, projection_error));
  numbers.bound_27 = trace_defect(scene, multipliers, D, interpolant, n_points);
  return numbers;
}

Columns<LemmaNumbers> LemmaNumbers::columns() {
  return {{"lemma_2_l2", &LemmaNumbers::projection_l2},
          {"lemma_2_dual", &LemmaNumbers::projection_dual},
          {"lemma_3_h1", &LemmaNumbers::interpolation_h1},
          {"lemma_3_trace", &LemmaNumbers::interpolation_trace},
          {"lemma_5", &LemmaNumbers::consistency},
          {"bound_26", &LemmaNumbers::bound_26},
          {"bound_27", &LemmaNumbers::bound_27},
          {"bound_30", &LemmaNumbers::bound_30}};
}
} // namespace Signorini
