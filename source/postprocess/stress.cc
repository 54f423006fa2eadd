// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress in space, and what is read off it.

#include <signorini/postprocess/stress.h>

#include <cmath>

namespace Signorini
{
template <int dim>
SpatialStress stress_in_space(const Material<dim> &material,
                              const dealii::Point<dim> &x,
                              const dealii::SymmetricTensor<2, dim> &strain)
{
  const dealii::SymmetricTensor<2, dim> stress = material.hooke(x) * strain;
  SpatialStress in_space;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      in_space[i][j] = stress[i][j];
  if (dim == 2)
    in_space[2][2] = material.out_of_plane_stress(x, strain);
  return in_space;
}

double von_mises(const SpatialStress &stress)
{
  return std::sqrt(1.5) * deviator(stress).norm();
}

std::array<double, 3> principal_stresses(const SpatialStress &stress)
{
  // Jacobi's method keeps all digits where eigenvalues are equal.
  const auto pairs = dealii::eigenvectors(stress, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  return {pairs[0].first, pairs[1].first, pairs[2].first};
}

template SpatialStress stress_in_space(const Material<2> &,
                                       const dealii::Point<2> &,
                                       const dealii::SymmetricTensor<2, 2> &);
template SpatialStress stress_in_space(const Material<3> &,
                                       const dealii::Point<3> &,
                                       const dealii::SymmetricTensor<2, 3> &);
} // namespace Signorini
