// SPDX-License-Identifier: LGPL-2.1-or-later
// E1, E2: rings with contact on the whole outer circle; E3: a half disc with contact on its arc.
// R1, R2: cylinders, bodies of revolution about x = 0.

#include "catalogue_scenes.h"

namespace Signorini {
namespace {
const std::string ring = lame_material + "Body      the ring 1 < r < 2\n"
                                         "Boundary  clamped: inner; contact: outer\n";
/** Polar coordinates. */
const std::string polar = "With      r = sqrt(x^2+y^2); c = x/r; s = y/r\n";
/** The displacement that lifts boundary data from y = 0 as in smooth_scenes.cc, and the load with
 * the hoop stress stt; U and V/x are even functions of x. */
const std::string cylinder =
  "Body      the unit cylinder\n"
  "Boundary  clamped: top; contact: bottom; traction: right\n"
  "Material  E = 2.5; nu = 0.25\n"
  "Load      -dx(srr) - dy(sry) - (srr-stt)/x; -dx(sry) - dy(syy) - sry/x\n"
  "Exact u   (V - y*dx(U))*(1-y^2); (U + y*b)*(1-y^2)\n"
  "With      trace = dx(u1) + dy(u2) + u1/x; srr = trace + 2*dx(u1); syy = trace + 2*dy(u2);\n"
  "          stt = trace + 2*u1/x; sry = dy(u1) + dx(u2); v = 0.1 - 0.06*x^2; V = x*v;\n"
  "          U = 0.05 + 0.1*x^2 - 0.08*x^4; b = (p - dx(V) - v)/3\n";
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
             "With      share = r^3*(r-1)*p/3\n"},
          {"R1", "a cylinder in full contact on its end, exact solution known",
           cylinder + "Gap       -U\n"
                      "Exact p   -2 - cos(pi*x)\n"},
          {"R2", "a cylinder in contact on a disc of its end, exact solution known",
           cylinder + "Gap       max(x-xi,0)^2 - U\n"
                      "Exact p   -10*max(xi^2-x^2,0)^3\n"
                      "Kinks     x = xi\n"
                      "With      xi = 1/sqrt(2)\n"}};
}
} // namespace Signorini
