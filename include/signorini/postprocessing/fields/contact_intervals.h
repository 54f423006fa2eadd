// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier.h>

#include <vector>

namespace Signorini {
/** A node of a multiplier on its side. */
struct SideNode {
  /** The arc length (length). */
  double s;
  NodeState state;
};

/** The nodes of one contact in the order of arc length. */
struct SideNodes {
  /** The number of the contact in Scene::contacts, and that of its side in the geometry. */
  unsigned int contact = 0, number = 0;
  /** The length of the side, and the arc lengths between which it may touch (length). */
  double length = 0., from = 0., to = 0.;
  /** Whether the first node follows the last one. */
  bool closed = false;
  std::vector<SideNode> nodes;
};

/** Returns the nodes of all multipliers, contact after contact, with the given states. */
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers,
                                     const std::vector<NodeState> &states);

/** Returns the runs of two or more neighbouring nodes each of which differs from the next: a zone
 * ends between the first and the last of each. Around a closed side, the positions go on beyond its
 * length, and the first node comes again at the end. */
std::vector<std::vector<SideNode>> alternations(const SideNodes &side);

/** A part of a side that is pressed, according to the nodes of the multipliers. */
struct PressedInterval {
  struct End {
    /** The arc length; around a closed side the end of an interval may exceed the length (length).
     */
    double s = 0.;
    /** The distance of the exact end, in order of magnitude (length). */
    double uncertainty = 0.;
  };
  /** The number of the contact in Scene::contacts, and that of its side in the geometry. */
  unsigned int contact = 0, side = 0;
  End start, end;

  double length() const {
    return end.s - start.s;
  }
};

/**
 * Returns the pressed intervals, contact after contact in the order of arc length.
 *
 * The nodes of the multipliers are points at which p_H presses or does not. Contact ends between
 * two neighbours that differ: the end is their middle, and its uncertainty is half of their
 * distance. Where pressing and open nodes alternate, contact ends only once between the first and
 * the last one of them, or, if these are of the same kind, there is a single gap or a single
 * interval between them. Where the first or the last node of a side presses, the interval ends with
 * the side, in a pair with the overlap, without uncertainty. A closed side that is pressed
 * everywhere is an interval from 0 to its length.
 */
std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const std::vector<NodeState> &states);

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
} // namespace Signorini
