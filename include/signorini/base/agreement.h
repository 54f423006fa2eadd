// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <functional>

namespace Signorini
{
/**
 * Runs @p work, which must not communicate, and lets all ranks leave together: if it throws on one
 * of them, all throw. An InputError or ComputationError keeps its type and its message (that of the
 * lowest rank that threw one); others become std::runtime_error. Collective.
 */
void agree(MPI_Comm communicator, const std::function<void()> &work);
} // namespace Signorini
