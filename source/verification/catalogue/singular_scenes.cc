// SPDX-License-Identifier: LGPL-2.1-or-later
// A3, B1, B1q, B1t, B2, B3, B4: Westergaard's fields, singular where contact ends. TS, KS, KSr, KO,
// KOr, CM: the same with friction, singular where stick, slip or contact ends.

#include <signorini/base/text.h>

#include "catalogue_scenes.h"

namespace Signorini {
namespace {
/**
 * Fields u = (1 - y²) w on the unit square, contact at y = 0, lambda = mu = 1. With kappa = 2 and a
 * complex function F = fr + i fi of x + iy, w is a sum of fields with -div sigma(w) = 0:
 *
 *     2 w1 = (kappa-c) Re F - 2 y Im F',   2 w2 = (kappa+c) Im F - 2 y Re F'.
 *
 * On y = 0:  c = 1: s22 = 2 Re F', s12 = 0;   c = -1: s12 = -2 Im F', s22 = 0;
 * c = -kappa (a roller: u2 = 0): s12 = -(kappa+1) Im F', s22 = (1-kappa) Re F'.
 * On the branch cut y = 0 the value from above is meant: Y is not -0.
 */
const std::string field =
  unit_square +
  "Material  E = 2.5; nu = 0.25\n"
  "Load      2*y*(dy(w1) + dx(w2)) + dx(2*y*w2) + dy(2*y*w1);\n"
  "          2*y*(dx(w1) + 3*dy(w2)) + dx(2*y*w1) + dy(6*y*w2)\n"
  "Exact u   (1-y^2)*w1; (1-y^2)*w2\n"
  "With      Y = max(y,0); R(a,b) = sqrt(a^2+b^2);\n"
  "          arg(a,b) = R(a,b) == 0 ? 0 : a > 0 ? 2*atan(b/(R(a,b)+a)) : pi-2*atan(b/(R(a,b)-a))\n";
const std::string beginning = "With      w1 = fr/2 - Y*gi; w2 = 3/2*fi - Y*gr\n";

/** F' = g re + i g im, a multiple of t^e with t = X + iY, singular at xi. */
const std::string power =
  field +
  "Kinks     x = xi\n"
  "With      X = x-xi; re = R(X,Y)^e*cos(e*arg(X,Y)+alpha); im = R(X,Y)^e*sin(e*arg(X,Y)+alpha);\n"
  "          fr = (X*gr - Y*gi)/(1+e); fi = (X*gi + Y*gr)/(1+e)\n";
const std::string at_half = "With      xi = 1/2\n", at_root = "With      xi = 1/sqrt(2)\n";

/** Westergaard's Z = 2 F' = i t^(1/2): the true singularity of a contact end. */
const std::string b1 = power + beginning +
                       "Gap       0\n"
                       "Exact p   -sqrt(max(xi-x,0))\n"
                       "With      gr = -im/2; gi = re/2; e = 1/2; alpha = 0\n";

/** F = i (t R - c² log((t+R)/c))/2 with t = a + ib, R = G + iH = (t-c)^(1/2) (t+c)^(1/2): F' = i R.
 * Hertz' contact: F' = i (R - t). */
const std::string two_ends =
  field +
  "With      X = x-m; m = (x1+x2)/2; rho = (x2-x1)/2; x1 = 1/sqrt(10); x2 = exp(1)/4;\n"
  "          G(a,b,c) = sqrt(R(a-c,b)*R(a+c,b))*cos((arg(a-c,b)+arg(a+c,b))/2);\n"
  "          H(a,b,c) = sqrt(R(a-c,b)*R(a+c,b))*sin((arg(a-c,b)+arg(a+c,b))/2);\n"
  "          re(a,b,c) = (c^2*arg(a+G(a,b,c),b+H(a,b,c)) - a*H(a,b,c) - b*G(a,b,c))/2;\n"
  "          im(a,b,c) = (a*G(a,b,c) - b*H(a,b,c) - c^2*log(R(a+G(a,b,c),b+H(a,b,c))/c))/2\n";
const std::string between_two_ends = two_ends + beginning +
                                     "Exact p   -2*sqrt(max((x-x1)*(x2-x),0))\n"
                                     "Kinks     x = x1; x = x2\n";
const std::string hertz =
  "With      hr(a,b,c) = re(a,b,c) + a*b; hi(a,b,c) = im(a,b,c) - (a^2-b^2)/2;\n"
  "          kr(a,b,c) = b - H(a,b,c); ki(a,b,c) = G(a,b,c) - a;\n"
  "          fr = hr(X,Y,rho); fi = hi(X,Y,rho); gr = kr(X,Y,rho); gi = ki(X,Y,rho)\n";

/** Stick before xi and slip behind it, with constant stresses s22 and s12. */
const std::string stick_and_slip = power +
                                   "Gap       0\n"
                                   "With      w1 = 2*fr - Y*gi + s12*y; w2 = s22*y/3 - Y*gr\n";
const std::string stick_by_bound =
  stick_and_slip + "Friction  tresca: 1\n"
                   "Exact p   -1 - 3/4*sqrt(max(x-xi,0))\n"
                   "Exact q   -1 + 9/4*sqrt(max(xi-x,0))\n"
                   "With      gr = 3/4*re; gi = 3/4*im; e = 1/2; alpha = 0; s22 = -1; s12 = 1\n";
/** With e = 1/2 - alpha/pi, Re F = 0 on the side of stick. The sign is 1 for slip away from the
 * zone of stick, -1 for slip towards it. */
const std::string stick_by_pressure =
  stick_and_slip + at_root +
  "Friction  coulomb: 0.5\n"
  "Exact p   -2 - A*cos(alpha)*max(x-xi,0)^e\n"
  "Exact q   sign*0.5*p + 3*A*max(xi-x,0)^e\n"
  "With      gr = A*re; gi = A*im; A = 0.3*sign*(1+e); alpha = -sign*atan(0.5/3);\n"
  "          e = 1/2 - alpha/pi; s22 = -2; s12 = sign\n";
/** Sliding before xi, open behind it. The body moves on by 0.6, so that all of it slides. */
const std::string sliding =
  power + at_root +
  "Gap       0\n"
  "Friction  coulomb: 0.5\n"
  "Exact p   -sin(pi*e)*max(xi-x,0)^e\n"
  "Exact q   sign*0.5*p\n"
  "With      gr = -im/2; gi = re/2; e = 1/2 - sign*atan(0.5/3)/pi; alpha = 0;\n"
  "          w1 = fr/2 - Y*gi - sign*0.5*(3/2*fi + Y*gr) + sign*0.6;\n"
  "          w2 = 3/2*fi - Y*gr + sign*0.5*(fr/2 + Y*gi)\n";
const std::string forwards = "With      sign = 1\n", backwards = "With      sign = -1\n";
} // namespace

CatalogueEntry<2> cattaneo_mindlin(const bool unloaded) {
  // q is the sum of Hertz' pressures on shares of the width.
  struct Part {
    std::string weight, radius;
  };
  std::vector<Part> parts = {{"1", "rho"}, {"-1", "0.6*rho"}};
  if (unloaded)
    parts = {{"-1", "rho"}, {"2", "0.85*rho"}, {"-1", "0.6*rho"}};
  std::vector<std::string> kinks;
  for (const Part &part : parts)
    kinks.push_back("x = m-" + part.radius + "; x = m+" + part.radius);
  const auto sum = [&](const std::string &before, const std::string &behind) {
    std::vector<std::string> terms;
    for (const Part &part : parts)
      terms.push_back(part.weight + "*" + before + part.radius + behind);
    return join(terms, " + ");
  };
  // The foundation takes the coupling of both modes.
  return {"CM", "Cattaneo's and Mindlin's contact: Hertz' pressure with stick and slip",
          two_ends + hertz +
            "Gap       3/4*X^2 + 0.2*Sr\n"
            "Friction  coulomb: 0.4\n"
            "Moves     fr/2 + 0.6*S0\n"
            "Exact p   -2*sqrt(max(rho^2-X^2,0))\n"
            "Exact q   0.8*(" +
            sum("sqrt(max((", ")^2-X^2,0))") +
            ")\n"
            "With      w1 = fr/2 - Y*gi + 0.4*(3/2*Si + Y*Tr);\n"
            "          w2 = 3/2*fi - Y*gr - 0.4*(Sr/2 + Y*Ti);\n"
            "          Sr = " +
            sum("hr(X,Y,", ")") + ";\n          Si = " + sum("hi(X,Y,", ")") +
            ";\n          Tr = " + sum("kr(X,Y,", ")") +
            ";\n          Ti = " + sum("ki(X,Y,", ")") +
            ";\n          S0 = " + sum("hi(0,0,", ")") + "\nKinks     " + join(kinks, "; ") + "\n"};
}

std::vector<CatalogueEntry<2>> singular_scenes() {
  return {
    {"A3", "contact pressure with a kink where contact ends",
     field + beginning + at_root +
       "Gap       max(x-xi,0)/2 - u2\n"
       "Exact p   -2*max(xi-x,0)\n"
       "Kinks     x = xi\n"
       "With      X = x-xi; L = R(X,Y) == 0 ? 0 : log(R(X,Y)); t = arg(X,Y);\n"
       "          fr = ((X^2-Y^2)*t/2 + X*Y*L - X*Y/2)/pi;\n"
       "          fi = (X*Y*t + (X^2-Y^2)*(1/4 - L/2))/pi;\n"
       "          gr = (X*t + Y*L)/pi; gi = (Y*t - X*L)/pi\n"},
    {"B1", "the true singularity of a contact end: square root pressure, flat foundation",
     b1 + at_root},
    // The transition is always in the middle of its patch (patches odd in number).
    {"B1q", "as B1, contact ends at x = 1/2", b1 + at_half},
    // The transition is one or two thirds into its patch on every level.
    {"B1t", "as B1, contact ends at x = 1/3", b1 + "With      xi = 1/3\n"},
    {"B2", "square root pressure at both ends of the contact zone, flat foundation",
     between_two_ends +
       "Gap       0\n"
       "With      fr = re(X,Y,rho); fi = im(X,Y,rho); gr = -H(X,Y,rho); gi = G(X,Y,rho)\n"},
    {"B3", "Hertz' contact: elliptic pressure on a parabolic foundation",
     between_two_ends + hertz + "Gap       3/4*X^2\n"},
    {"B4", "a contact end with a stronger singularity, pressure like the fourth root",
     power + beginning + at_half +
       "Gap       max(x-xi,0)/2 - u2\n"
       "Exact p   -sqrt(2)*max(xi-x,0)^0.25\n"
       "With      gr = -im; gi = re; e = 1/4; alpha = 0\n"},
    {"TS", "Tresca's friction: the true singularity between stick and slip",
     stick_by_bound + at_root},
    {"TSq", "as TS, stick ends at x = 1/2", stick_by_bound + at_half},
    {"KS", "Coulomb's friction: slip away from the zone of stick", stick_by_pressure + forwards},
    {"KSr", "Coulomb's friction: slip towards the zone of stick", stick_by_pressure + backwards},
    {"KO", "Coulomb's friction: sliding contact ends", sliding + forwards},
    {"KOr", "Coulomb's friction: sliding contact ends, the other direction", sliding + backwards},
    cattaneo_mindlin(false)};
}
} // namespace Signorini
