// SPDX-License-Identifier: LGPL-2.1-or-later
// ‖pi^{2h} u_h - u_h‖_1, the distance that (24) and (31) make an estimate of the error.

#include <signorini/postprocess/error_estimate.h>
#include <signorini/postprocess/patch_interpolation.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Signorini
{
template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  // Products of functions of degree two per direction: three points are exact on parallelograms.
  dealii::FEValues<dim> values(space.mesh().mapping(),
                               space.element(),
                               dealii::QGauss<dim>(3),
                               dealii::update_values | dealii::update_gradients |
                                 dealii::update_inverse_jacobians | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector displacement(0);
  PatchInterpolation<dim> interpolation(space, values.get_quadrature());
  std::vector<dealii::Tensor<1, dim>> u(values.n_quadrature_points);
  std::vector<dealii::Tensor<2, dim>> du(values.n_quadrature_points);
  double squared_difference = 0.;
  double squared_norm = 0.;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      values[displacement].get_function_values(U, u);
      values[displacement].get_function_gradients(U, du);
      const FieldValues<dim> &recovered = interpolation.evaluate(U, cell, values);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const auto &v = recovered.values[q];
        const auto &dv = recovered.gradients[q];
        squared_difference +=
          ((v - u[q]).norm_square() + (dv - du[q]).norm_square()) * values.JxW(q);
        squared_norm += (v.norm_square() + dv.norm_square()) * values.JxW(q);
      }
    }
  const MPI_Comm communicator = space.mesh().communicator();
  const double difference =
    std::sqrt(dealii::Utilities::MPI::sum(squared_difference, communicator));
  const double norm = std::sqrt(dealii::Utilities::MPI::sum(squared_norm, communicator));
  return {difference, norm > 0. ? difference / norm : 0.};
}

template ErrorEstimate estimate_error(const DisplacementSpace<2> &, const NodalVector &);
} // namespace Signorini
