// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** A contact of a scene: a side and its partner, a rigid foundation or a side of another body, with
 * the data that the scene prescribes between them. */
template <int dim>
class ContactPair {
public:
  /** The scene must outlive the object. @param number of the contact in Scene::contacts. */
  ContactPair(const Scene<dim> &scene, const unsigned int number)
    : scene_(scene)
    , number_(number) {}

  /** Returns the number of the contact in Scene::contacts. */
  unsigned int number() const {
    return number_;
  }
  const ContactCondition<dim> &data() const {
    return scene_.contacts[number_];
  }
  /** Returns the number of the side on which Γ_c lies. */
  unsigned int side() const {
    return data().side;
  }
  /** Returns the number of the side of the other body; none where the foundation is rigid. */
  const std::optional<unsigned int> &other_side() const {
    return data().opposite;
  }
  /** Returns the name of the side of the other body; empty where the foundation is rigid. */
  std::string other_name() const {
    return other_side() ? scene_.geometry.sides[*other_side()].name() : std::string();
  }
  /** Returns the name of the side, or of both: "roller.arc with plate.top". */
  std::string name() const {
    return scene_.geometry.sides[side()].name() + (other_side() ? " with " + other_name() : "");
  }
  /**
   * Returns the number of the carrier: of both sides the one whose body is more compliant, on whose
   * faces the traction of both is best given. Its own compliance keeps C = C_1 + C_2 >= C_1 stable
   * there whatever the mesh of the other side is. A side that touches a rigid foundation is its own
   * carrier.
   */
  unsigned int carrier() const;
  /** Returns whether a point of the side, or its arc length, lies in the part where two bodies may
   * touch. */
  bool contains(const Point<dim> &x) const;
  bool contains(double s) const;
  /** Returns the direction m of contact at a point of the side. */
  Tensor<1, dim> direction(const Point<dim> &x) const {
    const Tensor<1, dim> n = scene_.geometry.sides[side()].normal_at(x);
    if constexpr (dim == 2)
      return data().directions.at(scene_.geometry.sides[side()].arc_length(x), x, n);
    else
      return data().directions.at(x, n);
  }
  /** Returns the gap g at a point of the side. @throws InputError where it has no value. */
  double gap(const Point<dim> &x) const {
    return data().gap->value(x);
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
  const Scene<dim> &scene_;
  unsigned int number_;
};

/** Returns all contacts. */
template <int dim>
std::vector<ContactPair<dim>> contact_pairs(const Scene<dim> &scene) {
  std::vector<ContactPair<dim>> pairs;
  for (unsigned int i = 0; i < scene.contacts.size(); ++i)
    pairs.emplace_back(scene, i);
  return pairs;
}

/** Returns the contact of a side that is in one only, on either body. */
template <int dim>
ContactPair<dim> pair_with(const Scene<dim> &scene, const unsigned int side) {
  const std::vector<ContactPair<dim>> pairs = contact_pairs(scene);
  const auto found = std::find_if(pairs.begin(), pairs.end(), [side](const ContactPair<dim> &pair) {
    return pair.side() == side || pair.other_side() == side;
  });
  Assert(found != pairs.end(), ExcMessage("The side may touch something."));
  return *found;
}

/** Returns the directions of the contact on a side that is in one only; those of n where Γ_c lies
 * on no or on the other body. */
inline ContactDirections<2> directions_on(const Scene<2> &scene, const unsigned int side) {
  for (const ContactCondition<2> &contact : scene.contacts)
    if (contact.side == side)
      return contact.directions;
  return {};
}
} // namespace Signorini
