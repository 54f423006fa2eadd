// SPDX-License-Identifier: LGPL-2.1-or-later
// The screen, to which only the first rank writes.

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

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>
#include <unistd.h>

namespace Signorini {
Screen::Screen(MPI_Comm communicator, const bool is_quiet)
  : speaks_(Utilities::MPI::this_mpi_process(communicator) == 0)
  , is_quiet_(is_quiet)
  , silence_(nullptr) {}

std::ostream &Screen::out() {
  return speaks_ && !is_quiet_ ? std::cout : silence_;
}

void Screen::complain(const std::string &sentence) const {
  if (speaks_)
    std::cerr << "signorini: " << sentence << std::endl;
}

Progress Screen::progress() const {
  if (!speaks_)
    return [](const std::string &) {};
  const bool on_terminal = !is_quiet_ && isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  return [on_terminal](const std::string &text) {
    // Each level writes its files completely or not at all, as the sentence states.
    if (!text.empty())
      describe_interruption("on " + text + "; the results of finished levels are complete.");
    if (on_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
  };
}

// The run of one scene, from its parameter file to an exit code.

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
  return inputs;
}

bool is_first_rank(MPI_Comm communicator) {
  return Utilities::MPI::this_mpi_process(communicator) == 0;
}

/** Returns the parameters of a run. @throws InputError */
Parameters parameters_of(const RunInput &input) {
  return parse_parameters(input.text, input.name, input.overrides,
                          std::filesystem::path(input.file_name).parent_path().string());
}

/** Returns whether graded meshes were chosen that miss the contact of load cases: they follow that
 * of the scene itself, which does not touch. */
bool misses_contact(const Parameters &given, const RunSummary &run) {
  return given.discretization.strategy == Strategy::automatic && run.exit_code == 2 && run.finest &&
         run.finest->sizes.is_graded() && run.finest->load_cases && run.finest->contact.active == 0;
}

/** Runs the scene of some parameters. @throws InputError for wrong input. */
template <int dim>
RunSummary run_parameters(const Parameters &given, const RunInput &input, MPI_Comm communicator,
                          Screen &screen) {
  Scene<dim> scene;
  RunInput decided = input;
  agree(communicator, [&]() { scene = make_scene<dim>(given); });
  const StrategyDecision decision = decide_strategy(given, scene);
  std::copy(decision.overrides.begin(), decision.overrides.end(),
            std::back_inserter(decided.overrides));
  Parameters parameters = parameters_of(decided);
  if (decision.levels) {
    parameters.discretization.coarsest_level.value = (*decision.levels)[0];
    parameters.discretization.finest_level.value = (*decision.levels)[1];
  }
  std::optional<ResultsDirectory> results;
  agree(communicator, [&]() {
    if (is_first_rank(communicator))
      results.emplace(input.directory, inputs_of(input, parameters));
  });
  if (!decision.sentence.empty())
    screen.out() << "Strategy  " << decision.sentence << "\n";
  try {
    const StudyReport report = {screen.out(), input.directory, screen.progress()};
    if (input.only_show) {
      show_scene(parameters, scene, communicator, report);
      if (results)
        results->remove_if_empty();
      return {0, "shown", {}};
    }
    const StudyResult<dim> result = run_study(parameters, scene, communicator, report);
    if (is_first_rank(communicator))
      describe_interruption("after the last level; the results are complete.");
    RunSummary summary = {
      result.verdict.is_certified() ? 0 : 2, word_for(result.verdict.outcome), {}};
    if (!result.levels.empty())
      summary.finest = result.levels.back();
    if (misses_contact(given, summary)) {
      screen.out() << "\nStrategy  nested, since load cases alone touch\n";
      results.reset();
      Parameters nested = given;
      nested.discretization.strategy.value = Strategy::nested;
      decided = input;
      // The error of the scene itself says nothing about the cases: all levels are solved.
      decided.overrides.push_back(nested.discretization.strategy.name + "=nested");
      decided.overrides.push_back(nested.discretization.target_error.name + "=0");
      return run_parameters<dim>(nested, decided, communicator, screen);
    }
    if (!result.verdict.reason.empty())
      screen.complain(name_file(result.verdict.reason, parameters.file_name));
    return summary;
  } catch (const InputError &error) {
    // After wrong input no results remain.
    if (results)
      results->remove_if_empty();
    throw input_error(name_file(error.what(), parameters.file_name));
  }
}

/** Runs a scene. @throws InputError for wrong input. */
RunSummary try_to_run(const RunInput &input, MPI_Comm communicator, Screen &screen) {
  Parameters parameters;
  agree(communicator, [&]() { parameters = parameters_of(input); });
  const auto read_file = [&](GeometryParameters &geometry) {
    if (geometry.shape == Shape::file)
      require_one_version(geometry.file.where(), geometry.file.value, communicator);
    agree(communicator, [&]() {
      if (is_first_rank(communicator) && geometry.shape == Shape::file)
        geometry.mesh = read_mesh_file(geometry);
    });
    geometry.mesh = Utilities::MPI::broadcast(communicator, geometry.mesh);
  };
  if (parameters.bodies.empty())
    read_file(parameters.geometry);
  std::for_each(parameters.bodies.begin(), parameters.bodies.end(), read_file);
  return dimension_of(parameters) == 2 ? run_parameters<2>(parameters, input, communicator, screen)
                                       : run_parameters<3>(parameters, input, communicator, screen);
}
} // namespace

RunInput read_input(const std::string &file_name, const std::vector<std::string> &overrides,
                    const std::filesystem::path &directory, MPI_Comm communicator) {
  RunInput input = {file_name, shorten_path(file_name), "", overrides, directory, false, {}};
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
    return RunSummary{code, verdict, {}};
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

RunSummary run_scene(const RunInput &input, MPI_Comm communicator, Screen &screen) {
  if (is_first_rank(communicator))
    describe_interruption("before the first level.");
  // Every rank has the same input and throws the same errors; agree() ensures the rest.
  return tell_errors(screen, [&]() { return try_to_run(input, communicator, screen); });
}

// The runs of one scene for several values of its parameters.

namespace {
constexpr std::size_t max_runs = 1000;
constexpr const char *table_name = "sweep.csv";

/** Returns a value as the name of a directory: characters that a shell interprets become '_'. */
std::string as_file_name(const std::string &value) {
  constexpr std::size_t longest = 80;
  std::string name = value.substr(0, longest);
  std::replace_if(
    name.begin(), name.end(),
    [](const unsigned char c) {
      return std::isalnum(c) == 0 &&
             std::string(".-+=^*()").find(static_cast<char>(c)) == std::string::npos;
    },
    '_');
  if (name.empty() || name[0] == '.' || name[0] == '-')
    name.insert(0, "_");
  return name;
}

/** The columns of the table: their names, and those of the columns of a level. */
constexpr std::pair<const char *, const char *> sweep_columns[] = {
  {"level", "level"},
  {"dofs", "dofs"},
  {"contact_force", "contact_force_n"},
  {"peak_pressure", "peak_pressure"},
  {"energy", "energy"},
  {"estimate", "estimated_relative"},
  {"bound", "bound_relative"},
  {"seconds", "t_total"},
  {"contact_length", "contact_length"},
  {"plate_travel", "plate_travel"},
  {"plate_drift", "plate_drift"},
  {"plate_rotation", "plate_rotation"},
  {"tangential_force", "tangential_force"},
  {"stick_length", "stick_length"},
  {"slip_length", "slip_length"}};
/** The number of columns that the screen has, too; in the file these are there in every sweep. */
constexpr std::size_t n_on_screen = 8;

/** Returns the numbers of a run with their names, as far as they are known. */
std::vector<std::pair<std::string, double>> numbers_of(const RunSummary &run) {
  std::vector<std::pair<std::string, double>> numbers;
  if (!run.finest)
    return numbers;
  for (const auto &[name, column] : sweep_columns)
    if (const std::optional<double> x = value(*run.finest, column))
      numbers.emplace_back(name, *x);
  for (const SideForce &reaction : run.finest->answer.reactions)
    for (std::size_t d = 0; d < reaction.resultant.force.size(); ++d)
      numbers.emplace_back("reaction_" + reaction.side + "_" + "xyz"[d],
                           reaction.resultant.force[d]);
  for (const auto &extreme : named_extremes(run.finest->answer.reports))
    numbers.push_back(extreme);
  return numbers;
}

/** Returns the names of the columns: those of the screen, or with those that some run has. */
std::vector<std::string> column_names(const std::vector<RunSummary> &runs, const bool for_file) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < n_on_screen; ++i)
    names.emplace_back(sweep_columns[i].first);
  if (for_file)
    for (const RunSummary &run : runs)
      for (const auto &number : numbers_of(run))
        if (std::find(names.begin(), names.end(), number.first) == names.end())
          names.push_back(number.first);
  return names;
}

using Table = std::vector<std::vector<std::string>>;

/** Returns a row of titles, and a row for each run. */
Table sweep_table(const std::vector<Sweep> &sweeps, const std::vector<SweepPoint> &points,
                  const std::vector<RunSummary> &runs, const bool for_file) {
  constexpr int all_digits = 16, few = 5;
  const std::vector<std::string> names = column_names(runs, for_file);
  Table rows(1 + runs.size());
  for (const Sweep &sweep : sweeps)
    rows[0].push_back(sweep.parameter);
  rows[0].insert(rows[0].end(), names.begin(), names.end());
  rows[0].emplace_back("verdict");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::string> &row = rows[1 + i];
    row = points[i].values;
    const auto numbers = numbers_of(runs[i]);
    for (const std::string &name : names) {
      std::ostringstream text;
      const auto number = std::find_if(numbers.begin(), numbers.end(),
                                       [&](const auto &known) { return known.first == name; });
      if (number != numbers.end())
        text << std::setprecision(for_file ? all_digits : few) << number->second;
      row.push_back(text.str());
    }
    row.push_back(runs[i].verdict);
  }
  return rows;
}

/** Writes fields separated by commas; one that contains a comma stands in quotation marks. */
void write_csv(std::ostream &stream, Table rows) {
  for (std::vector<std::string> &row : rows) {
    for (std::string &field : row)
      if (field.find(',') != std::string::npos)
        field.insert(0, 1, '"').push_back('"');
    stream << join(row, ",") << "\n";
  }
}

/** Prints aligned columns, @p n_left of them on the left. */
void print_table(std::ostream &screen, Table rows, const std::size_t n_left) {
  std::vector<std::size_t> widths(rows[0].size());
  for (std::vector<std::string> &row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      row[k] = row[k].empty() ? "-" : shorten(row[k]);
      widths[k] = std::max(widths[k], row[k].size());
    }
  screen << "\n";
  for (const std::vector<std::string> &row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      screen << (k < n_left ? std::left : std::right) << std::setw(static_cast<int>(widths[k]))
             << row[k] << "  ";
    screen << row.back() << "\n";
  }
  screen << std::flush;
}

/** Returns the input of one run. */
RunInput input_at(const RunInput &input, const std::vector<Sweep> &sweeps,
                  const SweepPoint &point) {
  RunInput one = input;
  for (std::size_t k = 0; k < sweeps.size(); ++k)
    one.overrides.push_back(sweeps[k].parameter + "=" + point.values[k]);
  one.directory = input.directory / point.folder;
  return one;
}
} // namespace

Sweep read_sweep(const std::string &argument) {
  const auto equals = argument.find('=');
  const std::string parameter = trim(argument.substr(0, equals));
  Sweep sweep = {parameter, {}};
  // Values that contain commas are separated by '|'.
  if (equals != std::string::npos)
    sweep.values = split_list(argument.substr(equals + 1), '|');
  if (sweep.values.size() == 1)
    sweep.values = split_list(sweep.values[0], ',');
  const auto is_wrong = [](const std::string &value) {
    return value.empty() || value.find(" step ") != std::string::npos;
  };
  if (parameter.empty() || sweep.values.empty() ||
      std::any_of(sweep.values.begin(), sweep.values.end(), is_wrong))
    throw input_error("--sweep: found ", quote(argument),
                      ", but 'Subsection/Parameter=value, value, ...' is expected.");
  return sweep;
}

namespace {
/** Refuses sweeps of which one would replace the values of another. */
void refuse_double_sweeps(const std::vector<Sweep> &sweeps) {
  const std::string all = "Constants/Values", section = "Constants/";
  // A constant may be named without its subsection.
  const auto name = [&](const Sweep &sweep) {
    const std::string &parameter = sweep.parameter;
    return parameter.rfind(section, 0) == 0 ? parameter.substr(section.size()) : parameter;
  };
  const auto is_constant = [&](const Sweep &sweep) {
    return name(sweep).find('/') == std::string::npos;
  };
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (name(sweeps[i]) == name(sweeps[j]) ||
          (is_constant(sweeps[i]) && sweeps[j].parameter == all) ||
          (is_constant(sweeps[j]) && sweeps[i].parameter == all))
        throw input_error("--sweep: found ", quote(sweeps[j].parameter), " and ",
                          quote(sweeps[i].parameter),
                          ", allowed: one sweep of a parameter, with all of its values.");
}
} // namespace

std::vector<SweepPoint> combine(const std::vector<Sweep> &sweeps) {
  refuse_double_sweeps(sweeps);
  std::size_t n = 1;
  for (const Sweep &sweep : sweeps) {
    n *= sweep.values.size();
    if (n > max_runs)
      throw input_error("--sweep: found more than ", max_runs,
                        " combinations of values, allowed: at most ", max_runs, ".");
  }
  std::vector<SweepPoint> points = {{}};
  for (const Sweep &sweep : sweeps) {
    std::vector<SweepPoint> longer;
    for (const SweepPoint &point : points)
      for (const std::string &value : sweep.values) {
        longer.push_back(point);
        longer.back().values.push_back(value);
        longer.back().folder += (point.folder.empty() ? "" : "_") + as_file_name(value);
      }
    points = std::move(longer);
  }
  std::set<std::string> folders;
  for (const SweepPoint &point : points)
    if (!folders.insert(point.folder).second)
      throw input_error("--sweep: two runs would write into the directory '", point.folder,
                        "', allowed: values that differ in their letters and digits.");
  return points;
}

RunSummary run_sweep(const RunInput &input, const std::vector<Sweep> &sweeps, MPI_Comm communicator,
                     Screen &screen) {
  const std::vector<SweepPoint> points = combine(sweeps);
  std::vector<std::filesystem::path> inputs = input.others;
  inputs.emplace_back(input.file_name);
  for (const SweepPoint &point : points)
    inputs.emplace_back(parameters_of(input_at(input, sweeps, point)).geometry.file.value);
  const bool first_rank = is_first_rank(communicator);
  std::optional<ResultsDirectory> results;
  agree(communicator, [&]() {
    if (first_rank)
      results.emplace(input.directory, inputs,
                      [](const std::string &name) { return name == table_name; });
  });
  RunSummary worst;
  std::vector<RunSummary> runs;
  for (const SweepPoint &point : points) {
    screen.out() << (runs.empty() ? "" : "\n");
    for (std::size_t k = 0; k < sweeps.size(); ++k)
      screen.out() << "Sweep     " << sweeps[k].parameter << " = " << point.values[k] << "\n";
    runs.push_back(run_scene(input_at(input, sweeps, point), communicator, screen));
    if (runs.size() == 1 || runs.back().exit_code > worst.exit_code)
      worst = runs.back();
    // The table is written after every run: that of an interrupted sweep has all finished runs.
    const bool solved = std::any_of(runs.begin(), runs.end(),
                                    [](const RunSummary &run) { return run.finest.has_value(); });
    agree(communicator, [&]() {
      if (first_rank && solved)
        write_file(input.directory / table_name, [&](std::ostream &stream) {
          write_csv(stream, sweep_table(sweeps, points, runs, true));
        });
    });
  }
  if (results)
    results->remove_if_empty();
  print_table(screen.out(), sweep_table(sweeps, points, runs, false), sweeps.size());
  return worst;
}
} // namespace Signorini
