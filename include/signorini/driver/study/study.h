// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/progress.h>
#include <signorini/driver/level/level.h>
#include <signorini/driver/sequence/reference_run.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/results/verdict/judge.h>
#include <signorini/results/verdict/level_result.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini {
/** The destinations of the output of a study. */
struct StudyReport {
  /** The screen of this rank: on ranks other than the first, a stream that discards everything. */
  std::ostream &screen;
  /** The directory of the files; empty: no files are written. */
  std::filesystem::path directory;
  Progress progress;
};

/** Returns the judge of a study. */
template <int dim>
Judge judge_of(const Parameters &parameters, const Scene<dim> &scene);

/** All levels, and the verdict on them. */
template <int dim>
struct StudyResult {
  std::vector<LevelRecord> levels;
  /** The contact pressure of the finest level. */
  PatchPressure<dim> pressure;
  StudyVerdict verdict;
  /** Why the displacement of another program is not accurate enough, a sentence; mostly empty. */
  std::string objection;
};

/**
 * Solves a scene on a sequence of nested or graded meshes, until the finest level is reached or the
 * estimated error is small enough. Each mesh starts from the solution on the one before. Results
 * are written as meshes finish, and @p verify is called for each of them. Runs decide Strategy =
 * automatic before; here it means nested. Collective.
 */
template <int dim>
StudyResult<dim> run_study(const Parameters &parameters, const Scene<dim> &scene,
                           MPI_Comm communicator, const StudyReport &report,
                           const Verify<dim> &verify = {},
                           const std::shared_ptr<ReferenceRuns> &references = {});
} // namespace Signorini
