// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** A contact side and its partner, a rigid foundation or a side of another body, with the data that
 * the scene prescribes between them. */
template <int dim>
class ContactPair {
public:
  /** The scene must outlive the object. @param side a contact side. */
  ContactPair(const Scene<dim> &scene, const unsigned int side)
    : scene_(scene)
    , side_(side) {}

  /** Returns the number of the contact side. */
  unsigned int side() const {
    return side_;
  }
  /** Returns the number of the side of the other body; none where the foundation is rigid. */
  const std::optional<unsigned int> &other_side() const {
    return data().opposite;
  }
  /** Returns the name of the side of the other body; empty where the foundation is rigid. */
  std::string other_name() const {
    return other_side() ? scene_.geometry.sides[*other_side()].name() : std::string();
  }
  /**
   * Returns the number of the carrier: of both sides the one whose body is more compliant, on whose
   * faces the traction of both is best given. Its own compliance keeps C = C_1 + C_2 >= C_1 stable
   * there whatever the mesh of the other side is. A side that touches a rigid foundation is its own
   * carrier.
   */
  unsigned int carrier() const;
  /** Returns the gap g at a point of the contact side. @throws InputError where it has no value. */
  double gap(const Point<dim> &x) const {
    return data().data->value(x);
  }
  /** Returns a component of the motion g_t of the foundation. */
  double shift(const Point<dim> &x, const unsigned int component = 0) const {
    return data().shift == nullptr ? 0. : data().shift->value(x, component);
  }
  /** Returns the bound s of |q| at a point with the traction @p p along the direction of contact.
   * Infinite without friction. */
  double bound(const Point<dim> &x, const double p) const {
    return scene_.contact_law.bound(data(), x, p);
  }

private:
  const BoundaryCondition<dim> &data() const {
    return scene_.boundary[side_];
  }

  const Scene<dim> &scene_;
  unsigned int side_;
};

/** Returns the pairs of the contact sides. */
template <int dim>
std::vector<ContactPair<dim>> contact_pairs(const Scene<dim> &scene) {
  std::vector<ContactPair<dim>> pairs;
  for (const unsigned int side : scene.contact_sides())
    pairs.emplace_back(scene, side);
  return pairs;
}

/** Returns the pair of a contact side, or of the side that touches it. */
template <int dim>
ContactPair<dim> pair_with(const Scene<dim> &scene, const unsigned int side) {
  for (const ContactPair<dim> &pair : contact_pairs(scene))
    if (pair.other_side() == side)
      return pair;
  return {scene, side};
}

/** Returns whether the body may touch something on a side of this role. */
inline bool may_touch(const Role role) {
  return role == Role::contact || role == Role::opposite;
}
} // namespace Signorini
