// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/multiplier.h>
#include <signorini/postprocessing/quantities/answer_vector.h>

#include <vector>

namespace Signorini {
/** A part of a side in which a zone ends: between two nodes in different states. */
struct ZoneBracket {
  unsigned int side;
  /** The arc lengths; around a closed side the second may exceed its length (length). */
  double from, to;
};

/** Returns all brackets, side after side; those that share a node are one.
 * @param states of all nodes. */
std::vector<ZoneBracket> zone_brackets(const MultiplierSpace<2> &multipliers,
                                       const std::vector<NodeState> &states);

/** One end of a contact zone. */
struct ZoneEnd {
  BoundaryPoint at;
  /** The distance of the exact end, in order of magnitude: the length of the patch in which it
   * lies, or with polynomials half of the distance between the nodes around it. It is zero where
   * the zone ends with its side. */
  double uncertainty = 0.;
};

/** A part of a side that is pressed: a run of pressing patches, or with polynomials of nodes; in
 * space patches that share edges, which have no ends. */
struct ContactZone {
  ZoneEnd start, end;
  /** The length from start to end along the side; in space the area. */
  double length = 0.;
  /** The number of the contact in Scene::contacts. */
  unsigned int contact = 0;
};

/**
 * Returns the contact zones, contact after contact in the order of arc length. A closed side that
 * presses everywhere is one zone from its start to its start.
 *
 * At an end of smooth contact the pressure falls like the root of the distance. So the end is the
 * zero s_0 of c (s_0 - s)_+^{1/2} with the means of p_H over the last two pressing patches, at most
 * in the middle of the patch after them. Where the pressure does not fall, as under a sharp edge,
 * or where a single patch presses, the zone ends with its last patch.
 *
 * Where patches have polynomials, zones are pressed_intervals().
 * @param states of all nodes, which differ in whether they press. @param P their pressures; without
 * them zones end at edges of patches.
 */
std::vector<ContactZone> contact_zones(const MultiplierSpace<2> &multipliers,
                                       const std::vector<NodeState> &states,
                                       const Pressure &P = Pressure());

/** A zone in space and its patches. */
struct PressedArea {
  ContactZone zone;
  std::vector<unsigned int> patches;
};

/** Returns the pressed areas, contact after contact, in the order of their first patches. */
std::vector<PressedArea> pressed_areas(const MultiplierSpace<3> &multipliers, const Pressure &P);

/** Returns the contact zones of a pressure. */
inline std::vector<ContactZone> contact_zones(const MultiplierSpace<2> &multipliers,
                                              const Pressure &P) {
  return contact_zones(multipliers, Multiplier(P).states(), P);
}
} // namespace Signorini
