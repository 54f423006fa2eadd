// SPDX-License-Identifier: LGPL-2.1-or-later
// The tables of a run: convergence.csv, the lines on the screen, the errors at the end, and
// cases.csv.

#include <signorini/base/text.h>
#include <signorini/results/output/tables.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/math/statistics/linear_regression.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini {
void write_convergence_csv(std::ostream &stream, const std::vector<LevelRecord> &levels) {
  Columns<LevelRecord> columns = level_columns();
  for (const Column<TangentialSummary> &tangential : TangentialSummary::columns())
    if (levels.empty() || !levels.front().tangential)
      columns.erase(std::find_if(columns.begin(), columns.end(), [&](const auto &column) {
        return column.name == tangential.name;
      }));
  stream << csv_header(columns) << "\n";
  for (const LevelRecord &level : levels)
    stream << csv_row(columns, level) << "\n";
}

namespace {
constexpr int number_width = 11;
constexpr int order_width = 6;

/** The smallest error that has an order; errors below are rounding (patch tests). */
constexpr double min_error = 1e-13;

void print_number(std::ostream &stream, const int width, const std::optional<double> &value) {
  stream << std::setw(width);
  if (value)
    stream << *value;
  else
    stream << "-";
}

/** Prints a number with four digits. */
void print_value(std::ostream &stream, const int width, const std::optional<double> &value) {
  print_number(stream << std::scientific << std::setprecision(3), width, value);
}

void print_order(std::ostream &stream, const int width, const std::optional<double> &order) {
  print_number(stream << std::fixed << std::setprecision(2), width, order);
}

/** A number on the screen: its title, and its column of convergence.csv. */
struct ErrorColumn {
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
std::optional<double> order(const LevelRecord &level, const LevelRecord *before,
                            const std::string &name) {
  if (before == nullptr || level.sizes.is_graded() || !(before->sizes.h > level.sizes.h))
    return {};
  const std::optional<double> now = value(level, name), then = value(*before, name);
  if (!now || !then || *now <= min_error || *then <= min_error)
    return {};
  return std::log(*then / *now) / std::log(before->sizes.h / level.sizes.h);
}

/** Returns the slope of log(error) over log(h), least squares over the last levels. */
std::optional<double> slope(const std::vector<LevelRecord> &levels, const std::string &name) {
  constexpr std::size_t n_levels = 4;
  std::vector<double> x, y;
  for (std::size_t i = levels.size() - std::min(n_levels, levels.size()); i < levels.size(); ++i)
    if (const std::optional<double> error = value(levels[i], name); error && *error > min_error) {
      x.push_back(std::log(levels[i].sizes.h));
      y.push_back(std::log(*error));
    }
  if (x.size() < 3)
    return {};
  return boost::math::statistics::simple_ordinary_least_squares(x, y).second;
}
} // namespace

std::string screen_header(const bool graded) {
  std::ostringstream line;
  line << (graded ? " step" : "level") << std::setw(9) << "dofs" << std::setw(6) << "m"
       << std::setw(7) << "active" << std::setw(5) << "its" << std::setw(number_width) << "force"
       << std::setw(number_width) << "peak p" << std::setw(number_width) << "estimate"
       << std::setw(order_width) << "order";
  return line.str();
}

std::string screen_row(const LevelRecord &level, const LevelRecord *before) {
  std::ostringstream line;
  line << std::setw(5) << level.sizes.level << std::setw(9) << level.sizes.dofs << std::setw(6)
       << level.sizes.multipliers << std::setw(7) << level.contact.active << std::setw(5)
       << level.dual.iterations;
  print_value(line, number_width, level.contact.normal_force);
  print_value(line, number_width,
              level.answer.peak_pressure ? level.answer.peak_pressure->value : 0.);
  print_value(line, number_width, value(level, estimate_name));
  print_order(line, order_width, order(level, before, estimate_name));
  return line.str();
}

std::string screen_legend(const bool graded) {
  return std::string(graded ? "m: multipliers" : "m: patches") +
         "; active: those that press; its: iterations of the dual problem;\n"
         "force: integral of pressure; peak p: largest contact pressure (both positive in\n"
         "compression); estimate: of the error of u_h, relative, in the energy norm\n";
}

std::string error_table(const std::vector<LevelRecord> &levels) {
  Assert(!levels.empty(), ExcMessage("The table has a row for each level."));
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
  for (const LevelRecord &level : levels) {
    text << "\n" << std::setw(5) << level.sizes.level;
    for (const ErrorColumn &column : columns) {
      print_value(text, error_width, value(level, column.name));
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
          "interpolant; PI: interpolation on blocks of 2 x 2 cells). Slope: least squares\n"
          "over the last four levels.\n";
  return text.str();
}

std::string distance_table(const std::vector<LevelRecord> &levels) {
  constexpr int percent_width = 26;
  const auto percent = [](const LevelRecord &level, const std::optional<double> &error,
                          const std::optional<double> &margin) {
    const double scale = 100. * level.bound->relative.value() / level.bound->absolute.value();
    return error ? text_with_margin(scale * *error, scale * margin.value()) : std::string("-");
  };
  const auto is_known = [](const LevelRecord &level) {
    return level.bound && level.bound->distance && *level.bound->absolute > 0.;
  };
  if (!std::all_of(levels.begin(), levels.end(), is_known))
    return "";
  const bool has_post = levels.back().bound->post_distance.has_value();
  std::ostringstream text;
  text << "level" << std::setw(percent_width) << "error of u_h, %" << std::setw(order_width)
       << "order";
  if (has_post)
    text << std::setw(percent_width) << "recovered, %" << std::setw(order_width) << "order";
  const LevelRecord *before = nullptr;
  for (const LevelRecord &level : levels) {
    const ErrorBound &bound = *level.bound;
    text << "\n"
         << std::setw(5) << level.sizes.level << std::setw(percent_width)
         << percent(level, bound.distance, bound.margin);
    print_order(text, order_width, order(level, before, "distance"));
    if (has_post) {
      text << std::setw(percent_width) << percent(level, bound.post_distance, bound.post_margin);
      print_order(text, order_width, order(level, before, "post_distance"));
    }
    before = &level;
  }
  text << "\nErrors of the computed displacement u_h in the energy norm, in percent of u_h"
       << (has_post ? ";\nrecovered: u_h smoothed over blocks of 2 x 2 cells" : "")
       << ".\nThey are measured with one graded run, and "
       << (levels.back().bound->is_conditional
             ? "hold if friction carries at most f times\nits pressure.\n"
             : "guaranteed within the margins.\n");
  return text.str();
}

void print_columns(std::ostream &stream, const std::vector<std::vector<std::string>> &rows,
                   const std::size_t n_left) {
  Assert(!rows.empty(), ExcMessage("The first row has the titles."));
  std::vector<std::size_t> widths(rows[0].size());
  for (const std::vector<std::string> &row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      AssertIndexRange(k, widths.size());
      widths[k] = std::max(widths[k], row[k].size());
    }
  for (const std::vector<std::string> &row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      stream << (k < n_left ? std::left : std::right) << std::setw(static_cast<int>(widths[k]))
             << row[k] << "  ";
    stream << row.back() << "\n";
  }
}

void write_rows(std::ostream &stream, const std::string &header,
                const std::vector<std::vector<double>> &rows) {
  stream << header << "\n" << std::setprecision(16);
  for (const std::vector<double> &row : rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      stream << row[k] << (k + 1 < row.size() ? "," : "\n");
}

namespace {
using NamedNumbers = std::vector<std::pair<std::string, double>>;

NamedNumbers reactions_of(const CaseResult &result) {
  return result.reactions;
}
NamedNumbers extremes_of(const CaseResult &result) {
  return named_extremes(result.reports);
}

/** Returns the columns of numbers that the cases have names for. */
Columns<CaseResult> named_columns(const std::vector<CaseResult> &cases,
                                  NamedNumbers (*const numbers_of)(const CaseResult &),
                                  const std::string &before, const std::string &after) {
  Columns<CaseResult> columns;
  const auto known = std::find_if(cases.begin(), cases.end(),
                                  [&](const CaseResult &c) { return !numbers_of(c).empty(); });
  if (known != cases.end())
    for (const auto &named : numbers_of(*known))
      columns.push_back(
        {before + named.first + after, [name = named.first, numbers_of](const CaseResult &c) {
           const NamedNumbers numbers = numbers_of(c);
           const auto number = std::find_if(numbers.begin(), numbers.end(),
                                            [&](const auto &n) { return n.first == name; });
           return number != numbers.end() ? std::optional(number->second) : std::nullopt;
         }});
  return columns;
}

/** Returns the columns: first the loads, then the answers, which an escape leaves empty. */
Columns<CaseResult> case_columns(const std::vector<CaseResult> &cases) {
  using Case = CaseResult;
  Columns<Case> columns;
  const auto add_answer = [&](const std::string &name, const auto &value) {
    const Column<Case> answer = {name, value};
    columns.push_back({name, [answer](const Case &c) {
                         return c.escape.empty() ? answer.value(c) : std::nullopt;
                       }});
  };
  // A vector has a column for each component, a single number has one.
  const auto add_vector = [&](const std::string &name, const auto &vector_of) {
    std::size_t n = 0;
    for (const Case &c : cases)
      n = std::max(n, vector_of(c).size());
    for (std::size_t k = 0; k < std::max<std::size_t>(n, 1); ++k)
      add_answer(n > 1 ? name + "_" + "xyz"[k] : name, [vector_of, k](const Case &c) {
        const AnswerVector x = vector_of(c);
        return k < x.size() ? std::optional(x[k]) : std::nullopt;
      });
  };
  const auto of_plate = [](AnswerVector PlateRecord::*const part) {
    return
      [part](const Case &c) { return c.plates.empty() ? AnswerVector() : c.plates.front().*part; };
  };
  const auto add_factor = [&](const std::string &name) {
    for (const CaseFactor &factor : case_factors())
      if (factor.name == name)
        columns.push_back({boost::replace_all_copy(name, " ", "_"),
                           [part = factor.number](const Case &c) { return c.load_case.*part; }});
  };
  for (const char *const name : {"force", "weight", "travel", "gap", "shift x", "shift y"})
    add_factor(name);
  const bool in_space = std::any_of(cases.begin(), cases.end(),
                                    [](const Case &c) { return c.contact.force.size() == 3; });
  if (in_space)
    add_factor("shift z");
  add_vector("contact_force", [](const Case &c) { return c.contact.force; });
  add_vector("contact_moment", [](const Case &c) { return c.contact.moment; });
  add_answer("peak_pressure", [](const Case &c) { return std::optional(c.peak_pressure); });
  add_answer(in_space ? "contact_area" : "zone_length",
             [](const Case &c) { return std::optional(c.zone_length); });
  if (!in_space)
    add_answer("zones", [](const Case &c) { return std::optional<double>(c.n_zones); });
  add_answer("active", [](const Case &c) { return std::optional<double>(c.active); });
  add_answer("plate_travel", [](const Case &c) {
    return c.plates.empty() ? std::nullopt : std::optional(c.plates.front().travel);
  });
  add_vector("plate_rotation", of_plate(&PlateRecord::rotation));
  add_answer("qp_iterations", [](const Case &c) { return std::optional<double>(c.iterations); });
  add_answer("kkt", [](const Case &c) { return std::optional(c.kkt); });
  add_vector("plate_drift", of_plate(&PlateRecord::drift));
  add_factor("cross");
  columns.push_back({"estimate", &Case::estimate});
  for (const Column<Case> &column : named_columns(cases, reactions_of, "reaction_", ""))
    columns.push_back(column);
  if (std::any_of(cases.begin(), cases.end(), [](const Case &c) { return c.tangential; })) {
    columns.push_back({"level", &Case::level});
    add_factor("slide");
    for (const Column<Case> &column : columns_of(&Case::tangential))
      if (column.name != "q_l2" && column.name != "critical_friction_factor")
        columns.push_back(column);
  }
  // Names of probes may contain commas.
  for (const Column<Case> &column : named_columns(cases, extremes_of, "\"", "\""))
    columns.push_back(column);
  return columns;
}
} // namespace

void write_cases_csv(std::ostream &stream, const std::vector<CaseResult> &cases) {
  const Columns<CaseResult> columns = case_columns(cases);
  stream << "case," << csv_header(columns) << ",state\n";
  for (const CaseResult &result : cases)
    stream << result.number << "," << csv_row(columns, result) << ","
           << (!result.escape.empty() ? result.escape
               : result.converged     ? "solved"
                                      : "not converged")
           << "\n";
}
} // namespace Signorini
