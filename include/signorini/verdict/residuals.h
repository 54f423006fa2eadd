// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

namespace Signorini
{
/** A residual of the certificate that must vanish. */
struct Residual
{
  double value = 0.;
  /** As certificate.json calls it. */
  const char *name = "";
  /** What makes it large. */
  enum class Origin
  {
    equilibrium,
    contact,
    supports
  };
  Origin origin = Origin::equilibrium;
};

/** The largest of the residuals that must vanish; one that is not a number is the largest. */
Residual largest_residual(const Certificate &certificate);

/** The relative change of U or of its forces by rounding, the larger of both. */
double rounding(const LevelRecord &level);
} // namespace Signorini
