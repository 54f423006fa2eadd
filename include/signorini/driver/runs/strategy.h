// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <string>

namespace Signorini {
/**
 * Decides Strategy = automatic, and with hp a Coarsest level that is not given. Meshes are nested
 * where levels are given, where the exact solution is known, which shows orders, where an entry is
 * given that has no meaning with hp, with pairs and in space; else they are graded. The levels of
 * pairs follow from the number of cells: meshes from files have many on level 0.
 * @return "hp, since ..." for the user; empty where the parameters state a strategy or levels.
 */
template <int dim>
std::string decide_strategy(Parameters &parameters, const Scene<dim> &scene);

/** Makes the meshes nested, all levels of them: for load cases that alone touch, since the error of
 * the scene itself says nothing about them. */
void solve_all_nested_levels(Parameters &parameters);
} // namespace Signorini
