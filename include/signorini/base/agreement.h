// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <functional>
#include <string>

namespace Signorini
{
/**
 * Runs @p work, which must not communicate, and lets all ranks leave together: if it throws on one
 * of them, all throw. An InputError, ComputationError or WritingError keeps its type and its
 * message (that of the lowest rank that threw one), and std::bad_alloc its type; others become
 * std::runtime_error. Collective.
 */
void agree(MPI_Comm communicator, const std::function<void()> &work);

/** "rank 1" or "the ranks 1, 3": those on which @p condition holds; empty if there are none. Every
 * rank knows the answer. Collective. */
std::string list_ranks(MPI_Comm communicator, bool condition);
} // namespace Signorini
