// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/**
 * Sets the number of threads of OpenBLAS while it lives; with any other BLAS it does nothing.
 *
 * Threads pay for the large dense fronts of MUMPS; on the small blocks of everything else they
 * double the CPU time and gain nothing. So the program runs with one, and MUMPS asks for more.
 */
class BlasThreads
{
public:
  /** @param n not more than OpenBLAS had at first (OPENBLAS_NUM_THREADS, or all cores) is taken. */
  explicit BlasThreads(unsigned int n);
  ~BlasThreads();
  BlasThreads(const BlasThreads &) = delete;
  BlasThreads &operator=(const BlasThreads &) = delete;

private:
  int before_;
};
} // namespace Signorini
