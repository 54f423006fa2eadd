// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace Signorini {
/** Ignores the signal SIGHUP again if the process was started so, by nohup, and a library took it.
 */
void keep_ignoring_hangup();

/**
 * Refuses to start where libraries would hang or abort: without a working directory, and where the
 * address space (`ulimit -v`) is too small for the buffers of the BLAS, which waits for them
 * forever. With such a limit the buffers are taken at once.
 * @throws InputError, std::bad_alloc
 */
void check_surroundings();

/** The directory of temporary files (TMPDIR) while MPI starts: a new one in memory, which the
 * destructor removes. Open MPI 5 makes folders there, never uses them in a single process, and
 * leaves them behind. */
class SessionFolder {
public:
  SessionFolder();
  SessionFolder(const SessionFolder &) = delete;
  SessionFolder &operator=(const SessionFolder &) = delete;
  ~SessionFolder();

private:
  /** The folder; mkdtemp() replaces the letters X. Empty where it cannot be made. */
  std::string path_ = "/dev/shm/signorini-XXXXXX";
  /** The value of TMPDIR before. */
  std::optional<std::string> before_;
};

/**
 * Sets up Open MPI for a process that no launcher has started: it needs no daemon, no network, no
 * shared memory and no picture of the machine, which take as long to start as a small scene to
 * solve. Nor does it need a folder of its session: all such processes would share one, and one that
 * ends would remove it while another makes it. Settings of the user for these stay.
 * @return the folder that must last until MPI has started; null where there is a launcher.
 */
std::unique_ptr<SessionFolder> configure_single_process();
} // namespace Signorini
