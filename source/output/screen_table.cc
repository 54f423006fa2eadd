// SPDX-License-Identifier: LGPL-2.1-or-later
// The table that a run shows, one line per level as it finishes.

#include <signorini/output/tables.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Signorini
{
namespace
{
constexpr int number_width = 11;
constexpr int order_width = 6;

void print_count(std::ostream &stream, const int width, const unsigned long long value)
{
  stream << std::setw(width) << value;
}

void print_number(std::ostream &stream, const std::optional<double> &value)
{
  stream << std::setw(number_width);
  if (value)
    stream << std::scientific << std::setprecision(3) << *value;
  else
    stream << "-";
}

/** log(before/now) / log(h before/h now). */
void print_order(std::ostream &stream,
                 const std::optional<double> &value,
                 const std::optional<double> &before,
                 const double refinement)
{
  stream << std::setw(order_width);
  // Rounding errors (patch tests) have no order.
  const bool meaningful = value && before && *value > 1e-13 && *before > 1e-13 && refinement > 1.;
  if (meaningful)
    stream << std::fixed << std::setprecision(2)
           << std::log(*before / *value) / std::log(refinement);
  else
    stream << "-";
}

/** An error on the screen: its title, and its column of convergence.csv. */
struct ErrorColumn
{
  const char *title;
  const char *name;
};

constexpr ErrorColumn displacement_columns[] = {{"|u-uh|1", "u_h1"},
                                                {"|u-uh|0", "u_l2"},
                                                {"|Iu-uh|1", "u_superclose_h1"},
                                                {"|u-PIuh|1", "u_post_h1"}};
constexpr ErrorColumn pressure_columns[] = {{"|p-pH|0", "p_l2"}};
constexpr ErrorColumn estimate_column = {"estimate", "estimated_energy"};
} // namespace

ScreenTable::ScreenTable(const bool with_displacement_errors, const bool with_pressure_errors)
  : with_displacement_errors_(with_displacement_errors)
  , with_pressure_errors_(with_pressure_errors)
{
}

std::string ScreenTable::header() const
{
  std::ostringstream line;
  line << "level" << std::setw(9) << "dofs" << std::setw(6) << "m" << std::setw(7) << "active"
       << std::setw(6) << "its" << std::setw(number_width) << "force" << std::setw(number_width)
       << "max p";
  const auto print = [&](const ErrorColumn &column) {
    line << std::setw(number_width) << column.title << std::setw(order_width) << "order";
  };
  if (with_displacement_errors_)
    for (const ErrorColumn &column : displacement_columns)
      print(column);
  else
    print(estimate_column);
  if (with_pressure_errors_)
    for (const ErrorColumn &column : pressure_columns)
      print(column);
  return line.str();
}

std::string ScreenTable::row(const LevelRecord &level, const LevelRecord *before) const
{
  std::ostringstream line;
  print_count(line, 5, level.sizes.level);
  print_count(line, 9, level.sizes.dofs);
  print_count(line, 6, level.sizes.multipliers);
  print_count(line, 7, level.contact.active);
  print_count(line, 6, level.dual.iterations);
  print_number(line, level.contact.normal_force);
  print_number(line, level.contact.max_pressure);
  const double refinement = before == nullptr ? 0. : before->sizes.h / level.sizes.h;
  const auto print = [&](const ErrorColumn &column) {
    const std::optional<double> error = value(level, column.name);
    print_number(line, error);
    print_order(
      line, error, before == nullptr ? std::nullopt : value(*before, column.name), refinement);
  };
  if (with_displacement_errors_)
    for (const ErrorColumn &column : displacement_columns)
      print(column);
  else
    print(estimate_column);
  if (with_pressure_errors_)
    for (const ErrorColumn &column : pressure_columns)
      print(column);
  return line.str();
}
} // namespace Signorini
