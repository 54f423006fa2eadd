// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of A, found from the boundary conditions alone: no finite elements.

#include <signorini/base/message.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
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
 * the body, about the centre of the box around it. */
template <int dim>
class Conditions {
public:
  explicit Conditions(const Geometry<dim> &geometry)
    : matrix(n_rigid_motions<dim>)
    , centre(geometry.lower + 0.5 * (geometry.upper - geometry.lower))
    , size(geometry.diameter()) {}

  /** Adds the condition v(x).n = 0. */
  void forbid_velocity(const Point<dim> &x, const Tensor<1, dim> &n, const double weight = 1.) {
    dealii::Vector<double> row(matrix.m());
    for (unsigned int k = 0; k < row.size(); ++k)
      row[k] = rigid_velocity<dim>(k, (x - centre) / size) * n;
    for (unsigned int i = 0; i < row.size(); ++i)
      for (unsigned int j = 0; j < row.size(); ++j)
        matrix(i, j) += weight * row[i] * row[j];
  }
  /** Adds what a side of this role forbids at a point. */
  void forbid(const Role role, const Point<dim> &x, const Tensor<1, dim> &n, const double weight) {
    if (role == Role::roller)
      forbid_velocity(x, n, weight);
    if (role == Role::clamped || role == Role::displacement)
      for (unsigned int d = 0; d < dim; ++d)
        forbid_velocity(x, Point<dim>::unit_vector(d), weight);
  }

  LAPACKFullMatrix<double> matrix;
  Point<dim> centre;
  double size;
};

/** Adds what a side of this role forbids; two points suffice for a segment, three for a circle. */
void add_side_conditions(const Side<2> &side, const Role role, Conditions<2> &conditions) {
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const double share : {0., 1. / 3., 2. / 3., 1.}) {
      const double s = share * side.piece(k).length();
      conditions.forbid(role, side.piece(k).point(s), side.piece(k).normal(s),
                        1. / side.n_pieces());
    }
}

void add_side_conditions(const Side<3> &side, const Role role, Conditions<3> &conditions) {
  for (const double r : {0., side.lengths()[0]})
    for (const double t : {0., side.lengths()[1]})
      conditions.forbid(role, side.point({r, t}), side.normal({r, t}), 1.);
}

/** Adds what a plate forbids to a body that moves as a whole. */
void add_plate_conditions(const Plate &plate, Conditions<2> &conditions) {
  if (!plate.drifts)
    conditions.forbid_velocity(plate.centre, plate.across());
  if (!plate.is_pushed)
    conditions.forbid_velocity(plate.centre, plate.direction);
  if (!plate.turns)
    conditions.matrix(2, 2) += 1.;
}

/** Rounds a number for messages: no -0, no 1e-17. */
double rounded(const double value) {
  return std::round(value * 1e4) / 1e4 + 0.;
}

std::string point_text(const double x, const double y) {
  return concatenate("(", rounded(x), ", ", rounded(y), ")");
}

/** Returns the point that does not move, as text. */
std::string pole(const RigidMotion &motion) {
  const double omega = motion.rotation / motion.size;
  return point_text(motion.centre[0] - motion.translation[1] / omega,
                    motion.centre[1] + motion.translation[0] / omega);
}
} // namespace

Tensor<1, 2> RigidMotion::velocity(const Point<2> &x) const {
  const Tensor<1, 2> arm = (x - centre) / size;
  return translation + rotation * Tensor<1, 2>({-arm[1], arm[0]});
}

bool RigidMotion::is_translation() const {
  return std::abs(rotation) < 1e-6 * translation.norm();
}

std::string RigidMotion::name() const {
  if (!is_translation())
    return "the rotation about " + pole(*this);
  const Tensor<1, 2> t = translation / translation.norm();
  const double sign = (std::abs(t[0]) > 1e-6 ? t[0] : t[1]) < 0 ? -1. : 1.;
  return "the translation along " + point_text(sign * t[0], sign * t[1]);
}

std::string RigidMotion::direction() const {
  if (!is_translation())
    return std::string(rotation > 0. ? "counter-clockwise" : "clockwise") + " about " + pole(*this);
  const double length = translation.norm();
  return "along " + point_text(translation[0] / length, translation[1] / length);
}

RigidMotion combine(const std::vector<RigidMotion> &motions, const std::vector<double> &weights) {
  RigidMotion sum = motions.front();
  sum.translation = 0.;
  sum.rotation = 0.;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    sum.translation += weights[i] * motions[i].translation;
    sum.rotation += weights[i] * motions[i].rotation;
  }
  return sum;
}

std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene, const Plates plates) {
  Conditions<2> conditions(scene.geometry);
  // A body of revolution is rigid along its axis only.
  if (scene.geometry.axisymmetric)
    for (const unsigned int k : {0, 2})
      conditions.matrix(k, k) += 1.;
  std::vector<bool> is_released(scene.boundary.size(), false);
  if (plates == Plates::released)
    for (const Plate &plate : scene.plates) {
      is_released[plate.side] = true;
      add_plate_conditions(plate, conditions);
    }
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (!is_released[i])
      add_side_conditions(scene.geometry.sides[i], scene.boundary[i].role, conditions);
  dealii::Vector<double> eigenvalues(3);
  FullMatrix<double> vectors(3, 3);
  conditions.matrix.compute_eigenvalues_symmetric(-1., 1e6, 1e-15, eigenvalues, vectors);
  std::vector<RigidMotion> motions;
  for (unsigned int k = 0; k < 3; ++k)
    // A clamped side of the length l holds a rotation with (l / size)² at least, see
    // max_slenderness; rounding leaves 1e-15.
    if (eigenvalues[k] < 1e-14)
      motions.push_back({Tensor<1, 2>({vectors(0, k), vectors(1, k)}), vectors(2, k),
                         conditions.centre, conditions.size});
  return motions;
}

// Sides of a box are parallel to its axes: what they leave free is spanned by translations along
// the axes and rotations about axes through any point on the lines of symmetry of the held sides.
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

// Generalised displacements: what plates and pins could do.

namespace {
/** The motions of all plates, travels and rotations times the size of the body, or of a body. */
using Coordinates = dealii::Vector<double>;

Coordinates coordinates_of(const std::vector<PlateMotion> &motions, const double size) {
  Coordinates x(3 * motions.size());
  for (std::size_t p = 0; p < motions.size(); ++p) {
    x[3 * p] = motions[p].travel;
    x[3 * p + 1] = motions[p].drift;
    x[3 * p + 2] = size * motions[p].rotation;
  }
  return x;
}

/** Returns a basis of the same span: first all translations that lie in it, then what turns the
 * body. */
std::vector<RigidMotion> translations_first(std::vector<RigidMotion> motions) {
  const auto turning =
    std::max_element(motions.begin(), motions.end(), [](const auto &a, const auto &b) {
      return std::abs(a.rotation) < std::abs(b.rotation);
    });
  if (turning == motions.end() || turning->is_translation())
    return motions;
  std::iter_swap(turning, motions.end() - 1);
  const RigidMotion &last = motions.back();
  for (std::size_t i = 0; i + 1 < motions.size(); ++i)
    motions[i] = combine({motions[i], last}, {1., -motions[i].rotation / last.rotation});
  return motions;
}

/** Returns the scene with contact sides that can neither open nor close, with friction nor slide.
 */
Scene<2> with_sliding_contact(Scene<2> scene) {
  for (BoundaryCondition<2> &condition : scene.boundary)
    if (condition.role == Role::contact)
      condition.role = scene.friction == Friction::none ? Role::roller : Role::clamped;
  return scene;
}

/** Adds the direction of @p x to an orthonormal basis unless it lies in its span. @return whether
 * it was added. */
bool extend(std::vector<Coordinates> &basis, Coordinates x) {
  constexpr double negligible = 1e-6;
  // Twice, because of rounding.
  for (unsigned int pass = 0; pass < 2; ++pass)
    for (const Coordinates &e : basis)
      x.add(-(e * x), e);
  const double norm = x.size() == 0 ? 0. : x.l2_norm();
  if (norm < negligible)
    return false;
  x /= norm;
  basis.push_back(x);
  return true;
}

/** Returns the motions of the plates when the body moves as a whole. */
std::vector<PlateMotion> follow(const RigidMotion &rigid, const std::vector<Plate> &plates) {
  std::vector<PlateMotion> motions;
  motions.reserve(plates.size());
  for (const Plate &plate : plates)
    motions.push_back({plate.is_pushed ? rigid.velocity(plate.centre) * plate.direction : 0.,
                       plate.drifts ? rigid.velocity(plate.centre) * plate.across() : 0.,
                       plate.turns ? rigid.rotation / rigid.size : 0.});
  return motions;
}

/** Returns the motions in which one plate moves in one way and all others rest. */
std::vector<FreeMotion> single_motions(const std::vector<Plate> &plates, const double size) {
  std::vector<FreeMotion> motions;
  for (std::size_t p = 0; p < plates.size(); ++p) {
    const auto add = [&](const PlateMotion &motion) {
      motions.push_back({std::vector<PlateMotion>(plates.size()), {}});
      motions.back().plates[p] = motion;
    };
    if (plates[p].is_pushed)
      add({1., 0., 0.});
    if (plates[p].drifts)
      add({0., 1., 0.});
    if (plates[p].turns)
      add({0., 0., 1. / size});
  }
  return motions;
}
} // namespace

double FreeMotion::work_of_plates(const std::vector<Plate> &plates_of_scene) const {
  double work = 0.;
  for (std::size_t p = 0; p < plates.size(); ++p)
    work += plates_of_scene[p].work(plates[p]);
  return work;
}

FreeMotionBasis free_motions(const Scene<2> &scene) {
  FreeMotionBasis motions;
  std::vector<Coordinates> rigid_motions, plate_motions;
  const double size = scene.geometry.diameter();
  const auto add = [&](const RigidMotion &rigid, std::vector<FreeMotion> &kind) {
    const Tensor<1, 2> &t = rigid.translation;
    if (!extend(rigid_motions, Coordinates({t[0], t[1], rigid.rotation})))
      return;
    kind.push_back({follow(rigid, scene.plates), rigid});
    extend(plate_motions, coordinates_of(kind.back().plates, size));
  };
  for (const RigidMotion &rigid : free_rigid_motions(with_sliding_contact(scene), Plates::released))
    add(rigid, motions.unseen);
  // Pure translations are exact on all meshes, and their balance is that of forces.
  for (const RigidMotion &rigid : translations_first(free_rigid_motions(scene, Plates::released)))
    add(rigid, motions.seen);
  for (const FreeMotion &single : single_motions(scene.plates, size))
    if (extend(plate_motions, coordinates_of(single.plates, size)))
      motions.seen.push_back(single);
  return motions;
}

std::vector<PlateMotion> combine_plates(const std::vector<FreeMotion> &motions,
                                        const std::vector<double> &q, const std::size_t n_plates) {
  std::vector<PlateMotion> sum(n_plates);
  for (std::size_t j = 0; j < motions.size(); ++j)
    for (std::size_t p = 0; p < n_plates; ++p) {
      sum[p].travel += q[j] * motions[j].plates[p].travel;
      sum[p].drift += q[j] * motions[j].plates[p].drift;
      sum[p].rotation += q[j] * motions[j].plates[p].rotation;
    }
  return sum;
}
} // namespace Signorini
