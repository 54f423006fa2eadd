// SPDX-License-Identifier: LGPL-2.1-or-later
// The set-up before the program begins, which can fail.

#include "start_up.h"

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace {
/** Whether the process was told to ignore SIGHUP, by nohup. */
bool ignores_hangup = false;

/** Stores whether SIGHUP is ignored. This runs before the constructors of the libraries, because
 * that of UCX (part of Open MPI on some systems) replaces the action without looking. */
void see_hangup(int /*n*/, char ** /*arguments*/, char ** /*environment*/) {
  struct sigaction found = {};
  ignores_hangup = sigaction(SIGHUP, nullptr, &found) == 0 && found.sa_handler == SIG_IGN;
}
__attribute__((section(".preinit_array"),
               used)) void (*const before_libraries)(int, char **, char **) = see_hangup;
} // namespace

namespace Signorini {
void keep_ignoring_hangup() {
  if (ignores_hangup)
    std::signal(SIGHUP, SIG_IGN);
}

std::unique_ptr<SessionFolder> configure_single_process() {
  for (const char *launched : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"})
    if (std::getenv(launched) != nullptr)
      return nullptr;
  constexpr int keep = 0;
  // The daemon would be started by the framework plm: a user who sets that wants it.
  if (std::getenv("OMPI_MCA_plm") == nullptr)
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
  setenv("OMPI_MCA_pml", "ob1", keep);
  setenv("OMPI_MCA_btl", "self", keep);
  setenv("OMPI_MCA_coll", "^adapt,han,inter,monitoring,sm,sync,tuned", keep);
  setenv("OMPI_MCA_osc", "^sm,monitoring,rdma,ucx", keep);
  setenv("HWLOC_PLUGINS_BLACKLIST", "hwloc_gl.so,hwloc_opencl.so,hwloc_pci.so", keep);
  return std::make_unique<SessionFolder>();
}

SessionFolder::SessionFolder() {
  if (const char *const given = std::getenv("TMPDIR"))
    before_ = given;
  if (mkdtemp(path_.data()) == nullptr)
    path_.clear();
  else
    setenv("TMPDIR", path_.c_str(), 1);
}

SessionFolder::~SessionFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (before_)
    setenv("TMPDIR", before_->c_str(), 1);
  else
    unsetenv("TMPDIR");
}

namespace {
/** Multiplies two matrices: one product is enough for a thread of OpenBLAS to get its buffer. */
void multiply_matrices() {
  FullMatrix<double> a(200, 200), product(200, 200);
  a = 1.;
  a.mmult(product, a);
}

/** Takes the buffers of the BLAS: 128 MiB of address space per thread for OpenBLAS, and as much for
 * allocations of a thread in libc. */
void reserve_buffers() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return;
  const std::size_t n_threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t bytes = (2 * n_threads + 1) << 27U;
  void *const room =
    mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED)
    throw std::bad_alloc();
  munmap(room, bytes);
  std::vector<std::future<void>> threads;
  for (std::size_t i = 0; i < n_threads; ++i)
    threads.push_back(std::async(std::launch::async, multiply_matrices));
}
} // namespace

void check_surroundings() {
  std::error_code error;
  if (std::filesystem::current_path(error).empty() || error)
    throw InputError("The working directory cannot be found any more: " + error.message() +
                     "; allowed: to start in a directory that is there.");
  // A small stack ends the program in the middle of a level, without a message.
  constexpr rlim_t least_stack = 1U << 20U;
  rlimit stack = {};
  if (getrlimit(RLIMIT_STACK, &stack) == 0 && stack.rlim_cur < least_stack)
    throw InputError(
      "The stack of a process is limited to " + std::to_string(stack.rlim_cur / 1024) +
      " KiB (ulimit -s); allowed: at least " + std::to_string(least_stack / 1024) + " KiB.");
  reserve_buffers();
}
} // namespace Signorini
