// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/cell_field.h>

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
 * evaluated cell by cell of T^h, without unknowns of its own; the nodal values are read once for
 * all cells of an ancestor that follow one another. Where ancestors are bent (Mesh), the map of an
 * ancestor interpolates the vertices of its descendants in the same way.
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
   * @param U the nodal values; they must outlive the object, and not change.
   * @param usual_rule the rule of most cells; its shape functions are computed once.
   */
  PatchInterpolation(const DisplacementSpace<dim> &space, const Displacement &U,
                     const Quadrature<dim> &usual_rule = Quadrature<dim>(),
                     unsigned int n_generations = 1);

  /** Returns the interpolation at the points of @p fe_values, which is at @p cell and provides its
   * inverse Jacobians. */
  const FieldValues<dim> &evaluate(const CellIterator &cell, const FEValues<dim> &fe_values);
  /** Returns values, and gradients in the coordinates of the reference cell, at points of it; where
   * ancestors are bent those that the map of the cell turns into gradients in the body. */
  const FieldValues<dim> &on_reference_cell(const CellIterator &cell,
                                            const std::vector<Point<dim>> &points);
  /** Returns them at the points of the usual rule. */
  const FieldValues<dim> &on_reference_cell(const CellIterator &cell) {
    return on_reference_cell(cell, usual_points_);
  }
  /** Returns the values at the nodes of the ancestor of a cell, lexicographically. */
  const std::vector<Tensor<1, dim>> &nodal_values(const CellIterator &cell) {
    collect_values(cell);
    return nodal_values_;
  }

private:
  /** The position of a cell among the descendants of its ancestor: 0..2^k-1 per direction. */
  using GridPosition = std::array<unsigned int, dim>;

  /** A shape function of the ancestor at a quadrature point of a descendant; the gradient is that
   * in the reference coordinates of the descendant. */
  struct Shape {
    unsigned int node;
    double value;
    Tensor<1, dim> gradient;
  };
  /** The shape functions by point, without those that vanish: at a node nearly all do. */
  using ShapeTable = std::vector<std::vector<Shape>>;

  /** Evaluates products of nodal values with the shape functions at points of a cell. */
  void evaluate(const std::vector<Tensor<1, dim>> &nodal_values, const GridPosition &position,
                const std::vector<Point<dim>> &points, FieldValues<dim> &result);
  ShapeTable make_table(const std::vector<Point<dim>> &points, const GridPosition &position) const;
  /**
   * Fills nodal_values_ for the ancestor of a cell.
   * @return the position of the cell.
   */
  GridPosition collect_values(const CellIterator &cell);
  /** Turns derivatives by the map of the ancestor into those by the map of a cell. */
  void follow_ancestor(const CellIterator &cell, const std::vector<Point<dim>> &points);
  /** Fills nodal_values_ from the descendants of an ancestor. */
  void read_values(const AncestorIterator &cell, const GridPosition &position);

  const DisplacementSpace<dim> &space_;
  const Displacement &U_;
  unsigned int n_generations_;
  /** The number of cells per direction of the ancestor, 2^k. */
  unsigned int n_cells_;
  /** The degree per direction, 2^k p. */
  unsigned int degree_;
  /** The component of every degree of freedom of an element, and the number that its node has in
   * the ancestor of the first descendant. */
  std::vector<std::pair<unsigned int, unsigned int>> nodes_of_cell_;
  TensorProductPolynomials<dim> polynomials_;
  std::vector<Point<dim>> usual_points_;
  /** The tables of all positions, lexicographically; empty where lines_ replace them. */
  std::vector<ShapeTable> tables_;
  /** The polynomials along the cells of a direction, in 3-D if the usual rule is a tensor product.
   */
  std::vector<LineTable> lines_;
  ShapeTable cut_table_;
  /** The ancestor to which nodal_values_ belong. */
  AncestorIterator ancestor_;
  std::vector<Tensor<1, dim>> nodal_values_;
  /** The vertices of the descendants in the same order, where ancestors are bent, else empty. */
  std::vector<Tensor<1, dim>> vertices_;
  dealii::Vector<double> on_cell_;
  FieldValues<dim> result_, map_;
};
} // namespace Signorini
