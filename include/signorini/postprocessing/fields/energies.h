// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/solvers/contact/motion_modes.h>
#include <signorini/solvers/methods/solved.h>

namespace Signorini {
/** The energies of u_h and p_H (force x length per thickness). */
struct Energies {
  /** The strain energy a(u_h, u_h)/2. */
  double strain = 0.;
  /** The work f(u_h) of the loads. */
  double loads = 0.;
  /** The work of the forces on plates, which the loads do not contain. */
  double plates = 0.;
  /** The work Pᵀ G of contact on the gap, and the product Pᵀ W of contact and opening, which
   * vanishes without friction. */
  double gap = 0., opening = 0.;
  /** The work Σ s |w_t| of friction. */
  double dissipation = 0.;

  /** Returns J(u_h, p_H) of (22); [p, B u - g] is Pᵀ W. */
  double J() const {
    return strain - loads - opening - plates;
  }
  /** Returns J(u_h) = a(u_h, u_h)/2 - f(u_h) of the body alone, whose plates are held where they
   * have moved. */
  double J_without_plates() const {
    return strain - loads;
  }
};

/** Computes the energies. Collective. @param forces those of U and P. */
template <int dim>
Energies energies_of(const Solved<dim> &solved, const MotionModes<dim> &modes,
                     const NodalForces &forces) {
  const ContactSolution &contact = solved.contact;
  const dealii::Vector<double> &P = contact.P.values();
  const AdmissibleSet &K = contact.P.set();
  return {forces.strain_energy,
          contact.U * forces.loads,
          modes.work_of_plates(solved.scene.plates, contact.q),
          P * solved.discretization.G,
          P * contact.W,
          K.dissipation(K.slip(P, contact.W))};
}
} // namespace Signorini
