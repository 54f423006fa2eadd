// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid plates: their sides, directions and loads.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/scene.h>

#include <cmath>
#include <map>

#include "input.h"

namespace Signorini {
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
