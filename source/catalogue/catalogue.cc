// SPDX-License-Identifier: LGPL-2.1-or-later
// The list of scenes known by name.

#include <signorini/catalogue/catalogue.h>

#include <iomanip>
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
} // namespace Signorini
