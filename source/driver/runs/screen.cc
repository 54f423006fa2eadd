// SPDX-License-Identifier: LGPL-2.1-or-later
// The screen, to which only the first rank writes.

#include <signorini/base/dealii.h>
#include <signorini/driver/runs/screen.h>
#include <signorini/results/output/signals.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <unistd.h>

namespace Signorini {
Screen::Screen(MPI_Comm communicator, const bool is_quiet)
  : speaks_(Utilities::MPI::this_mpi_process(communicator) == 0)
  , is_quiet_(is_quiet)
  , silence_(nullptr) {}

std::ostream &Screen::out() {
  return speaks_ && !is_quiet_ ? std::cout : silence_;
}

void Screen::complain(const std::string &sentence) const {
  if (speaks_)
    std::cerr << "signorini: " << sentence << std::endl;
}

Progress Screen::progress() const {
  if (!speaks_)
    return [](const std::string &) {};
  const bool on_terminal = !is_quiet_ && isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return [on_terminal](const std::string &text) {
    // Each level writes its files completely or not at all, as the sentence states.
    if (!text.empty())
      describe_interruption("on " + text + "; the results of finished levels are complete.");
    if (on_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
  };
}

} // namespace Signorini
