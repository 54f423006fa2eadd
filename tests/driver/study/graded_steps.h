// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "study_helpers.h"

/** Overrides for a study on graded meshes that begins with level 2. */
inline std::vector<std::string> graded(const std::string &target) {
  return {"Discretization/Strategy=hp", "Discretization/Coarsest level=2",
          "Discretization/Target error=" + target, "Output/VTU=none"};
}

/** The unknowns of a step, and its errors in the energy norm divided by |||u_h|||. */
struct GradedStep {
  unsigned int number;
  double n_unknowns, error, estimate;
};

/** All steps that have an estimate, which those before contact was seen have not. */
inline std::vector<GradedStep> steps_of(const std::vector<Signorini::LevelRecord> &levels) {
  std::vector<GradedStep> steps;
  for (const Signorini::LevelRecord &level : levels)
    if (level.estimate) {
      const double norm = level.estimate->energy / level.estimate->relative;
      steps.push_back({level.sizes.level, static_cast<double>(level.sizes.dofs),
                       level.displacement_errors->energy / norm, level.estimate->relative});
    }
  return steps;
}

/** A line through log(error) as a function of N^{1/3}, from step 1 on. */
inline Line fit_exponential(const std::vector<GradedStep> &steps) {
  std::vector<double> x, y;
  for (const GradedStep &step : steps)
    if (step.number > 0) {
      x.push_back(std::cbrt(step.n_unknowns));
      y.push_back(std::log(step.error));
    }
  return fit(x, y);
}

/** The unknowns at which a line between two steps reaches an error, log(error) over N^{1/3}. */
inline double unknowns_between(const std::vector<GradedStep> &steps, const double error) {
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (steps[i].error <= error && steps[i - 1].error > error) {
      const double share =
        std::log(steps[i - 1].error / error) / std::log(steps[i - 1].error / steps[i].error);
      const double from = std::cbrt(steps[i - 1].n_unknowns), to = std::cbrt(steps[i].n_unknowns);
      return std::pow(from + share * (to - from), 3);
    }
  return INFINITY;
}
