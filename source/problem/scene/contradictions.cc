// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that prescribe different displacements where they meet.

#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/geometry/solid_edges.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/contradictions.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini {
namespace {
/** The share of the prescribed displacements, and of the directions of plates and normals, below
 * which a difference is rounding. */
constexpr double rounding = 1e-6;

/** Returns the common points of each two sides: corners, and points of edges. */
std::vector<std::pair<Point<2>, std::array<unsigned int, 2>>>
meetings(const Geometry<2> &geometry) {
  std::vector<std::pair<Point<2>, std::array<unsigned int, 2>>> found;
  for (const Corner &corner : corners(geometry))
    if (corner.sides[0] != corner.sides[1])
      found.emplace_back(corner.position, corner.sides);
  return found;
}

constexpr std::array<double, 9> shares = {{0., 1e-3, 0.2, 0.37, 0.5, 0.71, 0.9, 1. - 1e-3, 1.}};

std::vector<Point<2>> samples(const Side<2> &side) {
  std::vector<Point<2>> points;
  points.reserve(shares.size());
  for (const double share : shares)
    points.push_back(side.point(share * side.length()));
  return points;
}

std::vector<Point<3>> samples(const Side<3> &side) {
  std::vector<Point<3>> points;
  for (const SurfacePoint<3> &point : side.samples())
    points.push_back(point.x);
  return points;
}

std::vector<std::pair<Point<3>, std::array<unsigned int, 2>>>
meetings(const Geometry<3> &geometry) {
  std::vector<std::pair<Point<3>, std::array<unsigned int, 2>>> found;
  for (const SolidEdge &edge : solid_edges(geometry))
    if (edge.sides[0] != edge.sides[1])
      for (const double share : shares)
        found.push_back({edge.point(geometry, share), {{edge.sides[1], edge.sides[0]}}});
  return found;
}

/** Returns whether all components of u are prescribed, not u.n alone. */
bool prescribes_all(const Role role) {
  return role == Role::clamped || role == Role::displacement;
}

/** Returns the given part of the displacement of a side; zero where nothing is given. */
template <int dim>
Tensor<1, dim> given_displacement(const BoundaryCondition<dim> &condition, const Point<dim> &x) {
  Tensor<1, dim> u;
  if (condition.role == Role::displacement)
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = condition.data->value(x, c);
  return u;
}

/** Returns the velocities at a point of the plate on this side that forces and moments drive. */
template <int dim>
std::vector<std::pair<Tensor<1, dim>, std::string>> motions_at(const Scene<dim> &scene,
                                                               const unsigned int side,
                                                               const Point<dim> &x) {
  std::vector<std::pair<Tensor<1, dim>, std::string>> found;
  for (const Plate<dim> &plate : scene.plates)
    for (unsigned int k = 0; k < n_rigid_motions<dim> && plate.side == side; ++k)
      if (plate.drives(k)) {
        const Tensor<1, dim> v = plate.displacement(plate.unit_motions()[k], x);
        found.emplace_back(v, k < dim ? "move along " + vector_text(v) : "turn");
      }
  return found;
}

/** Returns u.n at a point of a side if that is given, and nothing can change it. */
template <int dim>
std::optional<double> given_along(const Scene<dim> &scene, const unsigned int side,
                                  const Point<dim> &x, const Tensor<1, dim> &n) {
  const BoundaryCondition<dim> &condition = scene.boundary[side];
  const Side<dim> &on = scene.geometry.sides[side];
  if (condition.role == Role::roller && std::abs(on.normal_at(x) * n) > 1. - rounding)
    return 0.;
  for (const auto &[motion, text] : motions_at(scene, side, x))
    if (std::abs(motion * n) > rounding * motion.norm())
      return {};
  return prescribes_all(condition.role)
           ? std::optional<double>(given_displacement(condition, x) * n)
           : std::nullopt;
}

/** Returns whether a closing is larger than a gap, which may have rounding. */
template <int dim>
bool penetrates(const Scene<dim> &scene, const double closing, const double gap,
                const double size) {
  return closing - gap > rounding * (size + std::abs(gap)) + 1e-12 * scene.geometry.diameter();
}

/** Returns why a side contradicts a rigid foundation at the end of a contact side, or nothing.
 * @param size the largest prescribed displacement. */
template <int dim>
std::string contradiction_to_foundation(const Scene<dim> &scene, const Point<dim> &x,
                                        const unsigned int side, const ContactPair<dim> &contact,
                                        const double size) {
  const Side<dim> &touching = scene.geometry.sides[contact.side()];
  const std::optional<double> u_n = given_along(scene, side, x, touching.normal_at(x));
  if (!u_n)
    return "";
  const double g = contact.gap(x);
  return !penetrates(scene, *u_n, g, size)
           ? ""
           : "the side '" + scene.geometry.sides[side].name() +
               "' prescribes u = " + vector_text(given_displacement(scene.boundary[side], x)) +
               " at " + vector_text(x) + ", where the side '" + touching.name() + "' has the gap " +
               number_text(g) +
               ", and no displacement of finite energy stays outside of the foundation; allowed: "
               "u.n <= g where they meet";
}

/** Returns why the second side contradicts the first one at a common point, or nothing. @param size
 * the largest prescribed displacement. */
template <int dim>
std::string contradiction_at(const Scene<dim> &scene, const Point<dim> &x, const unsigned int i,
                             const unsigned int j, const double size) {
  const Role role = scene.boundary[j].role;
  const bool second_holds_all = prescribes_all(role);
  if (!prescribes_all(scene.boundary[i].role) || !(second_holds_all || role == Role::roller))
    return "";
  const auto name = [&](const unsigned int k) {
    return "'" + scene.geometry.sides[k].name() + "'";
  };
  const Tensor<1, dim> n = scene.geometry.sides[j].normal_at(x);
  const auto held_part = [&](const Tensor<1, dim> &u) {
    return second_holds_all ? u : (u * n) * n;
  };
  const Tensor<1, dim> a = given_displacement(scene.boundary[i], x),
                       b = given_displacement(scene.boundary[j], x);
  for (const auto &[mover, holder] : {std::pair{i, j}, std::pair{j, i}})
    for (const auto &[motion, text] : motions_at(scene, mover, x))
      if (held_part(motion).norm() > rounding * motion.norm())
        return "the plate " + name(mover) + " cannot " + text + ", because the side " +
               name(holder) + " holds their common point " + vector_text(x) +
               ", allowed: plates whose neighbours let them move";
  if (held_part(a - b).norm() <= rounding * size)
    return "";
  return "the side " + name(i) + " prescribes u = " + vector_text(a) + " at " + vector_text(x) +
         ", where the side " + name(j) + " prescribes " +
         (second_holds_all ? "u = " + vector_text(b) : "u.n = 0 with n = " + vector_text(n)) +
         ", and no displacement of finite energy jumps; allowed: values that agree where sides "
         "meet";
}

/** A point at which two sides meet. */
template <int dim>
using Meeting = std::pair<Point<dim>, std::array<unsigned int, 2>>;

/** Returns why the bodies of a pair would overlap at a common point of a side and a contact side,
 * or nothing: where the other body is held, too, at the point across. Elsewhere that gives way. */
std::string contradiction_of_pair(const Scene<2> &scene, const Point<2> &x, const unsigned int side,
                                  const ContactPair<2> &pair, const std::vector<Meeting<2>> &all,
                                  const double size) {
  const auto &sides = scene.geometry.sides;
  const Side<2> &first = sides[pair.side()];
  const Tensor<1, 2> n = first.normal(first.arc_length(x)), m = pair.direction(x);
  const Side<2> &second = sides[*pair.other_side()];
  const Point<2> y = second.across(x, n);
  const std::optional<double> u_n = given_along(scene, side, x, m);
  if (!u_n || second.normal(second.arc_length(y)) * n >= 0.)
    return "";
  for (const auto &[point, meet] : all)
    for (const auto &[held, other] : {std::pair{meet[0], meet[1]}, std::pair{meet[1], meet[0]}})
      if (other == pair.other_side() && point.distance(y) < 1e-8 * scene.geometry.diameter())
        if (const std::optional<double> v_n = given_along(scene, held, y, m)) {
          const double g = pair.gap(x);
          if (penetrates(scene, *u_n - *v_n, g, size))
            return "the sides '" + sides[side].name() + "' and '" + sides[held].name() +
                   "' close the gap " + number_text(g) + " of the pair '" + first.name() +
                   "' with '" + pair.other_name() + "' by " + number_text(*u_n - *v_n) + " at " +
                   vector_text(x) +
                   ", and no displacement of finite energy keeps the bodies apart; allowed: a "
                   "closing of at most the gap where both are held";
        }
  return "";
}

/** Returns why a side contradicts the contacts of another one where both meet, or nothing. */
template <int dim>
std::string contradiction_to_contacts(const Scene<dim> &scene, const Point<dim> &x,
                                      const unsigned int side, const unsigned int touching,
                                      const std::vector<Meeting<dim>> &all, const double size) {
  std::string contradiction;
  for (const ContactPair<dim> &pair : contact_pairs(scene)) {
    if (pair.side() != touching || !contradiction.empty())
      continue;
    if (!pair.other_side())
      contradiction = contradiction_to_foundation(scene, x, side, pair, size);
    else if constexpr (dim == 2)
      contradiction = contradiction_of_pair(scene, x, side, pair, all, size);
  }
  return contradiction;
}
} // namespace

template <int dim>
std::string find_contradiction(const Scene<dim> &scene) {
  double size = 1e-14 * scene.geometry.diameter();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    for (const Point<dim> &x : samples(scene.geometry.sides[i]))
      size = std::max(size, given_displacement(scene.boundary[i], x).norm());
  std::string contradiction;
  const auto all = meetings(scene.geometry);
  for (const auto &meeting : all)
    for (const auto &[i, j] : {std::pair{meeting.second[0], meeting.second[1]},
                               std::pair{meeting.second[1], meeting.second[0]}}) {
      if (contradiction.empty())
        contradiction = contradiction_at(scene, meeting.first, i, j, size);
      if (contradiction.empty())
        contradiction = contradiction_to_contacts(scene, meeting.first, i, j, all, size);
    }
  return contradiction;
}

INSTANTIATE_FUNCTION(find_contradiction);
} // namespace Signorini
