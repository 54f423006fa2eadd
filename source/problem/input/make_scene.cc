// SPDX-License-Identifier: LGPL-2.1-or-later
// Problem (1) from the parameters: a scene with a name, or described by expressions.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/input/data_scan.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/contradictions.h>
#include <signorini/problem/scene/rigid_motions.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "input.h"

namespace Signorini {
namespace {
/** The name of the scene that the other entries describe. */
const std::string described = "described";

/** Refuses entries that describe a scene if a named scene fixes them. */
void refuse_description(const Parameters &parameters) {
  if (parameters.changes_of_scene.empty())
    return;
  const Given<std::string> &name = parameters.scene.name;
  throw error_at(parameters.changes_of_scene.front(), "the catalogue scene '", name.value,
                 "' fixes this entry; leave it out, or set ", name.name, " = ", described, ".");
}

/** Returns points all over a side. */
std::vector<Point<2>> points_on(const Side<2> &side) {
  constexpr unsigned int n = 64;
  std::vector<Point<2>> points;
  for (unsigned int k = 0; k < n; ++k)
    points.push_back(side.point((k + 0.5) / n * side.length()));
  return points;
}
std::vector<Point<3>> points_on(const Side<3> &side) {
  std::vector<Point<3>> points;
  for (const SurfacePoint<3> &point : side.samples())
    points.push_back(point.x);
  return points;
}

/** Returns whether anything could press the body onto the foundation. */
template <int dim>
bool is_loaded(const Scene<dim> &scene) {
  for (const ContactCondition<dim> &contact : scene.contacts)
    for (const Point<dim> &x : points_on(scene.geometry.sides[contact.side]))
      if (contact.gap->value(x) < 0.)
        return true;
  return has_load(scene, LoadKind::force) || has_load(scene, LoadKind::weight) ||
         has_load(scene, LoadKind::travel) || has_load(scene, LoadKind::cross);
}

/** Finds out whether contact alone holds the body, which needs a load. */
template <int dim>
void check_free_motions(Scene<dim> &scene, const std::string &where) {
  scene.is_held_by_contact = !free_rigid_motions(scene, Plates::held).empty();
  std::vector<std::string> names;
  for (const RigidMotion<dim> &motion : free_rigid_motions(scene, Plates::released))
    names.push_back(motion.name());
  if (!names.empty() && !is_loaded(scene))
    throw input_error(where, ": the clamped, prescribed and roller sides leave ",
                      join(names, " and "),
                      " of the body free, and no load presses it onto the foundation; hold the "
                      "body with Clamped, Displacement or Rollers, or load it.");
}

/** Refuses kinks that are too close, and positions that miss the body and would have no effect. */
void refuse_bad_kinks(const Geometry<2> &geometry, const Given<std::vector<double>> &given,
                      const unsigned int d) {
  const double lower = geometry.lower[d], upper = geometry.upper[d];
  const double min_distance = Kinks<2>::min_distance * (upper - lower);
  std::vector<double> positions = given;
  std::sort(positions.begin(), positions.end());
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    if (!(positions[i + 1] - positions[i] >= min_distance))
      throw error_at(given, "found kinks at ", positions[i], " at a distance of ",
                     positions[i + 1] - positions[i],
                     " from each other, allowed: distances of at least ", min_distance,
                     " (a thousandth of the body).");
  for (const double position : given.value)
    if (!(position >= lower && position <= upper))
      throw error_at(given, "found ", position, ", allowed: positions on the body, from ", lower,
                     " to ", upper, ".");
}

/** Refuses supports of which no displacement of finite energy satisfies all. */
template <int dim>
void refuse_contradiction(const Scene<dim> &scene, const std::string &where) {
  const std::string contradiction = find_contradiction(scene);
  if (!contradiction.empty())
    throw input_error(where, ": ", contradiction, ".");
}

/** Returns the scene that the parameters name. */
template <int dim>
Scene<dim> read_scene(const Parameters &parameters, const NamedScenes &known) {
  const std::string &name = parameters.scene.name;
  if (name == described)
    return make_described_scene<dim>(parameters);
  std::vector<std::string> names = {described};
  for (const NamedScene<dim> &entry : std::get<std::vector<NamedScene<dim>>>(known)) {
    names.push_back(entry.name);
    if (entry.name != name)
      continue;
    refuse_description(parameters);
    return entry.make();
  }
  throw error_at(parameters.scene.name, "found ", quote(name),
                 (dim == 2 ? "" : " with Dimension = 3"), ", allowed: ", join(names), ".");
}
} // namespace

unsigned int dimension_of(const Parameters &parameters, const NamedScenes &known) {
  if (parameters.dimension.changed)
    return parameters.dimension;
  const auto &entries = std::get<std::vector<NamedScene<3>>>(known);
  return std::any_of(entries.begin(), entries.end(),
                     [&](const auto &entry) { return entry.name == parameters.scene.name.value; })
           ? 3
           : parameters.dimension.value;
}

/** Reads the number of equal patches of all contacts, or of each of them. */
static void read_patches(const Given<std::string> &given, Scene<2> &scene) {
  for (const auto &[contact, text] : read_contact_list(given, scene)) {
    constexpr double most = 16384.;
    std::vector<double> n;
    if (!read_numbers(given, text, n) || n.size() != 1 || !(n[0] >= 0. && n[0] <= most) ||
        n[0] != std::floor(n[0]))
      throw error_at(given, "found ", quote(text), ", allowed: an integer from 0 to ", most, ".");
    scene.contacts[contact].n_patches = static_cast<unsigned int>(n[0]);
  }
}

template <>
Scene<2> make_scene(const Parameters &parameters, const NamedScenes &known) {
  Scene<2> scene = read_scene<2>(parameters, known);
  read_patches(parameters.discretization.patches, scene);
  refuse_contradiction(scene, parameters.boundary.where);
  check_free_motions(scene, parameters.boundary.where);
  const DiscretizationParameters &discretization = parameters.discretization;
  refuse_bad_kinks(scene.geometry, discretization.kinks_at_x, 0);
  refuse_bad_kinks(scene.geometry, discretization.kinks_at_y, 1);
  scene.kinks = scene.kinks.with_lines(
    lines_at<2>({{discretization.kinks_at_x.value, discretization.kinks_at_y.value}}));
  scan_data(scene);
  for (const ContactCondition<2> &contact : scene.contacts)
    scene.kinks.add_ends_on(scene.geometry.sides[contact.side]);
  scene.load_cases = read_load_cases(parameters.load_cases, scene);
  scene.probes = read_probes(parameters.output.report, scene.geometry);
  return scene;
}

template <>
Scene<3> make_scene(const Parameters &parameters, const NamedScenes &known) {
  refuse_2d_entries(parameters);
  Scene<3> scene = read_scene<3>(parameters, known);
  refuse_contradiction(scene, parameters.boundary.where);
  check_free_motions(scene, parameters.boundary.where);
  scene.load_cases = read_load_cases(parameters.load_cases, scene);
  scene.probes = read_probes(parameters.output.report, scene.geometry);
  return scene;
}

} // namespace Signorini
