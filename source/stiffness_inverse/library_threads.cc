// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenBLAS and OpenMP are found at run time: which BLAS a system uses is decided there.

#include <signorini/stiffness_inverse/library_threads.h>

#include <algorithm>
#include <dlfcn.h>

namespace Signorini
{
namespace
{
constexpr int unknown = -1;

int get(const char *const function)
{
  void *const symbol = dlsym(RTLD_DEFAULT, function);
  return symbol != nullptr ? reinterpret_cast<int (*)()>(symbol)() : unknown;
}

void set(const char *const function, const int value)
{
  if (void *const symbol = dlsym(RTLD_DEFAULT, function))
    reinterpret_cast<void (*)(int)>(symbol)(value);
}
} // namespace

LibraryThreads::LibraryThreads(const unsigned int n)
  : blas_threads_before_(get("openblas_get_num_threads"))
  , parallel_levels_before_(get("omp_get_max_active_levels"))
{
  static const int blas_threads_given = blas_threads_before_;
  if (blas_threads_before_ != unknown)
    set("openblas_set_num_threads", std::clamp(static_cast<int>(n), 1, blas_threads_given));
  if (parallel_levels_before_ != unknown)
    set("omp_set_max_active_levels", n > 1 ? 1 : 0);
}

LibraryThreads::~LibraryThreads()
{
  if (blas_threads_before_ != unknown)
    set("openblas_set_num_threads", blas_threads_before_);
  if (parallel_levels_before_ != unknown)
    set("omp_set_max_active_levels", parallel_levels_before_);
}
} // namespace Signorini
