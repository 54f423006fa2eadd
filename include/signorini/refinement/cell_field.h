// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace Signorini
{
/** Lagrange's polynomials at the nodes of an element's edge, at points between 0 and 1. */
struct LineTable
{
  /** points × nodes. */
  dealii::FullMatrix<double> values, derivatives;
};

/** @param degree of the element: FE_Q, whose nodes are those of Gauss and Lobatto. */
LineTable make_line_table(unsigned int degree, const std::vector<double> &points);

/** The nodes of an edge, ascending from 0 to 1. */
const std::vector<double> &nodes_of_edge(unsigned int degree);

/** u_h on one cell as products of polynomials in the two reference coordinates. */
class CellField
{
public:
  CellField(const dealii::DoFHandler<2>::active_cell_iterator &cell, const NodalVector &U);

  unsigned int degree() const
  {
    return degree_;
  }
  /** Component c at node (i, j): node i along the first coordinate, j along the second. */
  double operator()(const unsigned int c, const unsigned int i, const unsigned int j) const
  {
    return values_[c](j, i);
  }
  /** The derivatives by the reference coordinates of the cell at the points (x_i, y_j), point i +
   * n_x j; [c][d] is that of component c by coordinate d. */
  std::vector<dealii::Tensor<2, 2>> gradients(const LineTable &x, const LineTable &y) const;

private:
  unsigned int degree_;
  /** By component: second times first coordinate. */
  std::array<dealii::FullMatrix<double>, 2> values_;
};
} // namespace Signorini
