// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/errors/dual_norm_errors.h>
#include <signorini/multiplier/coupling.h>
#include <signorini/multiplier/multiplier_space.h>
#include <signorini/parameters/parameters.h>
#include <signorini/record/level_record.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <string>

namespace Signorini
{
/** T^h, V^h, Gamma_c^H, Q^H, D and G of one level. */
template <int dim>
struct Discretization
{
  Discretization(const Parameters &parameters,
                 const Scene<dim> &scene,
                 unsigned int level,
                 MPI_Comm communicator);

  /** What the mesh and the setup took. */
  StageTimes times;
  Mesh<dim> mesh;
  /** Gauss points per direction for loads; errors take one more. */
  unsigned int n_points;
  DisplacementSpace<dim> space;
  MultiplierSpace<dim> multipliers;
  Coupling D;
  Coupling condensed_D;
  dealii::Vector<double> G;
};

/** The contact pressure of a level, as the next one starts from it. */
struct StartingPressure
{
  std::vector<Patch> patches;
  dealii::Vector<double> P;
};

/** The answer of one level with what it was computed from. */
template <int dim>
struct LevelSolution
{
  /** Filled up to recovery; errors and output follow. */
  LevelRecord record;
  NodalVector U;
  dealii::Vector<double> P;
  dealii::Vector<double> F;
  /** Empty if nothing touches. */
  dealii::FullMatrix<double> C;
  /** f_j for all j, not condensed. */
  DistributedVector loads;
};

/** Called with what is being done, for the user to watch. */
using Progress = std::function<void(const std::string &)>;

/**
 * Solves (5) on one level: A and f, the factorisation, F, where something touches C and P, then U,
 * the certificate, and the error estimate. Collective.
 *
 * @param start pressure of the level before; without patches: none.
 */
template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const StartingPressure &start,
                               const Progress &progress);

/**
 * Adds the errors against the exact solution, as far as it is known. Collective.
 * @param pressure the exact pressure; null if it is not known.
 */
template <int dim>
void add_errors(const Parameters &parameters,
                const Scene<dim> &scene,
                const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution);
} // namespace Signorini
