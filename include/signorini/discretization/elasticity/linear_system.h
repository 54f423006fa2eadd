// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/discretization/elasticity/integration.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Signorini
{
/** Returns a matrix of V^h with the couplings of A, rows distributed, entries zero. Collective. */
template <int dim>
TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space);

/**
 * Adds matrices of cells to a matrix of V^h that make_matrix() made, condensing the constraints.
 *
 * In serial runs, entries are added to the stored rows directly, which is several times faster than
 * Trilinos' own search.
 */
template <int dim>
class MatrixScatter
{
public:
  using Indices = std::vector<types::global_dof_index>;

  /** Prepares the rows. Both arguments must outlive the object. */
  MatrixScatter(const DisplacementSpace<dim> &space, TrilinosWrappers::SparseMatrix &matrix);

  /** Adds cell_matrix to matrix(indices, indices). */
  void add(const FullMatrix<double> &cell_matrix, const Indices &indices);
  /** Adds cell_matrix to matrix(indices, indices), and cell_vector, reduced by prescribed
   * displacements, to vector(indices). */
  void add(const FullMatrix<double> &cell_matrix,
           const dealii::Vector<double> &cell_vector,
           const Indices &indices,
           DistributedVector &vector);

private:
  bool has_constraints(const Indices &indices) const;
  void add_to_rows(const FullMatrix<double> &cell_matrix, const Indices &indices);
  /** Computes Tᵀ K T and Tᵀ (b - K k) of a cell with constraints, U = T U_free + k, in condensed_
   * and condensed_vector_, for the indices in masters_. */
  void condense(const FullMatrix<double> &cell_matrix,
                const dealii::Vector<double> &cell_vector,
                const Indices &indices);
  /** Calls condense() and adds the matrix to the rows. */
  void add_condensed(const FullMatrix<double> &cell_matrix,
                     const dealii::Vector<double> &cell_vector,
                     const Indices &indices);
  /** Adds a positive number to the diagonal of a constrained row. */
  void add_diagonals(const FullMatrix<double> &cell_matrix, const Indices &indices);

  const AffineConstraints<double> &constraints_;
  TrilinosWrappers::SparseMatrix &matrix_;
  bool one_rank_;
  /** The rows as Trilinos stores them: row i has the entries start[i] to start[i + 1]. */
  int *start_ = nullptr;
  int *column_ = nullptr;
  double *value_ = nullptr;
  FullMatrix<double> half_condensed_, condensed_;
  dealii::Vector<double> condensed_vector_;
  Indices masters_;
};

/** The system A U = f. The matrix is that of a body of size one and modulus one, A = unit × matrix,
 * so that neither units nor sizes of numbers matter to a factorisation. All vectors are in the
 * user's units. */
template <int dim>
struct LinearSystem
{
  /** The matrix A/unit with the essential conditions eliminated. It is symmetric positive definite;
   * constrained rows hold a diagonal entry only. It is empty where A is not assembled. */
  TrilinosWrappers::SparseMatrix matrix;
  /** The unit stiffness_unit(). */
  double unit = 1.;
  /** The right-hand side f_j, reduced by the contribution of the prescribed displacements; zero in
   * constrained rows. */
  DistributedVector f;
  /** The loads f_j = ∫ f.φ_j + ∫ t.φ_j for all j, nothing eliminated (force). */
  DistributedVector loads;
  /** The resultant of the loads, by quadrature of f and t. */
  Resultant<dim> applied;
};

/**
 * Assembles A_ij = a(φ_j, φ_i) and f_i = ∫ f.φ_i + ∫_{Γ_F} t.φ_i with @p n_points
 * Gauss points per direction for the loads. Collective.
 * @throws InputError where the data has no value.
 */
template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene,
                                         unsigned int n_points);

/** Assembles the same system without the matrix. Serial, no hanging nodes. */
template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           unsigned int n_points);

/** Assembles LinearSystem::loads alone. Collective. */
template <int dim>
DistributedVector assemble_loads(const DisplacementSpace<dim> &space,
                                 const Scene<dim> &scene,
                                 unsigned int n_points);
} // namespace Signorini
