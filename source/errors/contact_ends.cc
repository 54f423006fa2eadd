// SPDX-License-Identifier: LGPL-2.1-or-later
// Where contact ends, in the exact and in the discrete solution.

#include <signorini/errors/contact_ends.h>
#include <signorini/postprocess/contact_pressure.h>
#include <signorini/refinement/contact_brackets.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** Arc lengths at which the sign of the exact pressure changes from 0 to negative or back. */
std::vector<double> exact_ends(const Scene<2> &scene, const unsigned int number)
{
  const Side<2> &side = scene.geometry.sides[number];
  const dealii::Function<2> &p = *scene.boundary[number].exact_pressure;
  const std::vector<double> cuts = scene.kinks.cut(side, 0., side.length());
  std::vector<double> ends;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
  {
    const double s = cuts[i], step = 1e-6 * side.length();
    const bool before = p.value(side.point(s - step)) < 0.;
    const bool after = p.value(side.point(s + step)) < 0.;
    if (before != after)
      ends.push_back(s);
  }
  return ends;
}

/** Arc lengths between a pressing patch and one that does not press; where patches have several
 * nodes, the middle between a pressing node and one that does not. */
std::vector<double> discrete_ends(const MultiplierSpace<2> &space,
                                  const unsigned int number,
                                  const dealii::Vector<double> &P)
{
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const double threshold = pressing_threshold(P);
  std::vector<double> ends;
  if (!space.is_piecewise_constant())
  {
    for (const ContactBracket &bracket : contact_brackets(space, P))
      if (bracket.side == number)
        ends.push_back(0.5 * (bracket.from + bracket.to));
    return ends;
  }
  for (std::size_t tau = 0; tau + 1 < patches.size(); ++tau)
    if (patches[tau].side == number && patches[tau + 1].side == number &&
        (P[tau] < threshold) != (P[tau + 1] < threshold))
      ends.push_back(patches[tau].upper[0]);
  return ends;
}

/** The largest distance of a point of @p from to the nearest of @p to. */
double one_sided_distance(const std::vector<double> &from, const std::vector<double> &to)
{
  double largest = 0.;
  for (const double s : from)
  {
    double nearest = std::abs(s - to.front());
    for (const double t : to)
      nearest = std::min(nearest, std::abs(s - t));
    largest = std::max(largest, nearest);
  }
  return largest;
}
} // namespace

std::optional<double> contact_end_error(const MultiplierSpace<2> &space,
                                        const Scene<2> &scene,
                                        const dealii::Vector<double> &P)
{
  std::optional<double> largest;
  for (const unsigned int number : scene.contact_sides())
  {
    const std::vector<double> exact = exact_ends(scene, number);
    const std::vector<double> discrete = discrete_ends(space, number, P);
    if (exact.empty() != discrete.empty())
      return {};
    if (!exact.empty())
      largest = std::max({largest.value_or(0.),
                          one_sided_distance(exact, discrete),
                          one_sided_distance(discrete, exact)});
  }
  return largest;
}
} // namespace Signorini
