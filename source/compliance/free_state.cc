// SPDX-License-Identifier: LGPL-2.1-or-later
// F = G - D^T A^{-1} f of the dual problem.

#include <signorini/compliance/free_state.h>

#include <algorithm>

namespace Signorini
{
bool FreeState::nothing_touches() const
{
  return std::none_of(F.begin(), F.end(), [](const double opening) { return opening < 0.; });
}

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

template FreeState solve_free_state(const StiffnessInverse &,
                                    const DisplacementSpace<2> &,
                                    const DistributedVector &,
                                    const Coupling &,
                                    const dealii::Vector<double> &);
template FreeState solve_free_state(const StiffnessInverse &,
                                    const DisplacementSpace<3> &,
                                    const DistributedVector &,
                                    const Coupling &,
                                    const dealii::Vector<double> &);
} // namespace Signorini
