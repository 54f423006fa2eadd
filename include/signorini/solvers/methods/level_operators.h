// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/motion_modes.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <memory>

namespace Signorini {
/** The operators of a level. The level owns them, as long as somebody solves with them, and lends
 * them: to its own dual problem, to the estimate and the bound of the error, to load cases. */
template <int dim>
struct LevelOperators {
  /** The matrix A, where it is assembled, f and the loads. */
  std::shared_ptr<const LinearSystem<dim>> system;
  /** A⁻¹ by factors, or by V-cycles with a tolerance that suffices for estimates. */
  std::shared_ptr<const StiffnessInverse> inverse;
  MotionModes<dim> modes;
  /** The compliance C = Dᵀ A⁻¹ D; V-cycles have none. */
  std::shared_ptr<const ComplianceOperator> C;
  /** The times of all these. */
  StageTimes times;
};
} // namespace Signorini
