// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/bound_constrained_qp.h>

#include <functional>
#include <vector>

namespace Signorini
{
/** Fills the given columns of C, and the rows of the same numbers. */
using ColumnSource =
  std::function<void(const std::vector<unsigned int> &columns, dealii::FullMatrix<double> &C)>;

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
 * @param C m x m; on return it holds the rows and columns of K, zeros elsewhere.
 */
QPResult solve_on_growing_set(const dealii::Vector<double> &F,
                              const dealii::Vector<double> &start,
                              const ColumnSource &columns,
                              const QPSolver &solve,
                              dealii::FullMatrix<double> &C);
} // namespace Signorini
