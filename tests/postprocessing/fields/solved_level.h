// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <memory>

#include "one_level.h"

/** One level of a scene with U, P and what they were computed from. */
struct SolvedLevel : public OneLevel {
  SolvedLevel(const std::string &text, const unsigned int number)
    : OneLevel(text, number)
    , system(assemble_linear_system(space(), scene, discretization.n_points))
    , inverse(factorise(system.matrix, system.unit, Signorini::LinearSolver::automatic))
    , free(solve_free_state(*inverse, space(), system.f, discretization.D, discretization.G))
    , C(make_compliance(*inverse, discretization.condensed_D, seconds))
    , P(solve_dual_problem(C, free.F, {}, {}).P)
    , U(recover(P)) {}
  Signorini::Displacement recover(const Signorini::Pressure &pressure) const {
    return recover_displacement(*inverse, space(), discretization.condensed_D, pressure, system.f);
  }

  Signorini::LinearSystem<2> system;
  std::unique_ptr<Signorini::StiffnessInverse> inverse;
  Signorini::FreeState free;
  double seconds = 0.;
  std::shared_ptr<const Signorini::ComplianceOperator> C;
  Signorini::Pressure P;
  Signorini::Displacement U;
};
