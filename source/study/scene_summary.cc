// SPDX-License-Identifier: LGPL-2.1-or-later
// What a user reads before and after the table.

#include "scene_summary.h"

#include <signorini/base/text.h>

namespace Signorini
{
namespace
{
/** "clamped top; contact bottom; ..." in the order of the roles. */
template <int dim>
std::string describe_boundary(const Scene<dim> &scene)
{
  const std::pair<Role, const char *> roles[] = {{Role::contact, "contact"},
                                                 {Role::clamped, "clamped"},
                                                 {Role::roller, "rollers"},
                                                 {Role::displacement, "displacement"},
                                                 {Role::traction, "traction"},
                                                 {Role::free, "free"}};
  std::vector<std::string> parts;
  for (const auto &role : roles)
  {
    std::vector<std::string> names;
    for (unsigned int i = 0; i < scene.boundary.size(); ++i)
      if (scene.boundary[i].role == role.first)
        names.push_back(scene.geometry.sides[i].name());
    if (!names.empty())
      parts.push_back(role.second + (" " + join(names, " ")));
  }
  return join(parts, "; ");
}

std::string describe_partition(const DiscretizationParameters &given)
{
  if (given.patches > 0)
    return std::to_string(given.patches) + " equal patches per contact side";
  return "H = " + std::to_string(given.patch_ratio) + " h";
}
} // namespace

template <int dim>
void print_scene(const Parameters &parameters, const Scene<dim> &scene, std::ostream &screen)
{
  const DiscretizationParameters &given = parameters.discretization;
  const SolverParameters &solver = parameters.solver;
  screen << "Scene     " << scene.name << ": " << scene.title << "\n"
         << "Body      from (" << scene.geometry.lower << ") to (" << scene.geometry.upper << ")\n"
         << "Boundary  " << describe_boundary(scene) << "\n"
         << "Levels    " << given.coarsest_level << " to " << given.finest_level << ", "
         << describe_partition(given) << "\n"
         << "Solver    " << to_text(solver.contact_solver.value) << ", tolerance "
         << solver.tolerance << ", linear solver " << to_text(solver.linear_solver.value) << "\n\n";
}

void print_verdict(const Parameters &parameters,
                   const std::vector<LevelRecord> &levels,
                   const bool certified,
                   std::ostream &screen)
{
  if (!levels.empty())
  {
    const LevelRecord &finest = levels.back();
    screen << "\nContact force " << finest.contact_force << ", largest pressure "
           << finest.max_pressure << ", contact length " << finest.contact_length << ", energy "
           << finest.certificate.energy;
    if (finest.estimated_relative)
      screen << ", estimated error " << 100. * *finest.estimated_relative << " % (H1)";
    screen << ".\n";
    if (finest.increment_iterations)
      screen << "Projected SOR: of " << finest.qp_iterations
             << " sweeps, the increment alone was small after " << *finest.increment_iterations
             << ".\n";
  }
  screen << (certified ? "Certified: KKT residuals below "
                       : "NOT certified: not all KKT residuals are below ")
         << parameters.solver.tolerance << (certified ? " and " : " or not all ")
         << "balances below " << largest_residual_bound(levels, parameters.solver.tolerance)
         << ".\n";
}

template void print_scene(const Parameters &, const Scene<2> &, std::ostream &);
} // namespace Signorini
