// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of A, found from the boundary conditions alone: three unknowns, no finite elements.

#include <signorini/scene/rigid_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
namespace
{
/** Row of the motion (t1, t2, omega L) in the direction n at x, relative to centre and size L. */
std::array<double, 3> normal_motion(const dealii::Tensor<1, 2> &relative,
                                    const dealii::Tensor<1, 2> &n,
                                    const double size)
{
  return {{n[0], n[1], (-relative[1] * n[0] + relative[0] * n[1]) / size}};
}

/** Sum of r r^T over conditions r.motion = 0. */
class Conditions
{
public:
  explicit Conditions(const Geometry<2> &geometry)
    : centre_(geometry.lower + 0.5 * (geometry.upper - geometry.lower))
    , size_(geometry.diameter())
    , matrix_(3, 3)
  {
  }

  /** v(x).n = 0. */
  void forbid_velocity(const dealii::Point<2> &x,
                       const dealii::Tensor<1, 2> &n,
                       const double weight = 1.)
  {
    add(normal_motion(x - centre_, n, size_), weight);
  }
  void forbid_rotation()
  {
    add({{0., 0., 1.}}, 1.);
  }
  /** All motions that obey. */
  std::vector<RigidMotion> solutions()
  {
    dealii::Vector<double> eigenvalues(3);
    dealii::FullMatrix<double> vectors(3, 3);
    matrix_.compute_eigenvalues_symmetric(-1., 1e6, 1e-15, eigenvalues, vectors);
    std::vector<RigidMotion> motions;
    for (unsigned int k = 0; k < 3; ++k)
      // A clamped side of the length l holds a rotation with (l / size)² at least, see
      // largest_slenderness; rounding leaves 1e-15.
      if (eigenvalues[k] < 1e-14)
        motions.push_back(
          {dealii::Tensor<1, 2>({vectors(0, k), vectors(1, k)}), vectors(2, k), centre_, size_});
    return motions;
  }

private:
  void add(const std::array<double, 3> &row, const double weight)
  {
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        matrix_(i, j) += weight * row[i] * row[j];
  }

  dealii::Point<2> centre_;
  double size_;
  dealii::LAPACKFullMatrix<double> matrix_;
};

/** What a side of this role forbids; two points tell all about a segment, three about a circle. */
void hold_side(const Side<2> &side, const Role role, Conditions &conditions)
{
  const double weight = 1. / side.n_pieces();
  for (unsigned int k = 0; k < side.n_pieces(); ++k)
    for (const double share : {0., 1. / 3., 2. / 3., 1.})
    {
      const Curve &piece = side.piece(k);
      const double s = share * piece.length();
      const dealii::Point<2> x = piece.point(s);
      if (role == Role::roller)
        conditions.forbid_velocity(x, piece.normal(s), weight);
      if (role == Role::clamped || role == Role::displacement)
        for (unsigned int d = 0; d < 2; ++d)
          conditions.forbid_velocity(x, dealii::Point<2>::unit_vector(d), weight);
    }
}

/** What a plate forbids to a body that moves as a whole. */
void hold_plate(const Plate &plate, Conditions &conditions)
{
  const dealii::Tensor<1, 2> across({-plate.direction[1], plate.direction[0]});
  conditions.forbid_velocity(plate.centre, across);
  if (!plate.is_pushed)
    conditions.forbid_velocity(plate.centre, plate.direction);
  if (!plate.turns)
    conditions.forbid_rotation();
}

/** Plain numbers for messages: no -0, no 1e-17. */
double rounded(const double value)
{
  return std::round(value * 1e4) / 1e4 + 0.;
}

std::string point_text(const double x, const double y)
{
  std::ostringstream text;
  text << "(" << rounded(x) << ", " << rounded(y) << ")";
  return text.str();
}

/** The point that does not move. */
std::string pole(const RigidMotion &motion)
{
  const double omega = motion.rotation / motion.size;
  return point_text(motion.centre[0] - motion.translation[1] / omega,
                    motion.centre[1] + motion.translation[0] / omega);
}
} // namespace

dealii::Tensor<1, 2> RigidMotion::velocity(const dealii::Point<2> &x) const
{
  const dealii::Tensor<1, 2> arm = (x - centre) / size;
  return translation + rotation * dealii::Tensor<1, 2>({-arm[1], arm[0]});
}

bool RigidMotion::is_translation() const
{
  return std::abs(rotation) < 1e-6 * translation.norm();
}

std::string RigidMotion::name() const
{
  if (!is_translation())
    return "the rotation about " + pole(*this);
  const dealii::Tensor<1, 2> t = translation / translation.norm();
  const double sign = (std::abs(t[0]) > 1e-6 ? t[0] : t[1]) < 0 ? -1. : 1.;
  return "the translation along " + point_text(sign * t[0], sign * t[1]);
}

std::string RigidMotion::direction() const
{
  if (!is_translation())
    return std::string(rotation > 0. ? "counter-clockwise" : "clockwise") + " about " + pole(*this);
  const double length = translation.norm();
  return "along " + point_text(translation[0] / length, translation[1] / length);
}

RigidMotion combine(const std::vector<RigidMotion> &motions, const std::vector<double> &weights)
{
  RigidMotion sum = motions.front();
  sum.translation = 0.;
  sum.rotation = 0.;
  for (std::size_t i = 0; i < motions.size(); ++i)
  {
    sum.translation += weights[i] * motions[i].translation;
    sum.rotation += weights[i] * motions[i].rotation;
  }
  return sum;
}

std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene, const Plates plates)
{
  Conditions conditions(scene.geometry);
  std::vector<bool> is_released(scene.boundary.size(), false);
  if (plates == Plates::released)
    for (const Plate &plate : scene.plates)
    {
      is_released[plate.side] = true;
      hold_plate(plate, conditions);
    }
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    if (!is_released[i])
      hold_side(scene.geometry.sides[i], scene.boundary[i].role, conditions);
  return conditions.solutions();
}
} // namespace Signorini
