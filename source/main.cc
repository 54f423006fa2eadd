// SPDX-License-Identifier: LGPL-2.1-or-later
// From the command line to an exit code: 0 certified, 1 wrong input, 2 not certified, 3 other.

#include <signorini/base/errors.h>
#include <signorini/driver/runs/run.h>
#include <signorini/driver/runs/sweep.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/signals.h>
#include <signorini/verification/catalogue/catalogue.h>
#include <signorini/verification/verify.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <new>
#include <system_error>
#include <unistd.h>

#include "command_line.h"
#include "start_up.h"

namespace {
using namespace Signorini;

constexpr int other_error = 3;

void complain(const std::string &sentence) {
  std::cerr << "signorini: " << sentence << std::endl;
}

/** Flushes the standard output; a full disk or a closed pipe gives a message and an exit code.
 * @return the exit code. */
int flush_standard_output(const int code) {
  if (std::cout.flush())
    return code;
  complain("the standard output could not be written.");
  return code != 0 ? code : other_error;
}

/** Runs one parameter file, or all runs of its sweeps. */
RunSummary run_file(const CommandLine &command_line, const std::size_t i, MPI_Comm communicator,
                    Screen &screen) {
  return tell_errors(screen, [&]() {
    RunInput input = read_input(command_line.parameter_files[i], command_line.overrides,
                                command_line.directories[i], communicator);
    input.others.assign(command_line.parameter_files.begin() + i + 1,
                        command_line.parameter_files.end());
    input.only_show = command_line.check;
    input.known = {named_scenes(), {make_verify<2>, make_verify<3>}};
    std::vector<Sweep> sweeps;
    for (const std::string &argument : command_line.sweeps)
      sweeps.push_back(read_sweep(argument));
    return sweeps.empty()
             ? run_scene(input, parameters_of(input, communicator), communicator, screen)
             : run_sweep(input, sweeps, communicator, screen);
  });
}

/** Runs one scene after the other. @return the largest exit code. */
int run(CommandLine command_line, MPI_Comm communicator) {
  Screen screen(communicator, command_line.quiet);
  const std::string others = share_command_line(command_line, communicator);
  if (!others.empty()) {
    screen.complain("another command line was given to " + others +
                    " than to the first rank, allowed: the same for all.");
    return 1;
  }
  int code = 0;
  std::vector<RunSummary> summaries;
  for (std::size_t i = 0; i < command_line.parameter_files.size(); ++i) {
    summaries.push_back(run_file(command_line, i, communicator, screen));
    summaries.back().results.reset();
    code = std::max(code, summaries.back().exit_code);
  }
  if (summaries.size() > 1)
    for (std::size_t i = 0; i < summaries.size(); ++i)
      screen.out() << (i == 0 ? "\n" : "") << command_line.parameter_files[i] << ": "
                   << summaries[i].verdict << ", exit code " << summaries[i].exit_code << ", "
                   << command_line.directories[i] << "\n";
  screen.out() << std::flush;
  return flush_standard_output(code);
}

/** Reports a failure of this rank alone, by an exception that is not agreed upon, and does not
 * leave the others waiting. @return the exit code. */
int fail_alone(const std::string &sentence) {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1) {
    complain(sentence);
    return other_error;
  }
  complain("rank " + std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
           ": " + sentence);
  // MPI ends all ranks by a signal, which needs no message of its own.
  describe_interruption("");
  MPI_Abort(MPI_COMM_WORLD, other_error);
  return other_error;
}

/** Returns the sentence about an exception that nobody expected. */
std::string describe(const std::exception &error) {
  // Where there is no room for another thread, a system_error is thrown.
  const auto *const system_error = dynamic_cast<const std::system_error *>(&error);
  const bool is_memory =
    dynamic_cast<const std::bad_alloc *>(&error) != nullptr ||
    (system_error != nullptr && system_error->code() == std::errc::resource_unavailable_try_again);
  return is_memory ? "out of memory: there is not enough for this computation."
                   : std::string("an unexpected error occurred: ") + error.what();
}

/** Starts MPI and runs all scenes. @return the exit code. */
int start_and_run(const CommandLine &command_line) {
  const std::vector<int> signals = ending_signals();
  std::unique_ptr<SessionFolder> session = configure_single_process();
  // deal.II starts PETSc, too, which would take the program's options for its own. It warns at the
  // end about options that it did not use, also about a user's settings for other programs.
  std::array<std::string, 4> words = {{"signorini", "-skip_petscrc", "-options_left", "no"}};
  std::array<char *, 5> pointers = {};
  std::transform(words.begin(), words.end(), pointers.begin(),
                 [](std::string &word) { return word.data(); });
  int argc = words.size();
  char **argv = pointers.data();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  session.reset();
  handle_signals(signals);
  try {
    return run(command_line, MPI_COMM_WORLD);
  } catch (const std::exception &error) {
    return fail_alone(describe(error));
  }
}
} // namespace

int main(int argc, char **argv) {
  make_standard_streams_safe();
  keep_ignoring_hangup();
  dealii::deal_II_exceptions::disable_abort_on_exception();
  try {
    const CommandLine command_line = read_command_line(argc, argv);
    if (!command_line.text.empty()) {
      std::cout << command_line.text;
      return flush_standard_output(0);
    }
    check_surroundings();
    return start_and_run(command_line);
  } catch (const InputError &error) {
    complain(error.what());
    return 1;
  } catch (const std::exception &error) {
    complain(describe(error));
    // Threads of the BLAS may be waiting for memory forever, and exit() for these threads.
    _exit(other_error);
  }
}
