// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>
#include <signorini/postprocessing/quantities/probe_report.h>
#include <signorini/postprocessing/quantities/side_forces.h>
#include <signorini/postprocessing/quantities/von_mises.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The largest u_h.m - g, positive where the body penetrates (length). */
struct Penetration {
  double value = 0.;
  BoundaryPoint at;
};

/** The engineering results of one level. Pressures are positive in compression. */
struct Answer {
  /** The dimension of the body: 2 or 3. */
  unsigned int dimension = 2;
  /** Whether the body is one of revolution. Then the components of forces are sums over the
   * circumference: outward, and along the axis. */
  bool axisymmetric = false;
  /** The thickness to which forces belong (length). */
  double thickness = 1.;
  /** The size of the body (length): smaller coordinates may be rounding. */
  double size = 0.;
  /** The force of all contacts together; with pairs of bodies that of the rigid foundation, or
   * where there is none of the first pair. */
  SideForce contact_force;
  std::vector<ContactForce> contact_by_side;
  std::vector<SideForce> reactions;
  /** The peak pressure; empty if nothing presses. */
  std::optional<PeakPressure> peak_pressure;
  /** The contact zones. */
  std::vector<ContactZone> zones;
  /** Their forces, in the same order. */
  std::vector<ContactForce> zone_forces;
  /** The penetration; empty without a contact side. */
  std::optional<Penetration> penetration;
  /** The largest |m + n_2| of the direction of contact and the unit normal of the other side of a
   * pair, or of the obstacle, where they press: the angle by which they are not opposite. */
  double turn_of_normals = 0.;
  VonMises von_mises;
  /** The probes of Output/Report. */
  std::vector<ProbeReport> reports;

  static Columns<Answer> columns();
};

/**
 * Returns the largest u_h.m - g at 17 points of every piece, in 3-D at 5 x 5.
 * @throws InputError where g has no value.
 */
template <int dim>
std::optional<Penetration> max_penetration(const DisplacedBody<dim> &body,
                                           const ContactSurface<dim> &surface);

/** Computes the answer. Collective. */
template <int dim>
Answer compute_answer(const BodyInContact<dim> &body, const NodalForces &forces);
} // namespace Signorini
