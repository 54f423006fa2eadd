// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/named_scene.h>

#include <string>
#include <vector>

namespace Signorini {
/**
 * A scene with a name in the program. Its description lists the parts of the scene, in lines of
 * text that begin with a word in ten columns; lines that begin with blanks continue:
 *
 *     Body        one of the bodies of catalogue.cc
 *     Material    E = ...; nu = ... in plane strain, or Q11; Q22; Q12; Q66; the angle of the axes
 *     Boundary    a role and its sides; ... The tractions are those of the exact solution
 *     Load        the body force; or none
 *     Gap         g; on another side the words "left gap", and "left p" for p
 *     Friction    tresca: s, or coulomb: f
 *     Moves       the given displacement of a side, or the tangential motion of the foundation
 *     Exact u     u1; u2. Exact p, Exact q: normal and tangential traction
 *     Kinks       x = ...; y = ...; t = ... (the angle of a line through the origin)
 *     With        definitions (FormulaTree) of names in the other lines; u1, u2, p and q are known
 */
template <int dim>
struct CatalogueEntry {
  std::string name;
  std::string title;
  std::string description;

  Scene<dim> make() const;
};

/** Returns all 2-D or 3-D scenes with a name. */
template <int dim>
const std::vector<CatalogueEntry<dim>> &catalogue();
template <>
const std::vector<CatalogueEntry<2>> &catalogue();
template <>
const std::vector<CatalogueEntry<3>> &catalogue();

/** Returns the scene CM, Hertz' pressure with stick and slip; or the state after some of the
 * tangential load is taken back, which follows the slip of CM (Mindlin and Deresiewicz). */
CatalogueEntry<2> cattaneo_mindlin(bool unloaded);

/** Returns the scenes of the catalogue for make_scene(). */
NamedScenes named_scenes();

/** Returns one line per scene: name and title. */
std::string describe_catalogue();
} // namespace Signorini
