// SPDX-License-Identifier: LGPL-2.1-or-later
// The list of scenes known by name.

#include <signorini/problem/catalogue/catalogue.h>

#include <iomanip>
#include <map>
#include <sstream>

#include "catalogue_scenes.h"

namespace Signorini
{
template <>
const std::vector<CatalogueEntry<2>> &catalogue()
{
  static const std::vector<CatalogueEntry<2>> entries = {
    {"A1", "smooth manufactured contact on half of a side, exact solution known", make_a1},
    {"A1L", "as A1, with a gap that has a kink where contact ends", make_a1l},
    {"A2", "smooth manufactured contact in two zones, three transitions", make_a2},
    {"A3", "contact pressure with a kink where contact ends", make_a3},
    {"B1", "the true singularity of a contact end: square root pressure, flat foundation", make_b1},
    {"B1q", "as B1, contact ends at x = 1/2", make_b1q},
    {"B1t", "as B1, contact ends at x = 1/3", make_b1t},
    {"B2", "square root pressure at both ends of the contact zone, flat foundation", make_b2},
    {"B3", "Hertz' contact: elliptic pressure on a parabolic foundation", make_b3},
    {"B4", "a contact end with a stronger singularity, pressure like the fourth root", make_b4},
    {"C1", "full contact", make_c1},
    {"C2", "no contact", make_c2},
    {"C3", "touching without pressure on a part of the side", make_c3},
    {"C4", "contact on two sides that meet in a corner", make_c4},
    {"D1", "patch test: constant strain under full contact, exact on every mesh", make_patch_test},
    {"E1", "a ring pressed from all around: constant pressure on a circle (Lame)", make_e1},
    {"E2", "a ring in contact on a part of its outer circle", make_e2},
    {"E3", "a half disc in contact on a part of its arc", make_e3},
    {"O1", "the contact of A1 with a rotated orthotropic material", make_o1},
    {"V1", "the contact of A1 with a material that varies in space", make_v1},
    {"block on parabola",
     "elastic block pressed on a parabolic foundation, no exact solution",
     make_block_on_parabola}};
  return entries;
}

template <>
const std::vector<CatalogueEntry<3>> &catalogue()
{
  static const std::vector<CatalogueEntry<3>> entries = {
    {"D3", "in space: smooth contact on a disc, exact solution known", make_d3},
    {"V3", "in space: the contact of D3 with a material that varies in space", make_v3}};
  return entries;
}

std::string describe_catalogue()
{
  std::ostringstream text;
  text << std::left << std::setw(20) << "described"
       << "everything by the expressions of the parameter file\n";
  for (const CatalogueEntry<2> &entry : catalogue<2>())
    text << std::setw(20) << entry.name << entry.title << "\n";
  for (const CatalogueEntry<3> &entry : catalogue<3>())
    text << std::setw(20) << entry.name << entry.title << "\n";
  return text.str();
}

// The scenes of the catalogue in words and formulas.

namespace
{
const std::string unit_square = "Body      the unit square 0 < x < 1, 0 < y < 1\n";
const std::string lame = "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n";
const std::string manufactured =
  "Boundary  clamped at y = 1, contact at y = 0, traction sigma(u) n on x = 0 and x = 1\n"
  "Load      body force -div sigma(u)\n";

std::string line(const std::string &key, const std::string &text)
{
  return key + std::string(10 - key.size(), ' ') + text + "\n";
}

/** Returns the text of manufactured scenes with u1 = V, u2 = U on y = 0, see LiftFamily. */
std::string lift(const std::string &pressure, const std::string &slack)
{
  return unit_square + lame + manufactured +
         line("Gap", "-0.1 x (1-x)" + (slack.empty() ? "" : " + " + slack)) +
         "Exact u   u1 = (0.1 x^2 - y (0.1 - 0.2 x)) (1 - y^2),\n"
         "          u2 = (0.1 x (1-x) + y (p(x) - 0.2 x)/3) (1 - y^2)\n" +
         line("Exact p", pressure);
}

/** Returns the text of scenes from Westergaard's stress function Z and its integral. */
std::string westergaard(const std::string &Z,
                        const std::string &integral,
                        const std::string &pressure,
                        const std::string &gap)
{
  return unit_square + lame + manufactured + line("Gap", gap) +
         "Exact u   u1 = (1 - y^2) (Re Zh/2 - y Im Z)/2, u2 = (1 - y^2) (3 Im Zh/2 - y Re Z)/2\n" +
         line("Z", Z + " with z = x + i y") + line("Zh", "the integral of Z from " + integral) +
         line("Exact p", pressure);
}

std::string b1(const std::string &xi)
{
  return westergaard("i (z-xi)^(1/2), xi = " + xi + ",", "xi", "-(xi-x)_+^(1/2)", "0");
}

/** Returns the text of O1 and V1, the contact of A1 in other materials. */
std::string contact_of_a1(const std::string &material,
                          const std::string &displacement,
                          const std::string &pressure)
{
  return unit_square + material + manufactured +
         line("Gap", "-0.1 x (1-x) + (x-xi)_+^2, xi = 1/sqrt(2)") + displacement +
         line("Exact p", pressure);
}

std::string round_body(const std::string &body,
                       const std::string &boundary,
                       const std::string &load,
                       const std::string &gap,
                       const std::string &u,
                       const std::string &pressure)
{
  return line("Body", body + "; polar coordinates r, t") + lame + line("Boundary", boundary) +
         line("Load", load) + line("Gap", gap) + line("Exact u", u) + line("Exact p", pressure);
}

const std::string orthotropic =
  "Material  Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6, first axis at 30 degrees; in x, y:\n"
  "          C11 = 2.9625, C12 = 0.8375, C13 = 7.4 sqrt(3)/16, C22 = 1.5625, C23 = 3.8 "
  "sqrt(3)/16,\n"
  "          C33 = 0.9375 with the strains e11, e22, 2 e12\n";
const std::string lift_of_o1 =
  "Exact u   u1 = (V + y (c - U')) (1 - y^2), u2 = (U + y b) (1 - y^2), U = 0.1 x (1-x),\n"
  "          V = 0.1 x^2, b = (p - (C12 - C13 C23/C33) V')/(C22 - C23^2/C33),\n"
  "          c = -(C13 V' + C23 b)/C33\n";
const std::string varying =
  "Material  E = 2.5 m, nu = 0.25 (lambda = mu = m), m = 1 + sin(2x+y)/2, plane strain\n";
const std::string lift_of_v1 =
  "Exact u   u1 = (0.1 x^2 - y (0.1 - 0.2 x)) (1 - y^2),\n"
  "          u2 = (0.1 x (1-x) + y (p(x)/m(x,0) - 0.2 x)/3) (1 - y^2)\n";
const std::string corner =
  unit_square + lame +
  "Boundary  clamped at y = 1, contact at y = 0 and at x = 0 for y < 3/4, free at x = 0 for y > "
  "3/4,\n"
  "          traction sigma(u) n on x = 1\n"
  "Load      body force -div sigma(u)\n"
  "Gap       (x - 1/sqrt(2))_+^2 at the bottom, (y - 1/sqrt(3))_+^2 on the left\n"
  "Exact u   u1 = x p_left(y)/3, u2 = (y - y^3) (p_bottom(x) + 2)/3\n"
  "Exact p   p_bottom = -2 (1 - 2 x^2)_+^3, p_left = -6 (1 - 3 y^2)_+^3\n";
const std::string patch_test = unit_square + lame +
                               "Boundary  clamped at y = 1, contact at y = 0, traction (0.125, 0) "
                               "on x = 0 and (-0.125, 0) on x = 1\n"
                               "Load      none\n"
                               "Gap       -0.125\n"
                               "Exact u   u1 = 0, u2 = 0.125 (1-y)\n"
                               "Exact p   -0.375\n";
const std::string block =
  "Body      the block -1 < x < 1, 0 < y < 1\n"
  "Material  E = 1, nu = 0.3, plane strain\n"
  "Boundary  displacement (0, -0.05) at y = 1, contact at y = 0, free on x = -1 and x = 1\n"
  "Load      none\n"
  "Gap       x^2/4\n"
  "Exact u   not known\n";

/** Returns the text of scenes with the displacement of D3. */
std::string contact_on_disc(const std::string &modulus, const std::string &pressure)
{
  return line("Body", "the unit cube") + line("Material", "E = " + modulus + ", nu = 0.3") +
         line("Boundary",
              "clamped at z = 1, contact at z = 0, traction sigma(u) n on the upright sides") +
         line("Load", "body force -div sigma(u)") +
         line("Gap", "-a + (r-s)_+^2/2, a = -0.05 (1 + x (1-x) + y (1-y)), s = 1/e,") +
         "          r the distance from (0.5707106781186547, 0.4422649730810374)\n" +
         "Exact u   (-a_x B, -a_y B, a A + b B), A = (1-z)^2 (1+2z), B = z (1-z)^2,\n"
         "          b = -0.3 (1 - r^2/s^2)_+^3\n" +
         line("Exact p", pressure);
}
} // namespace

std::string describe_scene(const std::string &name)
{
  const std::string a_and_b = ", a = 1/sqrt(10), b = e/4";
  const std::string two_ends = "-2 ((x-a) (b-x))_+^(1/2)" + a_and_b;
  const std::string R = "R = (z-a)^(1/2) (z-b)^(1/2),";
  const std::string opening = "-u2(x,0) + (x-xi)_+/2";
  const std::map<std::string, std::string> descriptions = {
    {"A1", lift("-10 (xi-x)_+^3, xi = 1/sqrt(2)", "(x-xi)_+^2")},
    {"A1L", lift("-10 (xi-x)_+^3, xi = 1/sqrt(2)", "0.3 (x-xi)_+")},
    {"A2", lift("-2 q_+^3, q = sin(3 pi x + 1)", "0.2 (-q)_+^2")},
    {"A3",
     westergaard("-(2 i/pi) (z-xi) log(z-xi), xi = 1/sqrt(2),", "xi", "-2 (xi-x)_+", opening)},
    {"B1", b1("1/sqrt(2)")},
    {"B1q", b1("1/2")},
    {"B1t", b1("1/3")},
    {"B2", westergaard("2 i R, " + R, "b", two_ends, "0")},
    {"B3",
     westergaard("2 i (R - (z-m)), m = (a+b)/2, " + R,
                 "b, minus i (b-a)^2/4",
                 two_ends,
                 "3/4 (x-m)^2, m = (a+b)/2")},
    {"B4", westergaard("2 i (z-xi)^(1/4), xi = 1/2,", "xi", "-sqrt(2) (xi-x)_+^(1/4)", opening)},
    {"C1", lift("-(2 + cos(pi x))", "")},
    {"C2", lift("0", "0.1")},
    {"C3", lift("-10 (xi1-x)_+^3, xi1 = (sqrt(5)-1)/4, xi = 1/sqrt(2)", "(x-xi)_+^2")},
    {"C4", corner},
    {"D1", patch_test},
    {"D3", contact_on_disc("1", "(lambda + 2 mu) b")},
    {"E1",
     round_body("the ring 1 < r < 2",
                "clamped at r = 1, contact at r = 2",
                "none",
                "-0.1",
                "u_r = -(r - 1/r)/15, u_t = 0",
                "-0.3")},
    {"E2",
     round_body("the ring 1 < r < 2",
                "clamped at r = 1, contact at r = 2",
                "body force -div sigma(u)",
                "0.05 cos 2t + 0.5 (0.3 - cos t)_+^2",
                "with s = r - 2, U = 0.05 cos 2t, V = 0.1 sin t:\n"
                "          u_r = (U + s (p - (U + V')/2)/3) (1 - s^2),\n"
                "          u_t = (V + s (V - U')/2) (1 - s^2)",
                "-3 (cos t - 0.3)_+^3")},
    {"E3",
     round_body("the half disc r < 1, y < 0",
                "clamped at y = 0, contact at r = 1",
                "body force -div sigma(u)",
                "0.5 (0.6 + sin t)_+^2",
                "u_r = r^4 (r-1) p(t)/3, u_t = 0",
                "-20 (-sin t - 0.6)_+^3")},
    {"O1", contact_of_a1(orthotropic, lift_of_o1, "-10 (xi-x)_+^3")},
    {"V1", contact_of_a1(varying, lift_of_v1, "-10 m(x,0) (xi-x)_+^3")},
    {"V3", contact_on_disc("1 + x/2 + y z", "(lambda + 2 mu) b with lambda and mu at the point")},
    {"block on parabola", block}};
  return descriptions.at(name);
}
} // namespace Signorini
