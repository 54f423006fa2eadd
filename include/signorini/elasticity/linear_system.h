// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/elasticity/resultant.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Signorini
{
/**
 * A U = f. The matrix is that of a body of size one and modulus one, A = unit × matrix, so that
 * neither units nor sizes of numbers matter to a factorisation. All vectors are in the user's
 * units.
 */
template <int dim>
struct LinearSystem
{
  /** A/unit with the essential conditions eliminated. Symmetric positive definite; constrained rows
   * hold a diagonal entry only. Empty where A is not assembled. */
  dealii::TrilinosWrappers::SparseMatrix matrix;
  /** stiffness_unit(). */
  double unit = 1.;
  /** f_j, reduced by what the prescribed displacements contribute; zero in constrained rows. */
  DistributedVector f;
  /** f_j = int f.phi_j + int t.phi_j for all j, nothing eliminated (force). */
  DistributedVector loads;
  /** Their resultant, by quadrature of f and t. */
  Resultant<dim> applied;
};

/**
 * Assembles A_ij = a(phi_j, phi_i) and f_i = int f.phi_i + int_{Gamma_F} t.phi_i with @p n_points
 * Gauss points per direction for the loads. Collective.
 * @throws InputError where the data has no value.
 */
template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene,
                                         unsigned int n_points);

/** The same without the matrix. One rank, no hanging nodes. */
template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           unsigned int n_points);

/** LinearSystem::loads alone. Collective. */
template <int dim>
DistributedVector assemble_loads(const DisplacementSpace<dim> &space,
                                 const Scene<dim> &scene,
                                 unsigned int n_points);
} // namespace Signorini
