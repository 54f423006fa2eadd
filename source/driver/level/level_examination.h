// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>

namespace Signorini
{
/** What is known about a level, and the parts of its bound by cell. */
struct Examination
{
  LevelRecord record;
  /** Empty where record.bound is. */
  BoundFields bound_fields;
};

/** What follows from U and P: beta, the certificate, the answer, and the estimate and the bound of
 * the error, as far as they are asked for. @param scene with plates where they have moved to.
 * Collective. */
template <int dim>
Examination examine(const Parameters &parameters,
                    const Discretization<dim> &discretization,
                    const Scene<dim> &scene,
                    const ContactState<dim> &contact,
                    const Progress &progress);
} // namespace Signorini
