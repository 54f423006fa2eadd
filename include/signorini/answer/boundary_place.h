// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <string>

namespace Signorini
{
/** A point of a plane body's boundary. */
struct BoundaryPlace
{
  std::string side;
  /** From the start of the side (length). */
  double arc_length = 0.;
  dealii::Point<2> point;
};
} // namespace Signorini
