// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/postprocessing/fields/patch_interpolation.h>

#include <cmath>
#include <memory>

#include "one_level.h"

namespace Signorini
{
/** |||u - u_h||| and, where cells have parents, |||u - pi^{2h} u_h|||. */
struct Errors
{
  double strain_of_u_h = 0., interpolated_part = 0.;
};

/** With six Gauss points per direction on cells that are cut at kinks. */
inline Errors energy_errors(const OneLevel &level, const Displacement &U)
{
  const DisplacementSpace<2> &space = level.space();
  const Scene<2> &scene = level.scene;
  CellValues<2> cell_values(space.mesh().mapping(),
                            space,
                            scene.kinks,
                            6,
                            dealii::update_gradients | dealii::update_quadrature_points |
                              dealii::update_JxW_values | dealii::update_inverse_jacobians);
  std::vector<std::unique_ptr<PatchInterpolation<2>>> fields;
  for (unsigned int generations = 0; generations < (space.mesh().has_parents() ? 2 : 1);
       ++generations)
    fields.push_back(
      std::make_unique<PatchInterpolation<2>>(space, dealii::QGauss<2>(6), generations));
  std::vector<std::vector<dealii::Tensor<1, 2>>> exact;
  std::array<double, 2> squares{};
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const dealii::FEValues<2> &values = cell_values.reinit(cell);
    exact.assign(values.n_quadrature_points, std::vector<dealii::Tensor<1, 2>>(2));
    scene.exact_displacement->vector_gradient_list(values.get_quadrature_points(), exact);
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      const FieldValues<2> &found = fields[i]->evaluate(U, cell, values);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        dealii::Tensor<2, 2> gradient;
        gradient[0] = exact[q][0];
        gradient[1] = exact[q][1];
        const dealii::SymmetricTensor<2, 2> e = dealii::symmetrize(gradient - found.gradients[q]);
        squares[i] += (scene.material->hooke(values.quadrature_point(q)) * e) * e * values.JxW(q);
      }
    }
  }
  return {std::sqrt(squares[0]), std::sqrt(squares[1])};
}
} // namespace Signorini
