// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading exponent of plane elasticity at a corner: roots of entire functions.

#include <signorini/base/instantiate.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini {
namespace {
using Complex = std::complex<double>;

/** The function constant + linear z + square z^2 + sine sin(frequency z) + cosine cos(frequency z);
 * its roots z are exponents. */
struct CornerFunction {
  double constant, linear, square, sine, cosine, frequency;

  Complex value(const Complex z) const {
    return constant + z * (linear + square * z) + sine * std::sin(frequency * z) +
           cosine * std::cos(frequency * z);
  }
  Complex derivative(const Complex z) const {
    return linear + 2. * square * z +
           frequency * (sine * std::cos(frequency * z) - cosine * std::sin(frequency * z));
  }
};

/** Returns the functions of (W1) to (W6). Functions that are products are given by their factors,
 * so that roots are simple at straight angles and at cracks. */
std::vector<CornerFunction> corner_functions(const double angle, const EdgeSupport first,
                                             const EdgeSupport second, const double kappa) {
  const double s = std::sin(angle), s2 = std::sin(2. * angle);
  const auto either = [&](const EdgeSupport support) {
    return first == support || second == support;
  };
  if (!either(EdgeSupport::held) && !either(EdgeSupport::sliding))
    return {{0., s, 0., 1., 0., angle}, {0., -s, 0., 1., 0., angle}};
  if (!either(EdgeSupport::free) && !either(EdgeSupport::sliding))
    return {{0., s, 0., kappa, 0., angle}, {0., -s, 0., kappa, 0., angle}};
  if (!either(EdgeSupport::sliding))
    return {
      {2. * kappa - (kappa + 1.) * (kappa + 1.), 0., 4. * s * s, 0., -2. * kappa, 2. * angle}};
  if (either(EdgeSupport::free))
    return {{0., s2, 0., 1., 0., 2. * angle}};
  if (either(EdgeSupport::held))
    return {{0., -s2, 0., kappa, 0., 2. * angle}};
  const double c = std::cos(angle);
  return {{0., 0., 0., c, s, angle}, {0., 0., 0., c, -s, angle}};
}

/** Returns the root that Newton's method finds from z, or nothing. */
std::optional<Complex> root_near(const CornerFunction &f, Complex z) {
  Complex step = 1.;
  for (unsigned int i = 0; i < 60 && std::abs(step) >= 1e-15 * std::abs(z); ++i) {
    step = f.value(z) / f.derivative(z);
    z -= step;
    // Far from all roots steps may lead to where the sine overflows.
    if (!(std::abs(step) < 1e3) || !(std::abs(f.frequency * z.imag()) < 100.))
      return {};
  }
  return std::abs(step) > 1e-10 * std::abs(z) ? std::nullopt : std::optional(z);
}

/** Returns the smallest Re z > 0 of the roots that are no integers, for which solutions are no
 * polynomials. Newton's method finds them from the points of a grid. With |frequency Im z| > 6 +
 * log(1 + kappa) a sine or cosine is larger than all other terms; roots come in pairs z, conj(z).
 */
double min_real_part(const CornerFunction &f, const double kappa) {
  const double spacing = 0.5 / f.frequency;
  const double highest = (6. + std::log(1. + kappa)) / f.frequency;
  double smallest = max_corner_exponent;
  for (double x = 0.5 * spacing; x < smallest + spacing; x += spacing)
    for (double y = 0.; y < highest; y += spacing)
      if (const std::optional<Complex> root = root_near(f, Complex(x, y)))
        if (root->real() > 1e-6 && std::abs(*root - std::round(root->real())) > 1e-6)
          smallest = std::min(smallest, root->real());
  return smallest;
}
} // namespace

double corner_exponent(const double angle, const EdgeSupport first, const EdgeSupport second,
                       const double kappa) {
  Assert(angle > 0. && angle < 2. * numbers::PI + 1e-6,
         ExcMessage("The angle of a corner lies between 0 and 2 pi."));
  Assert(kappa > 1. - 1e-6, ExcMessage("Kolosov's constant is at least one."));
  double smallest = max_corner_exponent;
  for (const CornerFunction &f : corner_functions(angle, first, second, kappa))
    smallest = std::min(smallest, min_real_part(f, kappa));
  return smallest;
}

double min_corner_exponent(const double angle, const Role first, const Role second,
                           const double kappa) {
  double smallest = max_corner_exponent;
  for (const EdgeSupport one : possible_supports(first))
    for (const EdgeSupport other : possible_supports(second))
      smallest = std::min(smallest, corner_exponent(angle, one, other, kappa));
  return smallest;
}

double kolosov_constant(const SymmetricTensor<4, 2> &hooke) {
  // E_iijj = 4 (lambda + mu) and E_ijij = 2 lambda + 6 mu do not change with the axes.
  double traces = 0., squares = 0.;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j) {
      traces += hooke[i][i][j][j];
      squares += hooke[i][j][i][j];
    }
  return 2. * squares / traces;
}

// Where the sides of a 2-D body meet, and how rough a displacement may be there.

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
    std::vector<Corner> here;
    for (const SideEnd &second : arriving)
      if (first.position.distance(second.position) < 1e-8 * geometry.diameter() &&
          geometry.body_of_side(first.side) == geometry.body_of_side(second.side))
        here.push_back({first.position, opening(first, second), {{first.side, second.side}}});
    const auto next = std::min_element(
      here.begin(), here.end(), [](const Corner &a, const Corner &b) { return a.angle < b.angle; });
    if (next != here.end())
      found.push_back(*next);
  }
  return found;
}

std::vector<EdgeSupport> possible_supports(const Role role) {
  if (role == Role::clamped || role == Role::displacement)
    return {EdgeSupport::held};
  if (role == Role::roller)
    return {EdgeSupport::sliding};
  if (role == Role::contact || role == Role::opposite)
    return {EdgeSupport::free, EdgeSupport::sliding};
  return {EdgeSupport::free};
}

double corner_exponent(const Scene<2> &scene, const Corner &corner) {
  return min_corner_exponent(corner.angle, scene.boundary[corner.sides[0]].role,
                             scene.boundary[corner.sides[1]].role,
                             kolosov_constant(scene.material->relative_hooke(corner.position)));
}

// Sides that prescribe different displacements where they meet.

namespace {
/** The share of the prescribed displacements, and of the directions of plates and normals, below
 * which a difference is rounding. */
constexpr double rounding = 1e-6;

/** Returns the common points of each two sides: corners, and points of the edges of a box. */
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
  for (const double share : shares)
    points.push_back(side.point(share * side.length()));
  return points;
}

std::vector<Point<3>> samples(const Side<3> &side) {
  std::vector<Point<3>> points;
  for (const double r : shares)
    for (const double s : shares)
      points.push_back(side.point({r * side.lengths()[0], s * side.lengths()[1]}));
  return points;
}

std::vector<std::pair<Point<3>, std::array<unsigned int, 2>>>
meetings(const Geometry<3> &geometry) {
  std::vector<std::pair<Point<3>, std::array<unsigned int, 2>>> found;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (const Point<3> &x : samples(geometry.sides[i]))
      for (unsigned int j = 0; j < i; ++j)
        if (x.distance(geometry.sides[j].point(geometry.sides[j].coordinates(x))) <
            1e-8 * geometry.diameter())
          found.push_back({x, {{i, j}}});
  return found;
}

template <int dim>
std::string text_of(const Tensor<1, dim> &vector) {
  std::vector<std::string> numbers;
  for (unsigned int d = 0; d < dim; ++d)
    numbers.push_back(number_text(vector[d] + 0.)); // no -0
  return "(" + join(numbers) + ")";
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
  if constexpr (dim == 2)
    for (const Plate &plate : scene.plates)
      if (plate.side == side) {
        if (plate.is_pushed)
          found.emplace_back(plate.direction, "move along " + text_of(plate.direction));
        if (plate.drifts)
          found.emplace_back(plate.across(), "move along " + text_of(plate.across()));
        if (plate.turns)
          found.emplace_back(plate.displacement({0., 0., 1.}, x), "turn");
      }
  return found;
}

/** Returns why the second side contradicts the first one at a common point, or nothing. @param size
 * the largest prescribed displacement. */
template <int dim>
std::string contradiction_at(const Scene<dim> &scene, const Point<dim> &x, const unsigned int i,
                             const unsigned int j, const double size) {
  const Role role = scene.boundary[j].role;
  const bool second_holds_all = prescribes_all(role), touches = role == Role::contact;
  if (!prescribes_all(scene.boundary[i].role) ||
      !(second_holds_all || touches || role == Role::roller))
    return "";
  const auto name = [&](const unsigned int k) {
    return "'" + scene.geometry.sides[k].name() + "'";
  };
  const Side<dim> &second = scene.geometry.sides[j];
  const Tensor<1, dim> n = second.normal(second.coordinates(x));
  const auto held_part = [&](const Tensor<1, dim> &u) {
    return second_holds_all ? u : (u * n) * n;
  };
  const Tensor<1, dim> a = given_displacement(scene.boundary[i], x),
                       b = given_displacement(scene.boundary[j], x);
  if (touches) {
    const double g = scene.boundary[j].data->value(x);
    // A gap by a foundation has rounding; a plate that is pushed moves until the gap lets it.
    const bool penetrates =
      a * n - g > rounding * (size + std::abs(g)) + 1e-12 * scene.geometry.diameter();
    return !penetrates || !motions_at(scene, i, x).empty()
             ? ""
             : "the side " + name(i) + " prescribes u = " + text_of(a) + " at " + text_of(x) +
                 ", where the side " + name(j) + " has the gap " + number_text(g) +
                 ", and no displacement of finite energy stays outside of the foundation; allowed: "
                 "u.n <= g where they meet";
  }
  for (const auto &[mover, holder] : {std::pair{i, j}, std::pair{j, i}})
    for (const auto &[motion, text] : motions_at(scene, mover, x))
      if (held_part(motion).norm() > rounding * motion.norm())
        return "the plate " + name(mover) + " cannot " + text + ", because the side " +
               name(holder) + " holds their common point " + text_of(x) +
               ", allowed: plates whose neighbours let them move";
  if (held_part(a - b).norm() <= rounding * size)
    return "";
  return "the side " + name(i) + " prescribes u = " + text_of(a) + " at " + text_of(x) +
         ", where the side " + name(j) + " prescribes " +
         (second_holds_all ? "u = " + text_of(b) : "u.n = 0 with n = " + text_of(n)) +
         ", and no displacement of finite energy jumps; allowed: values that agree where sides "
         "meet";
}
} // namespace

template <int dim>
std::string find_contradiction(const Scene<dim> &scene) {
  double size = 1e-14 * scene.geometry.diameter();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    for (const Point<dim> &x : samples(scene.geometry.sides[i]))
      size = std::max(size, given_displacement(scene.boundary[i], x).norm());
  std::string contradiction;
  for (const auto &[x, sides] : meetings(scene.geometry))
    for (const auto &[i, j] : {std::pair{sides[0], sides[1]}, std::pair{sides[1], sides[0]}})
      if (contradiction.empty())
        contradiction = contradiction_at(scene, x, i, j, size);
  return contradiction;
}

INSTANTIATE_FUNCTION(find_contradiction);
} // namespace Signorini
