// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid plates: their sides, directions and loads.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/parameters/entry_error.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <type_traits>

#include "input.h"

namespace Signorini {
namespace {
/** Returns the vector of the numbers of a text; none if these are too few, too many, too large or
 * no numbers. */
template <int dim>
std::optional<Tensor<1, dim>> vector_of(const Entry &entry, const std::string &text) {
  std::vector<double> numbers;
  Tensor<1, dim> x;
  if (!read_numbers(entry, text, numbers) || numbers.size() != dim)
    return {};
  std::copy(numbers.begin(), numbers.end(), x.begin_raw());
  return x.norm() <= max_magnitude ? std::optional(x) : std::nullopt;
}

/** Returns the middle of a side, of a closed one that of the box around it. */
Point<2> centre_of(const Side<2> &side) {
  return side.is_closed() ? side.box().center() : side.centre();
}
Point<3> centre_of(const Side<3> &side) {
  return side.centre();
}

/** Reads "dx, dy", perhaps with the word "turning" behind it. */
template <int dim>
Plate<dim> read_plate(const std::string &name, const std::string &text, const Entry &entry,
                      const Geometry<dim> &geometry) {
  const Phrase phrase(text, "turning");
  Plate<dim> plate;
  plate.turns = phrase.form == "... turning" && phrase.parts[1].text.empty();
  const auto d = vector_of<dim>(entry, plate.turns ? phrase.parts[0].text : text);
  if (!d || !(d->norm() > 0.))
    throw error_at(entry, "found ", quote(text), " for the side '", name,
                   "', allowed: a direction dx, dy", dim == 3 ? ", dz" : "",
                   ", perhaps followed by the word turning.");
  plate.side = geometry.find_side(name);
  plate.centre = centre_of(geometry.sides[plate.side]);
  plate.direction = *d / d->norm();
  return plate;
}

/** Reads a number for a plate, or a vector. @return whether it is one. */
bool read_load(const Entry &entry, const std::string &text, double &number) {
  return read_number(entry, text, number) && std::abs(number) <= max_magnitude;
}
bool read_load(const Entry &entry, const std::string &text, Tensor<1, 3> &vector) {
  const auto read = vector_of<3>(entry, text);
  vector = read.value_or(vector);
  return read.has_value();
}

/** Reads "side: number" entries for plates, by their names. */
template <typename Load>
std::map<std::string, Load> read_loads_of(const Given<std::string> &given,
                                          const std::vector<std::string> &plates) {
  std::map<std::string, Load> loads;
  if (!given.value.empty() && plates.empty())
    throw error_at(given, "found ", quote(given.value), ", but Boundary/Plates names no plate.");
  for (const auto &[name, text] : read_side_list(given.value, given.where(), plates))
    if (!read_load(given, text, loads[name]))
      throw error_at(given, "found ", quote(text), " for the plate '", name, "', allowed: ",
                     std::is_same_v<Load, double> ? "one number" : "a vector x, y, z", " up to ",
                     max_magnitude, ".");
  return loads;
}

/** Refuses a force across a plate in space that has a part along it. */
void check_cross_force(const Plate<2> & /*plate*/, const std::string & /*name*/,
                       const Entry & /*entry*/) {}
void check_cross_force(const Plate<3> &plate, const std::string &name, const Entry &entry) {
  constexpr double rounding = 1e-10;
  if (std::abs(plate.cross_force * plate.direction) > rounding * plate.cross_force.norm())
    throw error_at(entry, "found ", vector_text(plate.cross_force), " for the plate '", name,
                   "', allowed: a vector at right angles to its direction ",
                   vector_text(plate.direction), ".");
}
} // namespace

template <int dim>
std::vector<Plate<dim>> read_plates(const Given<std::string> &given, const LoadParameters &load,
                                    const Geometry<dim> &geometry) {
  std::vector<Plate<dim>> plates;
  std::vector<std::string> names;
  for (const auto &[name, text] :
       read_side_list(given.value, given.where(), geometry.side_names())) {
    plates.push_back(read_plate(name, text, given, geometry));
    names.push_back(name);
  }
  const auto forces = read_loads_of<double>(load.plate_force, names),
             travels = read_loads_of<double>(load.plate_travel, names);
  const auto moments = read_loads_of<Rotation<dim>>(load.plate_moment, names),
             cross_forces = read_loads_of<Rotation<dim>>(load.plate_cross_force, names);
  for (std::size_t p = 0; p < plates.size(); ++p) {
    Plate<dim> &plate = plates[p];
    const auto take = [&](const auto &loads, auto &value) {
      const auto found = loads.find(names[p]);
      if (found != loads.end())
        value = found->second;
      return found != loads.end();
    };
    plate.is_pushed = take(forces, plate.force);
    if (take(travels, plate.travel) == plate.is_pushed)
      throw error_at(given, "the plate '", names[p], "' has ", plate.is_pushed ? "both" : "none",
                     " of Load/Plate force and Load/Plate travel, allowed: one of the two.");
    if (take(moments, plate.moment) && !plate.turns)
      throw error_at(load.plate_moment, "the plate '", names[p],
                     "' does not turn; allowed: moments of plates with the word turning in "
                     "Boundary/Plates.");
    plate.drifts = take(cross_forces, plate.cross_force);
    check_cross_force(plate, names[p], load.plate_cross_force);
    // From here on all loads are those per unit of thickness; results multiply by it again.
    plate.force /= geometry.thickness;
    plate.cross_force /= geometry.thickness;
    plate.moment /= geometry.thickness;
  }
  return plates;
}

INSTANTIATE_FUNCTION(read_plates);
} // namespace Signorini
