// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/expression.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini
{
/** Refuses moduli that are far too large or too small, at points all over the body.
 * @throws InputError */
template <int dim>
void check_moduli(const std::vector<Expression<dim>> &moduli, const Geometry<dim> &geometry);

/** Evaluates everything once where the integrals will, to find data without values and an exact
 * solution that contradicts itself before the computation starts. @throws InputError */
template <int dim>
void check_described_scene(const ExactSolutionParameters &exact, const Scene<dim> &scene);
} // namespace Signorini
