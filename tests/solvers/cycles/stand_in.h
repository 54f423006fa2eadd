// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <memory>

/** A from its entries, and V = A^{-1} - e/5 (diag A)^{-1}: as a V-cycle, it leaves at most about e
 * of an error, the largest part of the roughest. (The eigenvalues of (diag A)^{-1} A are below 5.)
 */
template <int dim>
class StandIn final : public Signorini::StiffnessOperator
{
public:
  StandIn(const Signorini::DisplacementSpace<dim> &space,
          const Signorini::LinearSystem<dim> &system,
          const double e)
    : space_(space)
    , system_(system)
    , e_(e)
    , inverse_(factorise(system.matrix, system.unit, Signorini::LinearSolver::condensed))
  {
  }

  unsigned int size() const override
  {
    return space_.dofs().n_dofs();
  }
  void vmult(Vector &y, const Vector &x) const override
  {
    Signorini::DistributedVector in = space_.make_vector(), out = space_.make_vector();
    for (unsigned int i = 0; i < x.size(); ++i)
      in(i) = space_.constraints().is_constrained(i) ? 0. : x[i];
    system_.matrix.vmult(out, in);
    for (unsigned int i = 0; i < x.size(); ++i)
      y[i] = space_.constraints().is_constrained(i) ? 0. : out(i) * system_.unit;
  }
  void precondition(Vector &z, const Vector &r) const override
  {
    Signorini::DistributedVector in = space_.make_vector(), out = space_.make_vector();
    for (unsigned int i = 0; i < r.size(); ++i)
      in(i) = space_.constraints().is_constrained(i) ? 0. : r[i];
    inverse_->solve(out, in);
    for (unsigned int i = 0; i < r.size(); ++i)
      z[i] = space_.constraints().is_constrained(i)
               ? 0.
               : out(i) - e_ / 5. * r[i] / (system_.matrix.diag_element(i) * system_.unit);
  }

private:
  const Signorini::DisplacementSpace<dim> &space_;
  const Signorini::LinearSystem<dim> &system_;
  double e_;
  std::unique_ptr<Signorini::StiffnessInverse> inverse_;
};
