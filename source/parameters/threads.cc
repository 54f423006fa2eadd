// SPDX-License-Identifier: LGPL-2.1-or-later
// Threads of one process.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>
#include <signorini/parameters/threads.h>

#include <algorithm>
#include <cmath>
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

void check_thread_limit()
{
  constexpr double largest = 1024.;
  const char *const given = std::getenv("DEAL_II_NUM_THREADS");
  double number = 0.;
  if (given == nullptr || (read_number(given, number) && number >= 1. && number <= largest &&
                           number == std::floor(number) &&
                           std::string(given).find_first_not_of("0123456789") == std::string::npos))
    return;
  throw InputError("The environment variable DEAL_II_NUM_THREADS: found " + quote(given) +
                   ", allowed: an integer from 1 to 1024, or to leave it unset.");
}
} // namespace Signorini
