// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem's C = D^T A^{-1} D and F = G - D^T A^{-1} f.

#include <signorini/compliance/compliance.h>
#include <signorini/stiffness_inverse/condensed_inverse.h>

#include <numeric>
#include <set>

namespace Signorini
{
namespace
{
/** C = D^T S^{-1} D = W^T W with S = L_22 L_22^T, W = L_22^{-1} D. */
dealii::FullMatrix<double> compliance_from_schur_factor(const CondensedInverse &inverse,
                                                        const Coupling &condensed_D)
{
  const unsigned int m = condensed_D.n_columns();
  const dealii::LAPACKFullMatrix<double> L_22 = inverse.schur_factor();
  dealii::LAPACKFullMatrix<double> W(L_22.m(), m);
  for (unsigned int tau = 0; tau < m; ++tau)
    for (const auto &entry : condensed_D.column(tau))
      W(inverse.schur_row(entry.first), tau) += entry.second;
  L_22.solve(W);
  dealii::LAPACKFullMatrix<double> C(m, m);
  W.Tmmult(C, W);
  dealii::FullMatrix<double> result(m, m);
  result = C;
  return result;
}
} // namespace

std::vector<dealii::types::global_dof_index> contact_unknowns(const Coupling &condensed_D)
{
  std::set<dealii::types::global_dof_index> rows;
  for (unsigned int tau = 0; tau < condensed_D.n_columns(); ++tau)
    for (const auto &entry : condensed_D.column(tau))
      rows.insert(entry.first);
  return {rows.begin(), rows.end()};
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

bool holds_compliance(const StiffnessInverse &inverse, const Coupling &condensed_D)
{
  const auto *const condensed = dynamic_cast<const CondensedInverse *>(&inverse);
  return condensed != nullptr && condensed->eliminates_last(contact_unknowns(condensed_D));
}

template <int dim>
void compute_compliance_columns(const StiffnessInverse &inverse,
                                const DisplacementSpace<dim> &space,
                                const Coupling &condensed_D,
                                const std::vector<unsigned int> &columns,
                                dealii::FullMatrix<double> &C,
                                const std::function<void(unsigned int)> &progress)
{
  const unsigned int m = condensed_D.n_columns(), n = static_cast<unsigned int>(columns.size());
  if (n == 0)
    return;
  dealii::FullMatrix<double> found(m, n);
  DistributedVector z = space.make_vector();
  DistributedVector column = space.make_vector();
  dealii::Vector<double> unit(m);
  for (unsigned int k = 0; k < n; ++k)
  {
    unit = 0.;
    unit[columns[k]] = 1.;
    column = 0.;
    condensed_D.add_product(unit, column);
    column.compress(dealii::VectorOperation::add);
    inverse.solve(z, column);
    const dealii::Vector<double> C_tau = condensed_D.local_transpose_product(z);
    for (unsigned int i = 0; i < m; ++i)
      found(i, k) = C_tau[i];
    if (progress)
      progress(k + 1);
  }
  dealii::Utilities::MPI::sum(found, space.mesh().communicator(), found);
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int i = 0; i < m; ++i)
      C(i, columns[k]) = found(i, k);
  // Where both columns were computed now, the mean; elsewhere the row is the column.
  std::vector<bool> is_new(m, false);
  for (const unsigned int tau : columns)
    is_new[tau] = true;
  for (const unsigned int tau : columns)
    for (unsigned int i = 0; i < m; ++i)
      if (!is_new[i])
        C(tau, i) = C(i, tau);
      else if (i < tau)
        C(tau, i) = C(i, tau) = 0.5 * (C(tau, i) + C(i, tau));
}

template <int dim>
dealii::FullMatrix<double> compute_compliance(const StiffnessInverse &inverse,
                                              const DisplacementSpace<dim> &space,
                                              const Coupling &condensed_D,
                                              const std::function<void(unsigned int)> &progress)
{
  const unsigned int m = condensed_D.n_columns();
  if (holds_compliance(inverse, condensed_D))
  {
    if (progress)
      progress(m);
    return compliance_from_schur_factor(dynamic_cast<const CondensedInverse &>(inverse),
                                        condensed_D);
  }
  std::vector<unsigned int> all(m);
  std::iota(all.begin(), all.end(), 0);
  dealii::FullMatrix<double> C(m, m);
  compute_compliance_columns(inverse, space, condensed_D, all, C, progress);
  return C;
}

template FreeState solve_free_state(const StiffnessInverse &,
                                    const DisplacementSpace<2> &,
                                    const DistributedVector &,
                                    const Coupling &,
                                    const dealii::Vector<double> &);
template void compute_compliance_columns(const StiffnessInverse &,
                                         const DisplacementSpace<2> &,
                                         const Coupling &,
                                         const std::vector<unsigned int> &,
                                         dealii::FullMatrix<double> &,
                                         const std::function<void(unsigned int)> &);
template dealii::FullMatrix<double> compute_compliance(const StiffnessInverse &,
                                                       const DisplacementSpace<2> &,
                                                       const Coupling &,
                                                       const std::function<void(unsigned int)> &);
} // namespace Signorini
