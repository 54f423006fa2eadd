// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>
#include <signorini/verification/norms/exact_pressure.h>

namespace Signorini {
/**
 * Adds the errors against the exact solution to the record of a level, as far as its scene has one:
 * those of Theorems 3, 5 and 6, and the numbers of the lemmas. Collective.
 * @param pressure the exact pressure for the dual norms; null if it is not known, or if they are
 * not wanted.
 */
template <int dim>
void add_errors(const Parameters &parameters, const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure, LevelSolution<dim> &solution);

/** Adds the constant of Lemma 1, if it is wanted, to the record of a level. Collective. */
template <int dim>
void add_inf_sup(const Parameters &parameters, const Discretization<dim> &discretization,
                 const Progress &progress, LevelSolution<dim> &solution);

/** Returns the function that does both for the levels of a scene. Parameters and scene must outlive
 * it. The exact pressure is prepared on the first level. */
template <int dim>
Verify<dim> make_verify(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Signorini
