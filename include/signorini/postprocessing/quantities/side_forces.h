// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/discretization/space/paired_piece.h>
#include <signorini/discretization/space/resultant.h>
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** Returns whether a role holds nodes of its side, so that forces act through them. */
inline bool holds(const Role role) {
  return role == Role::clamped || role == Role::roller || role == Role::displacement;
}

/** The force that acts on the body through one side (force, in 2-D per thickness). */
struct SideForce {
  /** The force, and its moment about the origin: one number in 2-D, three in 3-D. */
  struct Total {
    AnswerVector force, moment;
  };
  std::string side;
  Total resultant;
  /** A point on the line of action: there the moment vanishes, or in 3-D is parallel to the force.
   * There is none where the force vanishes. */
  std::optional<AnswerVector> through;
};

/** The force through a contact, or through a zone of it, on one of its bodies. */
struct ContactForce : SideForce {
  /** The name of the side of the other body; empty where the foundation is rigid. */
  std::string other;
  PairSide acts_on = PairSide::first;
  /** The largest pressure; none where nothing presses, and on second bodies. */
  std::optional<PressureMaximum> peak = {};
};

/** Returns the force of a resultant. Its line of action is given by the point nearest to @p centre
 * (in 3-D, where the moment is parallel to the force); there is none where the force is rounding
 * compared with @p scale. */
template <int dim>
SideForce side_force(const std::string &name, const Resultant<dim> &resultant,
                     const Point<dim> &centre, double scale);

/** Returns the numbers of the contacts over which the contact force is summed: those with the rigid
 * foundation. Forces between bodies cancel, so where all are of bodies it is the first one alone.
 */
template <int dim>
std::vector<unsigned int> contacts_of_contact_force(const Scene<dim> &scene);

/** Returns the body on which that force acts: that of the side that is named first. */
template <int dim>
PairSide body_of_contact_force(const Scene<dim> &scene);

/** Returns ∫ p_H n, with friction ∫ p_H n + q_H t, over contacts, with the name of the side of a
 * single one; or the forces on the second bodies. The line of action is given by its point nearest
 * to the centre of pressure, which lies on a straight side. */
template <int dim>
SideForce contact_force(const MultiplierSpace<dim> &multipliers,
                        const std::vector<unsigned int> &contacts, const Multiplier &multiplier,
                        PairSide acts_on = PairSide::first);

/** Returns the forces of all contacts, in a pair those on both bodies, that of the side named first
 * before the other one. */
template <int dim>
std::vector<ContactForce> contact_forces(const MultiplierSpace<dim> &multipliers,
                                         const Multiplier &multiplier);

/** Returns the forces of contact zones on the (first) bodies, in their order. A piece between two
 * zones belongs to the nearer one: the forces of all zones of a contact sum up to its force. */
std::vector<ContactForce> zone_forces(const MultiplierSpace<2> &multipliers,
                                      const Multiplier &multiplier,
                                      const std::vector<ContactZone> &zones);
/** Returns the same in space. */
std::vector<ContactForce> zone_forces(const MultiplierSpace<3> &multipliers,
                                      const Multiplier &multiplier,
                                      const std::vector<PressedArea> &areas);

/**
 * Returns the reaction of every clamped, prescribed and roller side: the sum of
 * NodalForces::residual over its nodes, which is in balance with loads and contact forces to
 * rounding.
 *
 * Where held sides meet (two, in 3-D up to three), the node's reaction is divided: rollers take the
 * components along their normals, and sides that hold all components share the rest equally. So the
 * division is accurate up to the stress at the corner (in 3-D: at the edge) times h. The line of
 * action is given by its point nearest to the middle of the side.
 */
template <int dim>
std::vector<SideForce> reactions(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                 const NodalForces &forces);

/** The forces of reactions() as functionals of the solution, each r(u) = a(u, v) - f(v) - ∫ p_H v.n
 * with a fixed v in the space without essential conditions: for many loads on one body. */
class ReactionFunctionals {
public:
  /** Integrates a(., v) on the cells beside held sides. */
  ReactionFunctionals(const DisplacementSpace<2> &space, const Scene<2> &scene);

  /** Returns the components of all held sides, "left_x", ... (force per thickness).
   * @param forces loads and contact forces at all degrees of freedom. */
  std::vector<std::pair<std::string, double>> of(const Displacement &U,
                                                 const DualVector &forces) const;

private:
  struct Functional {
    std::string name;
    Displacement v;
    /** The values a(φ_j, v). */
    DualVector stiffness;
  };
  std::vector<Functional> functionals_;
};
} // namespace Signorini
