// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists by boundary name: entries separated by '|', the name before the first ':'.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

#include "input.h"

namespace Signorini
{
namespace
{
bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** Returns whether a text is a single word, as a name before ':' is. Expressions may contain a ':'
 * of their own (c ? a : b). */
bool looks_like_a_name(const std::string &text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](const unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
}
} // namespace

bool begins_with_a_name(const std::string &text)
{
  const auto colon = text.find(':');
  return colon != std::string::npos && looks_like_a_name(trim(text.substr(0, colon)));
}

std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides)
{
  std::vector<std::string> parts;
  const std::string beginning = name + ".";
  for (const std::string &side : sides)
  {
    if (side == name)
      return {name};
    const std::string number =
      side.compare(0, beginning.size(), beginning) == 0 ? side.substr(beginning.size()) : "";
    if (!number.empty() && std::all_of(number.begin(), number.end(), [](const unsigned char c) {
          return std::isdigit(c) != 0;
        }))
      parts.push_back(side);
  }
  return parts;
}

SideTexts read_side_list(const std::string &text,
                         const std::string &where,
                         const std::vector<std::string> &sides,
                         const std::string &allowed)
{
  SideTexts entries;
  for (const std::string &part : split_list(text, '|'))
  {
    const auto colon = part.find(':');
    const std::string name = trim(part.substr(0, colon));
    const std::vector<std::string> called = sides_called(name, sides);
    if (colon == std::string::npos || called.empty())
      throw InputError(where + ": found " + quote(part) + ", allowed: " +
                       (allowed.empty() ? "a side (" + join(sides) + ")" : allowed) +
                       ", ':' and its value.");
    for (const std::string &side : called)
      entries.emplace_back(side, trim(part.substr(colon + 1)));
  }
  return entries;
}

SideTexts read_contact_list(const std::string &text,
                            const std::string &where,
                            const std::vector<std::string> &sides,
                            const std::vector<std::string> &contact_sides)
{
  SideTexts entries;
  if (!begins_with_a_name(text))
  {
    for (const std::string &side : contact_sides)
      entries.emplace_back(side, trim(text));
    return entries;
  }
  for (const auto &entry : read_side_list(text, where, sides))
  {
    const bool repeated = std::any_of(entries.begin(), entries.end(), [&](const auto &other) {
      return other.first == entry.first;
    });
    if (repeated || !contains(contact_sides, entry.first))
      throw InputError(where + ": found an entry for " + quote(entry.first) +
                       ", allowed: one for each contact side (" + join(contact_sides) + ").");
    entries.push_back(entry);
  }
  for (const std::string &side : contact_sides)
    if (std::none_of(
          entries.begin(), entries.end(), [&](const auto &entry) { return entry.first == side; }))
      throw InputError(where + ": found no entry for the contact side '" + side +
                       "', allowed: one for each contact side.");
  return entries;
}

// Rigid plates: their sides and directions, and what drives them.

namespace
{
/** Reads "dx, dy", perhaps with the word "turning" behind it. */
Plate read_plate(const std::string &name,
                 const std::string &text,
                 const Entry &entry,
                 const Geometry<2> &geometry)
{
  const std::string word = "turning";
  Plate plate;
  std::string numbers = text;
  const auto place = text.find(word);
  plate.turns = place != std::string::npos && trim(text.substr(place)) == word;
  if (plate.turns)
    numbers = trim(text.substr(0, place));
  std::vector<double> d;
  if (!read_numbers(numbers, d) || d.size() != 2 || !(std::hypot(d[0], d[1]) > 0.))
    throw InputError(entry.where() + ": found " + quote(text) + " for the side '" + name +
                     "', allowed: a direction dx, dy, perhaps followed by the word turning.");
  plate.side = geometry.find_side(name);
  const Side<2> &side = geometry.sides[plate.side];
  plate.centre = side.point(0.5 * side.length());
  plate.direction = Tensor<1, 2>({d[0], d[1]}) / std::hypot(d[0], d[1]);
  return plate;
}

/** Reads "side: number" entries for plates. */
void read_numbers_of(const Given<std::string> &given,
                     const Geometry<2> &geometry,
                     std::vector<Plate> &plates,
                     const std::function<void(Plate &, double)> &take)
{
  if (given.value.empty())
    return;
  std::vector<std::string> names;
  names.reserve(plates.size());
  for (const Plate &plate : plates)
    names.push_back(geometry.sides[plate.side].name());
  if (names.empty())
    throw InputError(given.where() + ": found " + quote(given.value) +
                     ", but Boundary/Plates names no plate.");
  for (const auto &[name, text] : read_side_list(given.value, given.where(), names))
  {
    std::vector<double> number;
    if (!read_numbers(text, number) || number.size() != 1 ||
        !(std::abs(number[0]) <= max_magnitude))
      throw InputError(given.where() + ": found " + quote(text) + " for the plate '" + name +
                       "', allowed: one number up to " + number_text(max_magnitude) + ".");
    take(plates[std::find(names.begin(), names.end(), name) - names.begin()], number[0]);
  }
}

/** Reads the force or the travel of each plate. */
void read_drives(const LoadParameters &load,
                 const Given<std::string> &given,
                 const Geometry<2> &geometry,
                 std::vector<Plate> &plates)
{
  std::vector<bool> has_travel(plates.size(), false);
  const auto index = [&](const Plate &plate) { return &plate - plates.data(); };
  read_numbers_of(load.plate_force, geometry, plates, [](Plate &plate, const double force) {
    plate.is_pushed = true;
    plate.force = force;
  });
  read_numbers_of(load.plate_travel, geometry, plates, [&](Plate &plate, const double travel) {
    if (plate.is_pushed)
      throw InputError(load.plate_travel.where() + ": the plate '" +
                       geometry.sides[plate.side].name() +
                       "' has a Plate force already; allowed: one of the two.");
    has_travel[index(plate)] = true;
    plate.travel = travel;
  });
  read_numbers_of(load.plate_moment, geometry, plates, [&](Plate &plate, const double moment) {
    if (!plate.turns)
      throw InputError(load.plate_moment.where() + ": the plate '" +
                       geometry.sides[plate.side].name() +
                       "' does not turn; allowed: moments of plates with the word turning in "
                       "Boundary/Plates.");
    plate.moment = moment;
  });
  for (const Plate &plate : plates)
    if (!plate.is_pushed && !has_travel[index(plate)])
      throw InputError(given.where() + ": the plate '" + geometry.sides[plate.side].name() +
                       "' has no entry in Load/Plate force or Load/Plate travel, allowed: one of "
                       "the two.");
}
} // namespace

std::vector<Plate> read_plates(const Given<std::string> &given,
                               const LoadParameters &load,
                               const Geometry<2> &geometry)
{
  std::vector<Plate> plates;
  if (!given.value.empty())
    for (const auto &[name, text] :
         read_side_list(given.value, given.where(), geometry.side_names()))
      plates.push_back(read_plate(name, text, given, geometry));
  read_drives(load, given, geometry, plates);
  return plates;
}
} // namespace Signorini
