// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/level/discretization.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/results/record/level_record.h>
#include <signorini/solvers/kinematics/free_motions.h>
#include <signorini/solvers/kinematics/motion_modes.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace Signorini
{
/** What load cases are solved with. */
template <int dim>
struct LevelFactors
{
  std::shared_ptr<const LinearSystem<dim>> system;
  std::shared_ptr<const StiffnessInverse> inverse;
  MotionModes<dim> modes;
};

/** The answer of one level with what it was computed from. */
template <int dim>
struct LevelSolution
{
  /** Filled up to recovery; errors and output follow. */
  LevelRecord record;
  /** Empty where record.bound is. */
  BoundFields bound_fields;
  NodalVector U;
  dealii::Vector<double> P;
  dealii::Vector<double> F;
  /** t, for the next level; zero where no V-cycles were used. */
  double contact_scale = 0.;
  /** About the part of the duality gap that V-cycles leave in A U = f + D P (energy). */
  double energy_of_residual = 0.;
  /** See algebraic_error() (energy norm). */
  double algebraic_error = 0.;
  /** Only with Output/Compliance, and empty if nothing touches. */
  dealii::FullMatrix<double> C;
  /** B, K and b of free motions, and q; empty without. */
  FreeMotions motions;
  dealii::Vector<double> q;
  /** Only for scenes with load cases. */
  std::shared_ptr<const LevelFactors<dim>> factors;
  /** The scene with plates where they have moved to. */
  Scene<dim> scene;
  /** f_j for all j, not condensed. */
  DistributedVector loads;
  /** A and f. Only with Output/Compliance. */
  std::shared_ptr<const LinearSystem<dim>> system;
};

/** What a level starts from; all of it may be missing. */
struct LevelStart
{
  /** @param P a pressure on the patches of the level; empty: none. */
  LevelStart(dealii::Vector<double> P = {})
    : P(std::move(P))
  {
  }

  dealii::Vector<double> P;
  /** Nodal values of a displacement; empty: none. Only V-cycles use it. */
  NodalVector U;
  /** t of the level before, see ContactIterationOptions; zero: none. */
  double scale = 0.;
  /** The estimated error of the level before, relative in the energy norm; none: unknown. */
  std::optional<double> relative_error;
};

/** Called with what is being done, for the user to watch. */
using Progress = std::function<void(const std::string &)>;

/**
 * Solves (5) on one level: A and f, the factorisation, F, where something touches C and P, then U,
 * the certificate, and the error estimate. Collective.
 *
 * With Contact solver = multigrid A is neither assembled nor factorised, and V-cycles take the
 * place of F, C and the dual problem.
 */
template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const LevelStart &start,
                               const Progress &progress);

/**
 * Adds the errors against the exact solution, as far as it is known. Collective.
 * @param pressure the exact pressure for the dual norms; null if it is not known, or if they are
 * not wanted.
 */
template <int dim>
void add_errors(const Parameters &parameters,
                const Scene<dim> &scene,
                const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution);
} // namespace Signorini
