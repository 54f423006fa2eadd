// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/study/level.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace Signorini
{
/** Decides which results of a study become files, and writes them; without a directory, none. */
class ResultsWriter
{
public:
  /** Writes parameters.prm. Collective, like all members. */
  ResultsWriter(const Parameters &parameters,
                std::filesystem::path directory,
                MPI_Comm communicator);

  /** contact-LL.csv, and as far as asked for the VTU files and the dual problem. */
  template <int dim>
  void write_fields(const Discretization<dim> &discretization,
                    const Scene<dim> &scene,
                    const LevelSolution<dim> &solution,
                    bool last_level);

  /** convergence.csv and certificate.json for the levels so far. @param failure why no more. */
  void write_tables(const std::vector<LevelRecord> &levels, const std::string &failure);

private:
  template <int dim>
  void write_vtu(const Discretization<dim> &discretization,
                 const Scene<dim> &scene,
                 const LevelSolution<dim> &solution);
  template <int dim>
  void write_dual_problem(const Discretization<dim> &discretization,
                          const LevelSolution<dim> &solution);

  /** "name-LL.ending" in the directory. */
  std::filesystem::path level_file(const char *name, unsigned int level, const char *ending) const;

  const Parameters &parameters_;
  std::filesystem::path directory_;
  MPI_Comm communicator_;
  std::vector<std::pair<double, std::string>> solution_files_, contact_files_;
};
} // namespace Signorini
