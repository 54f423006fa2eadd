// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/methods/contact_method.h>

#include <memory>

#include "one_level.h"

/** One level of a scene with U, P and the data they were computed from. */
struct SolvedLevel : public OneLevel {
  SolvedLevel(const std::string &text, const unsigned int number)
    : OneLevel(text, number)
    , system(assemble_linear_system(space(), scene, discretization.n_points))
    , inverse(Signorini::factorise(system.matrix, system.unit, Signorini::LinearSolver::automatic))
    , free(solve_free_state(*inverse, space(), system.f, discretization.D, discretization.G))
    , C(make_compliance(*inverse, discretization.condensed_D))
    , P(solve_dual_problem(C, free.F, discretization.K, {}, {}).P)
    , U(recover(P)) {}
  Signorini::Displacement recover(const Signorini::Pressure &pressure) const {
    return recover_displacement(*inverse, space(), discretization.condensed_D, pressure, system.f);
  }

  /** Returns contact as a method hands it on, with another U and P. */
  Signorini::ContactSolution contact(const Signorini::Displacement &displacement,
                                     const Signorini::Pressure &pressure) const {
    Signorini::ContactSolution contact;
    contact.U = displacement;
    contact.P = pressure;
    contact.W = discretization.gap_residual(displacement);
    contact.C_P = C->apply(pressure);
    contact.diagonal_P = C->diagonal_times(pressure);
    contact.data = Signorini::DualData{free, free.F, Signorini::FreeMotions()};
    return contact;
  }
  Signorini::LevelOperators<2> operators() const {
    Signorini::LevelOperators<2> operators;
    operators.inverse = inverse;
    operators.C = C;
    return operators;
  }

  Signorini::LinearSystem<2> system;
  std::shared_ptr<const Signorini::StiffnessInverse> inverse;
  Signorini::FreeState free;
  std::shared_ptr<const Signorini::ComplianceOperator> C;
  Signorini::Pressure P;
  Signorini::Displacement U;
};
