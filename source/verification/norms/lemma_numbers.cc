// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemmas 2, 3 and 5 and the bounds (26), (27) and (30) as numbers.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/nodes.h>
#include <signorini/discretization/space/trace_values.h>
#include <signorini/postprocessing/fields/contact_load.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>
#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/errors.h>
#include <signorini/verification/norms/inf_sup.h>
#include <signorini/verification/norms/lemma_numbers.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Signorini {
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

LemmaNumbers compute_lemma_numbers(const Discretization<2> &discretization, const Scene<2> &scene,
                                   const ExactPressure<2> &pressure,
                                   const LinearSolver linear_solver) {
  const DisplacementSpace<2> &space = discretization.space;
  const MultiplierSpace<2> &multipliers = discretization.multipliers;
  const unsigned int n_points = discretization.n_points + 1;
  const Pressure projected_p(pressure.project(multipliers));
  const Displacement interpolant = interpolate_at_nodes(space, *scene.exact_displacement);
  const auto exact_p = [&](const Piece<2> &piece, const SurfaceRule<2> &rule) {
    return exact_pressure_on(multipliers.surface(), piece, rule);
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
  const DisplacedBody<2> body(space, scene, interpolant);
  const DisplacementErrors errors = compute_displacement_errors(body, n_points);
  numbers.interpolation_h1 = errors.h1;
  numbers.interpolation_trace =
    interpolation_trace(space, scene, multipliers.surface(), interpolant);
  numbers.bound_30 = errors.post_h1;

  const TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver);
  // a(u, φ_j) = f(φ_j) + [p, B φ_j].
  DualVector defect = test_on_contact(space, multipliers, n_points, exact_p);
  defect += assemble_right_hand_side(space, scene, discretization.n_points, space.zero()).loads;
  defect -= internal_forces(body).forces;
  numbers.consistency = dual_norm(space, *inverse, defect);
  numbers.bound_26 =
    dual_norm(space, *inverse, test_on_contact(space, multipliers, n_points, projection_error));
  numbers.bound_27 = trace_defect(scene, multipliers, discretization.D, interpolant, n_points);
  return numbers;
}
} // namespace Signorini
