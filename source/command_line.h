// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace Signorini
{
/** What the command line asks for. */
struct CommandLine
{
  /** The parameter file to run; empty if @p text is all that was asked for. */
  std::string parameter_file;
  /** "Subsection/Parameter=value", in the order given. */
  std::vector<std::string> overrides;
  /** Where results go. */
  std::filesystem::path output;
  /** Answer of --help, --version, --list-scenes or --print-parameters. */
  std::string text;
};

/** @throws InputError if the options make no sense. */
CommandLine read_command_line(int argc, char **argv);
} // namespace Signorini
