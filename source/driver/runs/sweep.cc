// SPDX-License-Identifier: LGPL-2.1-or-later
// The runs of one scene for several values of its parameters.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/driver/runs/sweep.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/results/output/tables.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <set>
#include <sstream>
#include <sys/resource.h>

namespace Signorini {
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

/** Prints the table; the texts of the sweeps stand on the left. */
void print_table(std::ostream &screen, Table rows, const std::size_t n_sweeps) {
  for (std::vector<std::string> &row : rows)
    for (std::string &field : row)
      field = field.empty() ? "-" : shorten(field);
  screen << "\n";
  print_columns(screen, rows, n_sweeps);
  screen << std::flush;
}

/** Returns the input of one run. */
RunInput input_at(const RunInput &input, const std::vector<Sweep> &sweeps,
                  const SweepPoint &point) {
  RunInput one = input;
  for (std::size_t k = 0; k < sweeps.size(); ++k)
    one.swept.push_back(sweeps[k].parameter + "=" + point.values[k]);
  one.directory = input.directory / point.folder;
  return one;
}

/** Lets runs keep their directories open. @return how many of them may, as far as the system lets
 * them. */
std::size_t allow_open_files(const std::size_t n_runs) {
  constexpr rlim_t others = 256;
  rlimit files = {};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min(files.rlim_max, std::max<rlim_t>(files.rlim_cur, n_runs + others));
  setrlimit(RLIMIT_NOFILE, &files);
  return files.rlim_cur - std::min(files.rlim_cur, others);
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
        throw input_error("--sweep: found ", quote(sweeps[j].parameter), " and again ",
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
  std::vector<Parameters> parameters;
  for (const SweepPoint &point : points) {
    parameters.push_back(parameters_of(input_at(input, sweeps, point), communicator));
    inputs.emplace_back(parameters.back().geometry.file.value);
  }
  const std::size_t n_kept = allow_open_files(points.size());
  const bool first_rank = Utilities::MPI::this_mpi_process(communicator) == 0;
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
    runs.push_back(tell_errors(screen, [&]() {
      return run_scene(input_at(input, sweeps, point), parameters[runs.size()], communicator,
                       screen);
    }));
    if (runs.size() > n_kept)
      runs.back().results.reset();
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
