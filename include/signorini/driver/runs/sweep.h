// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/runs/run.h>
#include <signorini/driver/runs/screen.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Signorini {
/** A parameter, and the values that it takes one after the other. */
struct Sweep {
  /** The name of the parameter, "Subsection/Parameter" or "Constants/NAME". */
  std::string parameter;
  std::vector<std::string> values;
};

/** Reads "Subsection/Parameter=v1, v2, v3"; commas in parentheses do not separate.
 * @throws InputError */
Sweep read_sweep(const std::string &argument);

/** One combination of values of several sweeps, with the name of its directory. */
struct SweepPoint {
  std::vector<std::string> values;
  std::string folder;
};

/** Returns all combinations; the last sweep varies fastest. @throws InputError if there are too
 * many, or two of them have the same name, or a parameter has two sweeps. */
std::vector<SweepPoint> combine(const std::vector<Sweep> &sweeps);

/**
 * Runs a scene for all combinations of values, each in a directory of its own below that of the
 * input, and prints one table over them, which is also written to sweep.csv. All values are parsed
 * before the first run, and other runs are kept out of all directories until the last one ends.
 * Errors of single runs are printed on the screen. Collective.
 * @return the largest exit code, with its verdict.
 */
RunSummary run_sweep(const RunInput &input, const std::vector<Sweep> &sweeps, MPI_Comm communicator,
                     Screen &screen);
} // namespace Signorini
