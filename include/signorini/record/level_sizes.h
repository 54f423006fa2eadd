// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>

namespace Signorini
{
/** How large the problem of one level is. */
struct LevelSizes
{
  unsigned int level = 0;
  unsigned long long cells = 0;
  unsigned long long dofs = 0;
  unsigned int multipliers = 0;
  /** The longest edge (length). */
  double h = 0.;
  /** The longest patch (length). */
  double H = 0.;
  /** Whether a patch is no longer than a face (H = h). */
  bool unstable = false;
  /** The highest degree of an element. */
  unsigned int max_degree = 1;
  /** The shortest edge (length). */
  double min_h = 0.;

  /** Whether the mesh is a step of a sequence of graded meshes, whose elements have degrees above
   * one. There h alone does not tell how fine a mesh is, and errors have no orders in h. */
  bool is_graded() const
  {
    return max_degree > 1;
  }
  /** What it is called on the screen. */
  const char *word() const
  {
    return is_graded() ? "step" : "level";
  }

  static Columns<LevelSizes> columns();
};
} // namespace Signorini
