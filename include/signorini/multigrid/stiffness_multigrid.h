// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/scene/scene.h>
#include <signorini/stiffness_inverse/stiffness_operator.h>

#include <cstddef>
#include <memory>

namespace Signorini
{
/**
 * A cell by cell, and a V-cycle on the levels of the mesh. Elements of degree one on meshes without
 * hanging nodes, on one rank.
 *
 * Cells of the coarse mesh are blocks of cells of the fine one. Cells that are congruent share a
 * matrix; others have one each. Products with A are computed in double precision and agree with the
 * assembled matrix up to rounding. The V-cycle computes in single precision: matrices of coarse
 * cells are sums over their children, A_H = P^T A P, Chebyshev's iteration with diagonal blocks of
 * nodes smooths, and the coarsest level is solved directly.
 */
template <int dim>
class StiffnessMultigrid final : public StiffnessOperator
{
public:
  /** @throws ComputationError if the coarsest level cannot be factorised. */
  StiffnessMultigrid(const DisplacementSpace<dim> &space, const Scene<dim> &scene);
  ~StiffnessMultigrid() override;

  unsigned int size() const override;
  void apply(Vector &y, const Vector &x) const override;
  void precondition(Vector &z, const Vector &r) const override;

  /** The diagonal of A; the unit of A at constrained degrees of freedom. */
  Vector diagonal() const;
  /** How many levels a V-cycle has. */
  unsigned int n_levels() const;
  /** Bytes of all that is kept. */
  std::size_t memory() const;

private:
  class Levels;

  std::unique_ptr<Levels> levels_;
};
} // namespace Signorini
