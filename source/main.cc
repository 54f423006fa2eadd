// SPDX-License-Identifier: LGPL-2.1-or-later
// From the command line to an exit code: 0 certified, 1 wrong input, 2 not certified, 3 other.

#include <signorini/base/agreement.h>
#include <signorini/base/exceptions.h>
#include <signorini/output/files.h>
#include <signorini/output/interruption.h>
#include <signorini/scene_input/make_scene.h>
#include <signorini/study/study.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <new>
#include <optional>
#include <unistd.h>

#include "command_line.h"

namespace
{
using namespace Signorini;

/** One line on a terminal that is overwritten; nothing in a log. */
void show_progress(const std::string &text)
{
  static const std::string erase_line = "\r\033[K";
  std::cerr << erase_line << text << std::flush;
}

/** Files appear complete or not at all, level by level, which is what the sentence says. */
Progress make_progress(const bool first_rank)
{
  if (!first_rank)
    return [](const std::string &) {};
  const bool on_terminal = isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return [on_terminal](const std::string &text) {
    if (!text.empty())
      describe_interruption("on " + text + "; the results of finished levels are complete.");
    if (on_terminal)
      show_progress(text);
  };
}

/** What goes wrong at a quadrature point knows its parameter, but not the file. */
std::string name_file(const std::string &message, const std::string &file_name)
{
  const bool named = message.rfind(file_name, 0) == 0 || message.rfind("--", 0) == 0;
  return named ? message : file_name + ": " + message;
}

/** One line, from one rank. */
void complain(const std::string &sentence)
{
  int initialized = 0;
  MPI_Initialized(&initialized);
  if (initialized == 0 || dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cerr << "signorini: " << sentence << std::endl;
}

/** What was printed must have arrived: a full disk or a closed pipe is told, by the exit code too.
 */
int confirm_screen(const int code)
{
  if (std::cout.flush())
    return code;
  complain("the standard output could not be written.");
  return code != 0 ? code : 3;
}

int run(const CommandLine &command_line, MPI_Comm communicator)
{
  const bool first_rank = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Parameters parameters =
    read_parameters(command_line.parameter_file, command_line.overrides);
  const Scene<2> scene = make_scene(parameters);
  const std::filesystem::path &directory = command_line.output;
  std::optional<ResultsDirectory> results;
  agree(communicator, [&]() {
    if (first_rank)
      results.emplace(directory);
  });

  std::ostream silence(nullptr);
  const StudyReport report = {
    first_rank ? std::cout : silence, directory, make_progress(first_rank)};
  try
  {
    const StudyResult result = run_study(parameters, scene, communicator, report);
    if (first_rank)
      describe_interruption("after the last level; the results are complete.");
    if (first_rank && !result.verdict.reason.empty())
      std::cerr << "signorini: " << result.verdict.reason << std::endl;
    return confirm_screen(result.verdict.is_certified() ? 0 : 2);
  }
  catch (const InputError &error)
  {
    // Wrong input leaves nothing behind.
    if (results)
      results->remove_if_empty();
    throw InputError(name_file(error.what(), parameters.file_name));
  }
}

/** Ranks that failed alone, by exceptions that are not agreed upon, say so and must not leave the
 * others waiting. @return the exit code. */
int fail_alone(const std::string &sentence)
{
  constexpr int code = 3;
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
  {
    complain(sentence);
    return code;
  }
  std::cerr << "signorini, rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)
            << ": " << sentence << std::endl;
  // MPI ends all ranks by a signal, about which nothing is left to say.
  describe_interruption("");
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}
} // namespace

int main(int argc, char **argv)
{
  make_standard_streams_safe();
  const std::vector<int> signals = ending_signals();
  dealii::deal_II_exceptions::disable_abort_on_exception();
  try
  {
    const CommandLine command_line = read_command_line(argc, argv);
    if (!command_line.text.empty())
    {
      std::cout << command_line.text;
      return confirm_screen(0);
    }
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    handle_signals(signals);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      describe_interruption("before the first level.");
    try
    {
      return run(command_line, MPI_COMM_WORLD);
    }
    // Every rank reads the same input and meets the same InputError; see agree() for the rest.
    catch (const InputError &error)
    {
      complain(error.what());
      return 1;
    }
    catch (const ComputationError &error)
    {
      complain(error.what());
      return 2;
    }
    catch (const std::bad_alloc &)
    {
      return fail_alone("there is not enough memory for this computation.");
    }
    catch (const std::exception &error)
    {
      return fail_alone(std::string("an unexpected error occurred: ") + error.what());
    }
  }
  catch (const InputError &error)
  {
    complain(error.what());
    return 1;
  }
}
