// SPDX-License-Identifier: LGPL-2.1-or-later
// The names of all options.

#include <signorini/problem/parameters/options.h>

#include <map>

namespace Signorini {
const std::vector<std::string> &option_names(const std::type_index &option) {
  static const std::map<std::type_index, std::vector<std::string>> names = {
    {typeid(Shape),
     {"rectangle", "box", "polygon", "half disc", "disc", "ring", "ball", "cylinder", "tube",
      "file"}},
    {typeid(Sector), {"whole", "half", "quarter", "octant"}},
    {typeid(Axis), {"x", "y", "z"}},
    {typeid(MaterialLaw), {"isotropic", "orthotropic", "general"}},
    {typeid(PlaneState), {"strain", "stress", "axisymmetric"}},
    {typeid(Strategy), {"automatic", "nested", "hp"}},
    {typeid(Element), {"Q1", "Q1 B-bar", "Q2"}},
    {typeid(ContactSolver), {"automatic", "psor", "active set", "multigrid"}},
    {typeid(LinearSolver), {"automatic", "condensed", "amesos_mumps", "amesos_klu", "multigrid"}},
    {typeid(ContactDirection), {"foundation", "body"}},
    {typeid(Friction), {"none", "tresca", "coulomb"}},
    {typeid(CaseSequence), {"independent", "steps"}},
    {typeid(VtuLevels), {"none", "finest", "all"}},
    {typeid(Choice), {"true", "false", "automatic"}},
    {typeid(WantedBound), {"automatic", "false"}}};
  return names.at(option);
}
} // namespace Signorini
