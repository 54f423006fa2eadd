// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <functional>
#include <memory>
#include <vector>

namespace Signorini {
/** A callback that gets the number of columns of C that are finished. */
using ColumnProgress = std::function<void(unsigned int)>;

/** Returns the rows of D that are not zero, in ascending order: the contact unknowns of
 * factorise(). */
std::vector<types::global_dof_index> contact_unknowns(const Coupling &condensed_D);

/**
 * Makes C = Dᵀ A⁻¹ D, m x m, with the condensed coupling; every rank stores it.
 *
 * Where the factors hold A⁻¹ for the contact unknowns (StiffnessInverse::trailing_factor), C is
 * read from them without a solve. Otherwise C is a ColumnCompliance. The inverse and D must outlive
 * the result. This function and all functions of the result are collective.
 */
std::shared_ptr<const ComplianceOperator> make_compliance(const StiffnessInverse &inverse,
                                                          const Coupling &condensed_D,
                                                          const ColumnProgress &progress = {});

/** The compliance C = Dᵀ A⁻¹ D by columns C_k = Dᵀ A⁻¹ D_k. Each column costs one solve; it
 * is computed at its first use and kept. Columns are symmetrised among each other. */
class ColumnCompliance final : public DenseCompliance {
public:
  ColumnCompliance(const StiffnessInverse &inverse, const Coupling &condensed_D,
                   ColumnProgress progress);

  bool is_explicit() const override {
    return n_known_ == size();
  }

private:
  void require(const Indices &numbers) const override;
  /** Returns Dᵀ A⁻¹ D_k for the given k, m x n. */
  Matrix solve_for(const Indices &numbers) const;

  const StiffnessInverse &inverse_;
  const Coupling &D_;
  ColumnProgress progress_;
  mutable std::vector<bool> known_;
  mutable unsigned int n_known_ = 0;
};

/** The displacement of the body without contact pressure, and the opening that it leaves. */
struct FreeState {
  /** The complete nodal values U_0 = A⁻¹ f. */
  Displacement U;
  /** The free opening F = G - Dᵀ U_0 of each patch, negative where the body penetrates
   * (length^dim). */
  dealii::Vector<double> F;

  /** Returns whether P = 0 solves the dual problem over K, without friction whether F ≥ 0. Then C
   * is not needed. */
  bool nothing_touches(const AdmissibleSet &K) const;
};

/** Computes F = G - Dᵀ A⁻¹ f by one solve; openings as small as rounding are zero. Collective. */
template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse, const DisplacementSpace<dim> &space,
                           const DualVector &f, const Coupling &D, const dealii::Vector<double> &G);

/** Returns U = A⁻¹(D P + f), (23): step (iv) of the algorithm. Collective. */
template <int dim>
Displacement recover_displacement(const StiffnessInverse &inverse,
                                  const DisplacementSpace<dim> &space, const Coupling &condensed_D,
                                  const dealii::Vector<double> &P, const DualVector &f);

/** Returns A⁻¹ b with homogeneous essential conditions: the displacement that the forces b
 * add. Collective. */
template <int dim>
Displacement solve_homogeneous(const StiffnessInverse &inverse, const DisplacementSpace<dim> &space,
                               const DualVector &b);
} // namespace Signorini
