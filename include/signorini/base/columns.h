// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/**
 * A column of a table: its name, and its value in a row, empty where that is not known. The value
 * may be a pointer to a member of Row.
 */
template <typename Row>
struct Column
{
  std::string name;
  std::function<std::optional<double>(const Row &)> value;
};

template <typename Row>
using Columns = std::vector<Column<Row>>;

/** The columns that a part of a row declares by Part::columns(), as columns of the row. */
template <typename Row, typename Part>
Columns<Row> columns_of(Part Row::*const part)
{
  Columns<Row> columns;
  for (const Column<Part> &column : Part::columns())
    columns.push_back(
      {column.name, [column, part](const Row &row) { return column.value(row.*part); }});
  return columns;
}

/** The same for a part that a row may lack; its columns are empty there. */
template <typename Row, typename Part>
Columns<Row> columns_of(std::optional<Part> Row::*const part)
{
  Columns<Row> columns;
  for (const Column<Part> &column : Part::columns())
    columns.push_back({column.name, [column, part](const Row &row) {
                         return row.*part ? column.value(*(row.*part)) : std::nullopt;
                       }});
  return columns;
}
} // namespace Signorini
