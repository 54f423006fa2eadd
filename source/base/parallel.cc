// SPDX-License-Identifier: LGPL-2.1-or-later
// Threads of one process: those of this program, and those of OpenBLAS and OpenMP.

#include <signorini/base/parallel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <thread>

namespace Signorini {
unsigned int n_available_threads() {
  if (const char *const given = std::getenv("DEAL_II_NUM_THREADS"))
    return static_cast<unsigned int>(std::max(1L, std::strtol(given, nullptr, 10)));
  return Utilities::MPI::job_supports_mpi() && Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1
           ? 1U
           : std::max(1U, std::thread::hardware_concurrency());
}

void work_on_ranges(const unsigned int n_threads, const std::size_t n,
                    const std::function<void(std::size_t, std::size_t)> &work) {
  constexpr std::size_t length = 256;
  produce_in_parallel<bool>(
    n_threads, (n + length - 1) / length,
    [&](const std::size_t i) {
      work(i * length, std::min(n, (i + 1) * length));
      return true;
    },
    [](const bool) {});
}

// OpenBLAS and OpenMP are found at run time: which BLAS a system uses is decided there.

namespace {
constexpr int unknown_setting = -1;

int library_setting(const char *const function) {
  void *const symbol = dlsym(RTLD_DEFAULT, function);
  return symbol != nullptr ? reinterpret_cast<int (*)()>(symbol)() : unknown_setting;
}

void set_library(const char *const function, const int value) {
  if (void *const symbol = dlsym(RTLD_DEFAULT, function))
    reinterpret_cast<void (*)(int)>(symbol)(value);
}
} // namespace

LibraryThreads::LibraryThreads(const unsigned int n)
  : blas_threads_before_(library_setting("openblas_get_num_threads"))
  , parallel_levels_before_(library_setting("omp_get_max_active_levels")) {
  static const int blas_threads_given = blas_threads_before_;
  if (blas_threads_before_ != unknown_setting)
    set_library("openblas_set_num_threads", std::clamp(static_cast<int>(n), 1, blas_threads_given));
  if (parallel_levels_before_ != unknown_setting)
    set_library("omp_set_max_active_levels", n > 1 ? 1 : 0);
}

LibraryThreads::~LibraryThreads() {
  if (blas_threads_before_ != unknown_setting)
    set_library("openblas_set_num_threads", blas_threads_before_);
  if (parallel_levels_before_ != unknown_setting)
    set_library("omp_set_max_active_levels", parallel_levels_before_);
}
} // namespace Signorini
