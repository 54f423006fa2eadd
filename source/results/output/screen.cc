// SPDX-License-Identifier: LGPL-2.1-or-later
// The texts on the screen before and after the table.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/results/output/screen.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini {
namespace {
/** Returns "roller.arc with upper.bottom lower.top", or the name of a side alone on a foundation;
 * nothing where Γ_c lies on the partners. */
template <int dim>
std::string contacts_on(const Scene<dim> &scene, const unsigned int side) {
  std::string text;
  for (const ContactPair<dim> &pair : contact_pairs(scene))
    if (pair.side() == side)
      text += text.empty() ? pair.name() : " " + pair.other_name();
  return text;
}

/** Returns "clamped top; contact bottom; ..." in the order of the roles. */
template <int dim>
std::string describe_boundary(const Scene<dim> &scene) {
  std::vector<std::string> parts, plates;
  const auto has_plate = [&scene](const unsigned int side) {
    return std::any_of(scene.plates.begin(), scene.plates.end(),
                       [side](const Plate<dim> &plate) { return plate.side == side; });
  };
  for (const Role role : {Role::contact, Role::clamped, Role::roller, Role::displacement,
                          Role::traction, Role::free}) {
    std::vector<std::string> names;
    for (unsigned int i = 0; i < scene.boundary.size(); ++i)
      if (scene.boundary[i].role == role) {
        if (role != Role::contact)
          (has_plate(i) ? plates : names).push_back(scene.geometry.sides[i].name());
        else if (const std::string name = contacts_on(scene, i); !name.empty())
          names.push_back(name);
      }
    if (!names.empty())
      parts.push_back(word_for(role) + " " + join(names, " "));
  }
  if (!plates.empty())
    parts.push_back("plates " + join(plates, " "));
  if (scene.contact_law.has_tangential_part())
    parts.push_back("friction " + scene.contact_law.name());
  if (scene.is_held_by_contact)
    parts.emplace_back("held by contact");
  return join(parts, "; ");
}

std::string describe_partition(const DiscretizationParameters &given) {
  if (given.patches.changed)
    return given.patches.value + " equal patches per contact side";
  return "H = " + std::to_string(given.patch_ratio) + " h";
}

/** The largest share of strongly strained or turned material without a warning. Near singular
 * stresses, or under a small contact zone, the share is smaller. */
constexpr double tolerated_share = 0.01;

/** Warns where much of the body is strained or turns so much that linear elasticity does not hold.
 * A scene with an exact solution is a test of the linear equations. */
void warn_of_large_gradients(const LevelRecord &finest, std::ostream &screen) {
  if (finest.displacement_errors || finest.pressure_errors)
    return;
  const VonMises &found = finest.answer.von_mises;
  const auto warn = [&](const double share, const std::string &objection) {
    if (share > tolerated_share)
      screen << "Warning: " << std::round(100. * share) << " % of the body " << objection
             << ", does not describe this.\n";
  };
  warn(found.strained_share, "is strained by more than " + number_text(100. * large_strain) +
                               " %: linear elasticity, which is made for small strains");
  warn(found.turned_share, "turns by more than " + number_text(large_rotation) +
                             " rad: linear elasticity, which is made for small rotations");
}

/** Returns a description of the sequence of meshes. */
std::string describe_meshes(const Parameters &parameters, const Judge &judge) {
  const DiscretizationParameters &given = parameters.discretization;
  std::ostringstream text;
  if (given.strategy != Strategy::hp) {
    text << "Levels    " << given.coarsest_level << " to " << given.finest_level << ", "
         << describe_partition(given) << "\n";
    return text.str();
  }
  text << "Steps     graded meshes from level " << given.coarsest_level << " on, degrees 2 to "
       << given.maximum_degree << ", to the error " << judge.demands.target_error << " or "
       << given.maximum_unknowns << " unknowns\n";
  std::vector<std::string> ignored;
  for (const Entry *const entry :
       std::initializer_list<const Entry *>{&given.finest_level, &given.element, &given.patch_ratio,
                                            &given.patches, &parameters.output.lemmas})
    if (entry->is_given)
      ignored.push_back(entry->name.substr(entry->name.find('/') + 1));
  if (!ignored.empty())
    text << "Ignored   " << join(ignored) << " (Strategy = hp)\n";
  return text.str();
}
} // namespace

template <int dim>
void print_scene(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &solvers,
                 const Judge &judge, std::ostream &screen) {
  const SolverParameters &solver = parameters.solver;
  screen << "Scene     " << scene.name << ": " << scene.title << "\n"
         << "Body      from (" << scene.geometry.lower << ") to (" << scene.geometry.upper << ")\n"
         << (scene.geometry.note.empty() ? "" : "Mesh      " + scene.geometry.note + "\n")
         << "Boundary  " << describe_boundary(scene) << "\n"
         << describe_meshes(parameters, judge) << "Solver    " << to_text(solvers.contact)
         << ", tolerance " << solver.tolerance << ", linear solver " << to_text(solvers.linear)
         << "\n\n";
}

void print_warnings(const LevelRecord &level, const Judge &judge, std::ostream &screen) {
  const std::string name =
    std::string(level.sizes.word()) + " " + std::to_string(level.sizes.level);
  if (level.sizes.unstable)
    screen << "Warning: on " << name
           << " a contact patch is no longer than a face (H = h), which is not inf-sup stable: "
              "the pressure may oscillate. Take a patch ratio of 2 or more.\n";
  if (level.dual.active_set_failure)
    screen << "Warning: on " << name << " the active set method failed ("
           << *level.dual.active_set_failure << "); projected SOR answered instead.\n";
  if (level.dual.stalled)
    screen << "Warning: on " << name << " " << *level.dual.stalled
           << "; the active set method with MINRES answered instead.\n";
  if (level.dual.failure_of_cycles)
    screen << "Warning: on " << name << " a factorisation answered instead of V-cycles ("
           << *level.dual.failure_of_cycles << ").\n";
  const std::string doubt = judge.doubt(level);
  if (!doubt.empty())
    screen << "Warning: " << name << " is not certified: " << doubt << "\n";
}

void print_verdict(const std::vector<LevelRecord> &levels, const Judge &judge,
                   const StudyVerdict &verdict, std::ostream &screen) {
  if (!levels.empty()) {
    const LevelRecord &finest = levels.back();
    if (finest.dual.increment_iterations)
      screen << "Projected SOR: of " << finest.dual.iterations
             << " sweeps, the increment alone was small after " << *finest.dual.increment_iterations
             << ".\n";
    warn_of_large_gradients(finest, screen);
  }
  constexpr double large_turn = 0.1;
  if (const double turn = levels.empty() ? 0. : levels.back().answer.turn_of_normals;
      turn > large_turn)
    screen
      << "Warning: where sides press, the normals of what they touch are up to "
      << std::round(100. * turn) / 100. << " from opposite (more than " << large_turn
      << "): contact acts along one of them, in a pair along their mean, and forces may be wrong "
         "by about the square of this.\n";
  if (!verdict.accuracy.empty())
    screen << "Accuracy: " << verdict.accuracy << ".\n";
  if (verdict.outcome == Outcome::not_certified)
    screen << "NOT certified: not all KKT residuals are below " << judge.demands.tolerance
           << " or not all balances below " << verdict.residual_bound << ".\n";
  else
    screen << (verdict.outcome == Outcome::certified             ? "Certified"
               : verdict.outcome == Outcome::equations_certified ? "Equations certified"
               : verdict.outcome == Outcome::accuracy_estimated
                 ? "Equations certified, accuracy estimated"
                 : "NOT resolved, equations certified")
           << ": KKT residuals below " << judge.demands.tolerance << " and balances below "
           << verdict.residual_bound << ".\n";
}

INSTANTIATE_FUNCTION(print_scene);
} // namespace Signorini
