// SPDX-License-Identifier: LGPL-2.1-or-later
// F = G - Dᵀ A⁻¹ f of the dual problem.

#include <signorini/solvers/contact/recovery.h>

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

// U = A⁻¹(D P + f), (23).

template <int dim>
Displacement recover_displacement(const StiffnessInverse &inverse,
                                  const DisplacementSpace<dim> &space,
                                  const Coupling &condensed_D,
                                  const dealii::Vector<double> &P,
                                  const DistributedVector &f)
{
  DistributedVector DP_plus_f(f);
  condensed_D.add_product(P, DP_plus_f);
  DP_plus_f.compress(dealii::VectorOperation::add);
  DistributedVector U = space.make_vector();
  inverse.solve(U, DP_plus_f);
  return space.complete(U);
}

template <int dim>
Displacement solve_homogeneous(const StiffnessInverse &inverse,
                               const DisplacementSpace<dim> &space,
                               DistributedVector &b)
{
  b.compress(dealii::VectorOperation::add);
  DistributedVector x = space.make_vector();
  inverse.solve(x, b);
  Displacement w = space.displacement(x);
  space.distribute_homogeneous(w);
  return w;
}

template <int dim>
Displacement solve_prescribed(const StiffnessInverse &inverse,
                              const DisplacementSpace<dim> &space,
                              const Displacement &k,
                              const DualVector &r)
{
  const DualVector condensed = space.condense(r);
  DistributedVector b = space.make_vector();
  for (const auto i : space.locally_owned())
    b(i) += condensed(i);
  Displacement U = solve_homogeneous(inverse, space, b);
  U += k;
  return U;
}

template Displacement solve_prescribed(const StiffnessInverse &,
                                       const DisplacementSpace<2> &,
                                       const Displacement &,
                                       const DualVector &);
template Displacement solve_homogeneous(const StiffnessInverse &,
                                        const DisplacementSpace<2> &,
                                        DistributedVector &);
template Displacement solve_homogeneous(const StiffnessInverse &,
                                        const DisplacementSpace<3> &,
                                        DistributedVector &);
template Displacement recover_displacement(const StiffnessInverse &,
                                           const DisplacementSpace<2> &,
                                           const Coupling &,
                                           const dealii::Vector<double> &,
                                           const DistributedVector &);
template Displacement recover_displacement(const StiffnessInverse &,
                                           const DisplacementSpace<3> &,
                                           const Coupling &,
                                           const dealii::Vector<double> &,
                                           const DistributedVector &);
} // namespace Signorini
