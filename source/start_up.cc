// SPDX-License-Identifier: LGPL-2.1-or-later
// What can fail before the program has begun.

#include "start_up.h"

#include <signorini/base/errors.h>
#include <signorini/base/text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <future>
#include <new>
#include <sstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace Signorini
{
namespace
{
/** The user's stderr while MPI starts; negative: MPI is not starting. */
int standard_error = -1;

/** The user's settings of Open MPI; it adds variables of its own while it starts. */
std::string given_settings;

/** Returns the names of variables of the environment that steer Open MPI, for the message. */
std::string mpi_settings()
{
  std::vector<std::string> names;
  for (char **entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, "OMPI_MCA_", 9) == 0)
      names.push_back(std::string(*entry).substr(0, std::string(*entry).find('=')));
  return names.empty() ? "" : " (the environment sets " + shorten(join(names)) + ")";
}

/** Sets up Open MPI for a process that no launcher has started: it needs no daemon, no network, no
 * shared memory and no picture of the machine, which take as long to start as a small scene to
 * solve. Nor does it need a folder of its session: all such processes would share one, and one that
 * ends would remove it while another makes it. Settings of the user for these stay. */
void configure_single_process()
{
  for (const char *launched : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"})
    if (std::getenv(launched) != nullptr)
      return;
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
}

/** Returns what has been printed on stderr since MPI starts. */
std::string mpi_output()
{
  std::string text;
  char buffer[4096];
  lseek(STDERR_FILENO, 0, SEEK_SET);
  for (ssize_t n = 0; (n = read(STDERR_FILENO, buffer, sizeof(buffer))) > 0;)
    text.append(buffer, static_cast<std::size_t>(n));
  return text;
}

void print_to_user(const std::string &text)
{
  // Nothing can be done where not even this can be written.
  if (write(standard_error, text.data(), text.size()) < 0)
    return;
}

/** Returns the first of the messages in frames of dashes, which names the cause, as words on one
 * line. */
std::string first_message(const std::string &text)
{
  std::istringstream words(text);
  std::string message;
  for (std::string word; words >> word;)
  {
    if (word.rfind("-----", 0) != 0)
      message += " " + word;
    else if (!message.empty())
      break;
  }
  if (!message.empty() && message.back() != '.')
    message += ".";
  return message;
}

/** Prints one line instead of all that MPI has printed. */
void report_failed_start()
{
  const std::string message = first_message(mpi_output());
  print_to_user(
    "signorini: MPI could not be started" + given_settings +
    ": check the variables OMPI_MCA_... of the environment and the installation of Open MPI." +
    (message.empty() ? "" : " It says:" + message) + "\n");
}

/** Multiplies two matrices: one product is enough for a thread of OpenBLAS to get its buffer. */
void multiply_matrices()
{
  FullMatrix<double> a(200, 200), product(200, 200);
  a = 1.;
  a.mmult(product, a);
}

/** Returns whether so many bytes of address space are free. */
bool can_reserve(const std::size_t bytes)
{
  void *const room =
    mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED)
    return false;
  munmap(room, bytes);
  return true;
}

/** Takes the buffers of the BLAS: 128 MiB of address space per thread for OpenBLAS, and as much for
 * what a thread allocates in libc. */
void reserve_buffers()
{
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return;
  constexpr std::size_t mebibyte = 1U << 20U;
  const std::size_t n_threads = std::max(1U, std::thread::hardware_concurrency());
  if (!can_reserve((2 * n_threads + 1) * 128 * mebibyte))
    throw std::bad_alloc();
  std::vector<std::future<void>> threads;
  for (std::size_t i = 1; i < n_threads; ++i)
    threads.push_back(std::async(std::launch::async, multiply_matrices));
  multiply_matrices();
}
} // namespace

void check_surroundings()
{
  std::error_code error;
  if (std::filesystem::current_path(error).empty() || error)
    throw InputError("The working directory cannot be found any more: " + error.message() +
                     "; allowed: to start in a directory that is there.");
  reserve_buffers();
}

MPIStartGuard::MPIStartGuard()
{
  given_settings = mpi_settings();
  configure_single_process();
  const int text = memfd_create("stderr", MFD_CLOEXEC);
  if (text < 0)
    return;
  standard_error = dup(STDERR_FILENO);
  dup2(text, STDERR_FILENO);
  close(text);
}

MPIStartGuard::~MPIStartGuard()
{
  if (standard_error < 0)
    return;
  print_to_user(mpi_output());
  const int original = standard_error;
  standard_error = -1;
  dup2(original, STDERR_FILENO);
  close(original);
}
} // namespace Signorini

/**
 * Reports a failed start of MPI. Open MPI ends a process in which it cannot start by _exit(1), and
 * its libraries find this function before that of libc. It is the only way to detect the failure:
 * MPI has no error codes yet.
 */
extern "C" void _exit(int status)
{
  if (Signorini::standard_error >= 0)
  {
    Signorini::report_failed_start();
    status = 3;
  }
  for (;;)
    syscall(SYS_exit_group, status);
}
