// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/mesh_plan.h>
#include <signorini/error_control/hp/cell_indicator.h>

namespace Signorini {
/** Splits cells of a first plan in which the scan of the data found small boxes or breaks, or
 * that bend too much for the stresses of the bound, up to six times; smaller
 * details are integrated on parts of cells. */
void resolve_hidden_data(const Scene<2> &scene, MeshPlan &plan);

/** The misfit of the cells in which moduli jump. */
struct JumpMisfit {
  /** Returns the number of such cells that leave the given error: along a curve half the size
   * means twice as many, and half the square of the misfit. */
  double n_cells_for(const double error) const {
    return n_cells * square / (error * error);
  }

  double n_cells = 0., square = 0.;
};

/** Adds the misfit of jumps of the moduli inside of cells to the indicators: u_h has no kink at a
 * jump. Where layers lie one behind the other the body is as stiff as the harmonic mean E_h of its
 * moduli, and u_h, whose strain does not jump, as the arithmetic mean E_a. Under the same stress
 * the energy of the cell is wrong by (E_a/E_h - 1) times that of u_h, which counts as error,
 * whatever the direction of the layers. @return the sum over these cells. */
JumpMisfit add_jump_misfit(const DisplacedBody<2> &body, std::vector<CellIndicator> &indicators);
} // namespace Signorini
