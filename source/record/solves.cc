// SPDX-License-Identifier: LGPL-2.1-or-later
// What convergence.csv shows of the dual problem's solver.

#include <signorini/record/solves.h>

namespace Signorini
{
Columns<DualSolve> DualSolve::columns()
{
  return {{"qp_iterations", &DualSolve::iterations},
          {"kkt", &DualSolve::kkt},
          {"qp_increment_iterations", &DualSolve::increment_iterations}};
}
} // namespace Signorini
