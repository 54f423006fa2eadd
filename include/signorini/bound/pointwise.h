// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/bound/cell_rule.h>

#include <vector>

namespace Signorini
{
/** s:e. */
inline double contraction(const Components &a, const Components &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Components difference(const Components &a, const Components &b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

inline Components sum(const Components &a, const Components &b)
{
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}

/** dual += weight psi e: what the strain e at a point adds to int psi e, by triangle and vertex. */
inline void add_dual(const StressPoint &point, const Components &e, CompositeCell::Stresses &dual)
{
  for (unsigned int m = 0; m < 3; ++m)
    for (unsigned int l = 0; l < 3; ++l)
      dual[9 * point.triangle + 3 * m + l] += point.weight * point.psi[m] * e[l];
}

/** The law at point number @p i; one law is that of all points. */
inline const Law &law_at(const std::vector<Law> &laws, const std::size_t i)
{
  return laws[laws.size() == 1 ? 0 : i];
}
} // namespace Signorini
