// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/record/level_record.h>

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

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

/** A parameter file with what the command line adds to it. */
struct RunInput
{
  /** As given, and as messages speak of it. */
  std::string file_name, name;
  /** The content of the file. */
  std::string text;
  /** "Subsection/Parameter=value". */
  std::vector<std::string> overrides;
  /** Where results go. */
  std::filesystem::path directory;
  /** Further files that will be read, after this run; its results must not replace them. */
  std::vector<std::filesystem::path> others;
};

/** How a run ended. */
struct RunSummary
{
  /** 0: certified, 1: wrong input, 2: not certified, 3: results could not be written. */
  int exit_code = 0;
  /** The verdict in one or two words. */
  std::string verdict;
  /** The finest level that was solved. */
  std::optional<LevelRecord> finest;
};

/**
 * Reads a parameter file on the first rank, for all of them. Ranks that see another text under this
 * name are named on the screen. Collective. @throws InputError
 */
RunInput read_input(const std::string &file_name,
                    const std::vector<std::string> &overrides,
                    const std::filesystem::path &directory,
                    MPI_Comm communicator,
                    const Screen &screen);

/** run(), with an InputError, a ComputationError or a WritingError told on the screen and turned
 * into the summary of a run that it has ended. */
RunSummary tell_errors(const Screen &screen, const std::function<RunSummary()> &run);

/** From parameters to results: one scene. What goes wrong is told on the screen. Collective. */
RunSummary run_scene(const RunInput &input, MPI_Comm communicator, Screen &screen);

/** A parameter with the values that it takes one after the other. */
struct Sweep
{
  /** "Subsection/Parameter" or "Constants/NAME". */
  std::string parameter;
  std::vector<std::string> values;
};

/** Reads "Subsection/Parameter=v1, v2, v3"; commas in parentheses do not separate.
 * @throws InputError */
Sweep read_sweep(const std::string &argument);

/** One combination of values of several sweeps, with the name of its directory. */
struct SweepPoint
{
  std::vector<std::string> values;
  std::string folder;
};

/** All combinations, the last sweep varying fastest. @throws InputError if there are too many, or
 * two of them have the same name. */
std::vector<SweepPoint> combine(const std::vector<Sweep> &sweeps);

/**
 * Runs a scene for all combinations of values, each in a directory of its own below that of the
 * input, and prints one table over them, which is also written to sweep.csv. All values are parsed
 * before the first run. Collective.
 * @return the largest exit code, with its verdict.
 */
RunSummary run_sweep(const RunInput &input,
                     const std::vector<Sweep> &sweeps,
                     MPI_Comm communicator,
                     Screen &screen);
} // namespace Signorini
