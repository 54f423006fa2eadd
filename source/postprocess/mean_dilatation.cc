// SPDX-License-Identifier: LGPL-2.1-or-later
// tr eps(u_h) without what alternates from cell to cell.

#include <signorini/postprocess/mean_dilatation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace Signorini
{
template <int dim>
std::vector<double> mean_dilatations(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  std::vector<double> means;
  const dealii::QGauss<dim> gauss(2);
  dealii::FEValues<dim> values(space.mesh().mapping(),
                               space.element(),
                               gauss,
                               dealii::update_gradients | dealii::update_JxW_values);
  std::vector<double> divergences(gauss.size());
  using CellId = std::pair<int, int>;
  const auto group = [&](const auto &cell) {
    return space.mesh().has_parents() ? CellId(cell->level() - 1, cell->parent_index())
                                      : CellId(cell->level(), cell->index());
  };
  std::map<CellId, std::pair<double, double>> integral_and_volume;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    values.reinit(cell);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_divergences(U, divergences);
    auto &sums = integral_and_volume[group(cell)];
    for (const unsigned int q : values.quadrature_point_indices())
    {
      sums.first += divergences[q] * values.JxW(q);
      sums.second += values.JxW(q);
    }
  }
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    const auto &sums = integral_and_volume[group(cell)];
    means.push_back(sums.first / sums.second);
  }
  return means;
}

template std::vector<double> mean_dilatations(const DisplacementSpace<2> &, const NodalVector &);
template std::vector<double> mean_dilatations(const DisplacementSpace<3> &, const NodalVector &);
} // namespace Signorini
