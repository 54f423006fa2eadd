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

using Error = std::optional<double> LevelRecord::*;

struct ErrorColumn
{
  const char *name;
  Error error;
};

constexpr ErrorColumn displacement_columns[] = {{"|u-uh|1", &LevelRecord::u_h1},
                                                {"|u-uh|0", &LevelRecord::u_l2},
                                                {"|Iu-uh|1", &LevelRecord::u_superclose_h1},
                                                {"|u-PIuh|1", &LevelRecord::u_post_h1}};
constexpr ErrorColumn pressure_columns[] = {{"|p-pH|0", &LevelRecord::p_l2}};
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
  const auto name = [&](const ErrorColumn &column) {
    line << std::setw(number_width) << column.name << std::setw(order_width) << "order";
  };
  if (with_displacement_errors_)
    for (const ErrorColumn &column : displacement_columns)
      name(column);
  else
    name({"estimate", nullptr});
  if (with_pressure_errors_)
    for (const ErrorColumn &column : pressure_columns)
      name(column);
  return line.str();
}

std::string ScreenTable::row(const LevelRecord &level, const LevelRecord *before) const
{
  std::ostringstream line;
  print_count(line, 5, level.level);
  print_count(line, 9, level.dofs);
  print_count(line, 6, level.multipliers);
  print_count(line, 7, level.active);
  print_count(line, 6, level.qp_iterations);
  print_number(line, level.contact_force);
  print_number(line, level.max_pressure);
  const double refinement = before == nullptr ? 0. : before->h / level.h;
  const auto print = [&](const Error error) {
    print_number(line, level.*error);
    print_order(line, level.*error, before == nullptr ? std::nullopt : before->*error, refinement);
  };
  if (with_displacement_errors_)
    for (const ErrorColumn &column : displacement_columns)
      print(column.error);
  else
    print(&LevelRecord::estimated_h1);
  if (with_pressure_errors_)
    for (const ErrorColumn &column : pressure_columns)
      print(column.error);
  return line.str();
}
} // namespace Signorini
