// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/mesh_plan.h>
#include <signorini/error_control/hp/cell_indicator.h>
#include <signorini/error_control/hp/hidden_data.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

namespace Signorini {
/** The results of a step that determine the next one. */
struct StepFindings {
  /** The indicators, by active cell. */
  std::vector<CellIndicator> indicators;
  JumpMisfit jumps;
  std::vector<ZoneBracket> brackets;
  /** The numbers of the cells with a face on which the body penetrates though nothing presses. */
  std::vector<unsigned int> missed_contact_cells;
  /** The part of the indicator on cells that cannot be split any more, (force length)^{1/2}, and
   * the middle of the worst of them. */
  double unsplit = 0.;
  Point<2> deepest;
  /** The estimated error, where there is an estimate, and the one that is aimed at, (force
   * length)^{1/2}. */
  double error = 0.;
  double target = 0.;
  /** The divisor of errors, see EnergyScale. */
  double scale = 0.;

  /** Without it the next mesh will see another problem. */
  bool has_estimate() const {
    return missed_contact_cells.empty();
  }
};

/** Returns the plan of the first step: a uniform mesh of degree 2, and the points that are singular
 * by the data. */
MeshPlan first_plan(const Scene<2> &scene, unsigned int base_level,
                    unsigned int max_element_degree);

/** Returns the plan of the next step. Its error should be smaller by a factor of about twelve, or
 * reach the target where that is near. Ends of contact are those of this step and get three more
 * layers. Corners and kinks get as many as their exponents need for the same effect, if they
 * matter. The degree rises. A cell whose error would still be too large is split where the
 * coefficients of u_h fall slowly; its degree rises further where they fall fast. */
MeshPlan next_plan(const MeshPlan &plan, const Scene<2> &scene, const Mesh<2> &mesh,
                   const std::vector<unsigned int> &degrees, const StepFindings &findings);
} // namespace Signorini
