// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress with three components per direction, and the quantities that follow from it.

#include <signorini/postprocessing/fields/stress.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Signorini {
template <int dim>
Stress3D StressIn3D<dim>::operator()(const Point<dim> &x, const Point<dim> &middle,
                                     const Strain<dim> &strain) {
  // Corners and sides belong to several cells, and to the material of each. A step inside chooses;
  // it is longer than rounding, and shorter than the details of a smooth law.
  constexpr double step = 1e-8;
  const Point<dim> inside = x + step * (middle - x);
  if (!is_known_)
    law_.in_body = material_.hooke(inside);
  is_known_ = material_.is_constant();
  if (dim == 2)
    law_.across = material_.across(inside);
  const SymmetricTensor<2, dim> stress = law_.stress(strain);
  Stress3D in_space;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      in_space[i][j] = stress[i][j];
  if (dim == 2)
    in_space[2][2] = law_.stress_across(strain);
  return in_space;
}

double von_mises(const Stress3D &stress) {
  return std::sqrt(1.5) * deviator(stress).norm();
}

std::array<double, 3> principal_stresses(const Stress3D &given) {
  // Jacobi's rotations keep all digits where eigenvalues are equal. LAPACK takes ten times as long,
  // which is half of the time of writing a VTU file, and deal.II's do not link with clang++.
  Stress3D stress = given;
  // An entry below rounding of the tensor changes no eigenvalue.
  const double rounding = 1e-17 * given.norm();
  for (unsigned int k = 0, n_small = 0; k < 30 && n_small < 3; ++k) {
    const unsigned int r = k % 3, p = (r + 1) % 3, q = (r + 2) % 3;
    const double a = stress[p][q], x = stress[r][p], y = stress[r][q];
    n_small = std::abs(a) <= rounding ? n_small + 1 : 0;
    if (n_small > 0)
      continue;
    const double theta = (stress[q][q] - stress[p][p]) / (2. * a),
                 t = std::copysign(1., theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.)),
                 c = 1. / std::sqrt(t * t + 1.), s = t * c;
    stress[p][p] -= t * a;
    stress[q][q] += t * a;
    stress[p][q] = 0.;
    stress[r][p] = c * x - s * y;
    stress[r][q] = s * x + c * y;
  }
  std::array<double, 3> values = {stress[0][0], stress[1][1], stress[2][2]};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

template class StressIn3D<2>;
template class StressIn3D<3>;
} // namespace Signorini
