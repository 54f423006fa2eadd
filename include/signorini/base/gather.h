// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace Signorini
{
/** All ranks' texts on rank 0, in order; nothing on the others. Collective. @throws
 * ComputationError if one has 2 GiB or more. */
std::vector<std::string> gather_texts(std::string text, MPI_Comm communicator);
} // namespace Signorini
