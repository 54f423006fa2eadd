// SPDX-License-Identifier: LGPL-2.1-or-later
// The sizes that convergence.csv shows.

#include <signorini/record/level_sizes.h>

namespace Signorini
{
Columns<LevelSizes> LevelSizes::columns()
{
  return {{"level", &LevelSizes::level},
          {"cells", &LevelSizes::cells},
          {"dofs", &LevelSizes::dofs},
          {"multipliers", &LevelSizes::multipliers},
          {"h", &LevelSizes::h},
          {"H", &LevelSizes::H},
          {"max_degree", &LevelSizes::max_degree},
          {"min_h", &LevelSizes::min_h}};
}
} // namespace Signorini
