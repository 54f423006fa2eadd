// SPDX-License-Identifier: LGPL-2.1-or-later
// The run of one scene, from its parameter file to an exit code.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/driver/check/show_scene.h>
#include <signorini/driver/runs/run.h>
#include <signorini/driver/runs/strategy.h>
#include <signorini/driver/study/study.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameter_text.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/signals.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>

namespace Signorini {
namespace {
/** Returns the message with the name of the file in front, if it lacks that: errors at a quadrature
 * point name the parameter only. */
std::string name_file(const std::string &message, const std::string &file_name) {
  const bool named = message.rfind(file_name, 0) == 0 || message.rfind("--", 0) == 0;
  return named ? message : file_name + ": " + message;
}

/** Refuses a file of which a rank, on another machine, has another version than the first rank.
 * Ranks that cannot read it are left out. Collective. @throws InputError */
void require_one_version(const std::string &name, const std::string &file_name,
                         MPI_Comm communicator) {
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return;
  std::ifstream file(file_name, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t digest = file.is_open() ? std::hash<std::string>()(text) : 0;
  const std::size_t of_first = Utilities::MPI::broadcast(communicator, digest);
  const std::string others =
    list_ranks(communicator, digest != of_first && digest != 0 && of_first != 0);
  if (!others.empty())
    throw input_error(name, ": found another text on ", others,
                      " than on the first rank, allowed: the same file for all.");
}

/** Returns the text without the comments in front, in which a run describes its scene. */
std::string without_description(const std::string &text) {
  std::size_t start = 0;
  while (start < text.size() && text[start] == '#')
    start = std::min(text.size(), text.find('\n', start)) + 1;
  return start < text.size() ? text.substr(start) : "";
}

/** Returns the files that results must not replace. The parameters of the same run may be replaced.
 */
std::vector<std::filesystem::path> inputs_of(const RunInput &input, const Parameters &parameters) {
  std::vector<std::filesystem::path> inputs = input.others;
  std::error_code error;
  if (without_description(input.text) != parameters.echo ||
      !std::filesystem::equivalent(input.file_name, input.directory / parameters_name, error))
    inputs.emplace_back(input.file_name);
  inputs.emplace_back(parameters.geometry.file.value);
  inputs.emplace_back(parameters.verify.file.value);
  return inputs;
}

bool is_first_rank(MPI_Comm communicator) {
  return Utilities::MPI::this_mpi_process(communicator) == 0;
}

/** Returns whether graded meshes were chosen that miss the contact of load cases: they follow that
 * of the scene itself, which does not touch. */
template <int dim>
bool misses_contact(const Parameters &given, const StudyResult<dim> &result) {
  return given.discretization.strategy == Strategy::automatic && !result.verdict.is_certified() &&
         !result.levels.empty() && result.levels.back().sizes.is_graded() &&
         result.levels.back().load_cases && result.levels.back().contact.active == 0;
}

/** Runs the scene of some parameters. @throws InputError for wrong input. */
template <int dim>
RunSummary run_parameters(Parameters given, const RunInput &input, MPI_Comm communicator,
                          Screen &screen) {
  Scene<dim> scene;
  agree(communicator, [&]() { scene = make_scene<dim>(given, input.known.scenes); });
  // The scene has the meshes of files now, whose texts may be long.
  given.geometry.mesh.clear();
  for (GeometryParameters &body : given.bodies)
    body.mesh.clear();
  Parameters parameters = given;
  const std::string reason = decide_strategy(parameters, scene);
  std::shared_ptr<ResultsDirectory> results;
  agree(communicator, [&]() {
    if (is_first_rank(communicator))
      results = std::make_shared<ResultsDirectory>(input.directory, inputs_of(input, parameters));
  });
  if (!reason.empty())
    screen.out() << "Strategy  " << reason << "\n";
  try {
    const StudyReport report = {screen.out(), input.directory, screen.progress()};
    if (input.only_show) {
      show_scene(parameters, scene, communicator, report);
      if (results)
        results->remove_if_empty();
      return {0, "shown", {}, {}};
    }
    const auto &make_verify = std::get<KnownSolutions::MakeVerify<dim>>(input.known.make_verify);
    const auto solve = [&]() {
      return run_study(parameters, scene, communicator, report,
                       make_verify ? make_verify(parameters, scene) : Verify<dim>(),
                       input.references);
    };
    StudyResult<dim> result = solve();
    if (misses_contact(given, result)) {
      screen.out() << "\nStrategy  nested, since load cases alone touch\n";
      parameters = given;
      solve_all_nested_levels(parameters);
      result = solve();
    }
    if (is_first_rank(communicator))
      describe_interruption("after the last level; the results are complete.");
    if (!result.verdict.reason.empty())
      screen.complain(name_file(result.verdict.reason, parameters.file_name));
    if (!result.objection.empty())
      screen.complain(result.objection);
    RunSummary summary = {result.verdict.is_certified() && result.objection.empty() ? 0 : 2,
                          word_for(result.verdict.outcome),
                          {},
                          results};
    if (!result.levels.empty())
      summary.finest = result.levels.back();
    return summary;
  } catch (const InputError &error) {
    // After wrong input no results remain.
    if (results)
      results->remove_if_empty();
    throw input_error(name_file(error.what(), parameters.file_name));
  }
}
} // namespace

Parameters parameters_of(const RunInput &input, MPI_Comm communicator) {
  Parameters parameters;
  agree(communicator, [&]() {
    parameters =
      parse_parameters(input.text, input.name, input.overrides,
                       std::filesystem::path(input.file_name).parent_path().string(), input.swept);
  });
  return parameters;
}

RunInput read_input(const std::string &file_name, const std::vector<std::string> &overrides,
                    const std::filesystem::path &directory, MPI_Comm communicator) {
  RunInput input;
  input.file_name = file_name;
  input.name = shorten_path(file_name);
  input.overrides = overrides;
  input.directory = directory;
  agree(communicator, [&]() {
    if (is_first_rank(communicator))
      input.text = read_text_file(file_name);
  });
  input.text = Utilities::MPI::broadcast(communicator, input.text);
  require_one_version(input.name, file_name, communicator);
  return input;
}

RunSummary tell_errors(const Screen &screen, const std::function<RunSummary()> &run) {
  const auto fail = [&](const std::exception &error, const int code, const char *verdict) {
    // When one rank has ended, mpirun ends the others by a signal, which needs no sentence.
    describe_interruption("");
    screen.complain(error.what());
    return RunSummary{code, verdict, {}, {}};
  };
  try {
    return run();
  } catch (const InputError &error) {
    return fail(error, 1, "wrong input");
  } catch (const WritingError &error) {
    return fail(error, 3, "not written");
  } catch (const ComputationError &error) {
    return fail(error, 2, "failed");
  }
}

RunSummary run_scene(const RunInput &input, Parameters parameters, MPI_Comm communicator,
                     Screen &screen) {
  if (is_first_rank(communicator))
    describe_interruption("before the first level.");
  const unsigned int dim = dimension_of(parameters, input.known.scenes);
  const auto read_file = [&](GeometryParameters &geometry) {
    if (geometry.shape == Shape::file)
      require_one_version(geometry.file.where(), geometry.file.value, communicator);
    agree(communicator, [&]() {
      if (is_first_rank(communicator) && geometry.shape == Shape::file)
        geometry.mesh = read_mesh_file(geometry, dim);
    });
    geometry.mesh = Utilities::MPI::broadcast(communicator, geometry.mesh);
  };
  if (parameters.bodies.empty())
    read_file(parameters.geometry);
  std::for_each(parameters.bodies.begin(), parameters.bodies.end(), read_file);
  return dim == 2 ? run_parameters<2>(std::move(parameters), input, communicator, screen)
                  : run_parameters<3>(std::move(parameters), input, communicator, screen);
}
} // namespace Signorini
