// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/**
 * Writes u_h, the patch interpolation that comes closest to u (pi^{2h} u_h or the one of degree
 * four, where T^{2h} exists), its stress and its von Mises stress for ParaView. Collective.
 */
template <int dim>
void write_solution_vtu(const std::filesystem::path &path,
                        const DisplacementSpace<dim> &space,
                        const Scene<dim> &scene,
                        const NodalVector &U);

/** Writes a .pvd that lists one file per level; the level plays the part of time. */
void write_pvd(const std::filesystem::path &path,
               const std::vector<std::pair<double, std::string>> &files);
} // namespace Signorini
