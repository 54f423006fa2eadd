// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <optional>
#include <vector>

namespace Signorini {
/**
 * Returns how many threads this process may use: DEAL_II_NUM_THREADS if that is set; otherwise one
 * if there are several ranks, and one for each core if there is a single rank.
 */
unsigned int n_available_threads();

/**
 * Computes consume(produce(i)) for i = 0, ..., n - 1: @p produce runs on @p n_threads threads at
 * once, @p consume on this one and in order, so that sums have the same digits for any number of
 * threads.
 * @throws the exceptions of either. (WorkStream ends the program when a worker throws; here wrong
 * data at a quadrature point must become a message.)
 */
template <typename Result>
void produce_in_parallel(const unsigned int n_threads, const std::size_t n,
                         const std::function<Result(std::size_t)> &produce,
                         const std::function<void(const Result &)> &consume) {
  const std::size_t n_ahead = n_threads > 1 ? n_threads : 0;
  std::deque<std::future<Result>> under_way;
  std::size_t started = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (n_ahead == 0) {
      consume(produce(i));
      continue;
    }
    for (; started < n && started <= i + n_ahead; ++started)
      under_way.push_back(std::async(std::launch::async, produce, started));
    const Result result = under_way.front().get();
    under_way.pop_front();
    consume(result);
  }
}

/**
 * Calls work(begin, end) for ranges that make up [0, n), on @p n_threads threads. The ranges are
 * the same for any number of threads: if work writes only to data of its range, so are the
 * digits.
 * @throws the exceptions of work.
 */
void work_on_ranges(unsigned int n_threads, std::size_t n,
                    const std::function<void(std::size_t, std::size_t)> &work);

/** Returns the vectors of all ranks, one behind the other. Collective. */
template <typename T>
std::vector<T> collect(const std::vector<T> &mine, MPI_Comm communicator) {
  std::vector<T> all;
  for (const std::vector<T> &of_rank : Utilities::MPI::all_gather(communicator, mine))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  return all;
}

/** Stores an optional value in an archive of Boost, or loads it into an empty one. */
template <typename Archive, typename T>
void archive_optional(Archive &archive, std::optional<T> &value) {
  bool has_value = value.has_value();
  archive &has_value;
  if (!has_value)
    return;
  if (!value)
    value.emplace();
  archive &*value;
}

/**
 * Sets the number of threads of OpenBLAS, and whether other libraries may use OpenMP, while it
 * lives; where these are not in use it does nothing.
 *
 * Threads pay for the large dense fronts of MUMPS. On the small blocks of everything else they cost
 * CPU time and gain nothing (CHOLMOD moves its blocks by four OpenMP threads, however many cores
 * there are). So the program runs with one, and MUMPS asks for more.
 */
class LibraryThreads {
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
