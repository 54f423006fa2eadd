// SPDX-License-Identifier: LGPL-2.1-or-later
// One rank speaks.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/driver/runs/run.h>
#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/results/files/files.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <unistd.h>
#include <variant>

namespace Signorini
{
Screen::Screen(MPI_Comm communicator)
  : speaks_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  , silence_(nullptr)
{
}

std::ostream &Screen::out()
{
  return speaks_ ? std::cout : silence_;
}

void Screen::complain(const std::string &sentence) const
{
  if (speaks_)
    std::cerr << "signorini: " << sentence << std::endl;
}

Progress Screen::progress() const
{
  if (!speaks_)
    return [](const std::string &) {};
  const bool on_terminal = isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return [on_terminal](const std::string &text) {
    // Files appear complete or not at all, level by level, which is what the sentence says.
    if (!text.empty())
      describe_interruption("on " + text + "; the results of finished levels are complete.");
    if (on_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
  };
}

// One scene, from its parameter file to an exit code.

namespace
{
/** What goes wrong at a quadrature point knows its parameter, but not the file. */
std::string name_file(const std::string &message, const std::string &file_name)
{
  const bool named = message.rfind(file_name, 0) == 0 || message.rfind("--", 0) == 0;
  return named ? message : file_name + ": " + message;
}

/** Whether a file can be read here, and has another content than on the first rank. */
bool differs(const std::string &file_name, const std::string &text)
{
  try
  {
    return read_text_file(file_name) != text;
  }
  catch (const InputError &)
  {
    return false;
  }
}

/** Without the comments in front, in which a run describes its scene. */
std::string without_description(const std::string &text)
{
  std::size_t start = 0;
  while (start < text.size() && text[start] == '#')
    start = std::min(text.size(), text.find('\n', start)) + 1;
  return start < text.size() ? text.substr(start) : "";
}

/** The files that results must not replace. The parameters of the same run may be. */
std::vector<std::filesystem::path> inputs_of(const RunInput &input, const Parameters &parameters)
{
  std::vector<std::filesystem::path> inputs = input.others;
  std::error_code error;
  if (without_description(input.text) != parameters.echo ||
      !std::filesystem::equivalent(input.file_name, input.directory / parameters_name, error))
    inputs.emplace_back(input.file_name);
  inputs.emplace_back(parameters.geometry.file.value);
  return inputs;
}

template <int dim>
RunSummary study_scene(const Parameters &parameters,
                       const Scene<dim> &scene,
                       const RunInput &input,
                       MPI_Comm communicator,
                       Screen &screen)
{
  const StudyResult<dim> result =
    run_study(parameters, scene, communicator, {screen.out(), input.directory, screen.progress()});
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    describe_interruption("after the last level; the results are complete.");
  if (!result.verdict.reason.empty())
    screen.complain(result.verdict.reason);
  RunSummary summary = {
    result.verdict.is_certified() ? 0 : 2, word_for(result.verdict.outcome), {}};
  if (!result.levels.empty())
    summary.finest = result.levels.back();
  return summary;
}

/** Ranks on several machines may see several files of one name, or none, which is refused later. */
void refuse_other_mesh_files(const Given<std::string> &file, MPI_Comm communicator)
{
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
    return;
  std::size_t digest = 0;
  agree(communicator, [&]() {
    constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();
    std::error_code error;
    if (std::filesystem::exists(file.value, error))
      digest =
        std::hash<std::string>()(read_whole_file(file, file.where() + ": ", "mesh file", any_size));
  });
  const std::size_t of_first = dealii::Utilities::MPI::broadcast(communicator, digest);
  const std::string others =
    list_ranks(communicator, digest != of_first && digest != 0 && of_first != 0);
  if (!others.empty())
    throw InputError(file.where() + ": found another mesh file on " + others +
                     " than on the first rank, allowed: the same file for all ranks.");
}

/** As far as no InputError ends it. */
RunSummary try_to_run(const RunInput &input, MPI_Comm communicator, Screen &screen)
{
  const bool first_rank = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  Parameters parameters;
  std::variant<Scene<2>, Scene<3>> scene;
  agree(communicator, [&]() {
    parameters = parse_parameters(input.text,
                                  input.name,
                                  input.overrides,
                                  std::filesystem::path(input.file_name).parent_path().string());
  });
  refuse_other_mesh_files(parameters.geometry.file, communicator);
  // A mesh file may be missing on one rank.
  agree(communicator, [&]() {
    if (dimension_of(parameters) == 2)
      scene = make_scene<2>(parameters);
    else
      scene = make_scene<3>(parameters);
  });
  std::optional<ResultsDirectory> results;
  agree(communicator, [&]() {
    if (first_rank)
      results.emplace(input.directory, inputs_of(input, parameters));
  });
  try
  {
    return std::visit(
      [&](const auto &of_dim) {
        return study_scene(parameters, of_dim, input, communicator, screen);
      },
      scene);
  }
  catch (const InputError &error)
  {
    // Wrong input leaves nothing behind.
    if (results)
      results->remove_if_empty();
    throw InputError(name_file(error.what(), parameters.file_name));
  }
}
} // namespace

RunInput read_input(const std::string &file_name,
                    const std::vector<std::string> &overrides,
                    const std::filesystem::path &directory,
                    MPI_Comm communicator,
                    const Screen &screen)
{
  const bool first_rank = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  RunInput input = {file_name, shorten_path(file_name), "", overrides, directory, {}};
  agree(communicator, [&]() {
    if (first_rank)
      input.text = read_text_file(file_name);
  });
  input.text = dealii::Utilities::MPI::broadcast(communicator, input.text);
  const std::string others =
    list_ranks(communicator, !first_rank && differs(file_name, input.text));
  if (!others.empty())
    screen.complain(input.name + ": another text is found on " + others +
                    " than on the first rank, whose text all of them use.");
  return input;
}

RunSummary tell_errors(const Screen &screen, const std::function<RunSummary()> &run)
{
  try
  {
    return run();
  }
  catch (const InputError &error)
  {
    screen.complain(error.what());
    return {1, "wrong input", {}};
  }
  catch (const WritingError &error)
  {
    screen.complain(error.what());
    return {3, "not written", {}};
  }
  catch (const ComputationError &error)
  {
    screen.complain(error.what());
    return {2, "failed", {}};
  }
}

RunSummary run_scene(const RunInput &input, MPI_Comm communicator, Screen &screen)
{
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    describe_interruption("before the first level.");
  // Every rank has the same input and meets the same errors; see agree() for the rest.
  return tell_errors(screen, [&]() { return try_to_run(input, communicator, screen); });
}
} // namespace Signorini
