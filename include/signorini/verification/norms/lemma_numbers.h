// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/discretization.h>
#include <signorini/problem/parameters/options.h>
#include <signorini/verification/norms/exact_pressure.h>

namespace Signorini {
/**
 * Computes the numbers with one factorisation of the Gram matrix A_1 of V^h: sup_v b(v)/‖v‖_1 is
 * (bᵀ A_1⁻¹ b)^{1/2}. Needs the exact displacement and pressure. Collective.
 */
LemmaNumbers compute_lemma_numbers(const Discretization<2> &discretization, const Scene<2> &scene,
                                   const ExactPressure<2> &pressure, LinearSolver linear_solver);
} // namespace Signorini
