// SPDX-License-Identifier: LGPL-2.1-or-later
// Scene/Name = described: every piece of problem (1) from the expressions of the parameter file.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/functions.h>

#include <algorithm>
#include <map>

#include "input.h"

namespace Signorini {
namespace {
/** Reads the components of a vector, separated by ';'. @p text is all of the entry or a part of it.
 */
template <int dim>
std::vector<Expression<dim>> read_components(const std::string &text, const unsigned int n,
                                             const Entry &entry) {
  const std::vector<std::string> parts = split_list(text, ';');
  if (parts.size() != n)
    throw error_at(entry, "found ", parts.size(), " component(s) in ", quote(text),
                   ", allowed: ", n, (n == 1 ? " expression." : " expressions separated by ';'."));
  std::vector<Expression<dim>> expressions;
  expressions.reserve(n);
  for (const std::string &part : parts)
    expressions.emplace_back(part, *entry.constants, entry.where());
  return expressions;
}
template <int dim>
std::vector<Expression<dim>> read_components(const Given<std::string> &given,
                                             const unsigned int n) {
  return read_components<dim>(given.value, n, given);
}

/** Reads a function that is data of the problem. */
template <int dim>
FunctionPointer<dim> read_function(const std::string &text, const unsigned int n,
                                   const Entry &entry) {
  return std::make_shared<ExpressionFunction<dim>>(read_components<dim>(text, n, entry));
}

template <int dim>
std::shared_ptr<const Material<dim>> read_one_material(const MaterialParameters &given,
                                                       const Geometry<dim> &geometry) {
  // Reads n expressions with plausible values on the body; entries across the plane may be empty.
  const auto moduli = [&](const Given<std::string> &entry, const unsigned int n) {
    if (&entry == &given.moduli_across && entry.value.empty())
      return std::vector<Expression<dim>>();
    std::vector<Expression<dim>> expressions = read_components<dim>(entry, n);
    check_moduli(expressions, geometry);
    return expressions;
  };
  const Point<dim> reference = geometry.inner_point();
  if (given.law == MaterialLaw::general)
    return make_general<dim>(moduli(given.hooke_tensor, dim == 2 ? 6 : 21),
                             moduli(given.moduli_across, 3), reference);
  if constexpr (dim == 2)
    if (given.law == MaterialLaw::orthotropic)
      return make_orthotropic(moduli(given.orthotropic_moduli, 4), given.orientation,
                              moduli(given.moduli_across, 2), reference);
  return make_isotropic<dim>(moduli(given.youngs_modulus, 1).front(),
                             read_components<dim>(given.poissons_ratio, 1).front(),
                             given.plane_state, reference);
}

/** Reads the material; where the body has regions, an entry may have a text for each of them:
 * "steel: 210000 | rubber: 5". */
template <int dim>
std::shared_ptr<const Material<dim>> read_material(const MaterialParameters &given,
                                                   const Geometry<dim> &geometry) {
  const MaterialLaw law = given.law;
  const std::string found = "Law = " + to_text(law);
  const std::pair<MaterialLaw, std::vector<const Entry *>> of_laws[] = {
    {MaterialLaw::isotropic, {&given.youngs_modulus, &given.poissons_ratio, &given.plane_state}},
    {MaterialLaw::general, {&given.hooke_tensor}},
    {MaterialLaw::orthotropic, {&given.orthotropic_moduli, &given.orientation}}};
  for (const auto &[owner, entries] : of_laws)
    refuse_foreign_entries(law == owner, entries, "Law = " + to_text(owner), found);
  refuse_foreign_entries(law != MaterialLaw::isotropic, {&given.moduli_across}, "Law = orthotropic",
                         found);
  const std::vector<std::string> &regions = geometry.regions;
  std::map<std::string, MaterialParameters> parts;
  for (const std::string &region : regions)
    parts[region] = given;
  bool differ = false;
  for (const auto entry :
       {&MaterialParameters::youngs_modulus, &MaterialParameters::poissons_ratio,
        &MaterialParameters::hooke_tensor, &MaterialParameters::orthotropic_moduli,
        &MaterialParameters::moduli_across})
    if (const Given<std::string> &text = given.*entry;
        !regions.empty() && begins_with_a_name(text.value)) {
      differ = true;
      for (const auto &[region, value] : read_list_for(regions, text.value, text.where(), regions))
        (parts[region].*entry).value = value;
    }
  if (!differ)
    return read_one_material(given, geometry);
  std::vector<std::shared_ptr<const Material<dim>>> materials;
  materials.reserve(regions.size());
  for (const std::string &region : regions)
    materials.push_back(read_one_material(parts[region], geometry));
  return make_piecewise(materials, geometry.region_at, geometry.inner_point());
}

/** Gives sides their roles; a side has one role only. */
template <int dim>
void read_boundary(const BoundaryParameters &given, const LoadParameters &load,
                   const bool has_numbers_only, Scene<dim> &scene) {
  const std::vector<std::string> sides = scene.geometry.side_names();
  scene.boundary.resize(sides.size());
  // The entry that named each side; null for a side without a role.
  std::vector<const Entry *> entries(sides.size());
  const auto assign = [&](const std::string &name, const Role role,
                          const Entry &entry) -> BoundaryCondition<dim> & {
    const std::size_t side = scene.geometry.find_side(name);
    if (side == sides.size())
      throw error_at(entry, "found the side ", quote(name), hint_for(name, sides),
                     ", allowed: ", join(scene.geometry.described_sides()), ".");
    if (entries[side] != nullptr)
      throw error_at(entry, "the side '", name, "' is listed in ", entries[side]->name,
                     " already; every side has exactly one role.");
    entries[side] = &entry;
    scene.boundary[side].role = role;
    return scene.boundary[side];
  };
  const auto assign_all = [&](const std::string &words, const Role role, const Entry &entry) {
    for (const std::string &name : split_words(words)) {
      const std::vector<std::string> called = sides_called(name, sides);
      for (const std::string &side : called.empty() ? std::vector<std::string>{name} : called)
        assign(side, role, entry);
    }
  };
  assign_all(given.clamped, Role::clamped, given.clamped);
  assign_all(given.rollers, Role::roller, given.rollers);
  for (const std::string &part : split_list(given.contact, '|'))
    if (const auto words = split_words(part); std::count(words.begin(), words.end(), "with") == 0)
      assign_all(part, Role::contact, given.contact);
  for (unsigned int side = 0; side < sides.size(); ++side)
    if (scene.boundary[side].role == Role::contact)
      scene.contacts.emplace_back().side = side;
  const std::vector<SidePair> pairs =
    read_pairs(given.contact, dim, sides,
               [&](const std::string &name) { assign(name, Role::contact, given.contact); });
  for (const auto &[list, role] :
       {std::pair{&given.displacement, Role::displacement}, {&given.traction, Role::traction}})
    for (const auto &[name, text] : read_side_list(list->value, list->where(), sides))
      assign(name, role, *list).data = read_function<dim>(text, dim, *list);
  scene.plates = read_plates(given.plates, load, scene.geometry);
  for (const Plate<dim> &plate : scene.plates)
    assign(sides[plate.side], Role::displacement, given.plates).data =
      plate_displacement(plate, PlateMotion<dim>{plate.travel});
  if constexpr (dim == 2) {
    hold_on_axis(entries, scene);
    add_pairs(pairs, has_numbers_only, given.contact, scene);
  }
  if (scene.contacts.empty())
    throw error_at(given.contact, "no contact side is given, allowed: one or more of ", join(sides),
                   ".");
}

/** Reads the gaps of all contacts: rigid obstacles or expressions. */
template <int dim>
void read_gaps(const Parameters &parameters, Scene<dim> &scene) {
  const ContactParameters &given = parameters.contact;
  const bool moves = parameters.load_cases.cases.value.find("shift") != std::string::npos;
  read_foundation(given, moves, scene);
  for (const auto &[name, text] : gaps_without_foundation(given, scene))
    scene.contacts[find_contact(name, scene)].gap =
      std::make_shared<GapFunction<dim>>(read_components<dim>(text, 1, given.gap));
  if constexpr (dim == 2)
    close_pairs(parameters.boundary.contact.where(), scene);
}

/** Reads the law of friction of all contacts: one expression for all, or one for each. */
template <int dim>
void read_friction(const Parameters &parameters, Scene<dim> &scene) {
  const ContactParameters &given = parameters.contact;
  const std::string found = "Friction = " + to_text(given.law.value);
  scene.contact_law = given.law.value;
  const std::vector<FrictionLimit<dim>> &limits = scene.contact_law.limits();
  // "Friction = none" overrides coefficients given elsewhere in the file.
  if (given.law.is_given && limits.empty())
    return;
  using Law = FrictionLaw<dim>;
  for (const auto entry :
       {&ContactParameters::friction_coefficient, &ContactParameters::friction_bound})
    refuse_foreign_entries(scene.contact_law.reads(entry), {&(given.*entry)},
                           "Friction = " + Law::names(entry), found);
  refuse_foreign_entries(!limits.empty(), {&given.foundation_shift}, "Friction = " + Law::names(),
                         found);
  if (limits.empty())
    return;
  const auto read = [&](const Given<std::string> &entry,
                        FunctionPointer<dim> ContactCondition<dim>::*const data,
                        const unsigned int n_components) {
    if (entry.value.empty())
      throw error_at(entry, "found nothing with ", found,
                     ", allowed: an expression for all contact sides, or one per side.");
    for (const auto &[contact, text] : read_contact_list(entry, scene))
      scene.contacts[contact].*data = read_function<dim>(text, n_components, entry);
  };
  for (const FrictionLimit<dim> &limit : limits)
    read(given.*limit.entry, limit.data, 1);
  if (!given.foundation_shift.value.empty())
    read(given.foundation_shift, &ContactCondition<dim>::shift, dim == 2 ? 1 : dim);
}

/** Reads one expression for all contacts, or one for each. */
template <int dim>
void read_exact_pressure(const Given<std::string> &given, Scene<dim> &scene) {
  if (given.value.empty())
    return;
  for (const auto &[contact, text] : read_contact_list(given, scene))
    scene.contacts[contact].exact_pressure = std::make_shared<ExpressionFunction<dim>>(
      read_components<dim>(text, 1, given), std::vector<Expression<dim>>());
}

template <int dim>
void read_exact_displacement(const ExactSolutionParameters &given, Scene<dim> &scene) {
  if (given.displacement.value.empty()) {
    if (!given.displacement_gradient.value.empty())
      throw error_at(given.displacement_gradient, "it needs ", given.displacement.name,
                     ", which is not given.");
    return;
  }
  std::vector<Expression<dim>> gradients;
  if (!given.displacement_gradient.value.empty())
    gradients = read_components<dim>(given.displacement_gradient, dim * dim);
  scene.exact_displacement = std::make_shared<ExpressionFunction<dim>>(
    read_components<dim>(given.displacement, dim), gradients);
}

/** Reads the body force: one for all, or one for each region. */
template <int dim>
void read_body_force(const Given<std::string> &given, Scene<dim> &scene) {
  if (dim == 3 && !given.changed)
    return;
  const std::vector<std::string> &regions = scene.geometry.regions;
  const bool differs = !regions.empty() && begins_with_a_name(given.value);
  std::vector<std::vector<Expression<dim>>> forces(differs ? regions.size() : 1);
  // A force that is zero needs no integrals.
  bool is_zero = true;
  for (const auto &[region, text] : differs
                                      ? read_list_for(regions, given.value, given.where(), regions)
                                      : SideTexts{{"", given.value}}) {
    auto &force =
      forces[differs ? std::find(regions.begin(), regions.end(), region) - regions.begin() : 0];
    force = read_components<dim>(text, dim, given);
    for (const Expression<dim> &component : force)
      is_zero = is_zero && component.is_constant() && component(Point<dim>()) == 0.;
  }
  if (is_zero)
    return;
  scene.body_force = differs
                       ? std::make_shared<ExpressionFunction<dim>>(forces, scene.geometry.region_at)
                       : std::make_shared<ExpressionFunction<dim>>(forces[0]);
}

} // namespace

template <int dim>
Scene<dim> make_described_scene(const Parameters &parameters) {
  Scene<dim> scene;
  scene.name = "described";
  scene.title = "described by expressions";
  if constexpr (dim == 3)
    scene.geometry = make_geometry<3>(parameters.geometry);
  else
    scene.geometry = make_geometry_of_bodies(parameters);
  if constexpr (dim == 2)
    revolve(parameters.material.plane_state, scene.geometry);
  scene.geometry.thickness = parameters.geometry.thickness;
  refuse_foreign_entries(!scene.geometry.axisymmetric, {&parameters.geometry.thickness},
                         "a plane body",
                         "Plane state = " + to_text(parameters.material.plane_state.value));
  scene.material = read_material(parameters.material, scene.geometry);
  const ContactParameters &contact = parameters.contact;
  const Given<std::string> *const data[] = {&contact.gap, &contact.friction_coefficient,
                                            &contact.friction_bound, &contact.foundation_shift,
                                            &parameters.exact.pressure};
  const bool has_numbers_only =
    std::all_of(std::begin(data), std::end(data), [](const auto *entry) {
      double number = 0.;
      return entry->value.empty() || read_number(entry->value, number);
    });
  read_boundary(parameters.boundary, parameters.load, has_numbers_only, scene);
  read_gaps(parameters, scene);
  read_friction(parameters, scene);
  read_exact_pressure(parameters.exact.pressure, scene);
  read_body_force(parameters.load.body_force, scene);
  read_exact_displacement(parameters.exact, scene);
  check_described_scene(parameters, scene);
  return scene;
}

INSTANTIATE_FUNCTION(make_described_scene);
} // namespace Signorini
