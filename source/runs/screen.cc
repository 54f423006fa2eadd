// SPDX-License-Identifier: LGPL-2.1-or-later
// One rank speaks.

#include <signorini/output/interruption.h>
#include <signorini/runs/screen.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <unistd.h>

namespace Signorini
{
Screen::Screen(MPI_Comm communicator)
  : speaks_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  , silence_(nullptr)
{
}

std::ostream &Screen::out()
{
  return speaks_ ? std::cout : silence_;
}

void Screen::complain(const std::string &sentence) const
{
  if (speaks_)
    std::cerr << "signorini: " << sentence << std::endl;
}

Progress Screen::progress() const
{
  if (!speaks_)
    return [](const std::string &) {};
  const bool on_terminal = isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return [on_terminal](const std::string &text) {
    // Files appear complete or not at all, level by level, which is what the sentence says.
    if (!text.empty())
      describe_interruption("on " + text + "; the results of finished levels are complete.");
    if (on_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
  };
}
} // namespace Signorini
