// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/bound_constrained_qp.h>

#include <functional>
#include <vector>

namespace Signorini
{
/** A solver of the dual problem with a start, which may be empty. */
using QPSolver =
  std::function<QPResult(const BoundConstrainedQP &qp, const dealii::Vector<double> &start)>;

/**
 * The dual problem with the bound zero where columns of C are expensive: solved on a set K of
 * patches, with P = 0 elsewhere; then the patches with W = C P - F > 0 join K, until there are
 * none. The answer solves the whole problem, and only the columns of K were needed.
 *
 * @param start K begins with the patches that press in it, and their neighbours; where nothing
 * presses, with F < 0.
 */
QPResult solve_on_growing_set(const ComplianceOperator &C,
                              const dealii::Vector<double> &F,
                              const dealii::Vector<double> &start,
                              const QPSolver &solve);
} // namespace Signorini
