// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/space/admissible_set.h>
#include <signorini/discretization/space/multiplier_space.h>

#include <vector>

namespace Signorini {
/** A pressure with the patches that it belongs to, as a start for another partition. */
template <int dim>
struct PatchPressure {
  std::vector<Patch<dim>> patches;
  Pressure P;
};

/** Transfers P of another partition to the patches of @p to: the mean of the piecewise constant
 * function on each patch (its L2-projection). The time is proportional to the number of overlaps,
 * after sorting. */
template <int dim>
Pressure transfer_pressure(const PatchPressure<dim> &from, const std::vector<Patch<dim>> &to);

/** Returns the values of p_H at the nodes of other multipliers on the same sides, cut off at the
 * ends of an interval, as a start for an active set. */
Pressure transfer_pressure(const MultiplierSpace<2> &from, const Pressure &P,
                           const MultiplierSpace<2> &to, const Interval &allowed = {});

/** Returns pi^{2h} u_h of (30), where T^{2h} exists, else u_h, at the nodes of the next level,
 * which is refined everywhere: a start for V-cycles. Elements of degree one. Empty if @p fine is
 * not that level. */
template <int dim>
Displacement carry_over(const DisplacementSpace<dim> &coarse, const Displacement &U,
                        const DisplacementSpace<dim> &fine);
} // namespace Signorini
