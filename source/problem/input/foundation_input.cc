// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact/Foundation: rigid obstacles by words and numbers, the gaps of sides, and those of pairs
// of sides.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/facing.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "input.h"

namespace Signorini {
namespace {
/** The largest number of obstacles: every point of a contact side computes its distance to all. */
constexpr std::size_t max_obstacles = 1000;

/** The largest gap in diameters of the body. */
constexpr double max_gap = 10.;

/** Reads the obstacles of one entry. */
template <int dim>
class ObstacleReader {
public:
  ObstacleReader(const Entry &entry, const Geometry<dim> &geometry)
    : entry_(entry)
    , geometry_(geometry) {}

  Obstacle<dim> read(const std::string &text) const;

  /** Reads "x, y" or "x, y, z". */
  Tensor<1, dim> vector(const Phrase::Part &part) const {
    const std::vector<double> components = numbers(part, dim);
    Tensor<1, dim> v;
    std::copy(components.begin(), components.end(), v.begin_raw());
    return v;
  }

private:
  [[noreturn]] void refuse(const std::string &found, const std::string &allowed) const {
    throw error_at(entry_, "found ", found, ", allowed: ", allowed, ".");
  }

  /** Reads numbers separated by commas, each a formula of the constants. */
  std::vector<double> numbers(const Phrase::Part &part, const std::size_t n) const {
    std::vector<double> numbers;
    const auto is_large = [](const double x) { return std::abs(x) > max_magnitude; };
    if (!read_numbers(entry_, part.text, numbers) || numbers.size() != n ||
        std::any_of(numbers.begin(), numbers.end(), is_large))
      refuse(quote(part.text) + (part.word.empty() ? "" : " after '" + part.word + "'"),
             std::string(n == 1   ? "one number"
                         : n == 2 ? "two numbers separated by a comma"
                                  : "three numbers separated by commas") +
               " (formulas of the constants) up to " + number_text(max_magnitude));
    return numbers;
  }

  Point<dim> point(const Phrase::Part &part) const {
    const Point<dim> x(vector(part));
    check_length(x.distance(geometry_.inner_point()), "a distance", part);
    return x;
  }

  /** Reads a normal or an axis. */
  Tensor<1, dim> direction(const Phrase::Part &part) const {
    const Tensor<1, dim> n = vector(part);
    if (!(n.norm() >= min_magnitude))
      refuse("the " + part.word + " " + quote(part.text),
             "a vector of any length but zero" +
               std::string(part.word == "normal" ? ", towards the body" : ""));
    return n;
  }

  double radius(const Phrase::Part &part) const {
    const double r = numbers(part, 1)[0];
    if (!(r >= min_magnitude))
      refuse("the radius " + number_text(r), "numbers from " + number_text(min_magnitude));
    check_length(r, "the radius", part);
    return r;
  }

  /** Refuses large and far circles and the like, whose gaps |x - c| - r lose digits. */
  void check_length(const double length, const std::string &name, const Phrase::Part &part) const {
    const double diameter = geometry_.diameter();
    if (!(length <= max_distance * diameter))
      refuse(quote(part.text) + " after '" + part.word + "', " + name + " of " +
               number_text(length) + " for a body of the size " + number_text(diameter),
             "at most " + number_text(max_distance) + " times its size; take a plane " +
               (dim == 2 ? "or a parabola " : "") + "that begins near the body");
  }

  const Entry &entry_;
  const Geometry<dim> &geometry_;
};

template <>
Obstacle<2> ObstacleReader<2>::read(const std::string &text) const {
  const auto [parts, form] = Phrase(text, "plane|circle|parabola|normal|radius|curvature|inside");
  if (form == "plane normal")
    return Obstacle<2>::plane(point(parts[1]), direction(parts[2]));
  if (form == "parabola normal curvature")
    return Obstacle<2>::parabola(point(parts[1]), direction(parts[2]), numbers(parts[3], 1)[0]);
  const bool is_inside = form == "circle radius inside" && parts[3].text.empty();
  if (is_inside || form == "circle radius") {
    // Compilers evaluate arguments in different orders.
    const double r = radius(parts[2]);
    return Obstacle<2>::circle(point(parts[1]), r, is_inside ? Body::inside : Body::outside);
  }
  refuse(quote(text),
         "plane x,y normal nx,ny; circle x,y radius r; circle x,y radius r inside; parabola x,y "
         "normal nx,ny curvature k");
}

template <>
Obstacle<3> ObstacleReader<3>::read(const std::string &text) const {
  const auto [parts, form] = Phrase(text, "plane|sphere|cylinder|normal|axis|radius|inside");
  if (form == "plane normal") {
    const Point<3> x = point(parts[1]);
    return Obstacle<3>::plane(x, direction(parts[2]));
  }
  const bool is_inside = parts.back().word == "inside" && parts.back().text.empty();
  const Body body = is_inside ? Body::inside : Body::outside;
  if (form == (is_inside ? "sphere radius inside" : "sphere radius")) {
    const double r = radius(parts[2]);
    return Obstacle<3>::circle(point(parts[1]), r, body);
  }
  if (form == (is_inside ? "cylinder axis radius inside" : "cylinder axis radius")) {
    const Tensor<1, 3> axis = direction(parts[2]);
    const double r = radius(parts[3]);
    return Obstacle<3>::cylinder(point(parts[1]), axis, r, body);
  }
  refuse(quote(text), "plane x,y,z normal a,b,c; sphere x,y,z radius r; cylinder x,y,z axis a,b,c "
                      "radius r; both also with 'inside' behind the radius");
}

/** Returns some points of a side with their normals, the one nearest to a point among them. */
std::vector<SurfacePoint<2>> sample(const Side<2> &side, const Point<2> &near) {
  constexpr unsigned int n_samples = 16;
  std::vector<double> samples;
  for (unsigned int k = 0; k < side.n_pieces(); ++k) {
    const double start = side.start_of(k), end = side.start_of(k + 1);
    for (unsigned int i = 0; i < n_samples; ++i)
      samples.push_back(start + (i + 0.5) / n_samples * (end - start));
    samples.push_back(std::clamp(start + side.piece(k).arc_length(near), start, end));
  }
  std::vector<SurfacePoint<2>> points;
  for (const double s : samples)
    points.push_back({side.point(s), side.normal(s)});
  return points;
}
std::vector<SurfacePoint<3>> sample(const Side<3> &side, const Point<3> & /*near*/) {
  return side.samples(side.faces().size() > 50 ? 2 : 8);
}

/** How obstacles are read: along which direction planes act, and whether load cases move them. */
struct FoundationUse {
  ContactDirection direction;
  bool moves;
};

/** Returns whether the direction of contact somewhere on a side meets an obstacle; wherever it is,
 * if load cases move it. */
template <int dim>
bool can_touch(const Obstacle<dim> &obstacle, const Side<dim> &side, const Tensor<1, dim> &position,
               const double reach, const FoundationUse &use) {
  const auto points = sample(side, obstacle.anchor() + position);
  const auto direction_at = [&](const Tensor<1, dim> &n) {
    const auto of_plane = obstacle.direction();
    return of_plane && use.direction == ContactDirection::foundation ? *of_plane : n;
  };
  return std::any_of(points.begin(), points.end(), [&](const SurfacePoint<dim> &point) {
    return obstacle.can_be_hit_along(point.n) &&
           (use.moves || obstacle.is_hit_by_line(point.x - position, direction_at(point.n), reach));
  });
}

/** Returns the obstacles of each contact. */
template <int dim>
std::map<unsigned int, std::vector<Obstacle<dim>>> read_obstacles(const Given<std::string> &given,
                                                                  const Scene<dim> &scene,
                                                                  const FoundationUse &use) {
  const Geometry<dim> &geometry = scene.geometry;
  const std::vector<std::string> texts = split_list(given, '|');
  if (texts.size() > max_obstacles)
    throw error_at(given, "found ", texts.size(), " things, allowed: at most ", max_obstacles, ".");
  const double reach = max_gap * geometry.diameter();
  const std::vector<std::string> names = contact_names(scene);
  // An obstacle without a side is for those that touch no other body.
  std::vector<std::string> rigid;
  for (const ContactPair<dim> &pair : contact_pairs(scene))
    if (!pair.other_side())
      rigid.push_back(names[pair.number()]);
  std::map<unsigned int, std::vector<Obstacle<dim>>> obstacles;
  for (const std::string &text : texts) {
    SideTexts entries;
    if (begins_with_a_name(text))
      entries = read_side_list(text, given.where(), names);
    else
      for (const std::string &name : rigid.empty() ? names : rigid)
        entries.emplace_back(name, text);
    const Obstacle<dim> obstacle =
      ObstacleReader<dim>(given, geometry).read(entries.front().second);
    bool touches = false;
    for (const auto &entry : entries) {
      const unsigned int contact = find_contact(entry.first, scene);
      obstacles[contact].push_back(obstacle);
      touches = touches || can_touch(obstacle, geometry.sides[scene.contacts[contact].side],
                                     scene.foundation_position, reach, use);
    }
    if (!touches)
      throw error_at(given, "found ", quote(text),
                     ", which no outward normal of its contact sides can meet; allowed: things "
                     "ahead of a contact side, with normals towards the body, at a distance below ",
                     reach, " (", max_gap, " times the size of the body).");
  }
  return obstacles;
}
} // namespace

template <int dim>
void read_foundation(const ContactParameters &given, const bool moves, Scene<dim> &scene) {
  if (given.foundation.value.empty()) {
    for (const Entry *const entry :
         std::initializer_list<const Entry *>{&given.foundation_position, &given.direction})
      if (entry->changed)
        throw error_at(*entry, "it needs ", given.foundation.name, ", which is not given.");
    return;
  }
  if (given.foundation_position.changed)
    scene.foundation_position = ObstacleReader<dim>(given.foundation_position, scene.geometry)
                                  .vector({"", trim(given.foundation_position)});
  const auto of_contacts = read_obstacles(given.foundation, scene, {given.direction, moves});
  for (const auto &[number, obstacles] : of_contacts) {
    ContactCondition<dim> &contact = scene.contacts[number];
    const Side<dim> &side = scene.geometry.sides[contact.side];
    contact.foundation =
      std::make_shared<Foundation<dim>>(obstacles, max_gap * scene.geometry.diameter());
    if (given.direction == ContactDirection::foundation)
      contact.directions =
        ContactDirections<dim>(side, *contact.foundation, scene.foundation_position);
    contact.gap =
      foundation_gap(side, contact.foundation, scene.foundation_position, contact.directions);
  }
}

INSTANTIATE_FUNCTION(read_foundation);

template <int dim>
SideTexts gaps_without_foundation(const ContactParameters &given, const Scene<dim> &scene) {
  const Given<std::string> &gap = given.gap;
  const std::vector<std::string> all = names_with_contacts(scene), names = contact_names(scene);
  SideTexts named;
  if (begins_with_a_name(gap.value))
    named = read_side_list(gap.value, gap.where(), all);
  std::vector<std::string> with, without, rigid;
  for (const ContactPair<dim> &pair : contact_pairs(scene)) {
    const std::string &side = names[pair.number()];
    const bool has_foundation = pair.data().foundation != nullptr, is_rigid = !pair.other_side(),
               has_text = std::any_of(named.begin(), named.end(),
                                      [&](const auto &entry) { return entry.first == side; });
    if (has_foundation)
      with.push_back(side);
    else if (is_rigid)
      rigid.push_back(side);
    // The gap of a pair is the distance of its sides, to which a text adds.
    if (!has_foundation && (is_rigid || named.empty() || has_text))
      without.push_back(side);
  }
  if (!with.empty() && gap.changed && (without.empty() || named.empty()))
    throw error_at(gap, "found a gap for the side '", with.front(), "', which has a ",
                   given.foundation.name, "; allowed: one of them for each contact side.");
  if (!with.empty() && !gap.changed && !rigid.empty())
    throw error_at(given.foundation, "found nothing for the contact side '", rigid.front(),
                   "', allowed: something for every contact side, here or in ", gap.name, " (",
                   rigid.front(), ": 0).");
  return read_list_for(without, gap.value, gap.where(), all);
}

INSTANTIATE_FUNCTION(gaps_without_foundation);

void close_pairs(const std::string &where, Scene<2> &scene) {
  const double small = small_overlap * scene.geometry.diameter();
  for (ContactCondition<2> &contact : scene.contacts) {
    if (!contact.opposite)
      continue;
    const Side<2> &first = scene.geometry.sides[contact.side],
                  &second = scene.geometry.sides[*contact.opposite];
    const std::string pair = "'" + first.name() + "' with '" + second.name() + "'";
    if (contact.foundation != nullptr)
      throw input_error(where, ": the pair ", pair,
                        " has a Contact/Foundation, allowed: a Gap, in addition to the distance of "
                        "the two sides.");
    const std::vector<FacingPart> parts = seen_parts(first, second, facing, scene.geometry);
    if (parts.empty())
      throw input_error(where, ": the sides of the pair ", pair,
                        " do not face each other, allowed: sides of which some part has a normal "
                        "within 30 degrees of the other's.");
    for (const FacingPart &part : parts)
      if (part.distance < -small)
        throw input_error(where, ": the bodies of the pair ", pair, " overlap by ", -part.distance,
                          " at (", first.point(part.nearest),
                          "), allowed: bodies that lie apart or touch as they are drawn, and a "
                          "negative Gap for interference.");
    if (!(contact.to > contact.from))
      throw input_error(where, ": the pair ", pair,
                        " lies behind other pairs of its sides, allowed: partners beside each "
                        "other.");
    if (contact.gap == nullptr)
      contact.gap = std::make_shared<Functions::ZeroFunction<2>>();
    contact.directions = ContactDirections<2>(first, second);
    contact.gap = gap_of_pair(first, second, contact.directions, contact.gap);
  }
}
} // namespace Signorini
