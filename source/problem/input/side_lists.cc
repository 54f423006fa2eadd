// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists by boundary name: entries separated by '|', the name before the first ':'.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>

#include "input.h"

namespace Signorini
{
// Expressions may contain a ':' of their own (c ? a : b).
bool begins_with_a_name(const std::string &text)
{
  const auto colon = text.find(':');
  const std::string name = trim(text.substr(0, colon));
  return colon != std::string::npos && !name.empty() &&
         std::all_of(name.begin(), name.end(), [](const unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
         });
}

std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides)
{
  std::vector<std::string> parts;
  for (const std::string &side : sides)
  {
    if (side == name)
      return {name};
    if (side.rfind(name + ".", 0) == 0 && side.size() > name.size() + 1 &&
        side.find_first_not_of("0123456789", name.size() + 1) == std::string::npos)
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
  const auto has_entry = [&](const std::string &side) {
    return std::any_of(
      entries.begin(), entries.end(), [&](const auto &entry) { return entry.first == side; });
  };
  for (const auto &entry : read_side_list(text, where, sides))
  {
    if (has_entry(entry.first) ||
        std::count(contact_sides.begin(), contact_sides.end(), entry.first) == 0)
      throw InputError(where + ": found an entry for " + quote(entry.first) +
                       ", allowed: one for each contact side (" + join(contact_sides) + ").");
    entries.push_back(entry);
  }
  for (const std::string &side : contact_sides)
    if (!has_entry(side))
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
                     const std::function<void(Plate &, const std::string &name, double)> &take)
{
  if (given.value.empty())
    return;
  std::vector<std::string> names;
  for (const Plate &plate : plates)
    names.push_back(geometry.sides[plate.side].name());
  if (names.empty())
    throw InputError(given.where() + ": found " + quote(given.value) +
                     ", but Boundary/Plates names no plate.");
  for (const auto &[name, text] : read_side_list(given.value, given.where(), names))
  {
    double number = 0.;
    if (!read_number(text, number) || !(std::abs(number) <= max_magnitude))
      throw InputError(given.where() + ": found " + quote(text) + " for the plate '" + name +
                       "', allowed: one number up to " + number_text(max_magnitude) + ".");
    take(plates[std::find(names.begin(), names.end(), name) - names.begin()], name, number);
  }
}

/** Reads the force or the travel of each plate. */
void read_drives(const LoadParameters &load,
                 const Given<std::string> &given,
                 const Geometry<2> &geometry,
                 std::vector<Plate> &plates)
{
  std::set<unsigned int> driven;
  read_numbers_of(
    load.plate_force, geometry, plates, [&](Plate &plate, const auto &, double force) {
      driven.insert(plate.side);
      plate.is_pushed = true;
      plate.force = force;
    });
  read_numbers_of(
    load.plate_travel, geometry, plates, [&](Plate &plate, const auto &name, double travel) {
      if (plate.is_pushed)
        throw InputError(load.plate_travel.where() + ": the plate '" + name +
                         "' has a Plate force already; allowed: one of the two.");
      driven.insert(plate.side);
      plate.travel = travel;
    });
  read_numbers_of(
    load.plate_moment, geometry, plates, [&](Plate &plate, const auto &name, double moment) {
      if (!plate.turns)
        throw InputError(load.plate_moment.where() + ": the plate '" + name +
                         "' does not turn; allowed: moments of plates with the word turning in "
                         "Boundary/Plates.");
      plate.moment = moment;
    });
  for (const Plate &plate : plates)
    if (driven.count(plate.side) == 0)
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
  for (const auto &[name, text] : read_side_list(given.value, given.where(), geometry.side_names()))
    plates.push_back(read_plate(name, text, given, geometry));
  read_drives(load, given, geometry, plates);
  return plates;
}
} // namespace Signorini
