// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace Signorini {
/** The files, options and texts of a command line. */
struct CommandLine {
  /** The parameter files to run; empty if only @p text is printed. */
  std::vector<std::string> parameter_files;
  /** "Subsection/Parameter=value", in the order given. */
  std::vector<std::string> overrides;
  /** "Subsection/Parameter=v1, v2, v3", in the order given. */
  std::vector<std::string> sweeps;
  /** The directory of each file's results. */
  std::vector<std::string> directories;
  /** Whether scenes are shown instead of solved. */
  bool check = false;
  /** Whether nothing but warnings and errors is printed. */
  bool quiet = false;
  /** The answer of --help, --version, --list-scenes or --print-parameters. */
  std::string text;

  /** Packs the command line for messages between ranks. */
  template <typename Archive>
  void serialize(Archive &archive, const unsigned int /*version*/) {
    archive &parameter_files &overrides &sweeps &directories &check &quiet &text;
  }
};

/** Reads the command line. @throws InputError if the options make no sense. */
CommandLine read_command_line(int argc, char **argv);

/** Replaces the command line of every rank by that of the first one. @return the ranks that were
 * given another one, in words; else nothing. Collective. */
std::string share_command_line(CommandLine &command_line, MPI_Comm communicator);
} // namespace Signorini
