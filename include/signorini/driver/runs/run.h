// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/runs/screen.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/driver/study/known_solutions.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/results/output/files.h>
#include <signorini/results/verdict/level_record.h>

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** A parameter file with the additions of the command line. */
struct RunInput {
  /** The name of the file as given, and as messages show it. */
  std::string file_name, name;
  /** The content of the file. */
  std::string text;
  /** Assignments "Subsection/Parameter=value" that replace values of the file. */
  std::vector<std::string> overrides;
  /** The same for one run of a sweep. */
  std::vector<std::string> swept;
  /** The directory of the results. */
  std::filesystem::path directory;
  /** Whether the scene is shown instead of solved. */
  bool only_show = false;
  /** Further files that are read after this run; its results must not replace them. */
  std::vector<std::filesystem::path> others;
  KnownSolutions known;
  /** The graded runs that tell errors; those of a sweep share them. */
  std::shared_ptr<ReferenceRuns> references = std::make_shared<ReferenceRuns>();
};

/** The end of a run. */
struct RunSummary {
  /** The exit code. 0: certified, 1: wrong input, 2: not certified, 3: results could not be
   * written. */
  int exit_code = 0;
  /** The verdict in one or two words. */
  std::string verdict;
  /** The finest level that was solved. */
  std::optional<LevelRecord> finest;
  /** The directory with results; other runs are kept out of it as long as this lives. */
  std::shared_ptr<const ResultsDirectory> results;
};

/** Returns the parameters of a run. Collective. @throws InputError */
Parameters parameters_of(const RunInput &input, MPI_Comm communicator);

/**
 * Reads a parameter file on the first rank, for all ranks. Collective. @throws InputError, also
 * where the file has another text on another rank.
 */
RunInput read_input(const std::string &file_name, const std::vector<std::string> &overrides,
                    const std::filesystem::path &directory, MPI_Comm communicator);

/** Calls run(). An InputError, a ComputationError or a WritingError is printed on the screen, and
 * the summary of the run that it ended is returned. */
RunSummary tell_errors(const Screen &screen, const std::function<RunSummary()> &run);

/** Runs one scene from its parameters to the results. Collective. @throws InputError,
 * ComputationError */
RunSummary run_scene(const RunInput &input, Parameters parameters, MPI_Comm communicator,
                     Screen &screen);

} // namespace Signorini
