// SPDX-License-Identifier: LGPL-2.1-or-later
// The files of a run.

#include <signorini/base/errors.h>
#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/matrix_market.h>
#include <signorini/results/output/pictures.h>
#include <signorini/results/output/results_writer.h>
#include <signorini/results/output/solution_vtu.h>
#include <signorini/results/output/tables.h>

#include <deal.II/base/mpi.h>

#include <sstream>

namespace Signorini {
namespace {
/** Returns the text with "# " before every line. */
std::string commented(const std::string &text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += "# " + line + "\n";
  return result;
}

/** Returns "name-LL.ending". */
std::string level_file(const char *name, const unsigned int level, const char *ending) {
  return std::string(name) + "-" + Utilities::int_to_string(level, 2) + ending;
}
} // namespace

ResultsWriter::ResultsWriter(const Parameters &parameters, const Judge &judge,
                             const std::string &scene_description, std::filesystem::path directory,
                             MPI_Comm communicator)
  : parameters_(parameters)
  , judge_(judge)
  , scene_description_(scene_description)
  , directory_(std::move(directory))
  , communicator_(communicator) {}

void ResultsWriter::on_first_rank(const std::function<void()> &work) const {
  agree(communicator_, [&]() {
    if (!directory_.empty() && Utilities::MPI::this_mpi_process(communicator_) == 0)
      work();
  });
}

void ResultsWriter::write(const std::string &name,
                          const std::function<void(std::ostream &)> &content) const {
  on_first_rank([&]() { write_file(directory_ / name, content); });
}

void ResultsWriter::start_directory() {
  if (started_)
    return;
  started_ = true;
  // From here on there is no verdict of an earlier run.
  write_certificate({}, judge_.unfinished({}));
  on_first_rank([&]() {
    remove_files(directory_, [](const std::string &name) {
      return is_name_of_result(name) && name != certificate_name;
    });
  });
  write(parameters_name,
        [&](std::ostream &stream) { stream << commented(scene_description_) << parameters_.echo; });
}

void ResultsWriter::write_certificate(const std::vector<LevelRecord> &levels,
                                      const StudyVerdict &verdict) const {
  write(certificate_name, [&](std::ostream &stream) {
    Signorini::write_certificate(stream, levels, judge_, verdict);
  });
}

template <int dim>
void ResultsWriter::write_fields(const LevelResult<dim> &level) {
  if (directory_.empty())
    return;
  const LevelSolution<dim> &solution = level.solution;
  const Solved<dim> solved = level.solved();
  const unsigned int number = solution.record.sizes.level;
  const VtuLevels vtu = parameters_.output.vtu;
  const bool wants_finest = vtu == VtuLevels::finest || parameters_.output.pictures;
  write_body_in_contact(level_file("", number, ""), "", solved, solution.bound_fields, number,
                        vtu == VtuLevels::all || (wants_finest && level.is_last));
  if (parameters_.output.compliance)
    write_dual_problem(*level.discretization, solution);
}

template <int dim>
void ResultsWriter::write_body_in_contact(const std::string &ending, const std::string &list,
                                          const BodyInContact<dim> &body, const BoundFields &bound,
                                          const unsigned int number, const bool with_vtu) {
  start_directory();
  TracedContact<dim> traced;
  agree(communicator_, [&]() { traced = trace_contact(body); });
  const std::string contact = "contact" + ending;
  write(contact + ".csv", [&](std::ostream &stream) { write_contact_csv<dim>(stream, traced); });
  if (!with_vtu)
    return;
  const std::string file = write_body("solution" + ending, body, bound, number);
  write(contact + ".vtu",
        [&](std::ostream &stream) { write_contact_vtu<dim>(stream, traced, bound.contact); });
  list_vtu("solution" + list, number, file);
  list_vtu("contact" + list, number, contact + ".vtu");
}

template <int dim>
std::string ResultsWriter::write_body(const std::string &name, const DisplacedBody<dim> &body,
                                      const BoundFields &bound, const unsigned int number) {
  const auto write_cells = solution_vtu(body, bound, number);
  if (!body.space.mesh().is_shared()) {
    write(name + ".vtu", write_cells);
    return name + ".vtu";
  }
  std::vector<std::string> files;
  for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(communicator_); ++rank)
    files.push_back(name + "." + Utilities::int_to_string(rank, 4) + ".vtu");
  VtuCells<dim> cells;
  agree(communicator_, [&]() {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator_);
    std::error_code error;
    if (rank > 0 && !std::filesystem::is_directory(directory_, error))
      throw WritingError("The file '" + (directory_ / files[rank]).string() +
                         "' could not be written: rank " + std::to_string(rank) +
                         " does not see the directory of the first rank; take one that all ranks "
                         "share, or VTU = none.");
    write_file(directory_ / files[rank],
               [&](std::ostream &stream) { cells = write_cells(stream); });
  });
  write(name + ".pvtu", [&](std::ostream &stream) { write_pvtu(stream, files, cells); });
  return name + ".pvtu";
}

template <int dim>
void ResultsWriter::write_case_fields(const BodyInContact<dim> &solved, const unsigned int number) {
  if (!directory_.empty())
    write_body_in_contact("-case-" + Utilities::int_to_string(number, 6), "-cases", solved, {},
                          number, parameters_.output.vtu != VtuLevels::none);
}

void ResultsWriter::list_vtu(const std::string &list, const unsigned int number,
                             const std::string &file) {
  // The best step of graded meshes is written once more, as the last one.
  auto &files = vtu_files_[list];
  while (!files.empty() && files.back().first >= number)
    files.pop_back();
  files.emplace_back(number, file);
  write(list + ".pvd", [&](std::ostream &stream) { write_pvd(stream, files); });
}

void ResultsWriter::write_cases(const std::vector<CaseResult> &cases) {
  start_directory();
  write("cases.csv", [&](std::ostream &stream) { write_cases_csv(stream, cases); });
}

template <int dim>
void ResultsWriter::write_dual_problem(const Discretization<dim> &discretization,
                                       const LevelSolution<dim> &solution) {
  const DisplacementSpace<dim> &space = discretization.space;
  const ContactSolution &contact = solution.contact;
  const LinearSystem<dim> &system = *solution.operators->system;
  const DualData &dual = *contact.dual();
  const std::string A = lower_triangle(system.matrix, system.unit);
  const dealii::Vector<double> f(system.f.begin(), system.f.end());
  // F = G - Dᵀ A⁻¹ f for unconstrained unknowns: prescribed displacements count as gap.
  dealii::Vector<double> G = discretization.G;
  G -= discretization.D.transpose_product(space.complete(space.zero()));
  const auto write_matrix = [&](const char *name, const auto &...matrix) {
    write(level_file(name, solution.record.sizes.level, ".mtx"),
          [&](std::ostream &stream) { write_matrix_market(stream, matrix...); });
  };
  const auto write_vector = [&](const char *name, const dealii::Vector<double> &x) {
    write_matrix(name, FullMatrix<double>(x.size(), 1, x.begin()));
  };
  const Coupling &D = discretization.condensed_D;
  write_matrix("A", f.size(), f.size(), A, true);
  write_matrix("D", f.size(), D.n_columns(), entries_of(D));
  write_vector("f", f);
  write_vector("G", G);
  write_vector("F", dual.F);
  write_vector("P", contact.P.values());
  if (contact.P.has_tangential_part()) {
    const AdmissibleSet &K = discretization.K;
    dealii::Vector<double> s(K.n_normal()), c(K.n_normal());
    for (unsigned int k = 0; k < s.size(); ++k) {
      s[k] = K[s.size() + k].upper;
      c[k] = K.coefficient(s.size() + k);
    }
    write_vector("s", s);
    write_vector("c", c);
  }
  if (contact.q.size() > 0) {
    write_vector("b", dual.motions.b);
    write_vector("q", contact.q);
    write_matrix("B", dual.motions.B);
    write_matrix("K", dual.motions.K, true);
  }
  if (contact.touches())
    write_matrix("C", solution.operators->C->dense(), true);
}

void ResultsWriter::write_tables(const std::vector<LevelRecord> &levels,
                                 const StudyVerdict &verdict) {
  start_directory();
  // The disk may fill up in between. Then the certificate must not claim more than the table
  // contains; the reason why a study is not certified must not get lost.
  if (!verdict.reason.empty())
    write_certificate(levels, verdict);
  write("convergence.csv", [&](std::ostream &stream) { write_convergence_csv(stream, levels); });
  if (verdict.reason.empty())
    write_certificate(levels, verdict);
}

void ResultsWriter::write_answer(const std::vector<LevelRecord> &levels,
                                 const StudyVerdict &verdict) {
  write("answer.json",
        [&](std::ostream &stream) { Signorini::write_answer(stream, levels, verdict); });
  const Answer &answer = levels.back().answer;
  write("contacts.csv", [&](std::ostream &stream) { write_contacts_csv(stream, answer); });
  for (std::size_t i = 0; i < answer.reports.size(); ++i)
    if (answer.reports[i].rows.size() > 1)
      write("line-" + std::to_string(i + 1) + ".csv", [&](std::ostream &stream) {
        write_rows(stream, report_header(answer.dimension), answer.reports[i].rows);
      });
}

void ResultsWriter::write_verified(const VerifiedField &verified) {
  write("verified.json", [&](std::ostream &stream) { write_verified_json(stream, verified); });
  write("verified.vtu", [&](std::ostream &stream) { write_verified_vtu(stream, verified); });
}

std::string ResultsWriter::write_pictures() {
  std::string missing;
  if (parameters_.output.pictures)
    on_first_rank([&]() { missing = draw_pictures(directory_); });
  return missing;
}

void ResultsWriter::write_failure(const std::vector<LevelRecord> &levels,
                                  const StudyVerdict &verdict) {
  bool keeps_earlier_results = false;
  if (!started_)
    on_first_rank([&]() {
      std::error_code error;
      keeps_earlier_results = std::filesystem::exists(directory_ / certificate_name, error);
    });
  try {
    if (!Utilities::MPI::broadcast(communicator_, keeps_earlier_results)) {
      write_tables(levels, verdict);
      if (!levels.empty())
        write_answer(levels, verdict);
    }
  } catch (const WritingError &) {
    // The first failure is reported. On a full disk even the certificate may fail: then its outcome
    // remains "unfinished".
  }
}

void ResultsWriter::abandon() {
  if (!started_ || Utilities::MPI::this_mpi_process(communicator_) != 0)
    return;
  try {
    remove_files(directory_, is_name_of_result);
  } catch (const WritingError &) {
    // The InputError is reported instead.
  }
}

template void ResultsWriter::write_fields(const LevelResult<2> &);
template void ResultsWriter::write_fields(const LevelResult<3> &);
template void ResultsWriter::write_case_fields(const BodyInContact<2> &, unsigned int);
template void ResultsWriter::write_case_fields(const BodyInContact<3> &, unsigned int);
} // namespace Signorini
