// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/stiffness/cell_operator.h>
#include <signorini/solvers/stiffness/coarsest_inverse.h>
#include <signorini/solvers/stiffness/shared_nodes.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/** One level of the V-cycle, in single precision. */
template <int dim>
struct MultigridLevel {
  MultigridLevel(const CellOperator<dim, double> &fine_K, ConstrainedNodes<dim> conditions,
                 SharedNodes shared);

  /** Returns the diagonal blocks of Tᵀ K T, with the unit matrix for constrained components. */
  std::vector<Tensor<2, dim>> free_diagonal_blocks() const;
  /**
   * Does steps of Chebyshev's iteration of the fourth kind (J. Lottes, Numer. Linear Algebra Appl.
   * 30 (2023) e2518): x changes by a polynomial in B A that depends on the largest eigenvalue only.
   * @param from_zero x is assumed to be zero.
   */
  void smooth(bool from_zero);
  std::size_t memory() const {
    return K.grid->memory() + K.memory() +
           conditions.size() * sizeof(typename ConstrainedNodes<dim>::value_type) + 4 * x.memory() +
           B.memory();
  }

  CellOperator<dim, float> K;
  ConstrainedNodes<dim> conditions;
  SharedNodes shared;
  /** The solution, the right-hand side, K x or a residual, and the last change of x. */
  LevelVector<dim, float> x, b, y, d;
  /** The inverses of the diagonal blocks on the displacements that the conditions allow. */
  NodeBlocks<dim> B;
  /** An upper bound of the eigenvalues of B A. */
  double max_eigenvalue;
};

/**
 * The stiffness A cell by cell, and a V-cycle on the levels of the mesh. It exists for elements of
 * degree one on meshes without hanging nodes.
 *
 * The roots of the subtrees of this rank (on one rank the cells of the coarse mesh) are blocks of
 * cells of the fine one. On several ranks the levels below the blocks are on every rank. Products
 * with A are computed in double precision and agree with the assembled matrix up to rounding. The
 * V-cycle computes in single precision: matrices of coarse cells are sums over their children, A_H
 * = Pᵀ A P, Chebyshev's iteration with diagonal blocks of nodes smooths, and the coarsest level is
 * factorised.
 */
template <int dim>
class StiffnessMultigrid final : public StiffnessOperator {
public:
  /**
   * Sets up all levels.
   * @throws ComputationError if the coarsest level cannot be factorised.
   */
  StiffnessMultigrid(const DisplacementSpace<dim> &space, const Scene<dim> &scene);

  Vector make_vector() const override {
    return Vector(rows_, communicator_);
  }
  void vmult(Vector &y, const Vector &x) const override;
  void precondition(Vector &z, const Vector &r) const override;

  /** Returns the diagonal of A; the unit of A at constrained degrees of freedom. */
  Vector diagonal() const;
  /** Returns the memory of all stored data in bytes. */
  std::size_t memory() const;

private:
  /** Makes coarser levels from the last one as long as that has many nodes. @return the last. */
  std::shared_ptr<const CellOperator<dim, double>>
  add_coarser_levels(std::shared_ptr<const CellOperator<dim, double>> K);
  void solve_coarsest(MultigridLevel<dim> &level) const;
  /** Does the V-cycle of a level by that of its copy on every rank. */
  void cycle_on_copy(unsigned int l) const;
  void cycle(unsigned int l) const;
  template <typename Number>
  void copy_to_level(LevelVector<dim, Number> &to, const Vector &from, double factor) const;
  template <typename Number>
  void copy_from_level(Vector &to, const LevelVector<dim, Number> &from, double factor) const;

  double unit_;
  IndexSet rows_;
  MPI_Comm communicator_;
  std::shared_ptr<const CellOperator<dim, double>> K_;
  /** The vectors for products in double precision. */
  mutable LevelVector<dim, double> x_, y_;
  /** The levels from the finest to the coarsest. */
  mutable std::vector<MultigridLevel<dim>> levels_;
  /** The level that is followed by its copy on every rank, and the nodes of this rank there. */
  std::optional<unsigned int> copied_level_;
  std::vector<NodeNumber> nodes_of_copy_;
  std::unique_ptr<const CoarsestInverse<dim>> coarsest_inverse_;
};

/** The tolerance of solves whose error must be negligible. */
constexpr double solve_tolerance = 1e-12;

/** The inverse A⁻¹ by conjugate gradients, each step with one V-cycle and one product with A.
 * They end when the residual has fallen to a given part. */
class MultigridInverse final : public StiffnessInverse {
public:
  /**
   * Stores the operator.
   * @param diagonal of A.
   * @param goal that part.
   */
  MultigridInverse(std::shared_ptr<const StiffnessOperator> A, const Vector &diagonal,
                   double goal = solve_tolerance);

  const StiffnessOperator *cycles() const override {
    return A_.get();
  }

private:
  /** Solves. @throws ComputationError if the iteration does not converge. */
  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override;
  void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const override;

  std::shared_ptr<const StiffnessOperator> A_;
  double tolerance_;
};

/**
 * Makes the multigrid solver of a scene. Collective.
 * @throws ComputationError see StiffnessMultigrid.
 */
template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         double goal = solve_tolerance);
} // namespace Signorini
