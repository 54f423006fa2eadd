// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/**
 * Refuses to start where libraries would hang or abort: without a working directory, and where the
 * address space (`ulimit -v`) is too small for the buffers of the BLAS, which waits for them
 * forever. With such a limit the buffers are taken at once.
 * @throws InputError, std::bad_alloc
 */
void check_surroundings();

/**
 * While an object of this class lives, MPI is being started. If MPI ends the process, which it does
 * with many lines on stderr, one line appears instead, with the first of MPI's messages, and the
 * exit code is 3. Otherwise what was printed on stderr appears when the object's life ends. At most
 * one lives at a time.
 */
class MPIStartGuard
{
public:
  MPIStartGuard();
  ~MPIStartGuard();
  MPIStartGuard(const MPIStartGuard &) = delete;
  MPIStartGuard &operator=(const MPIStartGuard &) = delete;
};
} // namespace Signorini
