// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem's C = D^T A^{-1} D and F = G - D^T A^{-1} f.

#include <signorini/compliance/compliance.h>

namespace Signorini
{
template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse,
                           const DisplacementSpace<dim> &space,
                           const DistributedVector &f,
                           const Coupling &D,
                           const dealii::Vector<double> &G)
{
  DistributedVector U_0 = space.make_vector();
  inverse.solve(U_0, f);
  FreeState state;
  state.U = space.complete(U_0);
  state.F = G;
  state.F -= D.transpose_product(state.U);
  return state;
}

template <int dim>
dealii::FullMatrix<double> compute_compliance(const StiffnessInverse &inverse,
                                              const DisplacementSpace<dim> &space,
                                              const Coupling &condensed_D,
                                              const std::function<void(unsigned int)> &progress)
{
  const unsigned int m = condensed_D.n_columns();
  dealii::FullMatrix<double> C(m, m);
  DistributedVector z = space.make_vector();
  DistributedVector column = space.make_vector();
  dealii::Vector<double> unit(m);
  for (unsigned int tau = 0; tau < m; ++tau)
  {
    unit = 0.;
    unit[tau] = 1.;
    column = 0.;
    condensed_D.add_product(unit, column);
    column.compress(dealii::VectorOperation::add);
    inverse.solve(z, column);
    const dealii::Vector<double> C_tau = condensed_D.local_transpose_product(z);
    for (unsigned int i = 0; i < m; ++i)
      C(i, tau) = C_tau[i];
    if (progress)
      progress(tau + 1);
  }
  dealii::Utilities::MPI::sum(C, space.mesh().communicator(), C);
  C.symmetrize();
  return C;
}

template FreeState solve_free_state(const StiffnessInverse &,
                                    const DisplacementSpace<2> &,
                                    const DistributedVector &,
                                    const Coupling &,
                                    const dealii::Vector<double> &);
template dealii::FullMatrix<double> compute_compliance(const StiffnessInverse &,
                                                       const DisplacementSpace<2> &,
                                                       const Coupling &,
                                                       const std::function<void(unsigned int)> &);
} // namespace Signorini
