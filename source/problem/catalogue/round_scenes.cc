// SPDX-License-Identifier: LGPL-2.1-or-later
// E1, E2: rings with contact on the whole outer circle; E3: a half disc with contact on its arc.

#include "catalogue_scenes.h"

namespace Signorini {
namespace {
const std::string ring = lame_material + "Body      the ring 1 < r < 2\n"
                                         "Boundary  clamped: inner; contact: outer\n";
/** Polar coordinates. */
const std::string polar = "With      r = sqrt(x^2+y^2); c = x/r; s = y/r\n";
} // namespace

std::vector<CatalogueEntry<2>> round_scenes() {
  return {{"E1", "a ring pressed from all around: constant pressure on a circle (Lame)",
           // Lame's solution: p = 2 (lambda + mu) a + 2 mu a R1²/R2² with a = -1/15.
           ring + "Load      none\n"
                  "Gap       -0.1\n"
                  "Exact u   x*(1/(x^2+y^2)-1)/15; y*(1/(x^2+y^2)-1)/15\n"
                  "Exact p   -0.3\n"},
          {"E2", "a ring in contact on a part of its outer circle",
           // sigma_rr = p and sigma_rt = 0 at r = 2.
           ring + exact_load + polar +
             "Gap       U + 0.5*max(0.3-c,0)^2\n"
             "Exact u   ur*c - ut*s; ur*s + ut*c\n"
             "Exact p   -3*max(c-0.3,0)^3\n"
             "Kinks     t = acos(0.3); t = -acos(0.3)\n"
             "With      U = 0.05*(c^2-s^2); dU = -0.2*s*c; V = 0.1*s; dV = 0.1*c;\n"
             "          ur = (U + (r-2)*(p-(U+dV)/2)/3)*(1-(r-2)^2);\n"
             "          ut = (V + (r-2)*(V-dU)/2)*(1-(r-2)^2)\n"},
          {"E3", "a half disc in contact on a part of its arc",
           // The field is zero near the line y = 0, where r may be zero.
           lame_material + exact_load + polar +
             "Body      the half disc r < 1, y < 0\n"
             "Boundary  clamped: flat; contact: arc\n"
             "Gap       0.5*max(0.6+s,0)^2\n"
             "Exact u   y < 0 ? x*share : 0; y < 0 ? y*share : 0\n"
             "Exact p   -20*max(-s-0.6,0)^3\n"
             "Kinks     t = -asin(0.6); t = asin(0.6)\n"
             "With      share = r^3*(r-1)*p/3\n"}};
}
} // namespace Signorini
