// SPDX-License-Identifier: LGPL-2.1-or-later
// Scene/Name = described: every piece of problem (1) from the expressions of the parameter file.

#include <signorini/base/exceptions.h>
#include <signorini/base/text.h>
#include <signorini/scene/functions.h>
#include <signorini/scene_input/described.h>

#include "described_checks.h"
#include "geometry_input.h"
#include "side_lists.h"

namespace Signorini
{
namespace
{
/** Reads the entries of one parameter file that hold expressions. */
class SceneReader
{
public:
  explicit SceneReader(const Parameters &parameters)
    : parameters_(parameters)
    , constants_(read_constants(parameters.constants.values, parameters.where("Constants/Values")))
  {
  }

  /** The components of a vector, separated by ';'. */
  std::vector<Expression<2>> components(const std::string &text,
                                        const unsigned int n,
                                        const std::string &path) const
  {
    const std::vector<std::string> parts = split_list(text, ';');
    if (parts.size() != n)
      throw InputError(parameters_.where(path) + ": found " + std::to_string(parts.size()) +
                       " component(s) in " + quote(text) + ", allowed: " + std::to_string(n) +
                       (n == 1 ? " expression." : " expressions separated by ';'."));
    std::vector<Expression<2>> expressions;
    expressions.reserve(n);
    for (const std::string &part : parts)
      expressions.emplace_back(part, constants_, parameters_.where(path));
    return expressions;
  }

  Expression<2> scalar(const std::string &text, const std::string &path) const
  {
    return components(text, 1, path).front();
  }

  /** Data of the problem. */
  FunctionPointer<2> function(const std::string &text,
                              const unsigned int n,
                              const std::string &path) const
  {
    return std::make_shared<ExpressionFunction<2>>(components(text, n, path));
  }

private:
  const Parameters &parameters_;
  Constants constants_;
};

/** Entries that a law does not use contradict it. */
void refuse_foreign_moduli(const Parameters &parameters)
{
  const std::string &law = parameters.material.law;
  const std::vector<std::pair<const char *, const char *>> laws_of_entries = {
    {"Material/Young's modulus", "isotropic"},
    {"Material/Poisson's ratio", "isotropic"},
    {"Material/Plane state", "isotropic"},
    {"Material/Hooke tensor", "general"},
    {"Material/Orthotropic moduli", "orthotropic"},
    {"Material/Orientation", "orthotropic"}};
  for (const auto &entry : laws_of_entries)
    if (entry.second != law && parameters.changed(entry.first))
      throw InputError(parameters.where(entry.first) + ": this entry belongs to Law = " +
                       entry.second + ", found Law = " + law + ".");
}

std::shared_ptr<const Material<2>> read_material(const Parameters &parameters,
                                                 const SceneReader &reader,
                                                 const Geometry<2> &geometry)
{
  const MaterialParameters &given = parameters.material;
  refuse_foreign_moduli(parameters);
  const bool is_general = given.law == "general", is_orthotropic = given.law == "orthotropic";
  const std::vector<Expression<2>> moduli =
    is_general       ? reader.components(given.hooke_tensor, 6, "Material/Hooke tensor")
    : is_orthotropic ? reader.components(given.orthotropic_moduli, 4, "Material/Orthotropic moduli")
                     : reader.components(given.youngs_modulus, 1, "Material/Young's modulus");
  check_moduli(moduli, geometry);
  const dealii::Point<2> reference = geometry.inner_point();
  if (is_general)
    return make_general(moduli, reference);
  if (is_orthotropic)
    return make_orthotropic(moduli, given.orientation, reference);
  return make_isotropic<2>(moduli[0],
                           reader.scalar(given.poissons_ratio, "Material/Poisson's ratio"),
                           given.plane_state == "stress" ? PlaneState::stress : PlaneState::strain,
                           reference);
}

/** Gives the sides named in one list their role; a side has one role only. */
void assign_roles(const Parameters &parameters,
                  const std::string &path,
                  const std::vector<std::string> &names,
                  const Role role,
                  Scene<2> &scene,
                  std::vector<std::string> &role_names)
{
  for (const std::string &name : names)
  {
    const std::size_t side = scene.geometry.find_side(name);
    if (side == scene.geometry.sides.size())
      throw InputError(parameters.where(path) + ": found the side " + quote(name) +
                       ", allowed: " + join(scene.geometry.side_names()) + ".");
    if (!role_names[side].empty())
      throw InputError(parameters.where(path) + ": the side '" + name + "' is listed in " +
                       role_names[side] + " already; every side has exactly one role.");
    role_names[side] = path;
    scene.boundary[side].role = role;
  }
}

void read_boundary(const Parameters &parameters, const SceneReader &reader, Scene<2> &scene)
{
  const BoundaryParameters &given = parameters.boundary;
  const std::vector<std::string> sides = scene.geometry.side_names();
  scene.boundary.resize(sides.size());
  std::vector<std::string> role_names(sides.size());
  const auto assign =
    [&](const std::string &path, const std::vector<std::string> &names, const Role role) {
      assign_roles(parameters, path, names, role, scene, role_names);
    };
  assign("Boundary/Clamped", split_words(given.clamped), Role::clamped);
  assign("Boundary/Rollers", split_words(given.rollers), Role::roller);
  assign("Boundary/Contact", split_words(given.contact), Role::contact);
  const auto assign_data = [&](const std::string &path, const std::string &text, const Role role) {
    for (const auto &entry : read_side_list(text, parameters.where(path), sides))
    {
      assign(path, {entry.first}, role);
      scene.boundary[scene.geometry.find_side(entry.first)].data =
        reader.function(entry.second, 2, path);
    }
  };
  assign_data("Boundary/Displacement", given.displacement, Role::displacement);
  assign_data("Boundary/Traction", given.traction, Role::traction);
  if (scene.contact_sides().empty())
    throw InputError(parameters.where("Boundary/Contact") +
                     ": no contact side is given, allowed: one or more of " + join(sides) + ".");
}

/** Gap and exact pressure: one expression for all contact sides, or one per side. */
void read_contact_data(const Parameters &parameters, const SceneReader &reader, Scene<2> &scene)
{
  std::vector<std::string> names;
  for (const unsigned int side : scene.contact_sides())
    names.push_back(scene.geometry.sides[side].name());
  const auto per_side = [&](const std::string &path, const std::string &text) {
    return read_contact_list(text, parameters.where(path), scene.geometry.side_names(), names);
  };
  for (const auto &gap : per_side("Contact/Gap", parameters.contact.gap))
    scene.boundary[scene.geometry.find_side(gap.first)].data =
      reader.function(gap.second, 1, "Contact/Gap");
  if (parameters.exact.pressure.empty())
    return;
  for (const auto &pressure : per_side("Exact solution/Pressure", parameters.exact.pressure))
    scene.boundary[scene.geometry.find_side(pressure.first)].exact_pressure =
      std::make_shared<ExpressionFunction<2>>(
        reader.components(pressure.second, 1, "Exact solution/Pressure"),
        std::vector<Expression<2>>(),
        1e-4 * scene.geometry.shortest_extent());
}

void read_exact_displacement(const Parameters &parameters,
                             const SceneReader &reader,
                             Scene<2> &scene)
{
  const ExactSolutionParameters &given = parameters.exact;
  if (given.displacement.empty())
  {
    if (!given.displacement_gradient.empty())
      throw InputError(parameters.where("Exact solution/Displacement gradient") +
                       ": it needs Exact solution/Displacement, which is not given.");
    return;
  }
  std::vector<Expression<2>> gradients;
  if (!given.displacement_gradient.empty())
    gradients =
      reader.components(given.displacement_gradient, 4, "Exact solution/Displacement gradient");
  scene.exact_displacement = std::make_shared<ExpressionFunction<2>>(
    reader.components(given.displacement, 2, "Exact solution/Displacement"),
    gradients,
    // Differences of slender bodies must not leave them far behind.
    1e-4 * scene.geometry.shortest_extent());
}

/** Zero body forces need no volume integrals. */
bool is_zero(const std::vector<Expression<2>> &force)
{
  for (const Expression<2> &component : force)
    if (!component.is_constant() || component(dealii::Point<2>()) != 0.)
      return false;
  return true;
}
} // namespace

Scene<2> make_described_scene(const Parameters &parameters)
{
  const SceneReader reader(parameters);
  Scene<2> scene;
  scene.name = "described";
  scene.title = "described by expressions";
  scene.geometry = make_geometry(parameters);
  scene.material = read_material(parameters, reader, scene.geometry);
  read_boundary(parameters, reader, scene);
  read_contact_data(parameters, reader, scene);
  if (!is_zero(reader.components(parameters.load.body_force, 2, "Load/Body force")))
    scene.body_force = reader.function(parameters.load.body_force, 2, "Load/Body force");
  read_exact_displacement(parameters, reader, scene);
  check_described_scene(parameters, scene);
  return scene;
}
} // namespace Signorini
