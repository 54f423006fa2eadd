// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <cstddef>
#include <memory>

namespace Signorini
{
/**
 * The stiffness A cell by cell, and a V-cycle on the levels of the mesh. It exists for elements of
 * degree one on meshes without hanging nodes, and is serial.
 *
 * Cells of the coarse mesh are blocks of cells of the fine one. Cells that are congruent share a
 * matrix; others have one each. Products with A are computed in double precision and agree with the
 * assembled matrix up to rounding. The V-cycle computes in single precision: matrices of coarse
 * cells are sums over their children, A_H = Pᵀ A P, Chebyshev's iteration with diagonal blocks of
 * nodes smooths, and the coarsest level is solved directly.
 */
template <int dim>
class StiffnessMultigrid final : public StiffnessOperator
{
public:
  /**
   * Sets up all levels.
   * @throws ComputationError if the coarsest level cannot be factorised.
   */
  StiffnessMultigrid(const DisplacementSpace<dim> &space, const Scene<dim> &scene);
  ~StiffnessMultigrid() override;

  unsigned int size() const override;
  void apply(Vector &y, const Vector &x) const override;
  void precondition(Vector &z, const Vector &r) const override;

  /** Returns the diagonal of A; the unit of A at constrained degrees of freedom. */
  Vector diagonal() const;
  /** Returns the number of levels of a V-cycle. */
  unsigned int n_levels() const;
  /** Returns the memory of all stored data in bytes. */
  std::size_t memory() const;

private:
  class Levels;

  std::unique_ptr<Levels> levels_;
};

/** The tolerance of solves whose error must be negligible. */
constexpr double solve_tolerance = 1e-12;

/** The inverse A⁻¹ by conjugate gradients, each step with one V-cycle and one product with A.
 * They end when the energy norm of the error, as the V-cycle measures it, has fallen to a given
 * part. */
class MultigridInverse final : public StiffnessInverse
{
public:
  /**
   * Stores the operator.
   * @param diagonal of A.
   * @param goal that part.
   */
  MultigridInverse(std::shared_ptr<const StiffnessOperator> A,
                   const Vector &diagonal,
                   double goal = solve_tolerance);

  bool has_factors() const override
  {
    return false;
  }

  const StiffnessOperator &stiffness() const
  {
    return *A_;
  }
  /** Returns the largest number of V-cycles that a solve took so far. */
  unsigned int max_cycles_of_a_solve() const
  {
    return max_cycles_of_a_solve_;
  }

private:
  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override;
  void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const override;
  /**
   * Solves for one right-hand side.
   * @throws ComputationError if the iteration does not converge.
   */
  void solve_one(Vector &x, const Vector &b) const;

  std::shared_ptr<const StiffnessOperator> A_;
  double tolerance_;
  mutable unsigned int max_cycles_of_a_solve_ = 0;
};

/**
 * Makes the multigrid solver of a scene; serial.
 * @throws ComputationError see StiffnessMultigrid.
 */
template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         double goal = solve_tolerance);
} // namespace Signorini
