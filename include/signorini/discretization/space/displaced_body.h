// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displacement_space.h>
#include <signorini/discretization/space/multiplier.h>

namespace Signorini {
/** A body that u_h displaces. All of it must outlive the object. */
template <int dim>
struct DisplacedBody {
  DisplacedBody(const DisplacementSpace<dim> &space, const Scene<dim> &scene, const Displacement &U)
    : space(space)
    , scene(scene)
    , U(U) {}

  const DisplacementSpace<dim> &space;
  /** The scene with its plates where they have moved. */
  const Scene<dim> &scene;
  const Displacement &U;
};

/** A displaced body with the multiplier on its contact boundary. All of it must outlive the object.
 */
template <int dim>
struct BodyInContact : DisplacedBody<dim> {
  BodyInContact(const DisplacedBody<dim> &body, const MultiplierSpace<dim> &multipliers,
                const Multiplier &P)
    : DisplacedBody<dim>(body)
    , multipliers(multipliers)
    , P(P) {}

  const ContactSurface<dim> &surface() const {
    return multipliers.surface();
  }

  const MultiplierSpace<dim> &multipliers;
  const Multiplier &P;
};
} // namespace Signorini
