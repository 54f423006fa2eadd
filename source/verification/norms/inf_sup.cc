// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemma 1 as a number: a generalised eigenvalue problem on the contact boundary, with the norm of
// V^h as a matrix.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/verification/norms/inf_sup.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace Signorini {
namespace {
/**
 * Returns the number of points of a Gauss rule for the Gram matrix. grad φ_i . grad φ_j on a
 * cell is a polynomial divided by the determinant of the cell's map. A determinant that falls
 * linearly by the factor @p r along an edge vanishes outside of it, where the ellipse around the
 * edge on which Gauss' rule with n points converges like ρ^{-2n} has ρ = (sqrt(r) + 1)/(sqrt(r)
 * - 1).
 *
 * @return n with ρ^{-2n} below 1e-10, and as many points more for the polynomial as the element's
 * degree; from degree + 2, which is enough for r = 1, to 39 + degree.
 */
unsigned int points_for_ratio(const double r, const unsigned int degree) {
  constexpr double most = 39.;
  const double root = std::sqrt(std::max(r, 1.));
  const double logarithm = std::log((root + 1.) / (root - 1.));
  const double n = std::min(most, std::ceil(0.5 * std::log(1e10) / logarithm));
  return degree + std::max(2U, static_cast<unsigned int>(n));
}

/** Returns the ratio of the largest to the smallest determinant at the vertices. */
template <int dim>
double ratio_of_determinants(const typename Triangulation<dim>::active_cell_iterator &cell) {
  using Geometry = GeometryInfo<dim>;
  Point<dim> vertices[Geometry::vertices_per_cell];
  Tensor<0, dim> determinants[Geometry::vertices_per_cell];
  for (const unsigned int v : cell->vertex_indices())
    vertices[v] = cell->vertex(v);
  Geometry::alternating_form_at_vertices(vertices, determinants);
  const auto [smallest, largest] =
    std::minmax_element(std::begin(determinants), std::end(determinants));
  return *largest / *smallest;
}
} // namespace

template <int dim>
TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space) {
  TrilinosWrappers::SparseMatrix A_1 = make_matrix(space);
  ValuesCache<dim> cache(update_values | update_gradients | update_JxW_values);
  FullMatrix<double> cell_matrix;
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const FiniteElement<dim> &element = cell->get_fe();
    const FEValues<dim> &values =
      cache.reinit(space.mesh().mapping(), element,
                   points_for_ratio(ratio_of_determinants<dim>(cell), element.degree), cell);
    const unsigned int n = element.n_dofs_per_cell();
    cell_matrix.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j) {
        if (element.system_to_component_index(i).first !=
            element.system_to_component_index(j).first)
          continue;
        double product = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          product += (values.shape_value(i, q) * values.shape_value(j, q) +
                      values.shape_grad(i, q) * values.shape_grad(j, q)) *
                     values.JxW(q);
        cell_matrix(i, j) = cell_matrix(j, i) = product;
      }
    space.constraints().distribute_local_to_global(cell_matrix, space.cell_dofs(cell), A_1);
  }
  A_1.compress(VectorOperation::add);
  return A_1;
}

INSTANTIATE_FUNCTION(assemble_h1_gram_matrix);

namespace {
/** Returns the root of the smallest eigenvalue of C against S on some of the multipliers. */
double smallest_root(const FullMatrix<double> &C, const FullMatrix<double> &S,
                     const std::vector<unsigned int> &numbers) {
  FullMatrix<double> part(numbers.size());
  LAPACKFullMatrix<double> C_part(numbers.size()), S_part(numbers.size());
  part.extract_submatrix_from(C, numbers, numbers);
  C_part = part;
  part.extract_submatrix_from(S, numbers, numbers);
  S_part = part;
  std::vector<dealii::Vector<double>> no_eigenvectors;
  C_part.compute_generalized_eigenvalues_symmetric(S_part, no_eigenvectors);
  double smallest = C_part.eigenvalue(0).real();
  for (unsigned int i = 1; i < numbers.size(); ++i)
    smallest = std::min(smallest, C_part.eigenvalue(i).real());
  return std::sqrt(std::max(smallest, 0.));
}
} // namespace

template <int dim>
InfSup measure_inf_sup(const DisplacementSpace<dim> &space, const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D, const FullMatrix<double> &S,
                       const LinearSolver linear_solver) {
  const TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver, contact_unknowns(condensed_D));
  std::vector<unsigned int> all(multipliers.n_multipliers()), of_pairs;
  std::iota(all.begin(), all.end(), 0);
  for (const Piece<dim> &piece : multipliers.surface().pieces())
    for (unsigned int k = multipliers.first_of(piece.patch);
         piece.opposite && k < multipliers.first_of(piece.patch + 1); ++k)
      if (of_pairs.empty() || of_pairs.back() < k)
        of_pairs.push_back(k);
  InfSup beta = {smallest_root(make_compliance(*inverse, condensed_D)->dense(), S, all), {}, {}};
  const auto beta_of = [&](const std::array<double, 2> &share) {
    const Coupling D = condense(assemble_coupling(space, multipliers, Component::normal, share),
                                space.constraints());
    return smallest_root(make_compliance(*inverse, D)->dense(), S, of_pairs);
  };
  if (!of_pairs.empty()) {
    beta.first = beta_of({{1., 0.}});
    beta.opposite = beta_of({{0., 1.}});
  }
  return beta;
}

INSTANTIATE_FUNCTION(measure_inf_sup);
} // namespace Signorini
