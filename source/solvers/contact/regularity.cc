// SPDX-License-Identifier: LGPL-2.1-or-later
// Uniqueness with Coulomb's friction for bodies that move freely.

#include <signorini/solvers/contact/free_motions.h>

namespace Signorini {
std::optional<Regularity> examine_regularity(const std::shared_ptr<const ComplianceOperator> &C,
                                             const FreeMotions &motions, const AdmissibleSet &K,
                                             const dealii::Vector<double> &P) {
  Balances balances;
  if (motions.b.size() > 0) {
    const double stiffness = P.size() * P.size() / C->diagonal().l1_norm();
    balances = ReducedMotions(motions, K, stiffness).balances;
  }
  return examine_regularity(BoundConstrainedQP(C, dealii::Vector<double>(P.size()), K, balances),
                            P);
}
} // namespace Signorini
