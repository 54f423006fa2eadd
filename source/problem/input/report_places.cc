// SPDX-License-Identifier: LGPL-2.1-or-later
// Output/Report: the places for which stresses are wanted.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/inside.h>
#include <signorini/problem/parameters/entry_error.h>

#include <algorithm>

#include "input.h"

namespace Signorini {
namespace {
/** The number of points along a line. */
constexpr unsigned int n_along_line = 101;

/** Returns a side or a region of this name. */
template <int dim>
ReportPlace<dim> named_place(const std::string &name, const Geometry<dim> &geometry,
                             const Entry &entry) {
  ReportPlace<dim> place;
  for (const std::string &side : sides_called(name, geometry.side_names()))
    place.sides.push_back(geometry.find_side(side));
  const auto region = std::find(geometry.regions.begin(), geometry.regions.end(), name);
  if (region != geometry.regions.end())
    place.region = region - geometry.regions.begin();
  if (place.sides.empty() && !place.region)
    throw error_at(entry, "found ", quote(name), hint_for(name, geometry.side_names()),
                   hint_for(name, geometry.regions), ", allowed, separated by '|': a side (",
                   join(geometry.described_sides()), ")",
                   geometry.regions.empty() ? "" : ", a region (" + join(geometry.regions) + ")",
                   dim == 2 ? ", x,y, x,y radius r, x,y to x,y."
                            : ", x,y,z, ... radius r, ... to ...");
  return place;
}
} // namespace

template <int dim>
std::vector<ReportPlace<dim>> read_report_places(const Given<std::string> &given,
                                                 const Geometry<dim> &geometry) {
  std::vector<ReportPlace<dim>> places;
  const double rounding = 1e-10 * geometry.diameter();
  const auto refuse = [&](const std::string &text, const std::string &allowed) {
    throw error_at(given, "found ", quote(text),
                   ", which is outside of the body, allowed: ", allowed, " of the body.");
  };
  for (const std::string &text : split_list(given.value, '|')) {
    const Phrase phrase(text, "radius|to");
    const std::string &first = phrase.parts[0].text;
    ReportPlace<dim> place;
    if (phrase.form == "... to") {
      const Point<dim> start = read_point<dim>(first, given),
                       end = read_point<dim>(phrase.parts[1].text, given);
      for (unsigned int i = 0; i < n_along_line; ++i)
        place.points.push_back(start + i / (n_along_line - 1.) * (end - start));
    } else if (phrase.form == "... radius") {
      place.centre = read_point<dim>(first, given);
      if (!read_number(given, phrase.parts[1].text, place.radius) || !(place.radius > 0.))
        throw error_at(given, "found the radius ", quote(phrase.parts[1].text),
                       ", allowed: a positive number.");
      if (distance_from_body(geometry, place.centre) > place.radius + rounding)
        refuse(text, "circles with points");
    } else if (phrase.form == "..." && first.find(',') != std::string::npos)
      place.points = {read_point<dim>(first, given)};
    else
      place = named_place(text, geometry, given);
    if (!place.points.empty() &&
        std::none_of(place.points.begin(), place.points.end(), [&](const Point<dim> &x) {
          return distance_from_body(geometry, x) <= rounding;
        }))
      refuse(text, "points");
    place.name = text;
    place.where = given.where();
    places.push_back(place);
  }
  return places;
}

INSTANTIATE_FUNCTION(read_report_places);
} // namespace Signorini
