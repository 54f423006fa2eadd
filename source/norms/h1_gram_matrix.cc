// SPDX-License-Identifier: LGPL-2.1-or-later
// The norm of V^h as a matrix.

#include <signorini/elasticity/matrix_scatter.h>
#include <signorini/norms/h1_gram_matrix.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Signorini
{
template <int dim>
dealii::TrilinosWrappers::SparseMatrix assemble_h1_gram_matrix(const DisplacementSpace<dim> &space)
{
  dealii::TrilinosWrappers::SparseMatrix A_1 = make_matrix(space);
  dealii::FEValues<dim> values(space.mesh().mapping(),
                               space.element(),
                               dealii::QGauss<dim>(space.element().degree + 2),
                               dealii::update_values | dealii::update_gradients |
                                 dealii::update_JxW_values);
  const dealii::FiniteElement<dim> &element = space.element();
  const unsigned int n = element.n_dofs_per_cell();
  dealii::FullMatrix<double> cell_matrix(n);
  std::vector<dealii::types::global_dof_index> indices(n);
  MatrixScatter<dim> scatter(space, A_1);
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
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
