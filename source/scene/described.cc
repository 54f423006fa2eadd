// SPDX-License-Identifier: LGPL-2.1-or-later
// Scene/Name = described: every piece of problem (1) from the expressions of the parameter file.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>
#include <signorini/scene/described.h>
#include <signorini/scene/functions.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <sstream>

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
                       " component(s) in '" + text + "', allowed: " + std::to_string(n) +
                       (n == 1 ? " expression." : " expressions separated by ';'."));
    std::vector<Expression<2>> expressions;
    for (const std::string &part : parts)
      expressions.emplace_back(part, constants_, parameters_.where(path));
    return expressions;
  }

  Expression<2> scalar(const std::string &text, const std::string &path) const
  {
    return components(text, 1, path).front();
  }

  FunctionPointer<2> function(const std::string &text,
                              const unsigned int n,
                              const std::string &path) const
  {
    return std::make_shared<ExpressionFunction<2>>(
      components(text, n, path), std::vector<Expression<2>>(), 1e-8);
  }

private:
  const Parameters &parameters_;
  Constants constants_;
};

/** A point inside of the body. */
dealii::Point<2> inner_point(const Geometry<2> &geometry)
{
  dealii::Point<2> inside;
  for (const Side<2> &side : geometry.sides)
    inside += side.point(0.5 * side.length()) / static_cast<double>(geometry.sides.size());
  return inside;
}

std::shared_ptr<const Material<2>> read_material(const Parameters &parameters,
                                                 const SceneReader &reader,
                                                 const dealii::Point<2> &reference)
{
  const MaterialParameters &given = parameters.material;
  if (given.law == "general")
    return make_general(reader.components(given.hooke_tensor, 6, "Material/Hooke tensor"),
                        reference);
  if (given.law == "orthotropic")
    return make_orthotropic(
      reader.components(given.orthotropic_moduli, 4, "Material/Orthotropic moduli"),
      given.orientation,
      reference);
  return make_isotropic<2>(reader.scalar(given.youngs_modulus, "Material/Young's modulus"),
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
      throw InputError(parameters.where(path) + ": found the side '" + name +
                       "', allowed: " + join(scene.geometry.side_names()) + ".");
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
      reader.function(pressure.second, 1, "Exact solution/Pressure");
}

/** The shorter edge of the box around the body: differences of slender bodies must not leave them
 * far behind. */
double shortest_extent(const Geometry<2> &geometry)
{
  return std::min(geometry.upper[0] - geometry.lower[0], geometry.upper[1] - geometry.lower[1]);
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
    1e-4 * shortest_extent(scene.geometry));
}

/** Points where every expression must have a value: Gauss points, as the integrals use them. */
std::vector<dealii::Point<2>> sample_body(const Geometry<2> &geometry)
{
  const dealii::Point<2> inside = inner_point(geometry);
  const dealii::QGauss<1> gauss(3);
  std::vector<dealii::Point<2>> points;
  for (const Side<2> &side : geometry.sides)
    for (const dealii::Point<1> &q : gauss.get_points())
      for (const dealii::Point<1> &r : gauss.get_points())
        points.push_back(inside + r[0] * (side.point(q[0] * side.length()) - inside));
  return points;
}

std::vector<dealii::Point<2>> sample_side(const Side<2> &side)
{
  const dealii::QGauss<1> gauss(7);
  std::vector<dealii::Point<2>> points;
  for (const dealii::Point<1> &q : gauss.get_points())
    points.push_back(side.point(q[0] * side.length()));
  return points;
}

void check_finite(const FunctionPointer<2> &function,
                  const std::vector<dealii::Point<2>> &points,
                  const std::string &where)
{
  if (function == nullptr)
    return;
  for (const dealii::Point<2> &x : points)
    for (unsigned int c = 0; c < function->n_components; ++c)
      if (!std::isfinite(function->value(x, c)))
      {
        std::ostringstream message;
        message << where << ": component " << c + 1 << " has the value " << function->value(x, c)
                << " at (" << x << "), allowed: finite values on the whole body.";
        throw InputError(message.str());
      }
}

/** A gradient that is given by expressions; differences may leave the body. */
void check_gradient(const Parameters &parameters,
                    const Scene<2> &scene,
                    const std::vector<dealii::Point<2>> &points)
{
  if (parameters.exact.displacement_gradient.empty())
    return;
  for (const dealii::Point<2> &x : points)
    for (unsigned int c = 0; c < 2; ++c)
      if (!std::isfinite(scene.exact_displacement->gradient(x, c).norm()))
      {
        std::ostringstream message;
        message << parameters.where("Exact solution/Displacement gradient")
                << ": the gradient of component " << c + 1 << " has no value at (" << x
                << "), allowed: finite values on the whole body.";
        throw InputError(message.str());
      }
}

/** Evaluates everything once where the integrals will, so that nonsense is found before work. */
void check_values(const Parameters &parameters, const Scene<2> &scene)
{
  const auto body = sample_body(scene.geometry);
  for (const dealii::Point<2> &x : body)
    scene.material->hooke(x);
  check_finite(scene.body_force, body, parameters.where("Load/Body force"));
  check_finite(scene.exact_displacement, body, parameters.where("Exact solution/Displacement"));
  check_gradient(parameters, scene, body);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const BoundaryCondition<2> &condition = scene.boundary[i];
    const char *path = condition.role == Role::contact        ? "Contact/Gap"
                       : condition.role == Role::displacement ? "Boundary/Displacement"
                                                              : "Boundary/Traction";
    const auto points = sample_side(scene.geometry.sides[i]);
    check_finite(condition.data, points, parameters.where(path));
    check_finite(condition.exact_pressure, points, parameters.where("Exact solution/Pressure"));
  }
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
  scene.material = read_material(parameters, reader, inner_point(scene.geometry));
  read_boundary(parameters, reader, scene);
  read_contact_data(parameters, reader, scene);
  if (!is_zero(reader.components(parameters.load.body_force, 2, "Load/Body force")))
    scene.body_force = reader.function(parameters.load.body_force, 2, "Load/Body force");
  read_exact_displacement(parameters, reader, scene);
  check_values(parameters, scene);
  return scene;
}
} // namespace Signorini
