// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/mesh/contact_surface.h>
#include <signorini/discretization/multiplier/multiplier.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace Signorini {
/** A part of a side that is pressed, according to the nodes of the multipliers. */
struct PressedInterval {
  struct End {
    /** The arc length; around a closed side the end of an interval may exceed the length (length).
     */
    double s = 0.;
    /** The distance of the exact end, in order of magnitude (length). */
    double uncertainty = 0.;
  };
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  End start, end;

  double length() const {
    return end.s - start.s;
  }
};

/**
 * Returns the pressed intervals, side after side in the order of arc length.
 *
 * The nodes of the multipliers are points at which p_H presses or does not. Contact ends between
 * two neighbours that differ: the end is their middle, and its uncertainty is half of their
 * distance. Where pressing and open nodes alternate, contact ends only once between the first and
 * the last one of them, or, if these are of the same kind, there is a single gap or a single
 * interval between them. Where the first or the last node of a side presses, the interval ends with
 * the side, without uncertainty. A closed side that is pressed everywhere is an interval from 0 to
 * its length.
 */
std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const Pressure &P);

/** A summary of the contact pressure. */
struct ContactSummary {
  /** The number of multipliers that press, P_k < pressing_threshold(P); with constants that of
   * patches. */
  unsigned int active = 0;
  /** The total length of the patches that press, in 3-D their area, if multipliers are constants;
   * that of the pressed_intervals() if they are polynomials (length^{dim-1}). */
  double length = 0.;
  /** The force -∫ p_H, positive in compression (force). */
  double normal_force = 0.;
  /** The maximum max(-P_k), positive in compression (force/area). */
  double max_pressure = 0.;

  static Columns<ContactSummary> columns();
};

template <int dim>
ContactSummary summarise_contact(const MultiplierSpace<dim> &space, const Pressure &P);

/**
 * A continuous pressure of second order, recovered from the means of p_H over the patches and cut
 * off at zero.
 *
 * In 2-D it is piecewise linear through the middles of the patches of a side, continued to its ends
 * (around a closed side). In 3-D it is bilinear between the centres of four patches of a side,
 * continued to its edges. Where patches have polynomials, it is p_H itself, cut off at zero.
 */
template <int dim>
class RecoveredPressure {
public:
  RecoveredPressure(const MultiplierSpace<dim> &space, const Pressure &P);

  /** Returns the value at the point @p s of the side to which @p patch belongs; @p patch contains
   * it. */
  double operator()(unsigned int patch, const Point<dim - 1> &s) const {
    return std::min(0., without_sign(patch, s));
  }
  /** Returns the same without the cut. */
  double without_sign(unsigned int patch, const Point<dim - 1> &s) const {
    return space_.is_piecewise_constant() ? interpolate(patch, s, dim - 1)
                                          : space_.value(P_, patch, s);
  }

private:
  /** Returns the mean of a patch, interpolated linearly between the middles of neighbours in the
   * first directions, one after the other. */
  double interpolate(unsigned int patch, const Point<dim - 1> &s, unsigned int n_directions) const;

  const MultiplierSpace<dim> &space_;
  Pressure P_;
  std::vector<Neighbours<dim>> neighbours_;
  /** The means of the patches. */
  std::vector<double> means_;
};

/** A node of a multiplier on its side. */
struct SideNode {
  /** The arc length (length). */
  double s;
  NodeState state;
};

/** The nodes of one side in the order of arc length. */
struct SideNodes {
  /** The number of the side in the geometry. */
  unsigned int number = 0;
  double length = 0.;
  bool closed = false;
  std::vector<SideNode> nodes;
};

/** Returns the nodes of all multipliers, side after side, with the given states. */
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers,
                                     const std::vector<NodeState> &states);

/** Returns the runs of two or more neighbouring nodes each of which differs from the next: a zone
 * ends between the first and the last of each. Around a closed side, the positions go on beyond its
 * length, and the first node comes again at the end. */
std::vector<std::vector<SideNode>> alternations(const SideNodes &side);

/** The forces at all degrees of freedom j (force per thickness); every rank stores all of them.
 * They are integrals over cells; the assembled and factorised A is not used. */
struct NodalForces {
  /** The internal forces a(u_h, φ_j). */
  DualVector internal;
  /** The loads ∫ f.φ_j + ∫_{Γ_F} t.φ_j. */
  DualVector loads;
  /** The contact forces ∫_{Γ_c} p_H φ_j.n. */
  DualVector contact;
  /** The residual internal - loads - contact: zero on free, the reaction on constrained degrees of
   * freedom. */
  DualVector residual;
  /** The size |A| |U| of the terms that make up the internal forces. */
  double magnitude = 0.;

  /** The size of u_h; where it is rigid, all forces are rounding. */
  EnergyScale energy;

  /** Returns the norm of the largest of the forces. */
  double largest() const;
  /** Returns the scale of residuals: the largest of the forces, or, where the body moves rigidly,
   * the size of the terms that cancel. */
  double scale() const {
    return energy.rigid ? std::max(magnitude, largest()) : largest();
  }
  /** Returns the smallest scale of energies: zero where the body is strained. */
  double rigid_energy() const {
    return std::pow(energy.rigid.value_or(0.), 2);
  }
};

/**
 * Computes the forces. Collective.
 * @param loads LinearSystem::loads. @param P all multipliers, as D has columns.
 */
template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                         const DualVector &loads, const Coupling &D, const Displacement &U,
                         const dealii::Vector<double> &P);

/** Returns the force and the moment of p_H n + q_H on a piece of Γ_c. */
template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const Multiplier &multiplier, const Piece<dim> &piece);

/** Returns u_{h,n} - g at the points of a rule on a piece, positive where the body penetrates, or
 * the slip u_{h,t} - g_t. @throws InputError where g has no value. */
template <int dim>
std::vector<double> penetration(const ContactSurface<dim> &surface, const Piece<dim> &piece,
                                const SurfaceRule<dim> &rule, const Displacement &U,
                                TraceValues<dim> &traces, Component component = Component::normal);

/** Returns ∫_{Γ_c} q φ_j.n for all j, as the column of a coupling: @p values_on (piece, rule) is q
 * at the points of @p rule_on (piece). With t in the place of n if the component is tangential. */
template <int dim, typename RuleOn, typename ValuesOn>
Coupling::Column contact_load(const DisplacementSpace<dim> &space,
                              const ContactSurface<dim> &surface, const RuleOn &rule_on,
                              const ValuesOn &values_on,
                              const Component component = Component::normal) {
  TraceValues<dim> traces(space);
  Coupling::Column load;
  for (const Piece<dim> &piece : surface.pieces()) {
    const ContactFace<dim> &face = surface.faces()[piece.face];
    const SurfaceRule<dim> &rule = rule_on(piece);
    const std::vector<double> q = values_on(piece, rule);
    const auto &values = traces.reinit(face, rule.on_face);
    const auto indices = space.cell_dofs(face.cell);
    for (std::size_t k = 0; k < rule.size(); ++k)
      for (unsigned int j = 0; j < indices.size(); ++j)
        load[indices[j]] += q[k] * rule.weights[k] *
                            (values[FEValuesExtractors::Vector(0)].value(j, k) *
                             direction_of(component, rule.normals[k]));
  }
  return load;
}

/** The force and the moment that act on the body through a plate (per thickness). */
struct PlateForce {
  /** The force along the plate's direction. */
  double force = 0.;
  /** The moment about the plate's centre, counter-clockwise. */
  double moment = 0.;
};

/** Returns the force and the moment of every plate of the scene: the work of NodalForces::residual
 * on its motions. A node at the end of the plate belongs to the plate. */
template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                     const NodalForces &forces);
} // namespace Signorini
