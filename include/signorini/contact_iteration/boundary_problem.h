// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/boundary_model/boundary_model.h>

namespace Signorini
{
/**
 * Q <= 0 with V = W + C^ (Q - P) <= 0 and Q.V = 0, by the primal-dual active set method, begun with
 * the set that P and W predict. Each of its steps is a BoundaryModel::solve for the change Q - P.
 * Where sets come back, solve_by_active_set() answers.
 *
 * @param P <= 0.
 */
dealii::Vector<double> solve_boundary_problem(const BoundaryModel &model,
                                              const dealii::Vector<double> &W,
                                              const dealii::Vector<double> &P);
} // namespace Signorini
