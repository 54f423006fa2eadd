// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>

#include <vector>

namespace Signorini
{
/** A part of a side in which contact ends: between a node that presses and one that does not. */
struct ContactBracket
{
  unsigned int side;
  /** Arc lengths; around a closed side the second may exceed its length (length). */
  double from, to;
};

/** All brackets of a pressure, side after side; those that share a node are one. */
std::vector<ContactBracket> contact_brackets(const MultiplierSpace<2> &multipliers,
                                             const dealii::Vector<double> &P);
} // namespace Signorini
