// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemmas 2, 3 and 5 and the bounds (26), (27) and (30) as numbers.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/traces.h>
#include <signorini/postprocessing/errors/displacement_errors.h>
#include <signorini/postprocessing/errors/lemma_numbers.h>
#include <signorini/postprocessing/errors/pressure_errors.h>
#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <map>
#include <set>

namespace Signorini
{
namespace
{
/** Returns ∫_{Γ_c} q φ_j.n for all j; @p values_on (piece, rule) is q at the points of a
 * rule. */
template <typename Function>
DistributedVector test_on_contact(const DisplacementSpace<2> &space,
                                  const MultiplierSpace<2> &multipliers,
                                  const unsigned int n_points,
                                  const Function &values_on)
{
  const ContactSurface<2> &surface = multipliers.surface();
  const dealii::FEValuesExtractors::Vector displacement(0);
  TraceValues<2> traces(space);
  DistributedVector b = space.make_vector();
  for (const Piece<2> &piece : surface.pieces())
  {
    const ContactFace<2> &face = surface.faces()[piece.face];
    const SurfaceRule<2> rule = surface.rule(piece, n_points, Grading::towards_kinks);
    const std::vector<double> q = values_on(piece, rule);
    const auto &values = traces.reinit(face, rule.on_face);
    const auto indices = space.cell_dofs(face.cell);
    for (unsigned int j = 0; j < indices.size(); ++j)
      if (b.in_local_range(indices[j]))
        for (std::size_t k = 0; k < rule.size(); ++k)
          b(indices[j]) +=
            q[k] * rule.weights[k] * (values[displacement].value(j, k) * rule.normals[k]);
  }
  b.compress(dealii::VectorOperation::add);
  return b;
}

/** Returns u.n of the exact displacement at the points of a rule. */
std::vector<double> exact_normal_displacement(const Scene<2> &scene, const SurfaceRule<2> &rule)
{
  std::vector<double> u_n(rule.size(), 0.);
  for (std::size_t k = 0; k < rule.size(); ++k)
    for (unsigned int d = 0; d < 2; ++d)
      u_n[k] += scene.exact_displacement->value(rule.points[k], d) * rule.normals[k][d];
  return u_n;
}

/** Returns sup_v b(v)/‖v‖_1 over V^h: the functional is condensed like a right-hand side. */
double dual_norm(const DisplacementSpace<2> &space,
                 const StiffnessInverse &inverse,
                 const DistributedVector &b)
{
  const DualVector condensed = space.condense(space.dual(b));
  DistributedVector right_hand_side = space.make_vector();
  for (const auto i : space.locally_owned())
    right_hand_side(i) = condensed(i);
  right_hand_side.compress(dealii::VectorOperation::insert);
  DistributedVector v = space.make_vector();
  inverse.solve(v, right_hand_side);
  return std::sqrt(std::max(v * right_hand_side, 0.));
}

/** Returns |||(u - I^h u).n|||_{1/2,Γ_c}, the root of the sum of squares over the sides. The
 * difference is smooth on every face and vanishes at the nodes. */
double interpolation_trace(const DisplacementSpace<2> &space,
                           const Scene<2> &scene,
                           const ContactSurface<2> &surface,
                           const Displacement &interpolant)
{
  // 8 points on the length of one period of the highest of 8192 modes.
  constexpr unsigned int n_intervals = 4096, n_points = 8;
  struct SideSamples
  {
    std::vector<double> arc_lengths, weighted_values;
    std::set<unsigned int> faces;
  };
  std::map<unsigned int, SideSamples> sides;
  TraceValues<2> traces(space);
  for (const Piece<2> &piece : surface.pieces())
  {
    const Patch<2> &patch = surface.patches()[piece.patch];
    SideSamples &samples = sides[patch.side];
    samples.faces.insert(piece.face);
    const double share = (piece.upper[0] - piece.lower[0]) / surface.side(patch).length();
    const auto n_parts = static_cast<unsigned int>(std::ceil(n_intervals * share));
    for (unsigned int i = 0; i < n_parts; ++i)
    {
      const SurfaceRule<2> rule =
        surface.rule(surface.part(piece, i, n_parts), n_points, Grading::towards_kinks);
      const auto u_n = exact_normal_displacement(scene, rule);
      const auto interpolated =
        traces.normal_displacement(surface.faces()[piece.face], rule, interpolant);
      for (std::size_t k = 0; k < rule.size(); ++k)
      {
        samples.arc_lengths.push_back(rule.on_side[k][0]);
        samples.weighted_values.push_back((u_n[k] - interpolated[k]) * rule.weights[k]);
      }
    }
  }
  double norm = 0.;
  for (const auto &[number, samples] : sides)
  {
    const SpectralNorm side_norm = spectral_norm_on(scene.geometry.sides[number]);
    const auto w = side_norm.coefficients(samples.arc_lengths, samples.weighted_values);
    norm = std::hypot(norm, side_norm.primal_norm(w, samples.faces.size()));
  }
  return norm;
}

/** Returns (bᵀ S⁻¹ b)^{1/2} with b_tau = ∫_tau (I^h u - u).n. */
double trace_defect(const Scene<2> &scene,
                    const MultiplierSpace<2> &multipliers,
                    const Coupling &D,
                    const Displacement &interpolant,
                    const unsigned int n_points)
{
  dealii::Vector<double> b = D.transpose_product(interpolant);
  b -= integrate_against_multipliers(multipliers,
                                     n_points,
                                     Grading::towards_kinks,
                                     [&](const Piece<2> & /*piece*/, const SurfaceRule<2> &rule) {
                                       return exact_normal_displacement(scene, rule);
                                     });
  const auto gram = dual_gram_matrix(multipliers.surface());
  dealii::LAPACKFullMatrix<double> S(gram.m(), gram.n());
  S = gram;
  S.set_property(dealii::LAPACKSupport::symmetric);
  S.compute_cholesky_factorization();
  dealii::Vector<double> x = b;
  S.solve(x);
  return std::sqrt(std::max(b * x, 0.));
}
} // namespace

LemmaNumbers compute_lemma_numbers(const DisplacementSpace<2> &space,
                                   const Scene<2> &scene,
                                   const MultiplierSpace<2> &multipliers,
                                   const Coupling &D,
                                   const ExactPressure<2> &pressure,
                                   const DistributedVector &loads,
                                   const LinearSolver linear_solver,
                                   const unsigned int n_points)
{
  const Pressure projected_p(pressure.project(multipliers));
  const Displacement interpolant = interpolate_at_nodes(space, *scene.exact_displacement);
  const auto exact_p = [&](const Piece<2> &piece, const SurfaceRule<2> &rule) {
    std::vector<double> p(rule.size());
    multipliers.surface().condition(piece).exact_pressure->value_list(rule.points, p);
    return p;
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
  const DisplacementErrors errors =
    compute_displacement_errors(space, scene, interpolant, n_points);
  numbers.interpolation_h1 = errors.h1;
  numbers.interpolation_trace =
    interpolation_trace(space, scene, multipliers.surface(), interpolant);
  numbers.bound_30 = errors.post_h1;

  const dealii::TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver);
  // a(u, φ_j) = f(φ_j) + [p, B φ_j].
  DistributedVector defect = test_on_contact(space, multipliers, n_points, exact_p);
  defect += loads;
  defect -= internal_forces(space, scene, interpolant).forces;
  numbers.consistency = dual_norm(space, *inverse, defect);
  numbers.bound_26 =
    dual_norm(space, *inverse, test_on_contact(space, multipliers, n_points, projection_error));
  numbers.bound_27 = trace_defect(scene, multipliers, D, interpolant, n_points);
  return numbers;
}

Columns<LemmaNumbers> LemmaNumbers::columns()
{
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
