// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/scene/plate.h>

#include <string>
#include <vector>

namespace Signorini
{
/** Where a plate is, and what holds it there. */
struct PlateRecord
{
  std::string side;
  Plate plate;
  PlateMotion motion;
  /** What acts on the body through the plate: along its direction, and about its centre; from the
   * nodal forces, also where they are given. */
  double force = 0.;
  double moment = 0.;
};

/** What moves freely, and how far it has moved. */
struct MotionRecord
{
  std::vector<PlateRecord> plates;
  /** Rigid motions that neither loads nor contact determine; they are zero. */
  std::vector<std::string> undetermined;

  /** Of the first plate. */
  static Columns<MotionRecord> columns();
};
} // namespace Signorini
