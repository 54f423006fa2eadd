// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/cell_fit.h>
#include <signorini/error_control/equilibration/edge_function.h>
#include <signorini/error_control/equilibration/tractions.h>

#include <vector>

namespace Signorini {
/** A stress τ of degrees q_K on cells: for tractions that are in balance the one with div τ + f_K =
 * 0 that is closest to σ(u_h), or to zero, see CellFit. */
struct EquilibratedStress {
  /** Returns ‖σ(u_h) - τ‖_K or ‖τ‖_K. */
  double distance(std::size_t cell) const;
  /** Returns a bound of the norm of a stress that balances f - f_K and t - t_h. @param of_pairs
   * whether q - t_h on the sides of pairs counts: it is known exactly. */
  double oscillation(std::size_t cell, bool of_pairs = true) const;
  /** Returns the part of f - f_K in it. */
  double load_oscillation(std::size_t cell) const;
  /** Returns the sum of the squares of either, over all cells. */
  double distance_square() const;
  double oscillation_square() const;

  /** Returns ∫ τ_n over Γ_c. */
  double contact_force(const Scene<2> &scene) const;
  /** Returns the tractions on the faces of the contact surface. */
  std::vector<FaceTractions> face_tractions(const ContactSurface<2> &surface) const;

  Tractions tractions;
  std::vector<CellFit> fits;
  /** The largest residual force of a cell, relative to the largest traction. */
  double defect = 0.;
};
} // namespace Signorini
