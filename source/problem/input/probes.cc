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
template <int dim>
void read_stretch(const Phrase &phrase, const Geometry<dim> &geometry, const Entry &entry,
                  Probe<dim> &probe) {
  if constexpr (dim == 2) {
    std::array<double, 2> ends;
    const double length = probe.sides.empty() ? 0. : geometry.sides[probe.sides[0]].length();
    for (unsigned int i = 0; i < 2; ++i)
      if (!read_number(entry, phrase.parts[i + 1].text, ends[i]) || probe.sides.size() != 1 ||
          !(ends[i] >= 0. && ends[i] <= length) || (i == 1 && ends[1] <= ends[0]))
        throw error_at(entry, "found ", quote(phrase.parts[i + 1].text), " behind ",
                       phrase.parts[i + 1].word,
                       ", allowed: growing arc lengths of one side, from "
                       "0 to ",
                       length, ".");
    probe.stretch = ends;
  }
}

/** Returns a text without its last word where that is a certain one. @param found whether it is. */
std::string without_last_word(const std::string &text, const std::string &word, bool &found) {
  const std::size_t begin = text.size() < word.size() ? 0 : text.size() - word.size();
  found = begin > 1 && text.substr(begin) == word && text[begin - 1] == ' ';
  return found ? trim(text.substr(0, begin)) : text;
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
    Probe<dim> probe;
    const std::string place = without_last_word(text, "guaranteed", probe.is_guaranteed);
    const Phrase phrase(place, "radius|box|from|to");
    const std::string &first = phrase.parts[0].text;
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
      read_stretch(phrase, geometry, given, probe);
    } else if (phrase.form == "..." && first.find(',') != std::string::npos)
      probe.points = {read_point<dim>(first, given)};
    else
      probe = named_probe(place, geometry, given);
    probe.is_guaranteed = place.size() < text.size();
    if (probe.is_guaranteed && (dim == 3 || !probe.points.empty()))
      throw error_at(given, "found ", quote(text), ", allowed with guaranteed: ",
                     dim == 3 ? "no place in space."
                              : "a side, a region, x,y radius r, x,y box x,y, SIDE from s to s; "
                                "values at points are estimates.");
    if (!probe.points.empty() &&
        std::none_of(probe.points.begin(), probe.points.end(), [&](const Point<dim> &x) {
          return distance_from_body(geometry, x) <= rounding;
        }))
      refuse(text, "points");
    probe.name = place;
    probe.where = given.where();
    probes.push_back(probe);
  }
  return probes;
}

INSTANTIATE_FUNCTION(read_probes);
} // namespace Signorini
