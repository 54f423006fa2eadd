// SPDX-License-Identifier: LGPL-2.1-or-later
// convergence.csv: one row per level.

#include <signorini/output/tables.h>

#include <iomanip>

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
} // namespace Signorini
