// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about one step of a graded sequence.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/error_control/hp/contact_zone.h>
#include <signorini/error_control/hp/step_examination.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
StepExamination::StepExamination(const Scene<2> &scene, const double target)
  : scene_(scene)
  , target_(target)
{
}

StepFindings StepExamination::examine(const SolvedStep &step,
                                      const std::optional<StepField> &before,
                                      const double planned)
{
  const auto &[space, multipliers, U, P, algebraic_error] = step;
  StepFindings findings;
  findings.indicators = indicate(space, scene_, U);
  add_contact_misfit(space, multipliers, scene_, U, P, findings.indicators);
  add_jump_misfit(space, scene_, U, findings.indicators);
  findings.brackets = contact_brackets(multipliers, P);
  findings.unseen_contact = unseen_contact(space, multipliers, U, P);
  const double indicator = total(findings.indicators);
  const double norm = energy_norm(space, scene_, U);
  findings.scale = energy_scale(norm, indicator, space, scene_, U);
  findings.target = target_ * findings.scale;
  if (!findings.unseen_contact.empty())
  {
    // The next mesh sees another problem.
    history_ = ErrorHistory();
    return findings;
  }
  std::optional<double> difference;
  if (before)
    difference = energy_distance({space, U}, *before, scene_);
  // A solution that lies in the space leaves nothing but rounding.
  constexpr double rounding = 1e-12;
  double error = std::max(history_.add(indicator, difference, planned), rounding * findings.scale);
  // What does not fall while the mesh is refined has no limit: data contradict each other.
  constexpr double noticeable = 1e-3;
  if (history_.stagnates() && error > noticeable * findings.scale)
    error = std::max(error, findings.scale);
  error = std::hypot(error, algebraic_error);
  // Nothing has an error where nothing deforms the body: all that is left is rounding.
  constexpr double rounding_of_rigid_motions = 1e-7;
  const bool is_rigid =
    norm < findings.scale && error <= rounding_of_rigid_motions * findings.scale;
  findings.error = is_rigid ? 0. : error;
  return findings;
}
} // namespace Signorini
