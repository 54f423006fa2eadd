// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/multiplier/multiplier_space.h>

#include <vector>

namespace Signorini
{
/**
 * The active cells with a contact face on which the body penetrates the foundation although no
 * multiplier there or on a neighbouring face presses: the nodes of the multipliers have missed the
 * contact. Where nothing presses at all, every penetration counts, else those deeper than a
 * thousandth of the largest |u_n - g|. @throws InputError where g has no value.
 */
std::vector<unsigned int> unseen_contact(const DisplacementSpace<2> &space,
                                         const MultiplierSpace<2> &multipliers,
                                         const NodalVector &U,
                                         const dealii::Vector<double> &P);
} // namespace Signorini
