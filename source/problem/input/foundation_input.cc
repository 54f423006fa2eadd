// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact/Foundation: rigid obstacles by words and numbers.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "input.h"

namespace Signorini
{
namespace
{
/** The largest number of obstacles: every point of a contact side computes its distance to all. */
constexpr std::size_t max_obstacles = 1000;

/** The largest gap in diameters of the body. */
constexpr double max_gap = 10.;

/** A word that begins a part of an obstacle, and the text up to the next one. */
struct Part
{
  std::string word;
  std::string text;
};

/** Splits "circle 0,1 radius 2" into {circle: 0,1} {radius: 2}. Text before the first word counts
 * as an unknown word. */
std::vector<Part> split_at_words(const std::string &text)
{
  const std::vector<std::string> words = {
    "plane", "circle", "parabola", "normal", "radius", "curvature", "inside"};
  const auto belongs_to_a_name = [](const unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '.';
  };
  std::vector<Part> parts(1);
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t end = i;
    while (end < text.size() && belongs_to_a_name(text[end]))
      ++end;
    end = std::max(end, i + 1);
    const std::string piece = text.substr(i, end - i);
    if (std::find(words.begin(), words.end(), piece) != words.end())
      parts.push_back({piece, ""});
    else
      parts.back().text += piece;
    i = end;
  }
  if (trim(parts.front().text).empty())
    parts.erase(parts.begin());
  else
    parts.front().word = trim(parts.front().text);
  return parts;
}

/** Reads the obstacles of one entry. */
class ObstacleReader
{
public:
  ObstacleReader(const Entry &entry, const Constants &constants, const Geometry<2> &geometry)
    : entry_(entry)
    , constants_(constants)
    , geometry_(geometry)
  {
  }

  Obstacle read(const std::string &text) const
  {
    const std::vector<Part> parts = split_at_words(text);
    std::string words;
    for (const Part &part : parts)
      words += (words.empty() ? "" : " ") + part.word;
    if (words == "plane normal")
      return Obstacle::plane(point(parts[0]), normal(parts[1]));
    if (words == "parabola normal curvature")
      return Obstacle::parabola(point(parts[0]), normal(parts[1]), numbers(parts[2], 1)[0]);
    if (words == "circle radius")
      return Obstacle::circle(point(parts[0]), radius(parts[1]), Body::outside);
    if (words == "circle radius inside" && trim(parts[2].text).empty())
      return Obstacle::circle(point(parts[0]), radius(parts[1]), Body::inside);
    throw InputError(entry_.where() + ": found " + quote(text) +
                     ", allowed: plane x,y normal nx,ny; circle x,y radius r; circle x,y radius r "
                     "inside; parabola x,y normal nx,ny curvature k.");
  }

  /** Reads "dx, dy". */
  Tensor<1, 2> vector(const std::string &text) const
  {
    const std::vector<double> xy = numbers({"", text}, 2);
    return Tensor<1, 2>({xy[0], xy[1]});
  }

private:
  /** Reads numbers separated by commas, each a formula of the constants. */
  std::vector<double> numbers(const Part &part, const std::size_t n) const
  {
    std::vector<double> numbers;
    const std::vector<std::string> texts = split_list(part.text, ',');
    const auto refuse = [&]() {
      throw InputError(entry_.where() + ": found " + quote(trim(part.text)) +
                       (part.word.empty() ? "" : " after '" + part.word + "'") +
                       (n == 1 ? ", allowed: one number"
                               : ", allowed: two numbers separated by a "
                                 "comma") +
                       " (formulas of the constants) up to " + number_text(max_magnitude) + ".");
    };
    if (texts.size() != n)
      refuse();
    for (const std::string &text : texts)
    {
      const Expression<2> formula(text, constants_, entry_.where());
      numbers.push_back(formula(Point<2>()));
      if (!formula.is_constant() || !(std::abs(numbers.back()) <= max_magnitude))
        refuse();
    }
    return numbers;
  }

  Point<2> point(const Part &part) const
  {
    const Point<2> x(vector_of(part));
    check_length(x.distance(geometry_.inner_point()), "a distance", part);
    return x;
  }

  Tensor<1, 2> vector_of(const Part &part) const
  {
    const std::vector<double> xy = numbers(part, 2);
    return Tensor<1, 2>({xy[0], xy[1]});
  }

  Tensor<1, 2> normal(const Part &part) const
  {
    const Tensor<1, 2> n = vector_of(part);
    if (!(n.norm() >= min_magnitude))
      throw InputError(entry_.where() + ": found the normal " + quote(trim(part.text)) +
                       ", allowed: a vector of any length but zero, towards the body.");
    return n;
  }

  double radius(const Part &part) const
  {
    const double r = numbers(part, 1)[0];
    if (!(r >= min_magnitude))
      throw InputError(entry_.where() + ": found the radius " + number_text(r) +
                       ", allowed: numbers from " + number_text(min_magnitude) + ".");
    check_length(r, "the radius", part);
    return r;
  }

  /** Refuses large and far circles, whose gaps |x - c| - r lose digits. */
  void check_length(const double length, const std::string &what, const Part &part) const
  {
    const double diameter = geometry_.diameter();
    if (!(length <= max_distance * diameter))
      throw InputError(entry_.where() + ": found " + quote(trim(part.text)) + " after '" +
                       part.word + "', " + what + " of " + number_text(length) +
                       " for a body of the size " + number_text(diameter) + ", allowed: at most " +
                       number_text(max_distance) +
                       " times its size; take a plane or a parabola that begins near the body.");
  }

  const Entry &entry_;
  const Constants &constants_;
  const Geometry<2> &geometry_;
};

/** Returns some arc lengths of a side, with the one nearest to a point on every piece. */
std::vector<double> sample(const Side<2> &side, const Point<2> &near)
{
  constexpr unsigned int n_samples = 16;
  std::vector<double> samples;
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
  {
    const double start = side.start_of(k), end = side.start_of(k + 1);
    for (unsigned int i = 0; i < n_samples; ++i)
      samples.push_back(start + (i + 0.5) / n_samples * (end - start));
    samples.push_back(std::clamp(start + side.piece(k).arc_length(near), start, end));
  }
  return samples;
}

/** Returns whether the normal somewhere on a side meets an obstacle; wherever it is, if load cases
 * move it. */
bool can_touch(const Obstacle &obstacle,
               const Side<2> &side,
               const Tensor<1, 2> &position,
               const double reach,
               const bool moves)
{
  const std::vector<double> samples = sample(side, obstacle.anchor() + position);
  return std::any_of(samples.begin(), samples.end(), [&](const double s) {
    const Tensor<1, 2> n = side.normal(s);
    return moves ? obstacle.can_be_hit_along(n)
                 : obstacle.is_hit_by_line(side.point(s) - position, n, reach);
  });
}

/** An obstacle with the sides that may touch it. */
struct ObstacleOfSides
{
  Obstacle obstacle;
  std::vector<unsigned int> sides;
};

std::vector<ObstacleOfSides> read_obstacles(const Given<std::string> &given,
                                            const Constants &constants,
                                            const Scene<2> &scene,
                                            const bool moves)
{
  const Geometry<2> &geometry = scene.geometry;
  const ObstacleReader reader(given, constants, geometry);
  const std::vector<unsigned int> contact_sides = scene.contact_sides();
  std::vector<std::string> names;
  for (const unsigned int side : contact_sides)
    names.push_back(geometry.sides[side].name());
  const std::vector<std::string> texts = split_list(given, '|');
  if (texts.size() > max_obstacles)
    throw InputError(given.where() + ": found " + std::to_string(texts.size()) +
                     " things, allowed: at most " + std::to_string(max_obstacles) + ".");
  const double reach = max_gap * geometry.diameter();
  std::vector<ObstacleOfSides> things;
  for (const std::string &text : texts)
  {
    std::vector<unsigned int> sides = contact_sides;
    std::string description = text;
    if (begins_with_a_name(text))
    {
      sides.clear();
      for (const auto &[name, rest] : read_side_list(text, given.where(), names))
      {
        sides.push_back(static_cast<unsigned int>(geometry.find_side(name)));
        description = rest;
      }
    }
    things.push_back({reader.read(description), sides});
    if (std::none_of(sides.begin(), sides.end(), [&](const unsigned int side) {
          return can_touch(
            things.back().obstacle, geometry.sides[side], scene.foundation_position, reach, moves);
        }))
      throw InputError(
        given.where() + ": found " + quote(text) +
        ", which no outward normal of its contact sides can meet; allowed: things "
        "ahead of a contact side, with normals towards the body, at a distance below " +
        number_text(reach) + " (" + number_text(max_gap) + " times the size of the body).");
  }
  return things;
}
} // namespace

void read_foundation(const ContactParameters &given,
                     const Constants &constants,
                     const bool moves,
                     Scene<2> &scene)
{
  if (given.foundation.value.empty())
  {
    if (given.foundation_position.changed)
      throw InputError(given.foundation_position.where() + ": it needs " + given.foundation.name +
                       ", which is not given.");
    return;
  }
  scene.foundation_position = ObstacleReader(given.foundation_position, constants, scene.geometry)
                                .vector(given.foundation_position);
  const std::vector<ObstacleOfSides> things =
    read_obstacles(given.foundation, constants, scene, moves);
  for (const unsigned int side : scene.contact_sides())
  {
    std::vector<Obstacle> side_data;
    for (const ObstacleOfSides &obstacle : things)
      if (std::count(obstacle.sides.begin(), obstacle.sides.end(), side) > 0)
        side_data.push_back(obstacle.obstacle);
    if (side_data.empty())
      continue;
    BoundaryCondition<2> &condition = scene.boundary[side];
    condition.foundation =
      std::make_shared<Foundation>(side_data, max_gap * scene.geometry.diameter());
    condition.data =
      foundation_gap(scene.geometry.sides[side], condition.foundation, scene.foundation_position);
  }
}

SideTexts gaps_without_foundation(const ContactParameters &given, const Scene<2> &scene)
{
  const Given<std::string> &gap = given.gap;
  const std::vector<std::string> all = scene.geometry.side_names();
  std::vector<std::string> with, without;
  for (const unsigned int side : scene.contact_sides())
    (scene.boundary[side].foundation == nullptr ? without : with).push_back(all[side]);
  if (with.empty())
    return read_contact_list(gap.value, gap.where(), all, without);
  const auto refuse_both = [&](const std::string &side) {
    throw InputError(gap.where() + ": found a gap for the side '" + side + "', which has a " +
                     given.foundation.name + "; allowed: one of them for each contact side.");
  };
  if (gap.changed && !begins_with_a_name(gap.value))
    refuse_both(with.front());
  if (!gap.changed)
  {
    if (!without.empty())
      throw InputError(given.foundation.where() + ": found nothing for the contact side '" +
                       without.front() +
                       "', allowed: something for every contact side, here or in " + gap.name +
                       " (" + without.front() + ": 0).");
    return {};
  }
  for (const auto &entry : read_side_list(gap.value, gap.where(), all))
    if (std::count(with.begin(), with.end(), entry.first) > 0)
      refuse_both(entry.first);
  return read_contact_list(gap.value, gap.where(), all, without.empty() ? with : without);
}
} // namespace Signorini
