// SPDX-License-Identifier: LGPL-2.1-or-later
// Threads of one process.

#include <signorini/base/threads.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace Signorini
{
unsigned int number_of_threads(MPI_Comm communicator)
{
  if (const char *const given = std::getenv("DEAL_II_NUM_THREADS"))
    return static_cast<unsigned int>(std::max(1L, std::strtol(given, nullptr, 10)));
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);
  return n_ranks > 1 ? 1U : std::max(1U, std::thread::hardware_concurrency());
}

void work_on_ranges(const unsigned int n_threads,
                    const std::size_t n,
                    const std::function<void(std::size_t, std::size_t)> &work)
{
  constexpr std::size_t length = 512;
  produce_in_parallel<bool>(
    n_threads,
    (n + length - 1) / length,
    [&](const std::size_t i) {
      work(i * length, std::min(n, (i + 1) * length));
      return true;
    },
    [](const bool) {});
}
} // namespace Signorini
