// SPDX-License-Identifier: LGPL-2.1-or-later
// Output/Report: the probes for which stresses are wanted.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/inside.h>
#include <signorini/problem/parameters/entry_error.h>

#include <algorithm>
#include <tuple>

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
                   dim == 2 ? ", x,y, x,y radius r, x,y box x,y, x,y to x,y, SIDE from s to s."
                            : ", x,y,z, ... radius r, ... box ..., ... to ...");
  return probe;
}

/** Reads the arc lengths of "SIDE from s to s". */
std::array<double, 2> read_stretch(const Phrase &phrase, const double length, const Entry &entry) {
  std::array<double, 2> ends;
  if (!read_number(entry, phrase.parts[1].text, ends[0]) ||
      !read_number(entry, phrase.parts[2].text, ends[1]) ||
      !(0. <= ends[0] && ends[0] < ends[1] && ends[1] <= length))
    throw error_at(entry, "found from ", quote(phrase.parts[1].text), " to ",
                   quote(phrase.parts[2].text),
                   ", allowed: growing arc lengths of one side, here "
                   "from 0 to ",
                   length, ".");
  return ends;
}

/** Reads a disc, a box, a line, a point, a stretch, or a name. */
template <int dim>
Probe<dim> read_probe(const std::string &text, const Geometry<dim> &geometry, const Entry &given) {
  const Phrase phrase(text, "radius|box|from|to");
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
  } else if (phrase.form == "... box") {
    const Point<dim> a = read_point<dim>(first, given),
                     b = read_point<dim>(phrase.parts[1].text, given);
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      std::tie(lower[d], upper[d]) = std::minmax({a[d], b[d]});
    probe.box = BoundingBox<dim>({lower, upper});
    if (!(probe.box->volume() > 0.))
      throw error_at(given, "found the box ", quote(text), ", allowed: opposite corners.");
  } else if (phrase.form == "... from to" && dim == 2) {
    probe = named_probe(first, geometry, given);
    if constexpr (dim == 2)
      probe.stretch = read_stretch(
        phrase, probe.sides.size() == 1 ? geometry.sides[probe.sides[0]].length() : 0., given);
  } else if (phrase.form == "..." && first.find(',') != std::string::npos)
    probe.points = {read_point<dim>(first, given)};
  else
    probe = named_probe(text, geometry, given);
  return probe;
}
} // namespace

template <int dim>
std::vector<Probe<dim>> read_probes(const Given<std::string> &given,
                                    const Geometry<dim> &geometry) {
  std::vector<Probe<dim>> probes;
  const double rounding = 1e-10 * geometry.diameter();
  for (const std::string &text : split_list(given.value, '|')) {
    const std::string last = " guaranteed";
    const bool is_guaranteed =
      text.size() > last.size() && text.compare(text.size() - last.size(), last.size(), last) == 0;
    const std::string name = text.substr(0, text.size() - (is_guaranteed ? last.size() : 0));
    Probe<dim> probe = read_probe(name, geometry, given);
    if (is_guaranteed && (dim == 3 || !probe.points.empty()))
      throw error_at(given, "found ", quote(text), ", allowed with guaranteed: ",
                     dim == 3 ? "nothing in space."
                              : "a side, a region, x,y radius r, x,y box x,y, SIDE from s to s; "
                                "values at points are estimates.");
    const auto is_far = [&](const Point<dim> &x) {
      return distance_from_body(geometry, x) > std::max(0., probe.radius) + rounding;
    };
    if (probe.radius > 0.
          ? is_far(probe.centre)
          : !probe.points.empty() && std::all_of(probe.points.begin(), probe.points.end(), is_far))
      throw error_at(given, "found ", quote(text), ", which is outside of the body, allowed: ",
                     probe.radius > 0. ? "circles with points" : "points", " of the body.");
    probe.name = name;
    probe.where = given.where();
    probe.is_guaranteed = is_guaranteed;
    probes.push_back(probe);
  }
  return probes;
}

INSTANTIATE_FUNCTION(read_probes);
} // namespace Signorini
