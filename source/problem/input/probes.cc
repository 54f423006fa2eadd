// SPDX-License-Identifier: LGPL-2.1-or-later
// Output/Report: the probes for which stresses are wanted.

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
Probe<dim> named_probe(const std::string &name, const Geometry<dim> &geometry, const Entry &entry) {
  Probe<dim> probe;
  for (const std::string &side : sides_called(name, geometry.side_names()))
    probe.sides.push_back(geometry.find_side(side));
  const auto region = std::find(geometry.regions.begin(), geometry.regions.end(), name);
  if (region != geometry.regions.end())
    probe.region = region - geometry.regions.begin();
  if (probe.sides.empty() && !probe.region)
    throw error_at(entry, "found ", quote(name), hint_for(name, geometry.side_names()),
                   hint_for(name, geometry.regions), ", allowed, separated by '|': a side (",
                   join(geometry.described_sides()), ")",
                   geometry.regions.empty() ? "" : ", a region (" + join(geometry.regions) + ")",
                   dim == 2 ? ", x,y, x,y radius r, x,y to x,y."
                            : ", x,y,z, ... radius r, ... to ...");
  return probe;
}
} // namespace

template <int dim>
std::vector<Probe<dim>> read_probes(const Given<std::string> &given,
                                    const Geometry<dim> &geometry) {
  std::vector<Probe<dim>> probes;
  const double rounding = 1e-10 * geometry.diameter();
  const auto refuse = [&](const std::string &text, const std::string &allowed) {
    throw error_at(given, "found ", quote(text),
                   ", which is outside of the body, allowed: ", allowed, " of the body.");
  };
  for (const std::string &text : split_list(given.value, '|')) {
    const Phrase phrase(text, "radius|to");
    const std::string &first = phrase.parts[0].text;
    Probe<dim> probe;
    if (phrase.form == "... to") {
      const Point<dim> start = read_point<dim>(first, given),
                       end = read_point<dim>(phrase.parts[1].text, given);
      for (unsigned int i = 0; i < n_along_line; ++i)
        probe.points.push_back(start + i / (n_along_line - 1.) * (end - start));
    } else if (phrase.form == "... radius") {
      probe.centre = read_point<dim>(first, given);
      if (!read_number(given, phrase.parts[1].text, probe.radius) || !(probe.radius > 0.))
        throw error_at(given, "found the radius ", quote(phrase.parts[1].text),
                       ", allowed: a positive number.");
      if (distance_from_body(geometry, probe.centre) > probe.radius + rounding)
        refuse(text, "circles with points");
    } else if (phrase.form == "..." && first.find(',') != std::string::npos)
      probe.points = {read_point<dim>(first, given)};
    else
      probe = named_probe(text, geometry, given);
    if (!probe.points.empty() &&
        std::none_of(probe.points.begin(), probe.points.end(), [&](const Point<dim> &x) {
          return distance_from_body(geometry, x) <= rounding;
        }))
      refuse(text, "points");
    probe.name = text;
    probe.where = given.where();
    probes.push_back(probe);
  }
  return probes;
}

INSTANTIATE_FUNCTION(read_probes);
} // namespace Signorini
