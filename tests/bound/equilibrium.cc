// SPDX-License-Identifier: LGPL-2.1-or-later
#include <signorini/bound/equilibrated_stress.h>
#include <signorini/elasticity/integration.h>

#include <chrono>
#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

double energy_error(const OneLevel &level, const NodalVector &U)
{
  const auto &space = level.space();
  CellValues<2> values(space.mesh().mapping(),
                       space.element(),
                       level.scene.kinks,
                       6,
                       dealii::update_gradients | dealii::update_quadrature_points |
                         dealii::update_JxW_values);
  double sum = 0.;
  const dealii::FEValuesExtractors::Vector u(0);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const auto &v = values.reinit(cell);
    std::vector<dealii::SymmetricTensor<2, 2>> e(v.n_quadrature_points);
    v[u].get_function_symmetric_gradients(U, e);
    for (unsigned q = 0; q < v.n_quadrature_points; ++q)
    {
      dealii::Tensor<2, 2> g;
      for (unsigned c = 0; c < 2; ++c)
      {
        const auto gr = level.scene.exact_displacement->gradient(v.quadrature_point(q), c);
        for (unsigned d = 0; d < 2; ++d)
          g[c][d] = gr[d];
      }
      dealii::SymmetricTensor<2, 2> d = e[q] - dealii::symmetrize(g);
      sum += d * (level.scene.material->hooke(v.quadrature_point(q)) * d) * v.JxW(q);
    }
  }
  return std::sqrt(sum);
}

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string name : {"C2", "C1", "A1", "V1", "O1"})
    for (unsigned l = 3; l <= 6; ++l)
    {
      OneLevel level(entry("Scene", "Name", name), l);
      const auto s = level.solve();
      const StressData data{
        level.space(), level.scene, level.multipliers(), s.U, s.P, level.discretization.n_points};
      const double err = energy_error(level, s.U);
      std::cout << name << " " << l << " error " << err;
      for (unsigned steps : {0u, 1u, 3u, 20u})
      {
        const EquilibratedStress stress(data, {steps, 0.01});
        const auto b = stress.bound();
        std::cout << "  " << b.steps << ": " << std::sqrt(b.square) / err;
        if (steps == 20)
          std::cout << " osc " << std::sqrt(b.oscillation_square) / err << " alg " << b.algebra;
      }
      std::cout << std::endl;
    }
}
