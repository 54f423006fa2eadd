// SPDX-License-Identifier: LGPL-2.1-or-later
// u_h on a cell, evaluated by sum factorisation.

#include <signorini/refinement/cell_field.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

#include <map>

namespace Signorini
{
namespace
{
/** Where FE_Q has the node (i, j) of the grid, for i + (p + 1) j. */
const std::vector<unsigned int> &numbers_on_grid(const unsigned int degree)
{
  thread_local std::map<unsigned int, std::vector<unsigned int>> known;
  std::vector<unsigned int> &numbers = known[degree];
  if (numbers.empty())
    numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<2>(degree);
  return numbers;
}
} // namespace

const std::vector<double> &nodes_of_edge(const unsigned int degree)
{
  thread_local std::map<unsigned int, std::vector<double>> known;
  std::vector<double> &nodes = known[degree];
  if (nodes.empty())
  {
    const dealii::QGaussLobatto<1> rule(degree + 1);
    for (const dealii::Point<1> &x : rule.get_points())
      nodes.push_back(x[0]);
  }
  return nodes;
}

LineTable make_line_table(const unsigned int degree, const std::vector<double> &points)
{
  const std::vector<double> &nodes = nodes_of_edge(degree);
  const unsigned int n = nodes.size();
  LineTable table = {{static_cast<unsigned int>(points.size()), n},
                     {static_cast<unsigned int>(points.size()), n}};
  for (unsigned int q = 0; q < points.size(); ++q)
    for (unsigned int i = 0; i < n; ++i)
    {
      double value = 1., derivative = 0.;
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
        {
          const double scale = 1. / (nodes[i] - nodes[j]);
          derivative = derivative * (points[q] - nodes[j]) * scale + value * scale;
          value *= (points[q] - nodes[j]) * scale;
        }
      table.values(q, i) = value;
      table.derivatives(q, i) = derivative;
    }
  return table;
}

CellField::CellField(const dealii::DoFHandler<2>::active_cell_iterator &cell, const NodalVector &U)
  : degree_(cell->get_fe().degree)
{
  const dealii::FiniteElement<2> &element = cell->get_fe();
  dealii::Vector<double> nodal(element.n_dofs_per_cell());
  cell->get_dof_values(U, nodal);
  const std::vector<unsigned int> &numbers = numbers_on_grid(degree_);
  const unsigned int n = degree_ + 1;
  for (unsigned int c = 0; c < 2; ++c)
  {
    values_[c].reinit(n, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        values_[c](j, i) = nodal[element.component_to_system_index(c, numbers[i + n * j])];
  }
}

std::vector<dealii::Tensor<2, 2>> CellField::gradients(const LineTable &x, const LineTable &y) const
{
  const unsigned int n_x = x.values.m(), n_y = y.values.m(), n = degree_ + 1;
  std::vector<dealii::Tensor<2, 2>> gradients(n_x * n_y);
  dealii::FullMatrix<double> at_x(n, n_x), derivative_at_x(n, n_x), result(n_y, n_x);
  for (unsigned int c = 0; c < 2; ++c)
  {
    values_[c].mTmult(at_x, x.values);
    values_[c].mTmult(derivative_at_x, x.derivatives);
    for (unsigned int d = 0; d < 2; ++d)
    {
      (d == 0 ? y.values : y.derivatives).mmult(result, d == 0 ? derivative_at_x : at_x);
      for (unsigned int j = 0; j < n_y; ++j)
        for (unsigned int i = 0; i < n_x; ++i)
          gradients[i + n_x * j][c][d] = result(j, i);
    }
  }
  return gradients;
}
} // namespace Signorini
