// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/files/contact_files.h>
#include <signorini/results/files/files.h>
#include <signorini/results/pictures/pressure_picture.h>
#include <signorini/results/record/level_result.h>
#include <signorini/results/verdict/judge.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/** Decides which results of a study become files, and writes them; without a directory, none. */
class ResultsWriter
{
public:
  /**
   * Nothing is changed in the directory before the first level is solved. Then the results of an
   * earlier run are set aside, by their names, and parameters.prm, with the description as
   * comments, and a certificate that says "unfinished" are written. Collective, like all members
   * but abandon().
   */
  ResultsWriter(const Parameters &parameters,
                const Judge &judge,
                const std::string &scene_description,
                std::filesystem::path directory,
                MPI_Comm communicator);

  /** contact-LL.csv, and as far as asked for the VTU files (of graded meshes also mesh-LL.svg) and
   * the dual problem. */
  template <int dim>
  void write_fields(const Scene<dim> &scene, const LevelResult<dim> &level);

  /** solution-case-NNNNNN.vtu and contact-case-NNNNNN.csv of a load case. @param scene that of the
   * case. */
  template <int dim>
  void write_case_fields(const Discretization<dim> &discretization,
                         const Scene<dim> &scene,
                         const Displacement &U,
                         const Pressure &P,
                         unsigned int number);
  /** cases.csv. */
  void write_cases(const std::vector<CaseResult> &cases);

  /** convergence.csv and certificate.json for the levels so far. With a verdict the results that
   * were set aside are removed. */
  void write_tables(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
  /** answer.json, after the last level. Collective. */
  void write_answer(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
  /** The pictures, after the last level, where they are asked for. Collective. @return one sentence
   * about what is missing, on the first rank; empty if nothing is. */
  std::string write_pictures(const std::vector<LevelRecord> &levels);

  /** write_tables() for a study that an error ended. Without a finished level the results of an
   * earlier run stay as they are. */
  void write_failure(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);

  /** For a study that an InputError ended, on every rank: the results of an earlier run are put
   * back in place of those of this one. */
  void abandon();

private:
  /** @param traced on the first rank; empty on others. */
  template <int dim>
  void write_vtu(const Discretization<dim> &discretization,
                 const Scene<dim> &scene,
                 const LevelSolution<dim> &solution,
                 const TracedContact<dim> &traced);
  /** Keeps what write_pictures() needs of the finest level. */
  void prepare_pictures(const Discretization<2> &discretization,
                        const Scene<2> &scene,
                        const LevelSolution<2> &solution);
  /** Collective. */
  template <int dim>
  void write_dual_problem(const Discretization<dim> &discretization,
                          const LevelSolution<dim> &solution);

  /** On first use. */
  void start_directory();
  /** Small files come from rank 0; if it cannot write one, all ranks hear of it. */
  void write_on_first_rank(const std::function<void()> &write) const;
  void write_convergence_of(const std::vector<LevelRecord> &levels) const;
  void write_certificate_of(const std::vector<LevelRecord> &levels,
                            const StudyVerdict &verdict) const;

  /** "name-LL.ending" in the directory. */
  std::filesystem::path level_file(const char *name, unsigned int level, const char *ending) const;

  const Parameters &parameters_;
  const Judge &judge_;
  std::string scene_description_;
  std::filesystem::path directory_;
  MPI_Comm communicator_;
  /** On the first rank, unless nothing is to be written. */
  std::optional<HeldDirectory> held_;
  /** Whether the results of this run have taken the place of earlier ones. */
  bool started_ = false;
  std::vector<std::pair<double, std::string>> solution_files_, contact_files_;
  /** Those of the finest level, on the first rank. */
  std::vector<Picture> pictures_, case_pictures_;
};
} // namespace Signorini
