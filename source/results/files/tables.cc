// SPDX-License-Identifier: LGPL-2.1-or-later
// convergence.csv: one row per level.

#include <signorini/results/files/tables.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini
{
void write_convergence_csv(std::ostream &stream, const std::vector<LevelRecord> &levels)
{
  const char *separator = "";
  for (const Column<LevelRecord> &column : level_columns())
  {
    stream << separator << column.name;
    separator = ",";
  }
  stream << "\n" << std::setprecision(16);
  for (const LevelRecord &level : levels)
  {
    separator = "";
    for (const Column<LevelRecord> &column : level_columns())
    {
      stream << separator;
      separator = ",";
      if (const std::optional<double> value = column.value(level))
        stream << *value;
    }
    stream << "\n";
  }
}

// convergence.md and convergence.tex: the numbers of a run for a report.

namespace
{
/** The sequences of meshes for which a column is shown. */
enum class ShownFor
{
  all,
  nested,
  graded
};

/** A column for people: of convergence.csv, with its title in Markdown and in LaTeX. */
struct PrintedColumn
{
  const char *name;
  const char *markdown;
  const char *latex;
  /** Whether the column has orders on nested meshes, as errors have. */
  bool has_order;
  bool is_count;
  ShownFor shown_for;
};

constexpr PrintedColumn printed_columns[] = {
  {"level", "level", "level", false, true, ShownFor::nested},
  {"level", "step", "step", false, true, ShownFor::graded},
  {"dofs", "dofs", "dofs", false, true, ShownFor::all},
  {"h", "h", "$h$", false, false, ShownFor::nested},
  {"min_h", "smallest h", "smallest $h$", false, false, ShownFor::graded},
  {"max_degree", "largest degree", "largest degree", false, true, ShownFor::graded},
  {"u_h1", "‖u−u_h‖₁", "$\\|u-u_h\\|_1$", true, false, ShownFor::all},
  {"u_l2", "‖u−u_h‖₀", "$\\|u-u_h\\|_0$", true, false, ShownFor::all},
  {"p_l2", "‖p−p_H‖₀", "$\\|p-p_H\\|_0$", true, false, ShownFor::all},
  {"estimated_h1", "estimate", "estimate", true, false, ShownFor::nested},
  {"estimated_relative", "estimate", "estimate", false, false, ShownFor::graded},
  {"bound_energy", "bound", "bound", false, false, ShownFor::all},
  {"contact_force_n", "force", "force", false, false, ShownFor::all}};

/** A table of texts; all rows are as long as the header. */
struct TextTable
{
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

std::string printed(const std::optional<double> &number, const bool is_count)
{
  std::ostringstream text;
  if (!number)
    return "";
  if (is_count)
    text << std::fixed << std::setprecision(0) << *number;
  else
    text << std::scientific << std::setprecision(3) << *number;
  return text.str();
}

/** Returns log(before/now) / log(h before/h now); empty where errors are rounding. */
std::string printed_order(const LevelRecord *before, const LevelRecord &now, const char *name)
{
  constexpr double rounding = 1e-13;
  const std::optional<double> e = value(now, name);
  const std::optional<double> E = before == nullptr ? std::nullopt : value(*before, name);
  if (!e || !E || *e < rounding || *E < rounding)
    return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2)
       << std::log(*E / *e) / std::log(before->sizes.h / now.sizes.h);
  return text.str();
}

/** Returns the columns that have a value on some level. */
TextTable collect(const std::vector<LevelRecord> &levels, const bool latex)
{
  TextTable table;
  const bool graded = !levels.empty() && levels.back().sizes.is_graded();
  table.rows.resize(levels.size());
  for (const PrintedColumn &column : printed_columns)
  {
    if (column.shown_for == (graded ? ShownFor::nested : ShownFor::graded))
      continue;
    if (std::none_of(levels.begin(), levels.end(), [&](const LevelRecord &level) {
          return value(level, column.name).has_value();
        }))
      continue;
    const bool has_order = column.has_order && !graded;
    table.header.emplace_back(latex ? column.latex : column.markdown);
    if (has_order)
      table.header.emplace_back("order");
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      table.rows[i].push_back(printed(value(levels[i], column.name), column.is_count));
      if (has_order)
        table.rows[i].push_back(
          printed_order(i == 0 ? nullptr : &levels[i - 1], levels[i], column.name));
    }
  }
  return table;
}

void write_row(std::ostream &stream,
               const std::vector<std::string> &fields,
               const char *start,
               const char *separator,
               const char *end)
{
  stream << start;
  for (std::size_t i = 0; i < fields.size(); ++i)
    stream << (i == 0 ? "" : separator) << fields[i];
  stream << end;
}
} // namespace

void write_convergence_markdown(std::ostream &stream, const std::vector<LevelRecord> &levels)
{
  const TextTable table = collect(levels, false);
  write_row(stream, table.header, "| ", " | ", " |\n");
  write_row(stream, std::vector<std::string>(table.header.size(), "---:"), "| ", " | ", " |\n");
  for (const std::vector<std::string> &row : table.rows)
    write_row(stream, row, "| ", " | ", " |\n");
}

void write_convergence_latex(std::ostream &stream, const std::vector<LevelRecord> &levels)
{
  const TextTable table = collect(levels, true);
  stream << "\\begin{tabular}{" << std::string(table.header.size(), 'r') << "}\n\\hline\n";
  write_row(stream, table.header, "", " & ", " \\\\\n");
  stream << "\\hline\n";
  for (const std::vector<std::string> &row : table.rows)
    write_row(stream, row, "", " & ", " \\\\\n");
  stream << "\\hline\n\\end{tabular}\n";
}

// The tables on the screen: one line per level as it finishes, and the errors at the end.

namespace
{
constexpr int number_width = 11;
constexpr int order_width = 6;

/** The smallest error that has an order; errors below are rounding (patch tests). */
constexpr double min_error = 1e-13;

void print_count(std::ostream &stream, const int width, const unsigned long long value)
{
  stream << std::setw(width) << value;
}

void print_number(std::ostream &stream, const int width, const std::optional<double> &value)
{
  stream << std::setw(width);
  if (value)
    stream << std::scientific << std::setprecision(3) << *value;
  else
    stream << "-";
}

void print_order(std::ostream &stream, const int width, const std::optional<double> &order)
{
  stream << std::setw(width);
  if (order)
    stream << std::fixed << std::setprecision(2) << *order;
  else
    stream << "-";
}

/** A number on the screen: its title, and its column of convergence.csv. */
struct ErrorColumn
{
  const char *title;
  const char *name;
};

constexpr ErrorColumn error_columns[] = {{"|u-uh|1", "u_h1"},
                                         {"|u-uh|0", "u_l2"},
                                         {"|Iu-uh|1", "u_superclose_h1"},
                                         {"|u-PIuh|1", "u_post_h1"},
                                         {"|p-pH|0", "p_l2"}};
constexpr const char *estimate_name = "estimated_relative";

/** Returns log(before/now) / log(h before/h now). */
std::optional<double> order(const LevelRecord &level,
                            const LevelRecord *before,
                            const std::string &name)
{
  if (before == nullptr || level.sizes.is_graded() || !(before->sizes.h > level.sizes.h))
    return {};
  const std::optional<double> now = value(level, name), then = value(*before, name);
  if (!now || !then || *now <= min_error || *then <= min_error)
    return {};
  return std::log(*then / *now) / std::log(before->sizes.h / level.sizes.h);
}

/** Returns the slope of log(error) over log(h), least squares over the last levels. */
std::optional<double> slope(const std::vector<LevelRecord> &levels, const std::string &name)
{
  constexpr std::size_t n_levels = 4;
  double n = 0., sum_x = 0., sum_y = 0., sum_xx = 0., sum_xy = 0.;
  for (std::size_t i = levels.size() - std::min(n_levels, levels.size()); i < levels.size(); ++i)
    if (const std::optional<double> error = value(levels[i], name); error && *error > min_error)
    {
      const double x = std::log(levels[i].sizes.h), y = std::log(*error);
      n += 1.;
      sum_x += x;
      sum_y += y;
      sum_xx += x * x;
      sum_xy += x * y;
    }
  const double determinant = n * sum_xx - sum_x * sum_x;
  if (n < 3. || !(determinant > 0.))
    return {};
  return (n * sum_xy - sum_x * sum_y) / determinant;
}
} // namespace

std::string screen_header(const bool graded)
{
  std::ostringstream line;
  line << (graded ? " step" : "level") << std::setw(9) << "dofs" << std::setw(6) << "m"
       << std::setw(7) << "active" << std::setw(5) << "its" << std::setw(number_width) << "force"
       << std::setw(number_width) << "peak p" << std::setw(number_width) << "estimate"
       << std::setw(order_width) << "order";
  return line.str();
}

std::string screen_row(const LevelRecord &level, const LevelRecord *before)
{
  std::ostringstream line;
  print_count(line, 5, level.sizes.level);
  print_count(line, 9, level.sizes.dofs);
  print_count(line, 6, level.sizes.multipliers);
  print_count(line, 7, level.contact.active);
  print_count(line, 5, level.dual.iterations);
  print_number(line, number_width, level.contact.normal_force);
  print_number(
    line, number_width, level.answer.peak_pressure ? level.answer.peak_pressure->value : 0.);
  print_number(line, number_width, value(level, estimate_name));
  print_order(line, order_width, order(level, before, estimate_name));
  return line.str();
}

std::string screen_legend(const bool graded)
{
  return std::string(graded ? "m: multipliers" : "m: patches") +
         "; active: those that press; its: iterations of the dual problem;\n"
         "force: contact force; peak p: largest contact pressure (both positive in\n"
         "compression); estimate: of the error of u_h, relative, in the energy norm\n";
}

std::string error_table(const std::vector<LevelRecord> &levels)
{
  constexpr int error_width = 10, error_order_width = 5;
  std::vector<ErrorColumn> columns;
  for (const ErrorColumn &column : error_columns)
    if (value(levels.back(), column.name))
      columns.push_back(column);
  if (columns.empty())
    return "";
  std::ostringstream text;
  const bool graded = levels.back().sizes.is_graded();
  text << std::setw(5) << levels.back().sizes.word();
  for (const ErrorColumn &column : columns)
    text << std::setw(error_width) << column.title << std::setw(error_order_width) << "ord";
  const LevelRecord *before = nullptr;
  for (const LevelRecord &level : levels)
  {
    text << "\n";
    print_count(text, 5, level.sizes.level);
    for (const ErrorColumn &column : columns)
    {
      print_number(text, error_width, value(level, column.name));
      print_order(text, error_order_width, order(level, before, column.name));
    }
    before = &level;
  }
  if (graded)
    return text.str() + "\nErrors against the exact solution (1: norm of H1, 0: of L2; Iu: nodal\n"
                        "interpolant).\n";
  text << "\nslope";
  for (const ErrorColumn &column : columns)
    print_order(text, error_width + error_order_width, slope(levels, column.name));
  text << "\nErrors against the exact solution (1: norm of H1, 0: of L2; Iu: nodal\n"
          "interpolant; PI: interpolation on cells of 2h). Slope: least squares over the\n"
          "last four levels.\n";
  return text.str();
}

// cases.csv: force against travel, zone against force.

namespace
{
using CaseColumn = std::pair<const char *, std::function<double(const CaseResult &)>>;

/** Returns a number of the first plate; not a number without one. */
double first_plate_value(const CaseResult &result, double PlateMotion::*const part)
{
  return result.plates.empty() ? std::numeric_limits<double>::quiet_NaN()
                               : result.plates.front().*part;
}

const std::vector<CaseColumn> &loads_of_case()
{
  static const std::vector<CaseColumn> columns = {
    {"force", [](const CaseResult &c) { return c.load_case.force; }},
    {"weight", [](const CaseResult &c) { return c.load_case.weight; }},
    {"travel", [](const CaseResult &c) { return c.load_case.travel; }},
    {"gap", [](const CaseResult &c) { return c.load_case.gap; }},
    {"shift_x", [](const CaseResult &c) { return c.load_case.shift[0]; }},
    {"shift_y", [](const CaseResult &c) { return c.load_case.shift[1]; }}};
  return columns;
}

const std::vector<CaseColumn> &answers_of_case()
{
  static const std::vector<CaseColumn> columns = {
    {"contact_force_x", [](const CaseResult &c) { return c.contact.force[0]; }},
    {"contact_force_y", [](const CaseResult &c) { return c.contact.force[1]; }},
    {"contact_moment", [](const CaseResult &c) { return c.contact.moment[0]; }},
    {"peak_pressure", [](const CaseResult &c) { return c.peak_pressure; }},
    {"zone_length", [](const CaseResult &c) { return c.zone_length; }},
    {"zones", [](const CaseResult &c) { return c.n_zones; }},
    {"active", [](const CaseResult &c) { return c.active; }},
    {"plate_travel",
     [](const CaseResult &c) { return first_plate_value(c, &PlateMotion::travel); }},
    {"plate_rotation",
     [](const CaseResult &c) { return first_plate_value(c, &PlateMotion::rotation); }},
    {"qp_iterations", [](const CaseResult &c) { return c.iterations; }},
    {"kkt", [](const CaseResult &c) { return c.kkt; }}};
  return columns;
}
} // namespace

void write_cases_csv(std::ostream &stream, const std::vector<CaseResult> &cases)
{
  stream << "case";
  for (const auto *const columns : {&loads_of_case(), &answers_of_case()})
    for (const CaseColumn &column : *columns)
      stream << "," << column.first;
  stream << ",state\n" << std::setprecision(16);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    stream << i + 1;
    for (const CaseColumn &column : loads_of_case())
      stream << "," << column.second(cases[i]);
    for (const CaseColumn &column : answers_of_case())
    {
      stream << ",";
      const double value = column.second(cases[i]);
      if (cases[i].escape.empty() && value == value)
        stream << value;
    }
    stream << ","
           << (!cases[i].escape.empty() ? cases[i].escape
               : cases[i].converged     ? "solved"
                                        : "not converged")
           << "\n";
  }
}
} // namespace Signorini
