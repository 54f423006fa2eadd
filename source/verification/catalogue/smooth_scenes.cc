// SPDX-License-Identifier: LGPL-2.1-or-later
// A1, A1L, A2, C1 to C4, D1, O1, V1: manufactured solutions on the unit square, contact at y = 0.
// T1 to T4, K1: the same with friction.

#include "catalogue_scenes.h"

namespace Signorini {
namespace {
/**
 * The displacement that lifts boundary data from y = 0 into the square,
 *
 *     u1 = (V + y (gamma - U')) c(y),   u2 = (U + y b) c(y),   c(y) = 1 - y^2,
 *     b = (p - C12* V') / C22*,         gamma = (q - C13 V' - C23 b) / C33,
 *     C22* = C22 - C23^2 / C33,         C12* = C12 - C13 C23 / C33,
 *     U = 0.1 x (1 - x),                V = 0.1 x^2,
 *
 * for Hooke's tensor m(x, y) C with C constant in Voigt's notation. It gives sigma_22 = m(x, 0) p
 * and sigma_12 = m(x, 0) q on y = 0. With the gap g = -U + s, s >= 0 where p = 0 and s = 0 where p
 * < 0, all conditions of (1) hold.
 */
const std::string lifted = "Exact u   (0.1*x^2 - y*(0.1-0.2*x))*(1-y^2);\n"
                           "          (0.1*x*(1-x) + y*(p-0.2*x)/3)*(1-y^2)\n";
const std::string square_lifted = unit_square + lame_material + exact_load + lifted;
const std::string of_a1 = "Gap       max(x-xi,0)^2 - 0.1*x*(1-x)\n"
                          "Kinks     x = xi\n"
                          "With      xi = 1/sqrt(2)\n";
const std::string p_of_a1 = "Exact p   -10*max(xi-x,0)^3\n";

const std::string tangential_part = unit_square + lame_material + exact_load +
                                    "Exact u   (V - y*(q + dx(U)))*(1-y^2);\n"
                                    "          (U + y*(p - dx(V))/3)*(1-y^2)\n"
                                    "With      U = 0.1*x*(1-x)\n";
const std::string given_bound = "Friction  tresca: s\n"
                                "With      s = 0.5 + 0.3*x\n";
const std::string full_contact = "Gap       -U\n"
                                 "Exact p   -2 - cos(pi*x)\n";
const std::string ending_contact = "Gap       max(x-xi,0)^2 - U\n"
                                   "Exact p   -10*max(xi-x,0)^3\n"
                                   "Kinks     x = xs; x = xi\n"
                                   "With      xi = 1/sqrt(2)\n";
const std::string ending_stick = "Exact q   10*max(xs-x,0)^3 - s\n"
                                 "With      xs = 1/sqrt(5); V = max(x-xs,0)^4\n";
} // namespace

std::vector<CatalogueEntry<2>> smooth_scenes() {
  return {{"A1", "smooth manufactured contact on half of a side, exact solution known",
           square_lifted + of_a1 + p_of_a1},
          {"A1L", "as A1, with a gap that has a kink where contact ends",
           square_lifted + p_of_a1 +
             "Gap       0.3*max(x-xi,0) - 0.1*x*(1-x)\n"
             "Kinks     x = xi\n"
             "With      xi = 1/sqrt(2)\n"},
          {"A2", "smooth manufactured contact in two zones, three transitions",
           square_lifted + "Gap       0.2*min(Q,0)^2 - 0.1*x*(1-x)\n"
                           "Exact p   -2*max(Q,0)^3\n"
                           "Kinks     x = (1-1/pi)/3; x = (2-1/pi)/3; x = (3-1/pi)/3\n"
                           "With      Q = sin(3*pi*x+1)\n"},
          {"C1", "full contact",
           square_lifted + "Gap       -0.1*x*(1-x)\n"
                           "Exact p   -2 - cos(pi*x)\n"},
          {"C2", "no contact",
           square_lifted + "Gap       0.1 - 0.1*x*(1-x)\n"
                           "Exact p   0\n"},
          {"C3", "touching without pressure on a part of the side",
           square_lifted + "Gap       max(x-xi,0)^2 - 0.1*x*(1-x)\n"
                           "Exact p   -10*max(xi1-x,0)^3\n"
                           "Kinks     x = xi1; x = xi\n"
                           "With      xi1 = (sqrt(5)-1)/4; xi = 1/sqrt(2)\n"},
          {"C4", "contact on two sides that meet in a corner",
           lame_material + exact_load +
             "Body      the unit square, left side up to y = 3/4\n"
             "Boundary  clamped: top; contact: bottom, left; traction: right\n"
             "Gap       max(x-xi,0)^2\n"
             "left gap  max(y-eta,0)^2\n"
             "Exact u   -x*bump(6,3,y)/3; (y-y^3)*(2-bump(2,2,x))/3\n"
             "Exact p   -bump(2,2,x)\n"
             "left p    -bump(6,3,y)\n"
             "Kinks     x = xi; y = eta\n"
             "With      xi = 1/sqrt(2); eta = 1/sqrt(3); bump(a,b,c) = a*max(1-b*c^2,0)^3\n"},
          {"D1", "patch test: constant strain under full contact, exact on every mesh",
           unit_square + lame_material +
             "Load      none\n"
             "Gap       -0.125\n"
             "Exact u   0; 0.125*(1-y)\n"
             "Exact p   -0.375\n"},
          {"O1", "the contact of A1 with a rotated orthotropic material",
           unit_square + exact_load + of_a1 + p_of_a1 +
             "Material  Q11 = 4; Q22 = 1.2; Q12 = 0.5; Q66 = 0.6; degrees = 30\n"
             "Exact u   (0.1*x^2 + y*(gamma-0.1+0.2*x))*(1-y^2); (0.1*x*(1-x) + y*beta)*(1-y^2)\n"
             "With      beta = (p - (C12-C13*C23/C33)*0.2*x)/(C22-C23^2/C33);\n"
             "          gamma = -(C13*0.2*x + C23*beta)/C33;\n"
             "          C11 = 2.9625; C12 = 0.8375; C13 = 7.4*sqrt(3)/16; C22 = 1.5625;\n"
             "          C23 = 3.8*sqrt(3)/16; C33 = 0.9375; e11 = dx(u1); e22 = dy(u2);\n"
             "          g12 = dy(u1) + dx(u2); s11 = C11*e11 + C12*e22 + C13*g12;\n"
             "          s22 = C12*e11 + C22*e22 + C23*g12; s12 = C13*e11 + C23*e22 + C33*g12\n"},
          {"V1", "the contact of A1 with a material that varies in space",
           unit_square + exact_load + of_a1 +
             "Material  E = 2.5*(1+0.5*sin(2*x+y)); nu = 0.25\n"
             "Exact u   (0.1*x^2 - y*(0.1-0.2*x))*(1-y^2);\n"
             "          (0.1*x*(1-x) + y*(pm-0.2*x)/3)*(1-y^2)\n"
             "Exact p   (1+0.5*sin(2*x))*pm\n"
             "With      pm = -10*max(xi-x,0)^3; m = 1+0.5*sin(2*x+y); s12 = m*(dy(u1) + dx(u2));\n"
             "          s11 = m*(3*dx(u1) + dy(u2)); s22 = m*(dx(u1) + 3*dy(u2))\n"},
          {"T1", "Tresca's friction: smooth stick, slip and opening",
           tangential_part + ending_contact + given_bound + ending_stick},
          {"T2", "Tresca's friction: smooth stick and slip",
           tangential_part + full_contact + given_bound + ending_stick + "Kinks     x = xs\n"},
          {"T3", "Tresca's friction: slip everywhere",
           tangential_part + full_contact + given_bound +
             "Exact q   -s\n"
             "With      V = 0.1 + 0.05*sin(x)\n"},
          {"T4", "Tresca's friction: stick everywhere",
           tangential_part + full_contact + given_bound +
             "Exact q   0.4*cos(2*x)\n"
             "With      V = 0\n"},
          {"K1", "Coulomb's friction: smooth stick, slip and opening",
           tangential_part + ending_contact + ending_stick +
             "Friction  coulomb: 0.3\n"
             "With      s = -0.3*p\n"},
          {"block on parabola",
           "elastic block pressed on a parabolic foundation, no exact solution",
           "Body      the block -1 < x < 1, 0 < y < 1\n"
           "Material  E = 1; nu = 0.3\n"
           "Boundary  displacement: top; contact: bottom\n"
           "Load      none\n"
           "Moves     0; -0.05\n"
           "Gap       x^2/4\n"
           "Exact u   none\n"}};
}
} // namespace Signorini
