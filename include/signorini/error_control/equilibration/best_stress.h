// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/error_control/equilibration/equilibrated_stress.h>
#include <signorini/error_control/equilibration/stress_bound.h>

#include <string>

namespace Signorini {
/**
 * The stress τ that is closest to σ(u_h), among those of degree q_K on cells (AiryCell) that are in
 * equilibrium: div τ + f_K = 0, continuous tractions, the projection of t on traction sides, no
 * shear on rollers and contact sides, and τ_n ≤ 0 on contact sides. With friction |τ_t| ≤ s there,
 * with Coulomb's law s = f |τ_n|. Nothing is assumed of u_h.
 *
 * 1. The cells are those of u_h on graded meshes, where its distance to σ(u_h) is that of the
 * differences on cells (DifferenceMisfit), else those of a mesh of its own (EnergyMisfit).
 * 2. Inside of the cells the best stress for given tractions follows cell by cell (CellFit).
 * 3. Tractions on edges minimise the sum of energies; the balances of cells, and of plates that a
 * force drives, are conditions (minimise()).
 * 4. Those of contact edges are fixed where they are not admissible (ContactTractions).
 * 5. Cells where f - f_K or t - t_h counts for more than a tenth are split, or their degree rises.
 */
struct BestStress {
  EquilibratedStress stress;
  StressBound bound;
};

/** Returns the reason why there is no such stress, one sentence; empty if there is one. */
std::string objection_to_stress(const DisplacedBody<2> &body);

/** @throws ComputationError if no stress in equilibrium is found. Collective. */
BestStress find_best_stress(const BoundData &data);
} // namespace Signorini
