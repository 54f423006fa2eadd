// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/expression.h>
#include <signorini/scene/scene.h>

namespace Signorini
{
/** Refuses moduli that are far too large or too small, at points all over the body.
 * @throws InputError */
void check_moduli(const std::vector<Expression<2>> &moduli, const Geometry<2> &geometry);

/** Evaluates everything once where the integrals will, so that nonsense is found before work: data
 * without values, and an exact solution that contradicts itself. @throws InputError */
void check_described_scene(const ExactSolutionParameters &exact, const Scene<2> &scene);
} // namespace Signorini
