// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/verified_files.h>
#include <signorini/results/verdict/judge.h>
#include <signorini/results/verdict/level_result.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** Decides which results of a study become files, and writes them; without a directory, none. */
class ResultsWriter {
public:
  /**
   * Prepares the files. The directory does not change before the first level is solved. Then
   * the results of an earlier run are removed, by their names, and parameters.prm, with the
   * description as comments, and a certificate with the outcome "unfinished" are written.
   * Collective, like all members but abandon().
   */
  ResultsWriter(const Parameters &parameters, const Judge &judge,
                const std::string &scene_description, std::filesystem::path directory,
                MPI_Comm communicator);

  /** Writes contact-LL.csv, and if wanted the VTU files and the dual problem. */
  template <int dim>
  void write_fields(const LevelResult<dim> &level);

  /** Writes solution-case-NNNNNN.vtu and contact-case-NNNNNN.csv of a load case. */
  template <int dim>
  void write_case_fields(const BodyInContact<dim> &solved, unsigned int number);
  /** Writes cases.csv. */
  void write_cases(const std::vector<CaseResult> &cases);

  /** Writes convergence.csv and certificate.json for the levels so far. */
  void write_tables(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
  /** Writes answer.json and contacts.csv, after the last level. Collective. */
  void write_answer(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);
  /** Writes verified.json and verified.vtu. Collective. */
  void write_verified(const VerifiedField &verified);
  /** Draws the pictures, if they are wanted, after the last level. Collective. @return one sentence
   * about missing pictures, on the first rank; empty if none is missing. */
  std::string write_pictures();

  /** Writes the tables of a study that an error ended. Without a finished level the results of an
   * earlier run stay as they are. */
  void write_failure(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict);

  /** Removes the results of a study that an InputError ended, on every rank. */
  void abandon();

private:
  /** Writes the matrices and vectors of the dual problem. Collective. */
  template <int dim>
  void write_dual_problem(const Discretization<dim> &discretization,
                          const LevelSolution<dim> &solution);

  /** Prepares the directory, at the first call only. */
  void start_directory();
  /** Calls @p work on rank 0 if there is a directory; if it fails, all ranks throw. Collective. */
  void on_first_rank(const std::function<void()> &work) const;
  /** Writes a file in this way. */
  void write(const std::string &name, const std::function<void(std::ostream &)> &content) const;
  /** Writes contactENDING.csv and, @p with_vtu, the body and its contact for ParaView, which it
   * adds to the lists of these names. @param number the time in the lists. Collective. */
  template <int dim>
  void write_body_in_contact(const std::string &ending, const std::string &list,
                             const BodyInContact<dim> &body, const BoundFields &bound,
                             unsigned int number, bool with_vtu);
  /** Writes NAME.vtu, the fields in the body; where ranks share the mesh NAME.RRRR.vtu of every
   * rank, and NAME.pvtu. Collective. @return the name of the file to open. */
  template <int dim>
  std::string write_body(const std::string &name, const DisplacedBody<dim> &body,
                         const BoundFields &bound, unsigned int number);
  /** Adds a VTU file to "list.pvd". @param number its time. */
  void list_vtu(const std::string &list, unsigned int number, const std::string &file);
  void write_certificate(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict) const;

  const Parameters &parameters_;
  const Judge &judge_;
  std::string scene_description_;
  std::filesystem::path directory_;
  MPI_Comm communicator_;
  /** Whether the results of this run have replaced earlier ones. */
  bool started_ = false;
  /** The VTU files of the levels so far: those of the body and of contact, by these names. */
  std::map<std::string, std::vector<std::pair<double, std::string>>> vtu_files_;
};
} // namespace Signorini
