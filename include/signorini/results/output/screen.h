// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/results/verdict/judge.h>
#include <signorini/solvers/methods/contact_method.h>

#include <ostream>
#include <vector>

namespace Signorini
{
/** The scene in five lines. */
template <int dim>
void print_scene(const Parameters &parameters,
                 const Scene<dim> &scene,
                 const SolverChoice &solvers,
                 const Judge &judge,
                 std::ostream &screen);

/** What a user should know about a level at once. */
void print_warnings(const LevelRecord &level, const Judge &judge, std::ostream &screen);

/** The finest level's contact and the verdict. */
void print_verdict(const std::vector<LevelRecord> &levels,
                   const Judge &judge,
                   const StudyVerdict &verdict,
                   std::ostream &screen);
} // namespace Signorini
