// SPDX-License-Identifier: LGPL-2.1-or-later
// The files of a run.

#include "results_writer.h"

#include <signorini/base/agreement.h>
#include <signorini/base/exceptions.h>
#include <signorini/base/gather.h>
#include <signorini/output/answer_output.h>
#include <signorini/output/contact_line.h>
#include <signorini/output/files.h>
#include <signorini/output/matrix_market.h>
#include <signorini/output/solution_vtu.h>
#include <signorini/output/tables.h>

#include <deal.II/base/mpi.h>

#include <regex>
#include <sstream>

namespace Signorini
{
namespace
{
/** Small files come from rank 0; if it cannot write one, all ranks hear of it. */
void write_on_first_rank(MPI_Comm communicator, const std::function<void()> &write)
{
  agree(communicator, [&]() {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      write();
  });
}

/** Whether a file of this name is written below, parameters.prm and certificate.json apart. */
bool is_result(const std::string &name)
{
  static const std::regex names(
    "convergence\\.csv|answer\\.json|(solution|contact)\\.pvd|contact-[0-9]{2}\\.csv|"
    "(solution|contact)-[0-9]{2}\\.vtu|[ACDFGPf]-[0-9]{2}\\.mtx");
  return std::regex_match(name, names);
}

/** Every line behind "# ". */
std::string commented(const std::string &text)
{
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += "# " + line + "\n";
  return result;
}

constexpr const char *parameters_name = "parameters.prm";
constexpr const char *certificate_name = "certificate.json";
} // namespace

ResultsWriter::ResultsWriter(const Parameters &parameters,
                             const Judge &judge,
                             const std::string &scene_description,
                             std::filesystem::path directory,
                             MPI_Comm communicator)
  : parameters_(parameters)
  , judge_(judge)
  , directory_(std::move(directory))
  , communicator_(communicator)
{
  if (directory_.empty())
    return;
  write_on_first_rank(communicator_, [&]() { start_directory(scene_description); });
}

void ResultsWriter::start_directory(const std::string &scene_description)
{
  // In this order the files in the directory tell the truth at every moment.
  had_parameters_ = std::filesystem::exists(directory_ / parameters_name);
  write_certificate_of({}, judge_.unfinished({}));
  remove_files(directory_, is_result);
  write_file(directory_ / parameters_name, [&](std::ostream &stream) {
    stream << commented(scene_description) << parameters_.echo;
  });
}

void ResultsWriter::write_convergence_of(const std::vector<LevelRecord> &levels) const
{
  write_file(directory_ / "convergence.csv",
             [&](std::ostream &stream) { write_convergence_csv(stream, levels); });
}

void ResultsWriter::write_certificate_of(const std::vector<LevelRecord> &levels,
                                         const StudyVerdict &verdict) const
{
  write_file(directory_ / certificate_name,
             [&](std::ostream &stream) { write_certificate(stream, levels, judge_, verdict); });
}

std::filesystem::path ResultsWriter::level_file(const char *name,
                                                const unsigned int level,
                                                const char *ending) const
{
  return directory_ /
         (std::string(name) + "-" + dealii::Utilities::int_to_string(level, 2) + ending);
}

template <int dim>
void ResultsWriter::write_fields(const Discretization<dim> &discretization,
                                 const Scene<dim> &scene,
                                 const LevelSolution<dim> &solution,
                                 const bool last_level)
{
  if (directory_.empty())
    return;
  std::vector<ContactSegment> line;
  write_on_first_rank(communicator_, [&]() {
    line =
      trace_contact_line(discretization.space, discretization.multipliers, solution.U, solution.P);
    write_file(level_file("contact", solution.record.sizes.level, ".csv"),
               [&](std::ostream &stream) { write_contact_csv(stream, line); });
  });
  const VtuLevels vtu = parameters_.output.vtu;
  if (vtu == VtuLevels::all || (vtu == VtuLevels::finest && last_level))
    write_vtu(discretization, scene, solution, line);
  if (solution.system != nullptr)
    write_dual_problem(discretization, solution);
}

template <int dim>
void ResultsWriter::write_vtu(const Discretization<dim> &discretization,
                              const Scene<dim> &scene,
                              const LevelSolution<dim> &solution,
                              const std::vector<ContactSegment> &line)
{
  const unsigned int level = solution.record.sizes.level;
  const auto body = level_file("solution", level, ".vtu");
  const auto contact = level_file("contact", level, ".vtu");
  write_solution_vtu(body, discretization.space, scene, solution.U, solution.bound_fields);
  solution_files_.emplace_back(level, body.filename().string());
  contact_files_.emplace_back(level, contact.filename().string());
  write_on_first_rank(communicator_, [&]() {
    write_file(contact, [&](std::ostream &stream) {
      write_contact_vtu(stream, line, solution.bound_fields.contact);
    });
    write_pvd(directory_ / "solution.pvd", solution_files_);
    write_pvd(directory_ / "contact.pvd", contact_files_);
  });
}

template <int dim>
void ResultsWriter::write_dual_problem(const Discretization<dim> &discretization,
                                       const LevelSolution<dim> &solution)
{
  const DisplacementSpace<dim> &space = discretization.space;
  const LinearSystem<dim> &system = *solution.system;
  const std::vector<std::string> A =
    gather_texts(lower_triangle(system.matrix, system.unit), communicator_);
  const dealii::Vector<double> f(system.f);
  // F = G - D^T A^{-1} f for unconstrained unknowns: prescribed displacements count as gap.
  dealii::Vector<double> G = discretization.G;
  G -= discretization.D.transpose_product(space.complete(space.make_vector()));
  const auto write = [&](const char *name, const std::function<void(std::ostream &)> &content) {
    write_file(level_file(name, solution.record.sizes.level, ".mtx"), content);
  };
  const auto write_vector = [&](const char *name, const dealii::Vector<double> &vector) {
    write(name, [&](std::ostream &stream) { write_matrix_market(stream, vector); });
  };
  write_on_first_rank(communicator_, [&]() {
    write("A", [&](std::ostream &stream) { write_symmetric_matrix_market(stream, f.size(), A); });
    write("D", [&](std::ostream &stream) {
      write_matrix_market(stream, discretization.condensed_D, f.size());
    });
    write_vector("f", f);
    write_vector("G", G);
    write_vector("F", solution.F);
    write_vector("P", solution.P);
    if (solution.C.m() > 0)
      write("C", [&](std::ostream &stream) { write_symmetric_matrix_market(stream, solution.C); });
  });
}

void ResultsWriter::write_tables(const std::vector<LevelRecord> &levels,
                                 const StudyVerdict &verdict)
{
  if (directory_.empty())
    return;
  write_on_first_rank(communicator_, [&]() {
    // The disk may fill up in between. Then the certificate must not promise more than the table
    // holds; the reason why a study is not certified must not get lost.
    if (verdict.reason.empty())
      write_convergence_of(levels);
    write_certificate_of(levels, verdict);
    if (!verdict.reason.empty())
      write_convergence_of(levels);
  });
}

void ResultsWriter::write_answer(const std::vector<LevelRecord> &levels,
                                 const StudyVerdict &verdict)
{
  if (directory_.empty())
    return;
  write_on_first_rank(communicator_, [&]() {
    write_file(directory_ / "answer.json",
               [&](std::ostream &stream) { Signorini::write_answer(stream, levels, verdict); });
  });
}

void ResultsWriter::abandon(const std::vector<LevelRecord> &levels, const std::string &failure)
{
  if (directory_.empty() || dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
    return;
  try
  {
    if (!levels.empty())
    {
      write_certificate_of(levels, judge_.failed(levels, failure));
      return;
    }
    remove_files(directory_, [&](const std::string &name) {
      return is_result(name) || name == certificate_name ||
             (name == parameters_name && !had_parameters_);
    });
  }
  catch (const ComputationError &)
  {
    // The InputError is what the user has to hear of.
  }
}

template void ResultsWriter::write_fields(const Discretization<2> &,
                                          const Scene<2> &,
                                          const LevelSolution<2> &,
                                          bool);
} // namespace Signorini
