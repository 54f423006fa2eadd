// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/error_control/hp/next_plan.h>
#include <signorini/error_control/hp/step_difference.h>

namespace Signorini
{
/** Contact as it was found on one mesh of a graded sequence. */
struct SolvedStep
{
  const DisplacementSpace<2> &space;
  const MultiplierSpace<2> &multipliers;
  const Displacement &U;
  const Pressure &P;
  /** What the contact solver leaves, (force length)^{1/2}. */
  double algebraic_error = 0.;
};

/** Examines the steps of a graded sequence one after the other. */
class StepExamination
{
public:
  /**
   * @param scene must outlive the object.
   * @param target the relative error that is aimed at.
   */
  StepExamination(const Scene<2> &scene, double target);

  /**
   * Computes the indicators, the brackets of the ends of contact and the estimated error of a step.
   * @param before the solution of the step before; empty for the first.
   * @param planned by what factor the mesh was to reduce the error.
   * @throws InputError where g has no value.
   */
  StepFindings examine(const SolvedStep &step,
                       const std::optional<StepField> &before,
                       double planned);

  /** Returns whether the estimates do not fall any more, see ErrorHistory. */
  bool stagnates() const
  {
    return history_.stagnates();
  }
  /** Returns whether a second mesh agrees. Bodies that nothing deforms need none. */
  bool is_checked(const StepFindings &findings) const
  {
    return history_.n_steps() > 1 || findings.error == 0.;
  }

private:
  const Scene<2> &scene_;
  double target_;
  ErrorHistory history_;
};
} // namespace Signorini
