// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/postprocessing/fields/energies.h>
#include <signorini/solvers/methods/solved.h>

namespace Signorini {
/** The residuals of (5) for (U, P), relative to the scene's own scales. */
struct Certificate {
  /** The residual |A U - D P - f|₂ on free degrees of freedom, relative to its largest term. */
  double stationarity = 0.;
  /** The largest mean penetration max (W_k)₊ / ∫ψ_k, or |W_t,k| / ∫ψ_k where k sticks, relative to
   * displacement and gap. */
  double penetration = 0.;
  /** The largest distance of a P_k from K(P), relative to max |P|. Without friction it is
   * max(P)₊ / max |P|. */
  double sign = 0.;
  /** The product |Pᵀ W| relative to the energies; with friction Pᵀ W + Σ s |W_t|, de Saxcé's
   * bipotential gap, which is never negative and vanishes at solutions only. */
  double complementarity = 0.;
  /** The primal minus the dual objective, relative to the energies. */
  double duality_gap = 0.;
  /** The sum of reactions, loads and contact pressure, relative to the largest force. */
  double force_balance = 0.;
  /** The sum of the moments of these forces about the body's centre, in the same way relative. */
  double moment_balance = 0.;
  /** The forces and moments on free motions of plates and of the body that nothing balances,
   * relative to the largest force. */
  double motion_balance = 0.;
  /** With friction: U.(A U - f - reactions) - P.G + Σ s |W_t|, the work of loads that is neither
   * stored nor dissipated, relative to the energies. */
  std::optional<double> dissipation_balance;
  /** Whether moments must balance exactly: V^h of curved cells contains rotations up to O(h²) only.
   */
  bool moments_are_exact = true;
  /**
   * The number of multipliers for which pressure and opening vanish together: |W_k| / |τ| and
   * C_kk |P_k| / |τ|, the displacement that the pressure causes there, are below 1e-6 of
   * displacement and gap.
   */
  unsigned int degenerate_patches = 0;
  /** The largest difference between U and the prescribed displacement, or the largest normal
   * displacement on rollers, at vertices, relative to the largest of both displacements. */
  double support = 0.;
  /** The largest displacement, relative to the largest displacement without the translation of the
   * whole body. */
  double translation = 1.;
  /** The size of residuals that rounding alone causes: the unit roundoff times |A| |U|, relative to
   * the largest of the forces. */
  double rounding = 0.;
  /** The energy J(u_h, p_H) of (22) (force x length per thickness). */
  double energy = 0.;

  static Columns<Certificate> columns();
};

/**
 * Computes the certificate from the cells' integrals, without the assembled and factorised A.
 * Collective.
 * @param applied LinearSystem::applied. @param forces of U and P, see nodal_forces().
 */
template <int dim>
Certificate certify(const Solved<dim> &solved, const std::vector<Resultant<dim>> &applied,
                    const NodalForces &forces, const Energies &energies);

} // namespace Signorini
