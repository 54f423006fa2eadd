// SPDX-License-Identifier: LGPL-2.1-or-later
// Problem (1) from the parameters: out of the catalogue, or described by expressions.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/catalogue/catalogue.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/corners.h>
#include <signorini/problem/scene/rigid_motions.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "input.h"

namespace Signorini
{
/** Reads the subsection Load cases. @throws InputError. */
std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene);

namespace
{
/** The name of the scene that the other entries describe. */
const std::string described = "described";

/** Refuses entries that describe a scene if a catalogue scene fixes them. */
void refuse_description(const Parameters &parameters)
{
  if (parameters.changes_of_scene.empty())
    return;
  const Given<std::string> &name = parameters.scene.name;
  throw InputError(parameters.changes_of_scene.front().where() + ": the catalogue scene '" +
                   name.value + "' fixes this entry; leave it out, or set " + name.name + " = " +
                   described + ".");
}

/** Returns whether the body begins inside the foundation somewhere on a side. */
bool begins_inside(const Side<2> &side, const Function<2> &gap)
{
  constexpr unsigned int n_samples = 64;
  for (unsigned int i = 0; i < n_samples; ++i)
    if (gap.value(side.point((i + 0.5) / n_samples * side.length())) < 0.)
      return true;
  return false;
}

/** Returns whether anything could press the body onto the foundation. */
bool is_loaded(const Scene<2> &scene)
{
  for (const unsigned int side : scene.contact_sides())
    if (begins_inside(scene.geometry.sides[side], *scene.boundary[side].data))
      return true;
  const bool is_pushed = std::any_of(scene.plates.begin(), scene.plates.end(), [](const auto &p) {
    return p.force != 0. || p.moment != 0.;
  });
  const bool has_data =
    std::any_of(scene.boundary.begin(), scene.boundary.end(), [](const auto &condition) {
      return condition.role == Role::traction || condition.role == Role::displacement;
    });
  return is_pushed || has_data || scene.body_force != nullptr;
}

/** Finds out whether contact alone holds the body, which needs a load. */
void check_free_motions(Scene<2> &scene, const std::string &where)
{
  scene.is_held_by_contact = !free_rigid_motions(scene, Plates::held).empty();
  std::vector<std::string> names;
  for (const RigidMotion &motion : free_rigid_motions(scene, Plates::released))
    names.push_back(motion.name());
  if (!names.empty() && !is_loaded(scene))
    throw InputError(where + ": the clamped, prescribed and roller sides leave " +
                     join(names, " and ") +
                     " of the body free, and no load presses it onto the foundation; hold the "
                     "body with Clamped, Displacement or Rollers, or load it.");
}

/** The smallest distance of two kinks as a share of the body. Closer ones cut off slivers, each of
 * which is integrated on parts that shrink towards it. */
constexpr double min_kink_distance = 1e-3;

/** Refuses kinks that are too close. @p positions are sorted. */
void refuse_close_kinks(const std::vector<double> &positions,
                        const double extent,
                        const std::string &where)
{
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    if (!(positions[i + 1] - positions[i] >= min_kink_distance * extent))
      throw InputError(where + ": found kinks at " + number_text(positions[i]) +
                       " at a distance of " + number_text(positions[i + 1] - positions[i]) +
                       " from each other, allowed: distances of at least " +
                       number_text(min_kink_distance * extent) + " (a thousandth of the body).");
}

/** Refuses a position that misses the body, which would have no effect. */
void refuse_bad_kinks(const Scene<2> &scene, const DiscretizationParameters &given)
{
  const auto check = [&](const Given<std::vector<double>> &positions, const unsigned int d) {
    std::vector<double> sorted = positions;
    std::sort(sorted.begin(), sorted.end());
    refuse_close_kinks(
      sorted, scene.geometry.upper[d] - scene.geometry.lower[d], positions.where());
    for (const double position : positions.value)
      if (!(position >= scene.geometry.lower[d] && position <= scene.geometry.upper[d]))
        throw InputError(positions.where() + ": found " + number_text(position) +
                         ", allowed: positions on the body, from " +
                         number_text(scene.geometry.lower[d]) + " to " +
                         number_text(scene.geometry.upper[d]) + ".");
  };
  check(given.kinks_at_x, 0);
  check(given.kinks_at_y, 1);
}

/** Refuses supports of which no displacement of finite energy satisfies all. */
template <int dim>
void refuse_contradiction(const Scene<dim> &scene, const std::string &where)
{
  const std::string contradiction = find_contradiction(scene);
  if (!contradiction.empty())
    throw InputError(where + ": " + contradiction + ".");
}

/** Returns the scene that the parameters name. */
template <int dim>
Scene<dim> read_scene(const Parameters &parameters)
{
  const std::string &name = parameters.scene.name;
  if (name == described)
    return make_described_scene<dim>(parameters);
  std::vector<std::string> names = {described};
  for (const CatalogueEntry<dim> &entry : catalogue<dim>())
  {
    names.push_back(entry.name);
    if (entry.name != name)
      continue;
    refuse_description(parameters);
    Scene<dim> scene = entry.make();
    scene.name = entry.name;
    scene.title = entry.title;
    scene.description = describe_scene(name);
    return scene;
  }
  throw InputError(parameters.scene.name.where() + ": found " + quote(name) +
                   (dim == 2 ? "" : " with Dimension = 3") + ", allowed: " + join(names) + ".");
}
} // namespace

unsigned int dimension_of(const Parameters &parameters)
{
  if (parameters.dimension.changed)
    return parameters.dimension;
  const auto &in_space = catalogue<3>();
  const bool is_3d = std::any_of(in_space.begin(), in_space.end(), [&](const auto &entry) {
    return entry.name == parameters.scene.name.value;
  });
  return is_3d ? 3 : parameters.dimension.value;
}

template <>
Scene<2> make_scene(const Parameters &parameters)
{
  Scene<2> scene = read_scene<2>(parameters);
  refuse_contradiction(scene, parameters.boundary.where);
  check_free_motions(scene, parameters.boundary.where);
  const DiscretizationParameters &discretization = parameters.discretization;
  refuse_bad_kinks(scene, discretization);
  std::vector<KinkLine<2>> lines = scene.kinks.lines();
  const std::vector<KinkLine<2>> more =
    lines_at<2>({{discretization.kinks_at_x.value, discretization.kinks_at_y.value}});
  lines.insert(lines.end(), more.begin(), more.end());
  scene.kinks = Kinks<2>(lines);
  for (const unsigned int side : scene.contact_sides())
    scene.kinks.add_ends_on(scene.geometry.sides[side]);
  scene.load_cases = read_load_cases(parameters.load_cases, scene);
  return scene;
}

template <>
Scene<3> make_scene(const Parameters &parameters)
{
  refuse_2d_entries(parameters);
  const Scene<3> scene = read_scene<3>(parameters);
  refuse_contradiction(scene, parameters.boundary.where);
  const std::vector<std::string> names = free_rigid_motions(scene);
  if (!names.empty())
    throw InputError(parameters.boundary.where +
                     ": the clamped, prescribed and roller sides leave " + join(names, " and ") +
                     " of the body free; in space, hold the body with Clamped, Displacement or "
                     "Rollers.");
  return scene;
}

// "force 0 to 3 in 100 cases, weight 1 | travel 2": lists and ranges of load cases.

namespace
{
constexpr unsigned int max_cases = 100000;

/** One factor, or a range of it. */
struct CaseFactor
{
  std::string name;
  double from;
  double to;
};

const std::vector<std::string> &factor_names()
{
  static const std::vector<std::string> names = {
    "force", "weight", "travel", "gap", "shift x", "shift y"};
  return names;
}

double &factor_of(LoadCase &load_case, const std::string &name)
{
  if (name == "force")
    return load_case.force;
  if (name == "weight")
    return load_case.weight;
  if (name == "travel")
    return load_case.travel;
  if (name == "gap")
    return load_case.gap;
  return load_case.shift[name == "shift x" ? 0 : 1];
}

/** Reads the entries of one parameter. */
class CaseReader
{
public:
  CaseReader(const Given<std::string> &given, const Scene<2> &scene)
    : given_(given)
    , scene_(scene)
  {
  }

  /** Reads one entry between '|'. */
  void read(const std::string &entry, std::vector<LoadCase> &cases) const
  {
    std::string text = entry;
    const unsigned int n = take_count(text);
    std::vector<CaseFactor> factors;
    for (const std::string &part : split_list(text, ','))
      factors.push_back(read_factor(part, entry));
    if (cases.size() + n > max_cases)
      throw InputError(given_.where() + ": found more than " + std::to_string(max_cases) +
                       " cases, allowed: at most that many.");
    for (unsigned int i = 0; i < n; ++i)
    {
      LoadCase load_case;
      const double t = n > 1 ? static_cast<double>(i) / (n - 1) : 0.;
      for (const CaseFactor &factor : factors)
        factor_of(load_case, factor.name) = (1. - t) * factor.from + t * factor.to;
      cases.push_back(load_case);
    }
    for (const CaseFactor &factor : factors)
      if (factor.from != factor.to && n == 1)
        refuse(entry);
  }

private:
  [[noreturn]] void refuse(const std::string &entry) const
  {
    throw InputError(given_.where() + ": found " + quote(entry) +
                     ", allowed: entries separated by '|' like force 0.5, weight 2 or force 0 to "
                     "3 in 100 cases, with the names " +
                     join(factor_names()) +
                     "; what changes the stiffness needs a run of its own (--sweep).");
  }

  /** Takes "in n cases" off the end. @return n, or 1. */
  unsigned int take_count(std::string &text) const
  {
    const std::vector<std::string> words = split_words(text);
    const std::size_t n = words.size();
    if (n < 3 || words[n - 1] != "cases" || words[n - 3] != "in")
      return 1;
    std::vector<double> count;
    if (!read_numbers(words[n - 2], count) || count.size() != 1 || !(count[0] >= 2.) ||
        !(count[0] <= max_cases) || count[0] != std::floor(count[0]))
      refuse(text);
    text = text.substr(0, text.rfind("in "));
    return static_cast<unsigned int>(count[0]);
  }

  CaseFactor read_factor(const std::string &part, const std::string &entry) const
  {
    for (const std::string &name : factor_names())
      if (part.compare(0, name.size() + 1, name + " ") == 0)
      {
        check(name);
        const std::vector<std::string> words = split_words(part.substr(name.size()));
        const bool is_range = words.size() == 3 && words[1] == "to";
        if (words.size() != 1 && !is_range)
          refuse(entry);
        return {name, number(words.front(), entry), number(words.back(), entry)};
      }
    refuse(entry);
  }

  double number(const std::string &word, const std::string &entry) const
  {
    std::vector<double> value;
    if (!read_numbers(word, value) || value.size() != 1 || !(std::abs(value[0]) <= max_magnitude))
      refuse(entry);
    return value[0];
  }

  /** Refuses a factor that could change nothing. */
  void check(const std::string &name) const
  {
    const auto refuse_name = [&](const std::string &what) {
      throw InputError(given_.where() + ": found the factor '" + name + "', but " + what + ".");
    };
    const bool is_shift = name == "shift x" || name == "shift y";
    if (is_shift)
      for (const unsigned int side : scene_.contact_sides())
        if (scene_.boundary[side].foundation == nullptr)
          refuse_name("the side '" + scene_.geometry.sides[side].name() +
                      "' has no Contact/Foundation that could be moved");
    if (name == "force" && !has_load(scene_, LoadKind::force))
      refuse_name("the scene has neither tractions nor plates with a force");
    if (name == "weight" && !has_load(scene_, LoadKind::weight))
      refuse_name("the scene has no body force");
    if (name == "travel" && !has_load(scene_, LoadKind::travel))
      refuse_name("the scene has no prescribed displacement");
  }

  const Given<std::string> &given_;
  const Scene<2> &scene_;
};

/** Marks the cases whose fields are written. */
void read_fields(const Given<std::string> &given, std::vector<LoadCase> &cases)
{
  for (const std::string &word : split_words(given.value))
  {
    std::vector<double> number;
    if (!read_numbers(word, number) || number.size() != 1 || number[0] != std::floor(number[0]) ||
        !(number[0] >= 1.) || !(number[0] <= static_cast<double>(cases.size())))
      throw InputError(
        given.where() + ": found " + quote(word) + ", allowed: numbers of cases, " +
        (cases.empty() ? "of which there are none" : "from 1 to " + std::to_string(cases.size())) +
        ".");
    cases[static_cast<std::size_t>(number[0]) - 1].has_fields = true;
  }
}
} // namespace

std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene)
{
  std::vector<LoadCase> cases;
  const CaseReader reader(given.cases, scene);
  if (!given.cases.value.empty())
    for (const std::string &entry : split_list(given.cases, '|'))
      reader.read(entry, cases);
  read_fields(given.fields, cases);
  return cases;
}
} // namespace Signorini
