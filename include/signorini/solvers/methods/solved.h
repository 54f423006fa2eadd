// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/discretization.h>
#include <signorini/discretization/space/displaced_body.h>
#include <signorini/solvers/methods/contact_solution.h>

namespace Signorini {
/** A solved level, or a load case on it: the discretization, the scene and the contact that was
 * found. All of it is const and must outlive the object. */
template <int dim>
struct Solved : BodyInContact<dim> {
  Solved(const Discretization<dim> &discretization, const Scene<dim> &scene,
         const ContactSolution &contact)
    : BodyInContact<dim>({discretization.space, scene, contact.U}, discretization.multipliers,
                         contact.P)
    , discretization(discretization)
    , contact(contact) {}

  const Discretization<dim> &discretization;
  const ContactSolution &contact;
};
} // namespace Signorini
