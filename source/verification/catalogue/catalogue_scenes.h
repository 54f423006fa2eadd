// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/verification/catalogue/catalogue.h>

namespace Signorini {
/** Returns the scenes on the unit square with fields of polynomials and trigonometric functions,
 * and the block on a parabola. */
std::vector<CatalogueEntry<2>> smooth_scenes();
/** Returns the scenes with fields of complex functions. */
std::vector<CatalogueEntry<2>> singular_scenes();
/** Returns the scenes of round bodies. */
std::vector<CatalogueEntry<2>> round_scenes();

/** lambda = mu = 1, and the body force of the exact solution. */
const std::string lame_material =
  "Material  E = 2.5; nu = 0.25\n"
  "With      s11 = 3*dx(u1) + dy(u2); s22 = dx(u1) + 3*dy(u2); s12 = dy(u1) + dx(u2)\n";
const std::string exact_load = "Load      -dx(s11) - dy(s12); -dx(s12) - dy(s22)\n";
const std::string unit_square = "Body      the unit square\n"
                                "Boundary  clamped: top; contact: bottom; traction: left, right\n";
} // namespace Signorini
