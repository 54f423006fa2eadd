// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/output/contact_line.h>
#include <signorini/study/level.h>
#include <signorini/verdict/judge.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace Signorini
{
/** Decides which results of a study become files, and writes them; without a directory, none. */
class ResultsWriter
{
public:
  /**
   * Removes the results of an earlier run from the directory, by their names, and writes
   * parameters.prm, with the description as comments, and a certificate that says "unfinished".
   * Collective, like all members but abandon().
   */
  ResultsWriter(const Parameters &parameters,
                const Judge &judge,
                const std::string &scene_description,
                std::filesystem::path directory,
                MPI_Comm communicator);

  /** contact-LL.csv, and as far as asked for the VTU files and the dual problem. */
  template <int dim>
  void write_fields(const Discretization<dim> &discretization,
                    const Scene<dim> &scene,
                    const LevelSolution<dim> &solution,
                    bool last_level);

  /** convergence.csv and certificate.json for the levels so far. */
  void write_tables(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
  /** answer.json, after the last level. Collective. */
  void write_answer(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);

  /**
   * For a study that an InputError ended, on every rank: without finished levels nothing is left
   * behind, otherwise the certificate says why there are no more.
   */
  void abandon(const std::vector<LevelRecord> &levels, const std::string &failure);

private:
  /** @param line on the first rank; empty on others. */
  template <int dim>
  void write_vtu(const Discretization<dim> &discretization,
                 const Scene<dim> &scene,
                 const LevelSolution<dim> &solution,
                 const std::vector<ContactSegment> &line);
  /** Collective. */
  template <int dim>
  void write_dual_problem(const Discretization<dim> &discretization,
                          const LevelSolution<dim> &solution);

  void start_directory(const std::string &scene_description);
  void write_convergence_of(const std::vector<LevelRecord> &levels) const;
  void write_certificate_of(const std::vector<LevelRecord> &levels,
                            const StudyVerdict &verdict) const;

  /** "name-LL.ending" in the directory. */
  std::filesystem::path level_file(const char *name, unsigned int level, const char *ending) const;

  const Parameters &parameters_;
  const Judge &judge_;
  std::filesystem::path directory_;
  MPI_Comm communicator_;
  /** Whether parameters.prm was there before: it may be what the run was started with. */
  bool had_parameters_ = false;
  std::vector<std::pair<double, std::string>> solution_files_, contact_files_;
};
} // namespace Signorini
