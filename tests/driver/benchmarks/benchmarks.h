// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "../../results/files/csv.h"

/** Runs prm/benchmarks/NAME.prm; files go to a directory, if one is given. */
inline Signorini::StudyResult<2> run_benchmark(const std::string &name,
                                               const std::vector<std::string> &overrides = {},
                                               const std::string &directory = "")
{
  std::ostream silence(nullptr);
  const Signorini::Parameters parameters =
    Signorini::read_parameters(SOURCE_DIR "/../../../prm/benchmarks/" + name + ".prm", overrides);
  if (!directory.empty())
    std::filesystem::create_directories(directory);
  return Signorini::run_study(parameters,
                              Signorini::make_scene<2>(parameters),
                              MPI_COMM_WORLD,
                              {silence, directory, [](const std::string &) {}});
}

/** The rows of a table that a run has written. */
inline std::vector<std::map<std::string, std::string>> table_of(const std::string &file)
{
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return read_csv(text.str());
}

/** contact-LL.csv of a level. */
inline std::vector<std::map<std::string, std::string>>
contact_table(const std::string &directory, const Signorini::LevelRecord &level)
{
  const std::string number = std::to_string(level.sizes.level);
  return table_of(directory + "/contact-" + (number.size() < 2 ? "0" : "") + number + ".csv");
}
