// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/mesh/contact_partition.h>
#include <signorini/mesh/kinks.h>

#include <utility>
#include <vector>

namespace Signorini
{
/**
 * D, n x m: one sparse column per patch, nonzero at the degrees of freedom next to it. Small, and
 * known to every rank as a whole.
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
  const Column &column(const unsigned int patch) const
  {
    return columns_[patch];
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
 * D_{j tau} = int_tau phi_j.n, integrated exactly on the pieces face ∩ tau.
 */
template <int dim>
Coupling assemble_coupling(const DisplacementSpace<dim> &space,
                           const std::vector<ContactFace<dim>> &faces,
                           const ContactPartition &partition);

/** u_h.n at arc length @p s of a contact face, on which the trace of u_h is linear. */
template <int dim>
double normal_displacement(const DisplacementSpace<dim> &space,
                           const ContactFace<dim> &face,
                           const dealii::Tensor<1, dim> &normal,
                           const NodalVector &U,
                           double s);

/** T^T D: the coupling seen from the unconstrained degrees of freedom. */
Coupling condense(const Coupling &D, const dealii::AffineConstraints<double> &constraints);
} // namespace Signorini
