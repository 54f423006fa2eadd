// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/progress.h>
#include <signorini/error_control/reference/reference_stress.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <map>
#include <optional>
#include <string>

namespace Signorini {
/** The limits of a graded run that others ask for. */
struct ReferenceTarget {
  /** The bound of the error of its displacement, relative in the energy norm. */
  double error = 1e-6;
  unsigned int max_unknowns = 200000;
};

/** The result of run_reference(): a stress, or one sentence that says why there is none. */
struct ReferenceRun {
  std::optional<ReferenceStress> stress;
  std::string missing;
};

/** Solves a scene on graded meshes, without files and tables, and keeps the stress of the step with
 * the smallest bound s. @param given the parameters of the scene: those of elements, patches and
 * solvers do not count. Every rank computes all of it. */
ReferenceRun run_reference(const Parameters &given, const Scene<2> &scene,
                           const ReferenceTarget &target, const Progress &progress);

/** The graded runs of scenes that differ in meshes, solvers and output only, as in a sweep of
 * these: each is made once. */
class ReferenceRuns {
public:
  /** Returns run_reference(), or the result of an earlier run with the same scene and a target that
   * is not larger. */
  const ReferenceRun &find(const Parameters &given, const Scene<2> &scene,
                           const ReferenceTarget &target, const Progress &progress);

private:
  struct Known {
    ReferenceTarget target;
    ReferenceRun run;
  };
  /** By the text of the parameters of the scene. */
  std::map<std::string, Known> known_;
};
} // namespace Signorini
