// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists by boundary name: entries separated by '|', the name before the first ':'.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "input.h"

namespace Signorini {
Phrase::Phrase(const std::string &text, const std::string &words)
  : parts(1) {
  const std::regex any("\\b(" + words + ")\\b");
  bool is_word = false;
  for (std::sregex_token_iterator piece(text.begin(), text.end(), any, {-1, 0}), end; piece != end;
       ++piece, is_word = !is_word)
    if (is_word)
      parts.push_back({*piece, ""});
    else
      parts.back().text = trim(*piece);
  form = parts[0].text.empty() ? "" : "...";
  for (std::size_t i = 1; i < parts.size(); ++i)
    form += (form.empty() ? "" : " ") + parts[i].word;
}

// Expressions may contain a ':' of their own (c ? a : b).
bool begins_with_a_name(const std::string &text) {
  const auto colon = text.find(':');
  const std::string name = trim(text.substr(0, colon));
  return colon != std::string::npos && !name.empty() &&
         std::all_of(name.begin(), name.end(), [](const unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
         });
}

std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides) {
  std::vector<std::string> parts;
  for (const std::string &side : sides) {
    if (side == name)
      return {name};
    if (side.rfind(name + ".", 0) == 0 && side.size() > name.size() + 1 &&
        side.find_first_not_of("0123456789", name.size() + 1) == std::string::npos)
      parts.push_back(side);
  }
  return parts;
}

SideTexts read_side_list(const std::string &text, const std::string &where,
                         const std::vector<std::string> &sides) {
  SideTexts entries;
  for (const std::string &part : split_list(text, '|')) {
    const auto colon = part.find(':');
    const std::vector<std::string> called = sides_called(trim(part.substr(0, colon)), sides);
    if (colon == std::string::npos || called.empty())
      throw input_error(where, ": found ", quote(part),
                        hint_for(trim(part.substr(0, colon)), sides), ", allowed: one of ",
                        join(sides), ", ':' and its value.");
    for (const std::string &side : called)
      entries.emplace_back(side, trim(part.substr(colon + 1)));
  }
  return entries;
}

SideTexts read_list_for(const std::vector<std::string> &called, const std::string &text,
                        const std::string &where, const std::vector<std::string> &sides) {
  SideTexts entries;
  if (!begins_with_a_name(text))
    for (const std::string &side : called)
      entries.emplace_back(side, trim(text));
  else
    entries = read_side_list(text, where, sides);
  std::multiset<std::string> names;
  for (const auto &entry : entries)
    names.insert(entry.first);
  for (const std::string &name : sides)
    if (const bool belongs = std::count(called.begin(), called.end(), name) > 0;
        names.count(name) != (belongs ? 1U : 0U))
      throw input_error(where, ": the number of entries for '", name, "' is ", names.count(name),
                        ", allowed: one for each of ", join(called), ".");
  return entries;
}

// Rigid plates: their sides, directions and loads.

namespace {
/** Reads "dx, dy", perhaps with the word "turning" behind it. */
Plate read_plate(const std::string &name, const std::string &text, const Entry &entry,
                 const Geometry<2> &geometry) {
  const Phrase phrase(text, "turning");
  Plate plate;
  plate.turns = phrase.form == "... turning" && phrase.parts[1].text.empty();
  std::vector<double> d;
  if (!read_numbers(entry, plate.turns ? phrase.parts[0].text : text, d) || d.size() != 2 ||
      !(std::hypot(d[0], d[1]) > 0.))
    throw error_at(entry, "found ", quote(text), " for the side '", name,
                   "', allowed: a direction dx, dy, perhaps followed by the word turning.");
  plate.side = geometry.find_side(name);
  const Side<2> &side = geometry.sides[plate.side];
  plate.centre = side.is_closed() ? side.box().center() : side.centre();
  plate.direction = Tensor<1, 2>({d[0], d[1]}) / std::hypot(d[0], d[1]);
  return plate;
}

/** Reads "side: number" entries for plates, by their names. */
std::map<std::string, double> read_numbers_of(const Given<std::string> &given,
                                              const std::vector<std::string> &plates) {
  std::map<std::string, double> numbers;
  if (!given.value.empty() && plates.empty())
    throw error_at(given, "found ", quote(given.value), ", but Boundary/Plates names no plate.");
  for (const auto &[name, text] : read_side_list(given.value, given.where(), plates))
    if (!read_number(given, text, numbers[name]) || !(std::abs(numbers[name]) <= max_magnitude))
      throw error_at(given, "found ", quote(text), " for the plate '", name,
                     "', allowed: one number up to ", max_magnitude, ".");
  return numbers;
}
} // namespace

std::vector<Plate> read_plates(const Given<std::string> &given, const LoadParameters &load,
                               const Geometry<2> &geometry) {
  std::vector<Plate> plates;
  std::vector<std::string> names;
  for (const auto &[name, text] :
       read_side_list(given.value, given.where(), geometry.side_names())) {
    plates.push_back(read_plate(name, text, given, geometry));
    names.push_back(name);
  }
  const auto forces = read_numbers_of(load.plate_force, names),
             travels = read_numbers_of(load.plate_travel, names),
             moments = read_numbers_of(load.plate_moment, names),
             cross = read_numbers_of(load.plate_cross_force, names);
  for (std::size_t p = 0; p < plates.size(); ++p) {
    Plate &plate = plates[p];
    const auto take = [&](const std::map<std::string, double> &numbers, double &number) {
      const auto found = numbers.find(names[p]);
      if (found != numbers.end())
        number = found->second;
      return found != numbers.end();
    };
    plate.is_pushed = take(forces, plate.force);
    if (take(travels, plate.travel) == plate.is_pushed)
      throw error_at(given, "the plate '", names[p], "' has ", plate.is_pushed ? "both" : "none",
                     " of Load/Plate force and Load/Plate travel, allowed: one of the two.");
    if (take(moments, plate.moment) && !plate.turns)
      throw error_at(load.plate_moment, "the plate '", names[p],
                     "' does not turn; allowed: moments of plates with the word turning in "
                     "Boundary/Plates.");
    plate.drifts = take(cross, plate.cross_force);
    // From here on all loads are those per unit of thickness; results multiply by it again.
    for (double *const number : {&plate.force, &plate.cross_force, &plate.moment})
      *number /= geometry.thickness;
  }
  return plates;
}
} // namespace Signorini
