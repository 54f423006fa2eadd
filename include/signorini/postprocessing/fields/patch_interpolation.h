// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/cell_field.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <vector>

namespace Signorini {
/**
 * The interpolation of nodal values by one polynomial on all descendants of a cell. Without
 * generations it is u_h. With one and elements of degree one it is π^{2h} of (30): the function of
 * degree two per direction on each cell of T^{2h} that takes the 3^dim nodal values of its
 * children. With k generations and elements of degree p it has the degree 2^k p on the cells of the
 * k-th mesh before T^h and takes the (2^k p + 1)^dim nodal values of their descendants. It is
 * evaluated cell by cell of T^h, without unknowns of its own.
 *
 * Needs Mesh::n_nested_ancestors() ≥ k. Copies share nothing: every thread has its own.
 */
template <int dim>
class PatchInterpolation {
public:
  using CellIterator = typename DoFHandler<dim>::active_cell_iterator;
  using AncestorIterator = typename DoFHandler<dim>::cell_iterator;

  /**
   * Tabulates the shape functions.
   * @param usual_rule the rule of most cells; its shape functions are computed once.
   */
  explicit PatchInterpolation(const DisplacementSpace<dim> &space,
                              const Quadrature<dim> &usual_rule = Quadrature<dim>(),
                              unsigned int n_generations = 1);

  /** Returns the interpolation of the nodal values @p U at the points of @p fe_values, which is at
   * @p cell and provides its inverse Jacobians. */
  const FieldValues<dim> &evaluate(const Displacement &U, const CellIterator &cell,
                                   const FEValues<dim> &fe_values);
  /** Returns the values alone, at the points of the usual rule. */
  const std::vector<Tensor<1, dim>> &values(const Displacement &U, const CellIterator &cell);

private:
  /** The place of a cell among the descendants of its ancestor: 0..2^k-1 per direction. */
  using Place = std::array<unsigned int, dim>;

  /** The shape functions of the ancestor at the quadrature points of a descendant. */
  struct ShapeTable {
    /** The values point by point, n_nodes each. */
    std::vector<double> values;
    /** The gradients with respect to the reference coordinates of the descendant. */
    std::vector<Tensor<1, dim>> gradients;
  };

  ShapeTable make_table(const std::vector<Point<dim>> &points, const Place &place) const;
  /** Fills result_ with values, and gradients in reference coordinates. */
  void interpolate(const Displacement &U, const CellIterator &cell,
                   const std::vector<Point<dim>> &points);
  /**
   * Fills nodal_values_ for the ancestor of a cell.
   * @return the place of the cell.
   */
  Place collect_values(const Displacement &U, const CellIterator &cell);
  /** Fills nodal_dofs_ from the descendants of an ancestor. */
  void find_nodes(const AncestorIterator &cell, const Place &place);

  const DisplacementSpace<dim> &space_;
  unsigned int n_generations_;
  /** The number of cells per direction of the ancestor, 2^k. */
  unsigned int n_cells_;
  /** The degree per direction, 2^k p. */
  unsigned int degree_;
  /** The place of every node of the element among its (p + 1)^dim nodes, in the element's order. */
  std::vector<Place> nodes_of_cell_;
  TensorProductPolynomials<dim> polynomials_;
  std::vector<Point<dim>> usual_points_;
  /** The tables of all places, lexicographically; empty where lines_ take their place. */
  std::vector<ShapeTable> tables_;
  /** The polynomials along the cells of a direction, in 3-D if the usual rule is a tensor product.
   */
  std::vector<LineTable> lines_;
  ShapeTable cut_table_;
  /** The ancestor to which nodal_dofs_ belong. */
  AncestorIterator ancestor_;
  std::vector<std::array<types::global_dof_index, dim>> nodal_dofs_;
  std::vector<Tensor<1, dim>> nodal_values_;
  FieldValues<dim> result_;
};

/** Returns pi^{2h} u_h of (30), where T^{2h} exists, else u_h, at the nodes of the next level,
 * which is refined everywhere: a start for V-cycles. Elements of degree one. Empty if @p fine is
 * not that level. */
template <int dim>
Displacement carry_over(const DisplacementSpace<dim> &coarse, const Displacement &U,
                        const DisplacementSpace<dim> &fine);
} // namespace Signorini
