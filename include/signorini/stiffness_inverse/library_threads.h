// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/**
 * Sets the number of threads of OpenBLAS, and whether other libraries may use OpenMP, while it
 * lives; where these are not in use it does nothing.
 *
 * Threads pay for the large dense fronts of MUMPS. On the small blocks of everything else they cost
 * CPU time and gain nothing (CHOLMOD moves its blocks by four OpenMP threads, however many cores
 * there are). So the program runs with one, and MUMPS asks for more.
 */
class LibraryThreads
{
public:
  /** @param n not more than OpenBLAS had at first (OPENBLAS_NUM_THREADS, or all cores) is taken. */
  explicit LibraryThreads(unsigned int n);
  ~LibraryThreads();
  LibraryThreads(const LibraryThreads &) = delete;
  LibraryThreads &operator=(const LibraryThreads &) = delete;

private:
  int blas_threads_before_;
  int parallel_levels_before_;
};
} // namespace Signorini
