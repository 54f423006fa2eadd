// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>

#include "results/output/csv.h"
#include "study_helpers.h"
#include "tests.h"

/** Runs prm/benchmarks/NAME.prm; files go to a directory, if one is given. */
inline Signorini::StudyResult<2> run_benchmark(const std::string &name,
                                               const std::vector<std::string> &overrides = {},
                                               const std::string &directory = "") {
  if (!directory.empty())
    std::filesystem::create_directories(directory);
  return solve_file(SOURCE_DIR "/prm/benchmarks/" + name + ".prm", overrides, directory);
}
