// SPDX-License-Identifier: LGPL-2.1-or-later
// The columns of seconds and of memory.

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>

#include <deal.II/base/utilities.h>

#include <fstream>
#include <sys/resource.h>

namespace Signorini {
double StageTimes::total() const {
  return mesh + setup + assembly + factor + compliance + qp + recovery + postprocess + bound +
         errors + output;
}

Columns<StageTimes> StageTimes::columns() {
  return {{"t_mesh", &StageTimes::mesh},
          {"t_setup", &StageTimes::setup},
          {"t_assembly", &StageTimes::assembly},
          {"t_factor", &StageTimes::factor},
          {"t_compliance", &StageTimes::compliance},
          {"t_qp", &StageTimes::qp},
          {"t_recovery", &StageTimes::recovery},
          {"t_postprocess", &StageTimes::postprocess},
          {"t_errors", &StageTimes::errors},
          {"t_bound", &StageTimes::bound},
          {"t_output", &StageTimes::output},
          {"t_total", &StageTimes::total}};
}

Columns<Resources> Resources::columns() {
  return {{"cpu_total", &Resources::cpu_seconds}, {"peak_memory_mb", &Resources::peak_memory_mb}};
}

Resources measure_resources() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  Utilities::System::MemoryStats memory = {};
  // Where /proc is missing, in a bare chroot, deal.II reads this file for ever.
  if (std::ifstream("/proc/self/status"))
    Utilities::System::get_memory_stats(memory);
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(memory.VmHWM) / 1024.};
}
} // namespace Signorini
