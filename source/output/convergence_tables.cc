// SPDX-License-Identifier: LGPL-2.1-or-later
// convergence.md and convergence.tex: what a report about a run needs.

#include <signorini/output/tables.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Signorini
{
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
  /** Errors on nested meshes have orders. */
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

/** Texts, all rows as long as the header. */
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

/** log(before/now) / log(h before/h now); empty where errors are rounding. */
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

/** The columns that have a value on some level. */
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
} // namespace Signorini
