// SPDX-License-Identifier: LGPL-2.1-or-later
// Problem (1) from the parameters: out of the catalogue, or described by expressions.

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/catalogue/catalogue.h>
#include <signorini/scene/rigid_motions.h>
#include <signorini/scene_input/described.h>
#include <signorini/scene_input/make_scene.h>

namespace Signorini
{
namespace
{
/** A catalogue scene fixes these subsections; its entries must stay at their defaults. */
void refuse_description(const Parameters &parameters)
{
  for (const char *section : {"Constants/",
                              "Geometry/",
                              "Material/",
                              "Boundary/",
                              "Load/",
                              "Contact/",
                              "Exact solution/"})
    for (const std::string &path : parameters.changes)
      if (path.rfind(section, 0) == 0)
        throw InputError(parameters.where(path) + ": the catalogue scene '" +
                         parameters.scene.name +
                         "' fixes this entry; leave it out, or set Scene/Name = described.");
}

void refuse_free_motions(const Scene<2> &scene, const Parameters &parameters)
{
  std::vector<std::string> names;
  for (const RigidMotion &motion : free_rigid_motions(scene))
    names.push_back(motion.name);
  if (!names.empty())
    throw InputError(parameters.file_name +
                     ": Boundary: the clamped, prescribed and roller sides "
                     "leave " +
                     join(names, " and ") +
                     " of the body free (the stiffness matrix is singular); hold the body with "
                     "Clamped, Displacement or Rollers.");
}
/** A position that misses the body is a slip of the pen. */
void refuse_kinks_outside(const Scene<2> &scene, const Parameters &parameters)
{
  const auto check =
    [&](const std::string &path, const std::vector<double> &positions, const unsigned int d) {
      for (const double position : positions)
        if (!(position >= scene.geometry.lower[d] && position <= scene.geometry.upper[d]))
          throw InputError(parameters.where(path) + ": found " + number_text(position) +
                           ", allowed: positions on the body, from " +
                           number_text(scene.geometry.lower[d]) + " to " +
                           number_text(scene.geometry.upper[d]) + ".");
    };
  check("Discretization/Kinks at x", parameters.discretization.kinks_at_x, 0);
  check("Discretization/Kinks at y", parameters.discretization.kinks_at_y, 1);
}
} // namespace

Scene<2> make_scene(const Parameters &parameters)
{
  const std::string &name = parameters.scene.name;
  Scene<2> scene;
  if (name == "described")
    scene = make_described_scene(parameters);
  else
  {
    std::vector<std::string> names = {"described"};
    const CatalogueEntry *found = nullptr;
    for (const CatalogueEntry &entry : catalogue())
    {
      names.push_back(entry.name);
      if (entry.name == name)
        found = &entry;
    }
    if (found == nullptr)
      throw InputError(parameters.where("Scene/Name") + ": found " + quote(name) +
                       ", allowed: " + join(names) + ".");
    refuse_description(parameters);
    scene = found->make();
    scene.name = found->name;
    scene.title = found->title;
  }
  refuse_free_motions(scene, parameters);
  refuse_kinks_outside(scene, parameters);
  const DiscretizationParameters &discretization = parameters.discretization;
  std::vector<KinkLine<2>> lines = scene.kinks.lines();
  const std::vector<KinkLine<2>> more =
    lines_at<2>({{discretization.kinks_at_x, discretization.kinks_at_y}});
  lines.insert(lines.end(), more.begin(), more.end());
  scene.kinks = Kinks<2>(lines);
  for (const unsigned int side : scene.contact_sides())
    scene.kinks.add_ends_on(scene.geometry.sides[side]);
  return scene;
}
} // namespace Signorini
