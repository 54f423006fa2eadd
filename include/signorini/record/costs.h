// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>

namespace Signorini
{
/** Wall seconds of the stages of one level. */
struct StageTimes
{
  double mesh = 0.;
  double setup = 0.;
  double assembly = 0.;
  double factor = 0.;
  double compliance = 0.;
  double qp = 0.;
  double recovery = 0.;
  double postprocess = 0.;
  double bound = 0.;
  double errors = 0.;
  double output = 0.;

  double total() const;

  static Columns<StageTimes> columns();
};

/** What this process has used since it began. */
struct Resources
{
  double cpu_seconds = 0.;
  double peak_memory_mb = 0.;

  static Columns<Resources> columns();
};

/** The resources used until now. */
Resources measure_resources();
} // namespace Signorini
