// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/coupling.h>
#include <signorini/qp/compliance_operator.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <functional>
#include <memory>

namespace Signorini
{
/** Called with the number of columns of C that are finished. */
using ColumnProgress = std::function<void(unsigned int)>;

/** The rows of D that are not zero, in ascending order: the contact unknowns of factorise(). */
std::vector<dealii::types::global_dof_index> contact_unknowns(const Coupling &condensed_D);

/**
 * C = D^T A^{-1} D with the condensed coupling, m x m, known to every rank.
 *
 * Where the factors hold A^{-1} for the contact unknowns (StiffnessInverse::trailing_factor), C is
 * read from them without a solve. Otherwise C is a ColumnCompliance. The inverse and D must outlive
 * the result. Collective, as is everything that the result is asked for.
 *
 * @param seconds the wall seconds of all work on C are added to it, also later.
 */
std::shared_ptr<const ComplianceOperator> make_compliance(const StiffnessInverse &inverse,
                                                          const Coupling &condensed_D,
                                                          double &seconds,
                                                          const ColumnProgress &progress = {});
} // namespace Signorini
