// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/catalogue/catalogue.h>

namespace Signorini {
/** Returns the scenes on the unit square with fields of polynomials and trigonometric functions,
 * and the block on a parabola. */
std::vector<CatalogueEntry<2>> square_scenes();
/** Returns the scenes of Westergaard's stress function. */
std::vector<CatalogueEntry<2>> westergaard_scenes();
/** Returns the scenes with friction. */
std::vector<CatalogueEntry<2>> friction_scenes();
/** Returns the scenes of round bodies. */
std::vector<CatalogueEntry<2>> round_scenes();
} // namespace Signorini
