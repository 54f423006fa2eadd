// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <vector>

namespace Signorini
{
/**
 * The error that u_h makes on sides with prescribed displacements, where it interpolates u_D: a
 * function z with z = u_D - u_h there and z = 0 on all other sides. So u_h + z has the boundary
 * values of u, and the bound of |||u - u_h - z||| holds.
 *
 * On a cell with an edge on such a side, z = rho(t) (1 - eta/depth)_+, t along the edge, eta across
 * the cell from 0 to 1, rho = u_D - u_h, which vanishes at both ends; elsewhere z = 0. The depth is
 * the best one among 1, 1/2, ..., 1/64.
 *
 * rho is sampled at four Gauss points on each of 16 equal parts of the edge, which is also cut at
 * kinks, its derivative by differences.
 */
struct PrescribedRest
{
  /** |||z|||_K for every cell, in the order of active cells (root of force x length per thickness).
   */
  std::vector<double> norms;
  /** |||z|||², at most: sum_K |||z|||_K². */
  double square = 0.;
  /** Whether rho does not vanish at the end of an edge: prescribed displacements jump, and no u has
   * a finite energy. */
  bool jumps = false;
};

PrescribedRest make_prescribed_rest(const DisplacementSpace<2> &space,
                                    const Scene<2> &scene,
                                    const NodalVector &U);
} // namespace Signorini
