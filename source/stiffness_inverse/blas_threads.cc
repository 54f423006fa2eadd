// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenBLAS is found at run time: which BLAS a system uses is decided there.

#include <signorini/stiffness_inverse/blas_threads.h>

#include <algorithm>
#include <dlfcn.h>

namespace Signorini
{
namespace
{
int current_number()
{
  void *const symbol = dlsym(RTLD_DEFAULT, "openblas_get_num_threads");
  return symbol != nullptr ? reinterpret_cast<int (*)()>(symbol)() : 0;
}

void set_number(const int n)
{
  if (void *const symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<void (*)(int)>(symbol)(n);
}
} // namespace

BlasThreads::BlasThreads(const unsigned int n)
  : before_(current_number())
{
  static const int given = before_;
  if (before_ > 0)
    set_number(static_cast<int>(std::clamp(n, 1U, static_cast<unsigned int>(given))));
}

BlasThreads::~BlasThreads()
{
  if (before_ > 0)
    set_number(before_);
}
} // namespace Signorini
