// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>
#include <signorini/discretization/space/resultant.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace Signorini {
/** Returns a matrix of V^h with the couplings of A, rows distributed, entries zero. Collective.
 * @param condensed whether unknowns inside cells hold a diagonal entry only. */
template <int dim>
TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space,
                                           bool condensed = false);

/**
 * The matrix of a cell whose inner unknowns i are eliminated; e are those on its edges:
 *
 *     K = (K_ee K_ei)   X = -K_ii⁻¹ K_ie,   S = K_ee + K_ei X.
 *         (K_ie K_ii),
 */
struct CondensedMatrix {
  /** Eliminates the last @p n_inner unknowns of a cell. */
  CondensedMatrix(const FullMatrix<double> &matrix, unsigned int n_inner);

  FullMatrix<double> S;
  LAPACKFullMatrix<double> X;
  /** K_ii as its Cholesky factor. */
  LAPACKFullMatrix<double> inner;
};

/** A cell of this rank with its matrix, which similar cells share. */
template <int dim>
struct CondensedCell {
  std::vector<types::global_dof_index> dofs;
  std::shared_ptr<const CondensedMatrix> matrix;
};

/** The system A U = f. The matrix is that of a body of size one and modulus one, A = unit × matrix,
 * so that neither units nor sizes of numbers matter to a factorisation. All vectors are in the
 * user's units. */
template <int dim>
struct LinearSystem {
  /** The matrix A/unit with the essential conditions eliminated. It is symmetric positive definite;
   * constrained rows hold a diagonal entry only. It is empty where A is not assembled. Where cells
   * are condensed, it is the sum of their S, with diagonal entries of A for inner unknowns. */
  TrilinosWrappers::SparseMatrix matrix;
  /** The condensed cells; none where the matrix couples all unknowns. */
  std::vector<CondensedCell<dim>> cells;
  /** The unit stiffness_unit(). */
  double unit = 1.;
  /** The right-hand side f_j, reduced by the contribution of the prescribed displacements; zero in
   * constrained rows. */
  DualVector f;
  /** The loads f_j = ∫ f.φ_j + ∫ t.φ_j for all j, nothing eliminated (force). */
  DualVector loads;
  /** The resultants of the loads on each body, by quadrature of f and t. */
  std::vector<Resultant<dim>> applied;
};

/**
 * Assembles A_ij = a(φ_j, φ_i) and f_i = ∫ f.φ_i + ∫_{Γ_F} t.φ_i with @p n_points
 * Gauss points per direction for the loads. Collective.
 * @param condensed whether unknowns inside cells are eliminated from the matrix.
 * @throws InputError where the data has no value.
 */
template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene, unsigned int n_points,
                                         bool condensed = false);

/** Assembles the same system without the matrix. Collective. @param k the prescribed displacements.
 */
template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene, unsigned int n_points,
                                           const Displacement &k);
} // namespace Signorini
