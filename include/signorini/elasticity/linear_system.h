// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Signorini
{
/** The resultant of surface and body forces: force and moment about the origin. */
template <int dim>
struct Resultant
{
  dealii::Tensor<1, dim> force;
  /** x1 F2 - x2 F1 in two dimensions. */
  double moment = 0.;

  /** Adds a force that acts at a point. */
  void add(const dealii::Tensor<1, dim> &F, const dealii::Point<dim> &x)
  {
    static_assert(dim == 2, "in three dimensions the moment is a vector");
    force += F;
    moment += x[0] * F[1] - x[1] * F[0];
  }
};

/**
 * A U = f, once with the essential conditions eliminated (A, f), once without (loads). A and f are
 * divided by @p unit: what is solved has the modulus one.
 */
template <int dim>
struct LinearSystem
{
  /** Symmetric positive definite; constrained rows hold a diagonal entry only. */
  dealii::TrilinosWrappers::SparseMatrix A;
  /** f_j, reduced by what the prescribed displacements contribute. */
  DistributedVector f;
  /** f_j = int f.phi_j + int t.phi_j for all j (force per thickness). */
  DistributedVector loads;
  /** Their resultant, by quadrature of f and t. */
  Resultant<dim> applied;
  /** stiffness_unit(). */
  double unit = 1.;
};

/**
 * Assembles A_ij = a(phi_j, phi_i)/unit and f_i = (int f.phi_i + int_{Gamma_F} t.phi_i)/unit with
 * @p n_points Gauss points per direction for the loads. Collective.
 * @throws InputError where the data has no value.
 */
template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene,
                                         unsigned int n_points);
} // namespace Signorini
