// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/multiplier/multiplier_space.h>

#include <utility>
#include <vector>

namespace Signorini
{
/**
 * D, n x m: one sparse column per multiplier, nonzero at the degrees of freedom near its patch.
 * Small, and known to every rank as a whole.
 */
class Coupling
{
public:
  using Column = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  explicit Coupling(std::vector<Column> columns);

  unsigned int n_columns() const
  {
    return columns_.size();
  }
  const Column &column(const unsigned int k) const
  {
    return columns_[k];
  }
  /** vector += D P, the locally owned rows. The caller compresses. */
  void add_product(const dealii::Vector<double> &P, DistributedVector &vector) const;
  /** D^T U. */
  dealii::Vector<double> transpose_product(const NodalVector &U) const;
  /** D^T U from the locally owned rows of a distributed U; summed over the ranks it is D^T U. */
  dealii::Vector<double> local_transpose_product(const DistributedVector &U) const;

private:
  std::vector<Column> columns_;
};

/**
 * D_jk = int_{Gamma_c} phi_j.n psi_k, integrated exactly on the pieces face ∩ patch.
 */
template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const MultiplierSpace<dim> &multipliers);

/** T^T D: the coupling seen from the unconstrained degrees of freedom. */
Coupling condense(const Coupling &D, const dealii::AffineConstraints<double> &constraints);
} // namespace Signorini
