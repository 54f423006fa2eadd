// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <string>

/** Returns the first contact on a side of a scene, which has one. */
template <typename Scene>
auto &contact_of(Scene &scene, const std::string &side) {
  const auto number = scene.geometry.find_side(side);
  return *std::find_if(scene.contacts.begin(), scene.contacts.end(),
                       [number](const auto &contact) { return contact.side == number; });
}
