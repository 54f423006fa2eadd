// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <mpi.h>

namespace Signorini
{
/** Whether Strategy = hp solves such scenes: bodies in the plane, on one process. */
template <int dim>
bool can_be_graded(const unsigned int n_ranks)
{
  return dim == 2 && n_ranks == 1;
}

/**
 * Refuses settings that contradict the scene or the number of ranks: a linear solver that does not
 * work on several, and a coarsest level with sides that end inside faces.
 * @throws InputError
 */
template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator);
} // namespace Signorini
