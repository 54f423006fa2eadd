// SPDX-License-Identifier: LGPL-2.1-or-later
// The norm of V^h as a matrix.

#include <signorini/elasticity/matrix_scatter.h>
#include <signorini/norms/h1_gram_matrix.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace Signorini
{
namespace
{
/**
 * grad phi_i . grad phi_j on a cell is a polynomial divided by the determinant of the cell's map. A
 * determinant that falls linearly by the factor @p r along an edge vanishes outside of it, where
 * the ellipse around the edge on which Gauss' rule with n points converges like rho^{-2n} has
 * rho = (sqrt(r) + 1)/(sqrt(r) - 1).
 *
 * @return n with rho^{-2n} below 1e-10, and as many points more for the polynomial as the element's
 * degree says; from degree + 2, which is enough for r = 1, to 39 + degree.
 */
unsigned int points_for_ratio(const double r, const unsigned int degree)
{
  constexpr double most = 39.;
  const double root = std::sqrt(std::max(r, 1.));
  const double logarithm = std::log((root + 1.) / (root - 1.));
  const double n = std::min(most, std::ceil(0.5 * std::log(1e10) / logarithm));
  return degree + std::max(2U, static_cast<unsigned int>(n));
}

/** Shape functions at as many Gauss points as the shape of a cell asks for. */
template <int dim>
class ValuesByShape
{
public:
  explicit ValuesByShape(const DisplacementSpace<dim> &space)
    : shape_(space.mesh().mapping(),
             no_functions_,
             dealii::QIterated<dim>(dealii::QTrapezoid<1>(), 2),
             dealii::update_jacobians)
  {
  }

  const dealii::FEValues<dim> &
  reinit(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell)
  {
    const dealii::FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = points_for_ratio(ratio_of_determinants(cell), element.degree);
    std::unique_ptr<dealii::FEValues<dim>> &values = values_[{element.degree, n}];
    if (values == nullptr)
      values = std::make_unique<dealii::FEValues<dim>>(
        shape_.get_mapping(),
        element,
        dealii::QGauss<dim>(n),
        dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    values->reinit(cell);
    return *values;
  }

private:
  /** The largest over the smallest, at the vertices and the middles between them. */
  double
  ratio_of_determinants(const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
  {
    shape_.reinit(cell);
    double smallest = shape_.jacobian(0).determinant(), largest = smallest;
    for (const unsigned int q : shape_.quadrature_point_indices())
    {
      smallest = std::min(smallest, shape_.jacobian(q).determinant());
      largest = std::max(largest, shape_.jacobian(q).determinant());
    }
    return largest / smallest;
  }

  dealii::FE_Nothing<dim> no_functions_;
  dealii::FEValues<dim> shape_;
  /** By the degree and the number of points per direction. */
  std::map<std::pair<unsigned int, unsigned int>, std::unique_ptr<dealii::FEValues<dim>>> values_;
};
} // namespace

template <int dim>
dealii::TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space)
{
  dealii::TrilinosWrappers::SparseMatrix A_1 = make_matrix(space);
  ValuesByShape<dim> values_by_shape(space);
  dealii::FullMatrix<double> cell_matrix;
  std::vector<dealii::types::global_dof_index> indices;
  MatrixScatter<dim> scatter(space, A_1);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const dealii::FEValues<dim> &values = values_by_shape.reinit(cell);
    const dealii::FiniteElement<dim> &element = cell->get_fe();
    const unsigned int n = element.n_dofs_per_cell();
    cell_matrix.reinit(n, n);
    indices.resize(n);
    // The same block for every component.
    for (unsigned int v = 0; v < n / dim; ++v)
      for (unsigned int w = 0; w <= v; ++w)
      {
        const unsigned int i = element.component_to_system_index(0, v);
        const unsigned int j = element.component_to_system_index(0, w);
        double product = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          product += (values.shape_value(i, q) * values.shape_value(j, q) +
                      values.shape_grad(i, q) * values.shape_grad(j, q)) *
                     values.JxW(q);
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i_d = element.component_to_system_index(d, v);
          const unsigned int j_d = element.component_to_system_index(d, w);
          cell_matrix(i_d, j_d) = cell_matrix(j_d, i_d) = product;
        }
      }
    cell->get_dof_indices(indices);
    scatter.add(cell_matrix, indices);
  }
  A_1.compress(dealii::VectorOperation::add);
  return A_1;
}

template dealii::TrilinosWrappers::SparseMatrix
assemble_h1_gram_matrix(const DisplacementSpace<2> &);
template dealii::TrilinosWrappers::SparseMatrix
assemble_h1_gram_matrix(const DisplacementSpace<3> &);
} // namespace Signorini
