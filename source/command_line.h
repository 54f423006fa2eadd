// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace Signorini
{
/** What the command line asks for. */
struct CommandLine
{
  /** The parameter files to run; empty if @p text is all that was asked for. */
  std::vector<std::string> parameter_files;
  /** "Subsection/Parameter=value", in the order given. */
  std::vector<std::string> overrides;
  /** "Subsection/Parameter=v1, v2, v3", in the order given. */
  std::vector<std::string> sweeps;
  /** Where the results of each file go. */
  std::vector<std::string> directories;
  /** Answer of --help, --version, --list-scenes or --print-parameters. */
  std::string text;

  /** For messages between ranks. */
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/)
  {
    archive &parameter_files &overrides &sweeps &directories &text;
  }
};

/** @throws InputError if the options make no sense. */
CommandLine read_command_line(int argc, char **argv);

/** The command line of the first rank, for all of them. @return the ranks that were given another
 * one, in words; else nothing. Collective. */
std::string share_command_line(CommandLine &command_line, MPI_Comm communicator);
} // namespace Signorini
