// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes and patches that miss details of the solution: the bound of the energy error holds
// nevertheless, and shows that the answer is worth nothing.
//
// The reference is u_f in V^h of a much finer mesh, nested in that of u_h. |||u_f - u_h||| is not
// above |||u - u_h||| where nothing touches, or the same points touch (a(u - u_f, u_f - u_h) = 0),
// and elsewhere up to |||u - u_f|||.

#include <signorini/discretization/space/internal_forces.h>

#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <memory>

#include "bounded.h"
#include "tests.h"
#include "unresolved_scenes.h"

using namespace Signorini;

namespace {
/** u_f, with a(.,.) of the conforming element. */
struct Reference {
  Reference(const std::string &text, const unsigned int number)
    : level(text, number)
    , space(level.discretization.mesh, level.scene)
    , U(level.solve().contact.U)
    , energy(square(U)) {}
  double square(const Displacement &V) const {
    const DualVector forces = internal_forces(DisplacedBody(space, level.scene, V)).forces;
    return std::max(0., V * forces);
  }

  OneLevel level;
  DisplacementSpace<2> space;
  Displacement U;
  double energy;
};

std::string text_of(const Unresolved::Given &given) {
  const bool names_contact = given.scene.find("Boundary/Contact") != std::string::npos;
  return given.scene + (names_contact ? "" : "Boundary/Contact = bottom\n");
}

/** A row of bound_unresolved.csv. */
void check(Checks &checks, std::ofstream &table, const Unresolved::Given &given,
           const Reference &fine, const unsigned int number) {
  const Bounded level(text_of(given) + given.discretization, number);
  Displacement on_fine(fine.U);
  dealii::VectorTools::interpolate_to_different_mesh(
    level.space().dofs(), level.solution.contact.U.entries(), fine.space.dofs(), on_fine.entries());
  Displacement difference(fine.U);
  difference -= on_fine;
  const double error = std::sqrt(fine.square(difference)), energy = fine.square(on_fine);
  const ErrorBound &bound = level.bound;
  const double relative = bound.relative.value_or(1e30),
               absolute = bound.absolute.value_or(1e10 * error);
  checks.about(given.name + ", level " + std::to_string(number));
  checks.between("bound / error", absolute / error, 0.98, given.largest);
  checks.that("not certified",
              std::abs(energy - fine.energy) <= 0.05 * fine.energy || relative > 0.2);
  table << '"' << given.name << "\"," << number << ',' << std::setprecision(3)
        << error / std::sqrt(fine.energy) << ',';
  if (bound.relative)
    table << relative << ',' << absolute / error;
  else
    table << ',';
  table << ',' << energy / fine.energy << std::endl;
}

void unresolved(Checks &checks) {
  std::ofstream table("bound_unresolved.csv");
  table << "scene,level,error_over_u,bound_relative,bound_over_error,energy_over_reference\n";
  Unresolved::Scenes scenes;
  for (const auto &add :
       {Unresolved::add_missed_contact, Unresolved::add_bending, Unresolved::add_fine_data,
        Unresolved::add_fine_materials, Unresolved::add_locking, Unresolved::add_mixed})
    add(scenes);
  // Scenes that differ in their discretization share the reference.
  std::string known;
  std::unique_ptr<const Reference> fine;
  for (const Unresolved::Given &given : checks.rows(scenes, 4)) {
    const std::string text =
      text_of(given) + "Discretization/Finest level = 14\nOutput/Inf-sup constant = false\n";
    if (text != known)
      fine = std::make_unique<const Reference>(text, given.reference_level);
    known = text;
    for (const unsigned int number : given.levels)
      check(checks, table, given, *fine, number);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {unresolved});
}
