// SPDX-License-Identifier: LGPL-2.1-or-later
// The ends of contact, according to the nodes of the multipliers.

#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <algorithm>
#include <cmath>

#include "peak_pressure_internal.h"

namespace Signorini
{
std::vector<ContactBracket> contact_brackets(const MultiplierSpace<2> &multipliers,
                                             const Pressure &P)
{
  std::vector<ContactBracket> brackets;
  for (SideNodes side : nodes_by_side(multipliers, P))
  {
    std::vector<SideNode> &nodes = side.nodes;
    if (side.closed)
      nodes.push_back({nodes.front().s + side.length, nodes.front().presses});
    const std::size_t first = brackets.size();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      if (nodes[i].presses == nodes[i + 1].presses)
        continue;
      if (brackets.size() > first && brackets.back().to == nodes[i].s)
        brackets.back().to = nodes[i + 1].s;
      else
        brackets.push_back({side.number, nodes[i].s, nodes[i + 1].s});
    }
    // The first node of a closed side is the last one, too.
    if (side.closed && brackets.size() > first + 1 && brackets[first].from == nodes.front().s &&
        brackets.back().to == nodes.back().s)
    {
      brackets.back().to += brackets[first].to - brackets[first].from;
      brackets.erase(brackets.begin() + first);
    }
  }
  return brackets;
}

// The contact zones: runs of pressing patches, and the points where the pressure vanishes.

namespace
{
/** The data of a pressure that ends: the lengths of the last two patches that press, the distance
 * from the edge between them to the farthest possible end, and the ratio of the means, that of the
 * last patch over the other. */
struct EndOfPressure
{
  double inner, last, farthest, ratio;
};

/**
 * Returns the distance e from the edge between both patches at which -p = c (e - x)_+^{1/2}
 * vanishes if its means have the given ratio:
 *
 *     (F(e) - F(e - last)) / last = ratio (F(e + inner) - F(e)) / inner,   F(x) = x_+^{3/2}.
 */
double root_end(const EndOfPressure &given)
{
  const auto F = [](const double x) { return std::pow(std::max(x, 0.), 1.5); };
  const auto ratio = [&](const double e) {
    return (F(e) - F(e - given.last)) / given.last / ((F(e + given.inner) - F(e)) / given.inner);
  };
  // The ratio grows with e from zero.
  double low = 0., high = given.farthest;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (ratio(middle) < given.ratio ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/** The patches first, ..., first + n - 1 of one side; a closed side goes on with the first. */
class SidePatches
{
public:
  SidePatches(const MultiplierSpace<2> &multipliers, const Pressure &P, const std::size_t first)
    : surface_(multipliers.surface())
    , first_(first)
  {
    const auto &patches = surface_.patches();
    const double threshold = pressing_threshold(P);
    for (std::size_t tau = first; tau < patches.size() && patches[tau].side == patches[first].side;
         ++tau)
    {
      means_.push_back(multipliers.value(P, tau, patches[tau].centre()));
      presses_.push_back(means_.back() < threshold);
    }
  }
  int size() const
  {
    return means_.size();
  }
  const Side<2> &side() const
  {
    return surface_.side(surface_.patches()[first_]);
  }
  /** Returns whether patch i presses; false beyond the ends of an open side. */
  bool presses(const int i) const
  {
    return exists(i) && presses_[wrapped(i)];
  }
  bool presses_everywhere() const
  {
    return std::all_of(presses_.begin(), presses_.end(), [](const bool p) { return p; });
  }

  /** Returns the end of a run: patch @p last presses and last + @p step does not. */
  ZoneEnd end_of_run(const int last, const int step) const
  {
    const double edge = step > 0 ? upper(last) : lower(last);
    if (!exists(last + step))
      return {place(edge), 0.};
    const double inner_edge = step > 0 ? lower(last) : upper(last);
    double s = edge;
    if (presses(last - step) && std::abs(mean(last)) < std::abs(mean(last - step)) &&
        !side().has_corner(inner_edge) && !side().has_corner(edge))
    {
      const double next_edge = step > 0 ? lower(last - step) : upper(last - step);
      s = inner_edge + step * root_end({std::abs(inner_edge - next_edge),
                                        std::abs(edge - inner_edge),
                                        std::abs(middle(last + step) - inner_edge),
                                        mean(last) / mean(last - step)});
    }
    const bool in_last_patch = (edge - s) * step >= 0.;
    const int patch = in_last_patch ? last : last + step;
    return {place(s), upper(patch) - lower(patch)};
  }

private:
  bool exists(const int i) const
  {
    return side().is_closed() || (i >= 0 && i < size());
  }
  std::size_t wrapped(const int i) const
  {
    return ((i % size()) + size()) % size();
  }
  /** Returns how often the number has gone around a closed side, as a length. */
  double turns(const int i) const
  {
    return (i - static_cast<int>(wrapped(i))) / size() * side().length();
  }
  const Patch<2> &patch(const int i) const
  {
    return surface_.patches()[first_ + wrapped(i)];
  }
  double mean(const int i) const
  {
    return means_[wrapped(i)];
  }
  double lower(const int i) const
  {
    return patch(i).lower[0] + turns(i);
  }
  double upper(const int i) const
  {
    return patch(i).upper[0] + turns(i);
  }
  double middle(const int i) const
  {
    return patch(i).centre()[0] + turns(i);
  }
  BoundaryPlace place(double s) const
  {
    const double length = side().length();
    if (side().is_closed())
      s -= length * std::floor(s / length);
    return {side().name(), s, side().point(s)};
  }

  const ContactSurface<2> &surface_;
  std::size_t first_;
  std::vector<double> means_;
  std::vector<bool> presses_;
};

void add_zones(const SidePatches &patches, std::vector<ContactZone> &zones)
{
  const Side<2> &side = patches.side();
  if (patches.presses_everywhere())
  {
    const auto at = [&side](const double s) {
      return ZoneEnd{{side.name(), s, side.point(s)}, 0.};
    };
    zones.push_back({at(0.), at(side.length()), side.length()});
    return;
  }
  for (int i = 0; i < patches.size(); ++i)
    if (patches.presses(i) && !patches.presses(i - 1))
    {
      int last = i;
      while (patches.presses(last + 1))
        ++last;
      ContactZone zone = {patches.end_of_run(i, -1), patches.end_of_run(last, 1)};
      zone.length = zone.end.place.arc_length - zone.start.place.arc_length;
      if (zone.length < 0.) // It contains the start of a closed side.
        zone.length += side.length();
      zones.push_back(zone);
    }
}
} // namespace

std::vector<ContactZone> contact_zones(const MultiplierSpace<2> &multipliers, const Pressure &P)
{
  if (!multipliers.is_piecewise_constant())
    return zones_of_polynomial(multipliers, P);
  std::vector<ContactZone> zones;
  const std::size_t n_patches = multipliers.surface().patches().size();
  for (std::size_t first = 0; first < n_patches;)
  {
    const SidePatches patches(multipliers, P, first);
    add_zones(patches, zones);
    first += patches.size();
  }
  return zones;
}
} // namespace Signorini
