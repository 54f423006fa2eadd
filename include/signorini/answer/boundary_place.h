// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/answer/answer_vector.h>

#include <string>

namespace Signorini
{
/** A point of a body's boundary. */
struct BoundaryPlace
{
  std::string side;
  /** From the start of the side (length); in the plane. */
  double arc_length = 0.;
  AnswerVector point;
};
} // namespace Signorini
