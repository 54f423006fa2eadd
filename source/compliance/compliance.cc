// SPDX-License-Identifier: LGPL-2.1-or-later
// C = D^T A^{-1} D: read from the factors, or by columns.

#include <signorini/base/stage_timer.h>
#include <signorini/compliance/column_compliance.h>
#include <signorini/compliance/compliance.h>

#include <set>

namespace Signorini
{
namespace
{
/** C = D^T S^{-1} D = W^T W with S = L L^T, W = L^{-1} D. */
dealii::FullMatrix<double> compliance_from(TrailingFactor &factor, const Coupling &condensed_D)
{
  // A matrix of LAPACK that was moved has forgotten it.
  factor.L.set_property(dealii::LAPACKSupport::lower_triangular);
  const unsigned int m = condensed_D.n_columns();
  dealii::LAPACKFullMatrix<double> W(factor.L.m(), m);
  for (unsigned int k = 0; k < m; ++k)
    for (const auto &entry : condensed_D.column(k))
      W(factor.rows.at(entry.first), k) += entry.second;
  factor.L.solve(W);
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
  for (unsigned int k = 0; k < condensed_D.n_columns(); ++k)
    for (const auto &entry : condensed_D.column(k))
      rows.insert(entry.first);
  return {rows.begin(), rows.end()};
}

std::shared_ptr<const ComplianceOperator> make_compliance(const StiffnessInverse &inverse,
                                                          const Coupling &condensed_D,
                                                          double &seconds,
                                                          const ColumnProgress &progress)
{
  const StageTimer timer(seconds);
  if (auto factor = inverse.trailing_factor(contact_unknowns(condensed_D)))
    return std::make_shared<const DenseCompliance>(compliance_from(*factor, condensed_D));
  return std::make_shared<const ColumnCompliance>(inverse, condensed_D, seconds, progress);
}
} // namespace Signorini
