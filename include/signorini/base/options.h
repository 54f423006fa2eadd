// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/** What the third direction does in two dimensions. */
enum class PlaneState
{
  strain,
  stress
};

/** The method for the dual problem. */
enum class ContactSolver
{
  /** multigrid on levels with many unknowns where it may be used, else active_set. */
  automatic,
  /** Projected SOR. */
  psor,
  /** The primal-dual active set method. */
  active_set,
  /** MPRGP: conjugate gradients and projected gradient steps. */
  mprgp,
  /** V-cycles, each followed by a problem on the boundary; no dual problem is formed. */
  multigrid
};

/** When V-cycles for contact end. */
enum class StopAt
{
  /** At the tolerance. */
  tolerance,
  /** At a tenth of the error of the discretisation, as the level before lets it expect. */
  discretisation_error
};

/** How systems with the stiffness matrix are solved. */
enum class LinearSolver
{
  /** condensed on one rank, amesos_mumps on several. */
  automatic,
  /** CHOLMOD; eliminates the contact unknowns last. One rank only. */
  condensed,
  /** MUMPS, distributed over all ranks. */
  amesos_mumps,
  /** KLU, gathered on one rank. */
  amesos_klu,
  /** Conjugate gradients with V-cycles; A is not assembled. One rank only. */
  multigrid
};
} // namespace Signorini
