// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/results/verdict/judge.h>
#include <signorini/solvers/methods/solver_choice.h>

#include <ostream>
#include <vector>

namespace Signorini {
/** Prints the scene in five lines. */
template <int dim>
void print_scene(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &solvers,
                 const Judge &judge, std::ostream &screen);

/** Prints the warnings about a level. */
void print_warnings(const LevelRecord &level, const Judge &judge, std::ostream &screen);

/** Prints the contact of the finest level, and the verdict. */
void print_verdict(const std::vector<LevelRecord> &levels, const Judge &judge,
                   const StudyVerdict &verdict, std::ostream &screen);
} // namespace Signorini
