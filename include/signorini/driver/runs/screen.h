// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/progress.h>

#include <mpi.h>

#include <ostream>
#include <string>

namespace Signorini {
/** The output for the user: the first rank prints it, the others discard it. */
class Screen {
public:
  explicit Screen(MPI_Comm communicator, bool is_quiet = false);

  /** Returns the standard output; on other ranks, and of a quiet screen, a stream that discards
   * everything. */
  std::ostream &out();
  /** Prints one line on stderr. */
  void complain(const std::string &sentence) const;
  /** Returns a callback that shows the current stage: in one line of a terminal that is
   * overwritten, never in a log. It also sets the message of an interruption. */
  Progress progress() const;

private:
  bool speaks_, is_quiet_;
  std::ostream silence_;
};

} // namespace Signorini
