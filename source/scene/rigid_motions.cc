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

/** Sum of r r^T over all conditions r.motion = 0 that the sides impose. */
dealii::LAPACKFullMatrix<double> normal_equations(const Scene<2> &scene,
                                                  const dealii::Point<2> &centre,
                                                  const double size)
{
  dealii::LAPACKFullMatrix<double> matrix(3, 3);
  const auto impose =
    [&](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n, const double weight) {
      const auto row = normal_motion(x - centre, n, size);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          matrix(i, j) += weight * row[i] * row[j];
    };
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const Side<2> &side = scene.geometry.sides[i];
    const Role role = scene.boundary[i].role;
    // Two points tell all about a segment, three about a circle.
    for (unsigned int k = 0; k < side.n_pieces(); ++k)
      for (const double share : {0., 1. / 3., 2. / 3., 1.})
      {
        const Curve &piece = side.piece(k);
        const double s = share * piece.length(), weight = 1. / side.n_pieces();
        const dealii::Point<2> x = piece.point(s);
        if (role == Role::roller)
          impose(x, piece.normal(s), weight);
        if (role == Role::clamped || role == Role::displacement)
          for (unsigned int d = 0; d < 2; ++d)
            impose(x, dealii::Point<2>::unit_vector(d), weight);
      }
  }
  return matrix;
}

/** Plain numbers for messages: no -0, no 1e-17. */
double rounded(const double value)
{
  return std::round(value * 1e4) / 1e4 + 0.;
}

RigidMotion name_motion(const dealii::Tensor<1, 2> &t,
                        const double rotation,
                        const dealii::Point<2> &centre,
                        const double size)
{
  std::ostringstream name;
  const double omega = rotation / size;
  if (std::abs(rotation) < 1e-6)
  {
    const double sign = (std::abs(t[0]) > 1e-6 ? t[0] : t[1]) < 0 ? -1. : 1.;
    name << "the translation along (" << rounded(sign * t[0]) << ", " << rounded(sign * t[1])
         << ")";
  }
  else
    name << "the rotation about (" << rounded(centre[0] - t[1] / omega) << ", "
         << rounded(centre[1] + t[0] / omega) << ")";
  return {t, rotation, name.str()};
}
} // namespace

std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene)
{
  const dealii::Point<2> centre =
    scene.geometry.lower + 0.5 * (scene.geometry.upper - scene.geometry.lower);
  const double size = scene.geometry.diameter();
  auto matrix = normal_equations(scene, centre, size);
  dealii::Vector<double> eigenvalues(3);
  dealii::FullMatrix<double> vectors(3, 3);
  matrix.compute_eigenvalues_symmetric(-1., 1e6, 1e-15, eigenvalues, vectors);
  std::vector<RigidMotion> motions;
  for (unsigned int k = 0; k < 3; ++k)
    // A clamped side of the length l holds a rotation with (l / size)² at least, see
    // largest_slenderness; rounding leaves 1e-15.
    if (eigenvalues[k] < 1e-14)
      motions.push_back(name_motion(
        dealii::Tensor<1, 2>({vectors(0, k), vectors(1, k)}), vectors(2, k), centre, size));
  return motions;
}
} // namespace Signorini
