// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>

namespace Signorini {
/** Returns whether the norms of the trace space are known on all contact sides: those of a plane
 * body that is none of revolution, and in space those of rectangles. */
template <int dim>
bool has_trace_norms(const Scene<dim> &scene) {
  if constexpr (dim == 2)
    return !scene.geometry.axisymmetric;
  else
    return std::all_of(scene.contacts.begin(), scene.contacts.end(), [&](const auto &contact) {
      return scene.geometry.sides[contact.side].rectangle()[0] > 0.;
    });
}
} // namespace Signorini
