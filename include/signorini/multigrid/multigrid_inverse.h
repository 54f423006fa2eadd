// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>
#include <signorini/stiffness_inverse/stiffness_operator.h>

#include <memory>

namespace Signorini
{
/** The goal of solves whose error must not matter. */
constexpr double goal_of_solves = 1e-12;

/** A^{-1} by conjugate gradients, each step with one V-cycle and one product with A, until the
 * energy norm of the error, as the V-cycle measures it, is a given part of what it was. */
class MultigridInverse final : public StiffnessInverse
{
public:
  /** @param diagonal of A. @param goal that part. */
  MultigridInverse(std::shared_ptr<const StiffnessOperator> A,
                   const Vector &diagonal,
                   double goal = goal_of_solves);

  bool has_factors() const override
  {
    return false;
  }

  const StiffnessOperator &stiffness() const
  {
    return *A_;
  }
  /** The largest number of V-cycles that a solve took so far. */
  unsigned int largest_number_of_cycles() const
  {
    return largest_number_of_cycles_;
  }

private:
  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override;
  void residual(Vector &r, const Vector &x, const Vector &b, bool accurate) const override;
  /** @throws ComputationError if the iteration does not converge. */
  void solve_one(Vector &x, const Vector &b) const;

  std::shared_ptr<const StiffnessOperator> A_;
  double goal_;
  mutable unsigned int largest_number_of_cycles_ = 0;
};

/** The multigrid solver of a scene; one rank. @throws ComputationError */
template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         double goal = goal_of_solves);
} // namespace Signorini
