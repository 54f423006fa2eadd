// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/study/level.h>

#include <mpi.h>

#include <ostream>
#include <string>

namespace Signorini
{
/** What a user reads: printed by the first rank, swallowed on the others. */
class Screen
{
public:
  explicit Screen(MPI_Comm communicator);

  /** The standard output. */
  std::ostream &out();
  /** One line on stderr. */
  void complain(const std::string &sentence) const;
  /** What is being done: one line on a terminal that is overwritten, nothing in a log; and what is
   * said if the run is interrupted. */
  Progress progress() const;

private:
  bool speaks_;
  std::ostream silence_;
};
} // namespace Signorini
