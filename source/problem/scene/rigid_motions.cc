// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of A, found from the boundary conditions alone: no finite elements.

#include <signorini/base/instantiate.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <sstream>

namespace Signorini {
namespace {
/** Returns the velocity of a translation along an axis or, behind these, of a rotation, in 3-D
 * about an axis. */
template <int dim>
Tensor<1, dim> rigid_velocity(const unsigned int k, const Tensor<1, dim> &x) {
  if (k < dim)
    return Point<dim>::unit_vector(k);
  Rotation<dim> omega = {};
  component(omega, k - dim) = 1.;
  return cross(omega, x);
}

/** The sum of r r^T over conditions r.motion = 0 on translations and rotations times the size of
 * the whole geometry, body after body, each about the centre of the box around it. */
template <int dim>
class Conditions {
public:
  explicit Conditions(const Geometry<dim> &geometry)
    : matrix(geometry.n_bodies() * n_rigid_motions<dim>)
    , size(geometry.diameter()) {
    const auto add = [&](const Point<dim> &lower, const Point<dim> &upper) {
      centres.push_back(lower + 0.5 * (upper - lower));
    };
    for (const ElasticBody<dim> &body : geometry.bodies)
      add(body.lower, body.upper);
    if (geometry.bodies.empty())
      add(geometry.lower, geometry.upper);
  }

  /** Adds the condition v(x).n = 0 for a body or, with another one, for v of the first less v of
   * the second. */
  void forbid_velocity(const Point<dim> &x, const Tensor<1, dim> &n, const double weight = 1.,
                       const unsigned int body = 0,
                       const std::optional<unsigned int> &other = std::nullopt) {
    constexpr unsigned int n_own = n_rigid_motions<dim>;
    std::vector<std::pair<unsigned int, double>> row;
    for (unsigned int k = 0; k < n_own; ++k) {
      row.emplace_back(n_own * body + k, rigid_velocity<dim>(k, (x - centres[body]) / size) * n);
      if (other)
        row.emplace_back(n_own * *other + k,
                         -(rigid_velocity<dim>(k, (x - centres[*other]) / size) * n));
    }
    for (const auto &[i, of_i] : row)
      for (const auto &[j, of_j] : row)
        matrix(i, j) += weight * of_i * of_j;
  }
  /** Adds the conditions of a side with this role at a point to a body, or to two bodies that
   * touch. */
  void forbid(const Role role, const Point<dim> &x, const Tensor<1, dim> &n, const double weight,
              const unsigned int body = 0,
              const std::optional<unsigned int> &other = std::nullopt) {
    if (role == Role::roller)
      forbid_velocity(x, n, weight, body, other);
    if (role == Role::clamped || role == Role::displacement)
      for (unsigned int d = 0; d < dim; ++d)
        forbid_velocity(x, Point<dim>::unit_vector(d), weight, body, other);
  }

  LAPACKFullMatrix<double> matrix;
  std::vector<Point<dim>> centres;
  double size;
};

/** Returns points of a side with the directions of a contact; two suffice for a segment, three for
 * a circle. */
std::vector<SurfacePoint<2>> contact_points(const Side<2> &side,
                                            const ContactCondition<2> &contact) {
  std::vector<SurfacePoint<2>> points;
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const double share : {0., 1. / 3., 2. / 3., 1.}) {
      const double s = share * side.piece(k).length();
      const Point<2> x = side.piece(k).point(s);
      points.push_back(
        {x, contact.directions.at(side.start_of(k) + s, x, side.piece(k).normal(s))});
    }
  return points;
}
std::vector<SurfacePoint<3>> contact_points(const Side<3> &side,
                                            const ContactCondition<3> &contact) {
  std::vector<SurfacePoint<3>> points = side.samples(2);
  for (auto &[x, m] : points)
    m = contact.directions.at(x, m);
  return points;
}

/** Adds the conditions of a side, as a contact one of it where there is one. */
template <int dim>
void add_side_conditions(const Scene<dim> &scene, const unsigned int number,
                         const ContactCondition<dim> &contact, Conditions<dim> &conditions) {
  const Geometry<dim> &geometry = scene.geometry;
  std::optional<unsigned int> other;
  if (contact.opposite)
    other = geometry.body_of_side(*contact.opposite);
  const std::vector<SurfacePoint<dim>> points = contact_points(geometry.sides[number], contact);
  for (const auto &[x, m] : points)
    conditions.forbid(scene.boundary[number].role, x, m, 4. / points.size(),
                      geometry.body_of_side(number), other);
}

/** Adds the conditions of a side, in each of its contacts. */
template <int dim>
void add_side_conditions(const Scene<dim> &scene, const unsigned int number,
                         Conditions<dim> &conditions) {
  for (const ContactCondition<dim> &contact : scene.contacts)
    if (contact.side == number)
      add_side_conditions(scene, number, contact, conditions);
  if (!scene.has_contact_on(number))
    add_side_conditions<dim>(scene, number, {}, conditions);
}

/** Adds the conditions of a plate on its body, which moves as a whole. */
template <int dim>
void add_plate_conditions(const Plate<dim> &plate, const unsigned int body,
                          Conditions<dim> &conditions) {
  for (const Tensor<1, dim> &across : plate.across())
    if (!plate.drifts)
      conditions.forbid_velocity(plate.centre, across, 1., body);
  if (!plate.is_pushed)
    conditions.forbid_velocity(plate.centre, plate.direction, 1., body);
  constexpr unsigned int n = n_rigid_motions<dim>;
  for (unsigned int k = n * body + dim; k < n * (body + 1) && !plate.turns; ++k)
    conditions.matrix(k, k) += 1.;
}

/** Returns a point or a direction rounded for messages: no 1e-17. @param size that of the body, 1
 * of directions. */
template <int dim>
std::string rounded_text(Tensor<1, dim> x, const double size = 1.) {
  const double scale = 1e4 * std::pow(10., -std::floor(std::log10(size)));
  for (unsigned int d = 0; d < dim; ++d)
    x[d] = std::round(x[d] * scale) / scale;
  return vector_text(x);
}

/** Returns "(1, 2)", the point that does not move. */
std::string pole(const BodyMotion<2> &motion) {
  const double omega = motion.rotation / motion.size;
  return rounded_text<2>(motion.centre - cross_product_2d(motion.translation) / omega, motion.size);
}
/** Returns "the line through (0, 0, 1) along (1, 0, 0)", with the motion along it if there is one.
 */
std::string pole(const BodyMotion<3> &motion) {
  constexpr double negligible = 1e-6;
  const Tensor<1, 3> omega = motion.rotation / motion.size, &t = motion.translation;
  const double pitch = omega * t / omega.norm_square();
  return "the line through " +
         rounded_text<3>(motion.centre + cross_product_3d(omega, t) / omega.norm_square(),
                         motion.size) +
         " along " + rounded_text<3>(omega / omega.norm()) +
         (std::abs(pitch) > negligible * motion.size
            ? " (by " + number_text(2. * numbers::PI * pitch) + " along it in each turn)"
            : "");
}

/** Returns "clockwise about (1, 2)". */
std::string turning(const BodyMotion<2> &motion) {
  return std::string(motion.rotation > 0. ? "counter-clockwise" : "clockwise") + " about " +
         pole(motion);
}
std::string turning(const BodyMotion<3> &motion) {
  return "about " + pole(motion);
}
} // namespace

template <int dim>
Tensor<1, dim> BodyMotion<dim>::velocity(const Point<dim> &x) const {
  return translation + cross(rotation, (x - centre) / size);
}

template <int dim>
double BodyMotion<dim>::speed() const {
  return std::max(translation.norm(), size_of(rotation));
}

namespace {
template <int dim>
bool is_translation(const BodyMotion<dim> &motion) {
  return size_of(motion.rotation) < 1e-6 * motion.translation.norm();
}

/** Returns the texts of all bodies that move. */
template <int dim>
std::string join_parts(const RigidMotion<dim> &motion, const std::string &before_body,
                       const std::function<std::string(const BodyMotion<dim> &)> &text_of) {
  double fastest = 0.;
  for (const BodyMotion<dim> &part : motion.bodies)
    fastest = std::max(fastest, part.speed());
  std::vector<std::string> texts;
  for (const BodyMotion<dim> &part : motion.bodies)
    if (part.speed() > 1e-6 * fastest)
      texts.push_back(text_of(part) +
                      (part.name.empty() ? "" : before_body + "'" + part.name + "'"));
  return join(texts, " and ");
}

/** Returns x or -x, of which the first component that is not zero is positive. */
template <int dim>
Tensor<1, dim> without_sign(const Tensor<1, dim> &x) {
  for (unsigned int d = 0; d < dim; ++d)
    if (std::abs(x[d]) > 1e-6 * x.norm())
      return x[d] < 0. ? -x : x;
  return x;
}
} // namespace

template <int dim>
bool RigidMotion<dim>::is_translation() const {
  return std::all_of(bodies.begin(), bodies.end(), [](const BodyMotion<dim> &part) {
    return part.speed() == 0. || Signorini::is_translation(part);
  });
}

template <int dim>
std::string RigidMotion<dim>::name() const {
  return join_parts<dim>(*this, " of ", [](const BodyMotion<dim> &part) {
    return Signorini::is_translation(part)
             ? "the translation along " +
                 rounded_text(without_sign(part.translation / part.translation.norm()))
             : "the rotation about " + pole(part);
  });
}

template <int dim>
std::string RigidMotion<dim>::direction() const {
  return join_parts<dim>(*this, ", of ", [](const BodyMotion<dim> &part) {
    return Signorini::is_translation(part)
             ? "along " + rounded_text(part.translation / part.translation.norm())
             : turning(part);
  });
}

template <int dim>
RigidMotion<dim> combine(const std::vector<RigidMotion<dim>> &motions,
                         const std::vector<double> &weights) {
  AssertDimension(motions.size(), weights.size());
  RigidMotion<dim> sum = motions.front();
  for (std::size_t b = 0; b < sum.bodies.size(); ++b) {
    BodyMotion<dim> &part = sum.bodies[b];
    part.translation = 0.;
    part.rotation = {};
    for (std::size_t i = 0; i < motions.size(); ++i) {
      part.translation += weights[i] * motions[i].bodies[b].translation;
      part.rotation += weights[i] * motions[i].bodies[b].rotation;
    }
  }
  return sum;
}

namespace {
/** Changes the columns of a matrix into a basis of their span in which each vector alone has a one
 * at some row: motions of one body each, where bodies move independently. These rows are rotations
 * as far as possible, so that all translations in the span come first. */
template <int dim>
FullMatrix<double> separate(FullMatrix<double> vectors) {
  constexpr unsigned int n_own = n_rigid_motions<dim>;
  constexpr double negligible = 1e-6;
  const unsigned int n = vectors.n();
  // The rows of the columns; none at first.
  std::vector<unsigned int> rows(n, vectors.m());
  for (unsigned int step = 0; step < n; ++step) {
    const auto find = [&](const bool among_rotations) {
      std::array<unsigned int, 2> pivot = {};
      double largest = 0.;
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int i = 0; i < vectors.m() && rows[k] == vectors.m(); ++i)
          if ((i % n_own >= dim) == among_rotations && std::abs(vectors(i, k)) > largest) {
            largest = std::abs(vectors(i, k));
            pivot = {{i, k}};
          }
      return std::pair(largest, pivot);
    };
    auto [largest, pivot] = find(true);
    if (largest < negligible)
      pivot = find(false).second;
    const auto [row, column] = pivot;
    rows[column] = row;
    const double factor = vectors(row, column);
    for (unsigned int i = 0; i < vectors.m(); ++i)
      vectors(i, column) /= factor;
    for (unsigned int l = 0; l < n; ++l)
      if (const double share = vectors(row, l); l != column)
        for (unsigned int i = 0; i < vectors.m(); ++i)
          vectors(i, l) -= share * vectors(i, column);
  }
  std::vector<unsigned int> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](const unsigned int k, const unsigned int l) {
    return std::pair(rows[k] % n_own >= dim, rows[k]) < std::pair(rows[l] % n_own >= dim, rows[l]);
  });
  FullMatrix<double> basis(vectors.m(), n);
  // The work of loads must not be rounding relative to rounding.
  for (unsigned int i = 0; i < vectors.m(); ++i)
    for (unsigned int k = 0; k < n; ++k)
      if (const double entry = vectors(i, order[k]); std::abs(entry) >= 1e-10)
        basis(i, k) = entry;
  return basis;
}
} // namespace

template <int dim>
std::vector<RigidMotion<dim>> free_rigid_motions(const Scene<dim> &scene, const Plates plates) {
  Conditions<dim> conditions(scene.geometry);
  constexpr unsigned int n_own = n_rigid_motions<dim>;
  // A body of revolution is rigid along its axis only.
  const unsigned int n = conditions.matrix.m(), n_bodies = scene.geometry.n_bodies();
  if (scene.geometry.axisymmetric)
    for (unsigned int k = 0; k < n; ++k)
      conditions.matrix(k, k) += k % n_own != 1 ? 1. : 0.;
  std::vector<bool> is_released(scene.boundary.size(), false);
  if (plates == Plates::released)
    for (const Plate<dim> &plate : scene.plates) {
      is_released[plate.side] = true;
      add_plate_conditions(plate, scene.geometry.body_of_side(plate.side), conditions);
    }
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (!is_released[i])
      add_side_conditions(scene, i, conditions);
  dealii::Vector<double> eigenvalues(n);
  FullMatrix<double> vectors(n, n);
  conditions.matrix.compute_eigenvalues_symmetric(-1., 1e6, 1e-15, eigenvalues, vectors);
  // A clamped side of the length l holds a rotation with (l / size)² at least, see
  // max_slenderness; rounding leaves 1e-15.
  const unsigned int n_free = std::count_if(eigenvalues.begin(), eigenvalues.end(),
                                            [](const double value) { return value < 1e-14; });
  FullMatrix<double> free(n, n_free);
  for (unsigned int k = 0; k < n_free; ++k)
    for (unsigned int i = 0; i < n; ++i)
      free(i, k) = vectors(i, k);
  free = separate<dim>(free);
  std::vector<RigidMotion<dim>> motions(n_free);
  for (unsigned int k = 0; k < n_free; ++k)
    for (unsigned int b = 0; b < n_bodies; ++b) {
      BodyMotion<dim> motion = {n_bodies > 1 ? scene.geometry.bodies[b].name : "",
                                {},
                                {},
                                conditions.centres[b],
                                conditions.size};
      for (unsigned int d = 0; d < dim; ++d)
        motion.translation[d] = free(n_own * b + d, k);
      for (unsigned int d = dim; d < n_own; ++d)
        component(motion.rotation, d - dim) = free(n_own * b + d, k);
      motions[k].bodies.push_back(motion);
    }
  return motions;
}

template struct BodyMotion<2>;
template struct BodyMotion<3>;
template struct RigidMotion<2>;
template struct RigidMotion<3>;
INSTANTIATE_FUNCTION(combine);
INSTANTIATE_FUNCTION(free_rigid_motions);
} // namespace Signorini
