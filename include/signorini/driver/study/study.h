// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/results/record/level_result.h>
#include <signorini/results/verdict/judge.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
/** Where a study reports to. */
struct StudyReport
{
  /** The screen of this rank: a stream that swallows everything on ranks other than the first. */
  std::ostream &screen;
  /** Where files go; empty: nowhere. */
  std::filesystem::path directory;
  Progress progress;
};

/** All levels, and whether they can be trusted. */
template <int dim>
struct StudyResult
{
  std::vector<LevelRecord> levels;
  /** The contact pressure of the finest level. */
  PatchPressure<dim> pressure;
  StudyVerdict verdict;
};

/**
 * Solves a scene on nested levels, from the coarsest to the finest or until the estimated error is
 * small enough, each started from the pressure of the one before; writes results as levels finish.
 * Collective.
 */
template <int dim>
StudyResult<dim> run_study(const Parameters &parameters,
                           const Scene<dim> &scene,
                           MPI_Comm communicator,
                           const StudyReport &report);
} // namespace Signorini
