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
/** Reads the subsection Load cases. @throws InputError. */
std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene);

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

/** Returns whether anything could press the body onto the foundation. */
bool is_loaded(const Scene<2> &scene) {
  constexpr unsigned int n_samples = 64;
  for (const unsigned int i : scene.contact_sides())
    for (unsigned int k = 0; k < n_samples; ++k) {
      const Side<2> &side = scene.geometry.sides[i];
      if (scene.boundary[i].data->value(side.point((k + 0.5) / n_samples * side.length())) < 0.)
        return true;
    }
  return has_load(scene, LoadKind::force) || has_load(scene, LoadKind::weight) ||
         has_load(scene, LoadKind::travel) || has_load(scene, LoadKind::cross);
}

/** Finds out whether contact alone holds the body, which needs a load. */
void check_free_motions(Scene<2> &scene, const std::string &where) {
  scene.is_held_by_contact = !free_rigid_motions(scene, Plates::held).empty();
  std::vector<std::string> names;
  for (const RigidMotion &motion : free_rigid_motions(scene, Plates::released))
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

/** Reads the number of equal patches of all contact sides, or of each of them. */
static void read_patches(const Given<std::string> &given, Scene<2> &scene) {
  for (const auto &[side, text] : read_contact_list(given, scene)) {
    constexpr double most = 16384.;
    std::vector<double> n;
    if (!read_numbers(given, text, n) || n.size() != 1 || !(n[0] >= 0. && n[0] <= most) ||
        n[0] != std::floor(n[0]))
      throw error_at(given, "found ", quote(text), ", allowed: an integer from 0 to ", most, ".");
    scene.boundary[side].n_patches = static_cast<unsigned int>(n[0]);
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
  for (const unsigned int side : scene.contact_sides())
    scene.kinks.add_ends_on(scene.geometry.sides[side]);
  scene.load_cases = read_load_cases(parameters.load_cases, scene);
  scene.probes = read_probes(parameters.output.report, scene.geometry);
  return scene;
}

template <>
Scene<3> make_scene(const Parameters &parameters, const NamedScenes &known) {
  refuse_2d_entries(parameters);
  Scene<3> scene = read_scene<3>(parameters, known);
  refuse_contradiction(scene, parameters.boundary.where);
  const std::vector<std::string> names = free_rigid_motions(scene);
  if (!names.empty())
    throw input_error(parameters.boundary.where,
                      ": the clamped, prescribed and roller sides leave ", join(names, " and "),
                      " of the body free; in 3-D, hold the body with Clamped, Displacement or "
                      "Rollers.");
  scene.probes = read_probes(parameters.output.report, scene.geometry);
  return scene;
}

// "force 0 to 3 in 100 cases, weight 1 | travel 2": lists and ranges of load cases.

namespace {
constexpr unsigned int max_cases = 100000;

/** Returns why a number of load cases could change nothing; empty if it could. */
std::string uselessness(const CaseFactor &factor, const Scene<2> &scene) {
  if (factor.name.rfind("shift", 0) == 0)
    for (const unsigned int side : scene.contact_sides())
      if (scene.boundary[side].foundation == nullptr)
        return "the side '" + scene.geometry.sides[side].name() +
               "' has no Contact/Foundation that could be moved";
  const bool slides = std::any_of(scene.boundary.begin(), scene.boundary.end(),
                                  [](const auto &condition) { return condition.shift != nullptr; });
  const bool acts = factor.kind ? has_load(scene, *factor.kind) : factor.name != "slide" || slides;
  return acts ? "" : "the scene has " + factor.lacking;
}

/** Reads a whole number from @p min to @p max; returns 0 if it is none. */
unsigned int whole_number(const Entry &entry, const std::string &text, const double min,
                          const double max) {
  double number = 0.;
  const bool is_whole = read_number(entry, text, number) && number == std::floor(number);
  return is_whole && number >= min && number <= max ? static_cast<unsigned int>(number) : 0;
}

/** Reads one entry between '|': one case, or a range of them. */
void read_cases(const std::string &entry, const Given<std::string> &given, const Scene<2> &scene,
                std::vector<LoadCase> &cases) {
  const auto require = [&](const bool is_allowed, const std::string &found,
                           const std::string &allowed) {
    if (!is_allowed)
      throw error_at(given, "found ", quote(found), " in ", quote(entry), ", allowed: ", allowed,
                     ".");
  };
  std::string text = entry;
  unsigned int n = 1;
  const std::vector<std::string> all = split_words(text);
  if (all.size() >= 3 && all.back() == "cases" && all[all.size() - 3] == "in") {
    n = whole_number(given, all[all.size() - 2], 2., max_cases);
    require(n > 0, all[all.size() - 2], "2 to " + std::to_string(max_cases) + " cases");
    text = text.substr(0, text.rfind("in "));
  }
  if (cases.size() + n > max_cases)
    throw error_at(given, "found more than ", max_cases, " cases, allowed: at most that many.");
  const std::size_t first = cases.size();
  cases.resize(first + n);
  const std::vector<CaseFactor> &factors = case_factors();
  std::vector<std::string> names;
  for (const CaseFactor &factor : factors)
    names.push_back(factor.name);
  for (const std::string &part : split_list(text, ',')) {
    const auto factor = std::find_if(factors.begin(), factors.end(), [&](const CaseFactor &known) {
      return part.rfind(known.name + " ", 0) == 0;
    });
    require(factor != factors.end(), part,
            "one of " + join(names) +
              ", a blank and a number; what changes the stiffness needs a run of its own "
              "(--sweep)");
    const std::string useless = uselessness(*factor, scene);
    if (!useless.empty())
      throw error_at(given, "found the factor '", factor->name, "', but ", useless, ".");
    const std::vector<std::string> words = split_words(part.substr(factor->name.size()));
    double from = 0., to = 0.;
    const bool is_range = words.size() == 3 && words[1] == "to";
    require(words.size() == 1 || is_range, part,
            "one number, or two with 'to' between them and 'in 100 cases' at the end, and a comma "
            "before the next factor");
    require(!is_range || n > 1, part, "a range with the number of its cases, 'in 100 cases'");
    require(read_number(given, words.front(), from), words.front(), "a number");
    require(read_number(given, words.back(), to), words.back(), "a number");
    require(std::max(std::abs(from), std::abs(to)) <= max_magnitude, part,
            "numbers up to " + number_text(max_magnitude));
    for (unsigned int i = 0; i < n; ++i) {
      const double t = n > 1 ? static_cast<double>(i) / (n - 1) : 0.;
      cases[first + i].*factor->number = (1. - t) * from + t * to;
    }
  }
}
} // namespace

std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene) {
  std::vector<LoadCase> cases;
  for (const std::string &entry : split_list(given.cases, '|'))
    read_cases(entry, given.cases, scene, cases);
  for (const std::string &word : split_words(given.fields)) {
    const unsigned int number =
      whole_number(given.fields, word, 1., static_cast<double>(cases.size()));
    if (number == 0)
      throw input_error(
        given.fields.where() + ": found " + quote(word) + ", allowed: numbers of cases, " +
        (cases.empty() ? "of which there are none" : "from 1 to " + std::to_string(cases.size())) +
        ".");
    cases[number - 1].has_fields = true;
  }
  return cases;
}
} // namespace Signorini
