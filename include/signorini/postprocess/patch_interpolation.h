// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/fe/fe_values.h>

#include <array>

namespace Signorini
{
/** Values and gradients of a vector field at the quadrature points of a cell. */
template <int dim>
struct FieldValues
{
  std::vector<dealii::Tensor<1, dim>> values;
  std::vector<dealii::Tensor<2, dim>> gradients;
};

/**
 * pi^{2h}: the function of degree two per direction on each cell of T^{2h} that takes the 3^dim
 * nodal values of its children. Evaluated cell by cell of T^h, without unknowns of its own.
 *
 * Needs Mesh::has_parents().
 */
template <int dim>
class PatchInterpolation
{
public:
  using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /** @param usual_rule the rule of most cells; its shape functions are computed once. */
  explicit PatchInterpolation(
    const DisplacementSpace<dim> &space,
    const dealii::Quadrature<dim> &usual_rule = dealii::Quadrature<dim>());

  /**
   * pi^{2h} of the nodal values @p U at the points of @p fe_values, which is at @p cell and knows
   * its inverse Jacobians.
   */
  const FieldValues<dim> &evaluate(const NodalVector &U,
                                   const CellIterator &cell,
                                   const dealii::FEValues<dim> &fe_values);

private:
  static constexpr unsigned int n_nodes = dealii::Utilities::pow(3, dim);

  /** Shape functions of the parent at the quadrature points of each child. */
  struct ShapeTable
  {
    std::vector<std::array<double, n_nodes>> values;
    /** With respect to the reference coordinates of the child. */
    std::vector<std::array<dealii::Tensor<1, dim>, n_nodes>> gradients;
  };

  ShapeTable make_table(const std::vector<dealii::Point<dim>> &points, unsigned int child) const;
  const ShapeTable &table(const dealii::Quadrature<dim> &quadrature, unsigned int child);
  void gather(const NodalVector &U, const CellIterator &cell);

  const DisplacementSpace<dim> &space_;
  dealii::TensorProductPolynomials<dim> polynomials_;
  std::vector<dealii::Point<dim>> usual_points_;
  std::array<ShapeTable, dealii::GeometryInfo<dim>::max_children_per_cell> tables_;
  ShapeTable cut_table_;
  std::array<dealii::Tensor<1, dim>, n_nodes> nodal_values_;
  FieldValues<dim> result_;
};
} // namespace Signorini
