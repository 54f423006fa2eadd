// SPDX-License-Identifier: LGPL-2.1-or-later
// The corners of a 2-D body, the materials and the conditions about them, and how rough a
// displacement may be at them.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/corners.h>
#include <signorini/problem/scene/facing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace Signorini {
namespace {
using numbers::PI;

/** An end of a smooth part of a side, with the direction in which the side leaves it. */
struct SideEnd {
  unsigned int side;
  Point<2> position;
  Tensor<1, 2> direction;
  /** Whether a walk with the body on its left leaves the point along this side. */
  bool leaves;
};

/** Returns the end at s of the part that lies in the direction of @p towards. */
SideEnd side_end(const Side<2> &side, const unsigned int number, const double s,
                 const double towards) {
  const Tensor<1, 2> normal = side.normal(s, towards);
  const Tensor<1, 2> along_walk({-normal[1], normal[0]});
  const Tensor<1, 2> direction = (towards > s ? 1. : -1.) * side.tangent(s, towards);
  const bool leaves = along_walk * direction > 0.;
  return {number, side.point(s), leaves ? along_walk : -along_walk, leaves};
}

/** Returns the ends of a side, and those of its smooth parts at corners inside. */
std::vector<SideEnd> ends_of(const Side<2> &side, const unsigned int number) {
  std::vector<SideEnd> ends;
  const double length = side.length();
  if (!side.is_closed())
    ends = {side_end(side, number, 0., length), side_end(side, number, length, 0.)};
  for (const double s : side.corners())
    for (const double towards : {s - length, s + length})
      ends.push_back(side_end(side, number, s, towards));
  return ends;
}

/** Returns the angle from the direction of one end counter-clockwise to that of the other, in (0, 2
 * pi]. */
double opening(const SideEnd &first, const SideEnd &second) {
  const Tensor<1, 2> &a = first.direction, &b = second.direction;
  const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
  // A body does not end in a cusp: parallel sides are those of a crack.
  return angle > 1e-8 ? angle : angle + 2. * PI;
}
} // namespace

std::vector<Corner> corners(const Geometry<2> &geometry) {
  std::vector<SideEnd> leaving, arriving;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (const SideEnd &end : ends_of(geometry.sides[i], i))
      (end.leaves ? leaving : arriving).push_back(end);
  std::vector<Corner> found;
  for (const SideEnd &first : leaving) {
    // Where the body touches itself, it lies between a side and the next one.
    std::vector<Corner> candidates;
    for (const SideEnd &second : arriving)
      if (first.position.distance(second.position) < 1e-8 * geometry.diameter() &&
          geometry.body_of_side(first.side) == geometry.body_of_side(second.side))
        candidates.push_back(
          {first.position, opening(first, second), {{first.side, second.side}}, first.direction});
    const auto next =
      std::min_element(candidates.begin(), candidates.end(),
                       [](const Corner &a, const Corner &b) { return a.angle < b.angle; });
    if (next != candidates.end())
      found.push_back(*next);
  }
  return found;
}

WedgeLayer make_layer(const SymmetricTensor<4, 2> &hooke, const double angle) {
  // E_iijj = 4 (lambda + mu) and E_ijij = 2 lambda + 6 mu do not change with the axes.
  double traces = 0., squares = 0.;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j) {
      traces += hooke[i][i][j][j];
      squares += hooke[i][j][i][j];
    }
  return {angle, 2. * squares / traces, (2. * squares - traces) / 8.};
}

namespace {
using Law = std::optional<SymmetricTensor<4, 2>>;

/** Returns Hooke's tensor at a point, or nothing where its data has no value. */
Law law_at(const Scene<2> &scene, const Point<2> &x) {
  try {
    return scene.material->relative_hooke(x);
  } catch (const InputError &) {
    return {};
  }
}

bool differ(const Law &a, const Law &b) {
  constexpr double rounding = 1e-4;
  return a && b && (*a - *b).norm() > rounding * std::max(a->norm(), b->norm());
}

/** Returns 0, the points of (0, 1) at which a law jumps, and 1.
 * @param n number of parts, in each of which one jump is found. */
std::vector<double> jumps(const std::function<Law(double)> &law, const unsigned int n) {
  constexpr double margin = 1e-4, resolution = 1e-12;
  std::vector<double> found = {0.};
  for (unsigned int i = 0; i < n; ++i) {
    double a = std::max(margin, i / double(n)), b = std::min(1. - margin, (i + 1) / double(n));
    Law at_a = law(a), at_b = law(b);
    while (b - a > resolution && differ(at_a, at_b)) {
      const double middle = 0.5 * (a + b);
      const Law at_middle = law(middle);
      const bool is_first = differ(at_a, at_middle);
      (is_first ? b : a) = middle;
      (is_first ? at_b : at_a) = at_middle;
    }
    if (differ(at_a, at_b))
      found.push_back(a);
  }
  found.push_back(1.);
  return found;
}

/** The distance from a point at which its neighbourhood is looked at, in sizes of the body. */
constexpr double nearby = 1e-7;
} // namespace

std::vector<Corner> interface_ends(const Scene<2> &scene) {
  std::vector<Corner> ends;
  if (scene.material->is_constant())
    return ends;
  const double distance = nearby * scene.geometry.diameter();
  constexpr unsigned int n_parts = 256;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const Side<2> &side = scene.geometry.sides[i];
    const double length = side.length();
    const std::vector<double> found = jumps(
      [&](const double t) {
        return law_at(scene, side.point(t * length) - distance * side.normal(t * length));
      },
      n_parts);
    for (std::size_t k = 1; k + 1 < found.size(); ++k) {
      const double s = found[k] * length;
      const Tensor<1, 2> n = side.normal(s);
      ends.push_back({side.point(s), PI, {{i, i}}, Tensor<1, 2>({-n[1], n[0]})});
    }
  }
  return ends;
}

std::vector<WedgeLayer> layers_at(const Scene<2> &scene, const Corner &corner) {
  if (scene.material->is_constant())
    return {make_layer(scene.material->relative_hooke(corner.position), corner.angle)};
  constexpr unsigned int n_parts = 64;
  const auto law = [&](const double t) {
    const double angle = t * corner.angle;
    const Tensor<1, 2> across({-corner.direction[1], corner.direction[0]});
    return law_at(scene, corner.position +
                           nearby * scene.geometry.diameter() *
                             (std::cos(angle) * corner.direction + std::sin(angle) * across));
  };
  const std::vector<double> found = jumps(law, n_parts);
  std::vector<WedgeLayer> layers;
  for (std::size_t k = 0; k + 1 < found.size(); ++k)
    if (const Law middle = law(0.5 * (found[k] + found[k + 1])))
      layers.push_back(make_layer(*middle, (found[k + 1] - found[k]) * corner.angle));
  return layers;
}

template <int dim>
std::vector<EdgeCondition> possible_conditions(const Scene<dim> &scene, const unsigned int side,
                                               const Point<dim> &x) {
  AssertIndexRange(side, scene.boundary.size());
  AssertIndexRange(side, scene.boundary.size());
  const Role role = scene.boundary[side].role;
  if (role == Role::clamped || role == Role::displacement)
    return {{EdgeSupport::held}};
  if (role == Role::roller)
    return {{EdgeSupport::sliding}};
  if (role != Role::contact)
    return {{EdgeSupport::free}};
  std::vector<EdgeCondition> conditions = {{EdgeSupport::free}, {EdgeSupport::sliding}};
  const auto found = std::find_if(scene.contacts.begin(), scene.contacts.end(),
                                  [side](const auto &contact) { return contact.side == side; });
  if (found == scene.contacts.end())
    return conditions;
  if (scene.contact_law.has_tangential_part())
    conditions.push_back({EdgeSupport::held});
  for (const auto &limit : scene.contact_law.limits())
    if (limit.follows_pressure && dim == 2)
      for (const int sign : {1, -1})
        conditions.push_back({EdgeSupport::sliding, sign * ((*found).*limit.data)->value(x)});
  return conditions;
}

template <int dim>
double smallest_exponent(const Scene<dim> &scene, const Point<dim> &x,
                         const std::array<unsigned int, 2> &sides,
                         const std::vector<WedgeLayer> &layers) {
  double smallest = max_corner_exponent;
  const std::vector<EdgeCondition> first = possible_conditions(scene, sides[0], x),
                                   second = possible_conditions(scene, sides[1], x);
  const bool goes_on =
    std::abs(opening(layers) - PI) < 1e-6 && first.size() > 1 && second.size() > 1;
  for (const EdgeCondition &one : first)
    for (const EdgeCondition &other : second)
      if (!goes_on || one.support == other.support)
        smallest = std::min(smallest, corner_exponent(layers, one, other));
  return smallest;
}

// Corners of a body that touch another one.

namespace {
/** Returns the arc length on the one side of a pair across from a point of the other one; none
 * where they do not face each other. */
std::optional<double> across_from(const Scene<2> &scene, const ContactPair<2> &pair,
                                  const unsigned int side, const Point<2> &x) {
  const auto &sides = scene.geometry.sides;
  const Side<2> &first = sides[pair.side()], &second = sides[*pair.other_side()];
  const bool is_first = side == pair.side();
  const Side<2> &own = is_first ? first : second, &other = is_first ? second : first;
  const double s = own.arc_length(x), middle = 0.5 * own.length();
  const Tensor<1, 2> n = own.normal(s, s < middle ? own.length() : 0.);
  // The lines between both are along the normals of the first side.
  const Point<2> y = is_first ? second.across(x, n) : first.point(first.arc_length(x));
  const double t = other.arc_length(y), rounding = 1e-8 * scene.geometry.diameter();
  if (t < -rounding || t > other.length() + rounding || n * other.normal(t) > -grazing)
    return {};
  return std::clamp(t, 0., other.length());
}

/** A body about a corner as one part of a pair: its layers, and the conditions on the edge that is
 * not the common one, both counter-clockwise. */
struct WedgeOfPair {
  std::vector<WedgeLayer> layers;
  std::vector<EdgeCondition> outer;
};

/** Returns that of a corner; a side that goes on beyond the corner is free there. */
WedgeOfPair wedge_of_pair(const Scene<2> &scene, const Corner &corner, const unsigned int side) {
  const unsigned int outer = corner.sides[corner.sides[0] == side ? 1 : 0];
  return {layers_at(scene, corner), outer == side
                                      ? std::vector<EdgeCondition>{{EdgeSupport::free}}
                                      : possible_conditions(scene, outer, corner.position)};
}

/** Returns the smallest exponent of two wedges that press on each other in a state of contact. */
double smallest_exponent(const WedgeOfPair &first, const WedgeOfPair &second,
                         const EdgeCondition &state) {
  std::vector<WedgeLayer> both = first.layers;
  both.insert(both.end(), second.layers.begin(), second.layers.end());
  double smallest = 1.;
  for (const EdgeCondition &one : first.outer)
    for (const EdgeCondition &other : second.outer)
      if (state.support == EdgeSupport::sliding)
        smallest = std::min(
          smallest,
          corner_exponent(SlippingWedges{first.layers, second.layers, state.ratio}, one, other));
      else if (state.support == EdgeSupport::held)
        smallest = std::min(smallest, corner_exponent(both, one, other));
  return smallest;
}
} // namespace

std::vector<PairedCorner> paired_corners(const Scene<2> &scene) {
  std::vector<PairedCorner> found;
  const std::vector<Corner> all = corners(scene.geometry);
  for (const ContactPair<2> &pair : contact_pairs(scene)) {
    if (!pair.other_side())
      continue;
    const std::array<unsigned int, 2> sides = {{pair.side(), *pair.other_side()}};
    for (const unsigned int i : {0U, 1U})
      for (const Corner &corner : all) {
        if (corner.sides[0] != sides[i] && corner.sides[1] != sides[i])
          continue;
        const auto t = across_from(scene, pair, sides[i], corner.position);
        if (!t)
          continue;
        const unsigned int across = sides[1 - i];
        const Side<2> &other = scene.geometry.sides[across];
        const Tensor<1, 2> n = other.normal(*t);
        Corner at = {other.point(*t), PI, {{across, across}}, Tensor<1, 2>({-n[1], n[0]})};
        const auto meets = std::find_if(all.begin(), all.end(), [&](const Corner &candidate) {
          return (candidate.sides[0] == across || candidate.sides[1] == across) &&
                 candidate.position.distance(at.position) < 1e-8 * scene.geometry.diameter();
        });
        if (meets != all.end())
          at = *meets;
        WedgeOfPair first = wedge_of_pair(scene, corner, sides[i]),
                    second = wedge_of_pair(scene, at, across);
        if (corner.sides[1] != sides[i])
          std::swap(first, second);
        const auto exponent_in = [first, second](const EdgeCondition &state) {
          return smallest_exponent(first, second, state);
        };
        double smallest = 1.;
        for (const EdgeCondition &state : possible_conditions(
               scene, sides[0],
               i == 0 ? corner.position : scene.geometry.sides[sides[0]].point(*t)))
          smallest = std::min(smallest, exponent_in(state));
        found.push_back({corner, across, *t, meets != all.end(), exponent_in, smallest});
      }
  }
  return found;
}

INSTANTIATE_FUNCTION(possible_conditions);
INSTANTIATE_FUNCTION(smallest_exponent);
} // namespace Signorini
