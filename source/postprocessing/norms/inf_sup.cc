// SPDX-License-Identifier: LGPL-2.1-or-later
// Lemma 1 as a number: a generalised eigenvalue problem on the contact boundary.

#include <signorini/postprocessing/norms/inf_sup.h>
#include <signorini/postprocessing/norms/polynomial_gram.h>
#include <signorini/postprocessing/norms/spectral_norm.h>
#include <signorini/solvers/contact/compliance.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
dealii::LAPACKFullMatrix<double> to_lapack(const dealii::FullMatrix<double> &matrix)
{
  dealii::LAPACKFullMatrix<double> copy(matrix.m(), matrix.n());
  copy = matrix;
  return copy;
}
} // namespace

template <int dim>
double measure_inf_sup(const DisplacementSpace<dim> &space,
                       const MultiplierSpace<dim> &multipliers,
                       const Coupling &condensed_D,
                       const LinearSolver linear_solver)
{
  const dealii::TrilinosWrappers::SparseMatrix A_1 = assemble_h1_gram_matrix(space);
  const auto inverse = factorise(A_1, 1., linear_solver, contact_unknowns(condensed_D));
  double seconds = 0.;
  auto DA_1D = to_lapack(make_compliance(*inverse, condensed_D, seconds)->dense());
  auto S = to_lapack(dual_gram_matrix(multipliers));
  std::vector<dealii::Vector<double>> no_eigenvectors;
  DA_1D.compute_generalized_eigenvalues_symmetric(S, no_eigenvectors);
  double smallest = DA_1D.eigenvalue(0).real();
  for (unsigned int i = 1; i < multipliers.n_multipliers(); ++i)
    smallest = std::min(smallest, DA_1D.eigenvalue(i).real());
  return std::sqrt(std::max(smallest, 0.));
}

template double measure_inf_sup(const DisplacementSpace<2> &,
                                const MultiplierSpace<2> &,
                                const Coupling &,
                                LinearSolver);
template double measure_inf_sup(const DisplacementSpace<3> &,
                                const MultiplierSpace<3> &,
                                const Coupling &,
                                LinearSolver);
} // namespace Signorini
