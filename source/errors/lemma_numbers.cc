// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemmas 2, 3 and 5 and the bounds (26), (27) and (30) as numbers.

#include <signorini/elasticity/cell_stiffness.h>
#include <signorini/elasticity/integration.h>
#include <signorini/errors/displacement_errors.h>
#include <signorini/errors/lemma_numbers.h>
#include <signorini/errors/pressure_errors.h>
#include <signorini/norms/h1_gram_matrix.h>
#include <signorini/postprocess/nodal_interpolation.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <map>
#include <set>

namespace Signorini
{
namespace
{
/** int_{Gamma_c} q phi_j.n for all j and a function q of piece and arc length. */
template <int dim, typename Function>
DistributedVector test_on_contact(const DisplacementSpace<dim> &space,
                                  const MultiplierSpace<dim> &multipliers,
                                  const unsigned int n_points,
                                  const Function &q)
{
  DistributedVector b = space.make_vector();
  for (const Piece &piece : multipliers.partition().pieces)
  {
    const ContactFace<dim> &face = multipliers.faces()[piece.face];
    const Side<dim> &side = multipliers.side(multipliers.partition().patches[piece.patch]);
    const auto mesh_face = space.dof_cell(face.cell)->face(face.face_no);
    const auto rule = multipliers.rule(piece, n_points, true);
    for (std::size_t k = 0; k < rule.points.size(); ++k)
    {
      const double t = face.parameter(rule.arc_lengths[k]);
      const double weighted = q(piece, rule.points[k]) * rule.weights[k];
      const dealii::Tensor<1, dim> n = side.normal(rule.arc_lengths[k]);
      for (unsigned int v = 0; v < 2; ++v)
        for (unsigned int d = 0; d < dim; ++d)
        {
          const auto dof = mesh_face->vertex_dof_index(v, d);
          if (b.in_local_range(dof))
            b(dof) += weighted * (v == 0 ? 1. - t : t) * n[d];
        }
    }
  }
  b.compress(dealii::VectorOperation::add);
  return b;
}

/** sup_v b(v)/‖v‖_1 over V^h: the functional is condensed like a right-hand side. */
template <int dim>
double dual_norm(const DisplacementSpace<dim> &space,
                 const StiffnessInverse &inverse,
                 const DistributedVector &b)
{
  const NodalVector condensed = space.condense(NodalVector(b));
  DistributedVector right_hand_side = space.make_vector();
  for (const auto i : space.locally_owned())
    right_hand_side(i) = condensed[i];
  right_hand_side.compress(dealii::VectorOperation::insert);
  DistributedVector v = space.make_vector();
  inverse.solve(v, right_hand_side);
  return std::sqrt(std::max(v * right_hand_side, 0.));
}

/**
 * |||(u - I^h u).n|||_{1/2,Gamma_c}, the root of the sum of squares over the sides. The difference
 * is smooth on every face and vanishes at the nodes.
 */
template <int dim>
double interpolation_trace(const DisplacementSpace<dim> &space,
                           const Scene<dim> &scene,
                           const MultiplierSpace<dim> &multipliers,
                           const NodalVector &interpolant)
{
  // 8 points on the length of one period of the highest of 8192 modes.
  constexpr unsigned int n_intervals = 4096, n_points = 8;
  struct SideSamples
  {
    std::vector<double> arc_lengths, weighted_values;
    std::set<unsigned int> faces;
  };
  std::map<unsigned int, SideSamples> sides;
  for (const Piece &piece : multipliers.partition().pieces)
  {
    const unsigned int number = multipliers.partition().patches[piece.patch].side;
    const Side<dim> &side = scene.geometry.sides[number];
    const ContactFace<dim> &face = multipliers.faces()[piece.face];
    SideSamples &samples = sides[number];
    samples.faces.insert(piece.face);
    const double length = piece.end - piece.start;
    const auto n_parts = static_cast<unsigned int>(std::ceil(n_intervals * length / side.length()));
    for (unsigned int i = 0; i < n_parts; ++i)
    {
      const Piece part = {piece.face,
                          piece.patch,
                          piece.start + i * length / n_parts,
                          piece.start + (i + 1) * length / n_parts};
      const auto rule = multipliers.rule(part, n_points, true);
      for (std::size_t k = 0; k < rule.points.size(); ++k)
      {
        const dealii::Tensor<1, dim> n = side.normal(rule.arc_lengths[k]);
        double w = -normal_displacement(space, face, n, interpolant, rule.arc_lengths[k]);
        for (unsigned int d = 0; d < dim; ++d)
          w += scene.exact_displacement->value(rule.points[k], d) * n[d];
        samples.arc_lengths.push_back(rule.arc_lengths[k]);
        samples.weighted_values.push_back(w * rule.weights[k]);
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

/** (b^T S^{-1} b)^{1/2}, b_tau = int_tau (I^h u - u).n. */
template <int dim>
double trace_defect(const Scene<dim> &scene,
                    const MultiplierSpace<dim> &multipliers,
                    const Coupling &D,
                    const NodalVector &interpolant,
                    const unsigned int n_points)
{
  dealii::Vector<double> b = D.transpose_product(interpolant);
  for (const Piece &piece : multipliers.partition().pieces)
  {
    const Side<dim> &side = multipliers.side(multipliers.partition().patches[piece.patch]);
    const auto rule = multipliers.rule(piece, n_points, true);
    for (std::size_t k = 0; k < rule.points.size(); ++k)
    {
      const dealii::Tensor<1, dim> n = side.normal(rule.arc_lengths[k]);
      for (unsigned int d = 0; d < dim; ++d)
        b[piece.patch] -=
          scene.exact_displacement->value(rule.points[k], d) * n[d] * rule.weights[k];
    }
  }
  const auto gram = dual_gram_matrix(multipliers.partition().patches, scene.geometry);
  dealii::LAPACKFullMatrix<double> S(gram.m(), gram.n());
  S = gram;
  S.set_property(dealii::LAPACKSupport::symmetric);
  S.compute_cholesky_factorization();
  dealii::Vector<double> x = b;
  S.solve(x);
  return std::sqrt(std::max(b * x, 0.));
}
} // namespace

template <int dim>
LemmaNumbers compute_lemma_numbers(const DisplacementSpace<dim> &space,
                                   const Scene<dim> &scene,
                                   const MultiplierSpace<dim> &multipliers,
                                   const Coupling &D,
                                   const ExactPressure<dim> &pressure,
                                   const DistributedVector &loads,
                                   const std::string &linear_solver,
                                   const unsigned int n_points)
{
  const dealii::Vector<double> projected_p = pressure.project(multipliers);
  const NodalVector interpolant = interpolate_at_nodes(space, *scene.exact_displacement);
  const auto exact_p = [&](const Piece &piece, const dealii::Point<dim> &x) {
    return multipliers.condition(multipliers.partition().patches[piece.patch])
      .exact_pressure->value(x);
  };

  LemmaNumbers numbers;
  numbers.projection_l2 = compute_pressure_errors(multipliers, projected_p, n_points).l2;
  numbers.projection_dual = pressure.errors(multipliers, projected_p).spectral;
  const DisplacementErrors errors =
    compute_displacement_errors(space, scene, interpolant, n_points);
  numbers.interpolation_h1 = errors.h1;
  numbers.interpolation_trace = interpolation_trace(space, scene, multipliers, interpolant);
  numbers.bound_30 = errors.post_h1;

  const dealii::TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, linear_solver);
  // a(u, phi_j) = f(phi_j) + [p, B phi_j].
  DistributedVector defect = test_on_contact(space, multipliers, n_points, exact_p);
  defect += loads;
  defect -= internal_forces(space, scene, interpolant).forces;
  numbers.consistency = dual_norm(space, *inverse, defect);
  numbers.bound_26 =
    dual_norm(space,
              *inverse,
              test_on_contact(
                space, multipliers, n_points, [&](const Piece &piece, const dealii::Point<dim> &x) {
                  return exact_p(piece, x) - projected_p[piece.patch];
                }));
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

template LemmaNumbers compute_lemma_numbers(const DisplacementSpace<2> &,
                                            const Scene<2> &,
                                            const MultiplierSpace<2> &,
                                            const Coupling &,
                                            const ExactPressure<2> &,
                                            const DistributedVector &,
                                            const std::string &,
                                            unsigned int);
} // namespace Signorini
