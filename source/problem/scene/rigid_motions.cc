// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of A, found from the boundary conditions alone: no finite elements.

#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/contact_pair.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>

namespace Signorini {
namespace {
/** The translations and rotations of a body as a whole. */
template <int dim>
constexpr unsigned int n_rigid_motions = dim *(dim + 1) / 2;

/** Returns the velocity of a translation along an axis or, behind these, of a rotation, in 3-D
 * about an axis. */
template <int dim>
Tensor<1, dim> rigid_velocity(const unsigned int k, const Tensor<1, dim> &x) {
  if (k < dim)
    return Point<dim>::unit_vector(k);
  if constexpr (dim == 2)
    return Tensor<1, 2>({-x[1], x[0]});
  else
    return cross_product_3d(Point<3>::unit_vector(k - 3), x);
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

/** Adds the conditions of a side, as a contact one of it where there is one; two points suffice for
 * a segment, three for a circle. */
void add_side_conditions(const Scene<2> &scene, const unsigned int number,
                         const ContactCondition<2> &contact, Conditions<2> &conditions) {
  const Geometry<2> &geometry = scene.geometry;
  const Side<2> &side = geometry.sides[number];
  std::optional<unsigned int> other;
  if (contact.opposite)
    other = geometry.body_of_side(*contact.opposite);
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const double share : {0., 1. / 3., 2. / 3., 1.}) {
      const double s = share * side.piece(k).length();
      const Point<2> x = side.piece(k).point(s);
      conditions.forbid(scene.boundary[number].role, x,
                        contact.directions.at(side.start_of(k) + s, x, side.piece(k).normal(s)),
                        1. / side.n_pieces(), geometry.body_of_side(number), other);
    }
}

/** Adds the conditions of a side, in each of its contacts. */
void add_side_conditions(const Scene<2> &scene, const unsigned int number,
                         Conditions<2> &conditions) {
  for (const ContactCondition<2> &contact : scene.contacts)
    if (contact.side == number)
      add_side_conditions(scene, number, contact, conditions);
  if (!scene.has_contact_on(number))
    add_side_conditions(scene, number, {}, conditions);
}

void add_side_conditions(const Side<3> &side, const Role role, Conditions<3> &conditions) {
  for (const SurfacePoint<3> &point : side.samples(2))
    conditions.forbid(role, point.x, point.n, 1. / side.faces().size());
}

/** Adds the conditions of a plate on its body, which moves as a whole. */
void add_plate_conditions(const Plate &plate, const unsigned int body, Conditions<2> &conditions) {
  if (!plate.drifts)
    conditions.forbid_velocity(plate.centre, plate.across(), 1., body);
  if (!plate.is_pushed)
    conditions.forbid_velocity(plate.centre, plate.direction, 1., body);
  if (!plate.turns)
    conditions.matrix(3 * body + 2, 3 * body + 2) += 1.;
}

/** Returns a point or a direction rounded for messages: no 1e-17. */
std::string rounded_text(Tensor<1, 2> x) {
  for (unsigned int d = 0; d < 2; ++d)
    x[d] = std::round(x[d] * 1e4) / 1e4;
  return vector_text(x);
}

/** Returns the point that does not move, as text. */
std::string pole(const BodyMotion &motion) {
  const double omega = motion.rotation / motion.size;
  return rounded_text(motion.centre - cross_product_2d(motion.translation) / omega);
}
} // namespace

Tensor<1, 2> BodyMotion::velocity(const Point<2> &x) const {
  const Tensor<1, 2> arm = (x - centre) / size;
  return translation + rotation * Tensor<1, 2>({-arm[1], arm[0]});
}

double BodyMotion::speed() const {
  return std::max(translation.norm(), std::abs(rotation));
}

namespace {
bool is_translation(const BodyMotion &motion) {
  return std::abs(motion.rotation) < 1e-6 * motion.translation.norm();
}

/** Returns the texts of all bodies that move. */
std::string join_parts(const RigidMotion &motion, const std::string &before_body,
                       const std::function<std::string(const BodyMotion &)> &text_of) {
  double fastest = 0.;
  for (const BodyMotion &part : motion.bodies)
    fastest = std::max(fastest, part.speed());
  std::vector<std::string> texts;
  for (const BodyMotion &part : motion.bodies)
    if (part.speed() > 1e-6 * fastest)
      texts.push_back(text_of(part) +
                      (part.name.empty() ? "" : before_body + "'" + part.name + "'"));
  return join(texts, " and ");
}
} // namespace

bool RigidMotion::is_translation() const {
  return std::all_of(bodies.begin(), bodies.end(), [](const BodyMotion &part) {
    return part.speed() == 0. || Signorini::is_translation(part);
  });
}

std::string RigidMotion::name() const {
  return join_parts(*this, " of ", [](const BodyMotion &part) {
    if (!Signorini::is_translation(part))
      return "the rotation about " + pole(part);
    const Tensor<1, 2> t = part.translation / part.translation.norm();
    const double sign = (std::abs(t[0]) > 1e-6 ? t[0] : t[1]) < 0 ? -1. : 1.;
    return "the translation along " + rounded_text(sign * t);
  });
}

std::string RigidMotion::direction() const {
  return join_parts(*this, ", of ", [](const BodyMotion &part) {
    if (!Signorini::is_translation(part))
      return std::string(part.rotation > 0. ? "counter-clockwise" : "clockwise") + " about " +
             pole(part);
    return "along " + rounded_text(part.translation / part.translation.norm());
  });
}

RigidMotion combine(const std::vector<RigidMotion> &motions, const std::vector<double> &weights) {
  AssertDimension(motions.size(), weights.size());
  RigidMotion sum = motions.front();
  for (std::size_t b = 0; b < sum.bodies.size(); ++b) {
    BodyMotion &part = sum.bodies[b];
    part.translation = 0.;
    part.rotation = 0.;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      part.translation += weights[i] * motions[i].bodies[b].translation;
      part.rotation += weights[i] * motions[i].bodies[b].rotation;
    }
  }
  return sum;
}

namespace {
/** Changes the columns of a matrix into a basis of their span in which each vector alone has a one
 * at some row: motions of one body each, where bodies move independently. */
void separate(FullMatrix<double> &vectors) {
  std::vector<bool> done(vectors.m(), false);
  for (unsigned int k = 0; k < vectors.n(); ++k) {
    unsigned int pivot = 0;
    double largest = 0.;
    for (unsigned int i = 0; i < vectors.m(); ++i)
      if (!done[i] && std::abs(vectors(i, k)) > largest) {
        largest = std::abs(vectors(i, k));
        pivot = i;
      }
    done[pivot] = true;
    const double factor = vectors(pivot, k);
    for (unsigned int i = 0; i < vectors.m(); ++i)
      vectors(i, k) /= factor;
    for (unsigned int l = 0; l < vectors.n(); ++l)
      if (const double share = vectors(pivot, l); l != k)
        for (unsigned int i = 0; i < vectors.m(); ++i)
          vectors(i, l) -= share * vectors(i, k);
  }
  // The work of loads must not be rounding relative to rounding.
  for (unsigned int i = 0; i < vectors.m(); ++i)
    for (unsigned int k = 0; k < vectors.n(); ++k)
      if (std::abs(vectors(i, k)) < 1e-10)
        vectors(i, k) = 0.;
}
} // namespace

std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene, const Plates plates) {
  Conditions<2> conditions(scene.geometry);
  // A body of revolution is rigid along its axis only.
  const unsigned int n = conditions.matrix.m(), n_bodies = scene.geometry.n_bodies();
  if (scene.geometry.axisymmetric)
    for (unsigned int k = 0; k < n; ++k)
      conditions.matrix(k, k) += k % 3 != 1 ? 1. : 0.;
  std::vector<bool> is_released(scene.boundary.size(), false);
  if (plates == Plates::released)
    for (const Plate &plate : scene.plates) {
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
  if (n_bodies > 1)
    separate(free);
  std::vector<RigidMotion> motions(n_free);
  for (unsigned int k = 0; k < n_free; ++k)
    for (unsigned int b = 0; b < n_bodies; ++b)
      motions[k].bodies.push_back({n_bodies > 1 ? scene.geometry.bodies[b].name : "",
                                   Tensor<1, 2>({free(3 * b, k), free(3 * b + 1, k)}),
                                   free(3 * b + 2, k), conditions.centres[b], conditions.size});
  return motions;
}

// Sides of a box are parallel to its axes: the motions that they leave free are spanned by
// translations along the axes and rotations about axes through any point on the lines of symmetry
// of the held sides.
std::vector<std::string> free_rigid_motions(const Scene<3> &scene) {
  Conditions<3> conditions(scene.geometry);
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    add_side_conditions(scene.geometry.sides[i], scene.boundary[i].role, conditions);
  std::vector<std::string> names;
  for (unsigned int k = 0; k < 6; ++k)
    if (conditions.matrix(k, k) < 1e-20)
      names.push_back(k < 3 ? std::string("the translation along ") + "xyz"[k]
                            : std::string("the rotation about the ") + "xyz"[k - 3] + "-axis");
  return names;
}

} // namespace Signorini
