// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
/** "WHERE: found FOUND at (X), allowed: ALLOWED." @throws InputError */
template <int dim>
[[noreturn]] void refuse_value(const std::string &where,
                               const std::string &found,
                               const dealii::Point<dim> &x,
                               const std::string &allowed);

/**
 * A gradient given by expressions is that of the displacement: compared with differences at points
 * inside the body. Where two differences do not agree (kinks, singularities) nothing is said.
 * @throws InputError if three points object.
 */
template <int dim>
void check_exact_gradient(const ExactSolutionParameters &exact,
                          const Scene<dim> &scene,
                          const std::vector<dealii::Point<dim>> &points);

/**
 * An exact displacement satisfies what the scene prescribes on a side: u = 0, u·n = 0, u = u_D, or
 * u·n <= g. @throws InputError
 */
template <int dim>
void check_exact_on_side(const ExactSolutionParameters &exact,
                         const Scene<dim> &scene,
                         unsigned int side,
                         const std::vector<dealii::Point<dim>> &points);
} // namespace Signorini
