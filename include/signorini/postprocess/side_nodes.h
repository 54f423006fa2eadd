// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>

#include <vector>

namespace Signorini
{
/** A node of a multiplier on its side. */
struct SideNode
{
  /** Arc length (length). */
  double s;
  bool presses;
};

/** The nodes of one side in the order of arc length. */
struct SideNodes
{
  /** Number of the side in the geometry. */
  unsigned int number = 0;
  double length = 0.;
  bool closed = false;
  std::vector<SideNode> nodes;
};

/** The nodes of all multipliers, side after side; those below pressing_threshold(P) press. */
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers,
                                     const dealii::Vector<double> &P);
} // namespace Signorini
