// SPDX-License-Identifier: LGPL-2.1-or-later
// pi^{2h} of (30): biquadratic interpolation on the cells of T^{2h}.

#include <signorini/postprocess/patch_interpolation.h>

#include <deal.II/base/polynomial.h>

namespace Signorini
{
namespace
{
/** Which child of its parent a cell is. */
template <int dim>
unsigned int child_number(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell)
{
  const auto parent = cell->parent();
  unsigned int c = 0;
  while (parent->child_index(c) != cell->index())
    ++c;
  return c;
}

/** Coordinate d (0 or 1) of a vertex of the unit cell, or of a child's place in its parent. */
unsigned int bit(const unsigned int number, const unsigned int d)
{
  return (number >> d) & 1U;
}
} // namespace

template <int dim>
PatchInterpolation<dim>::PatchInterpolation(const DisplacementSpace<dim> &space,
                                            const dealii::Quadrature<dim> &usual_rule)
  : space_(space)
  , polynomials_(dealii::Polynomials::LagrangeEquidistant::generate_complete_basis(2))
  , usual_points_(usual_rule.get_points())
{
  Assert(space.mesh().has_parents(), dealii::ExcMessage("pi^{2h} needs the level before"));
  for (unsigned int c = 0; c < tables_.size(); ++c)
    tables_[c] = make_table(usual_points_, c);
}

template <int dim>
typename PatchInterpolation<dim>::ShapeTable
PatchInterpolation<dim>::make_table(const std::vector<dealii::Point<dim>> &points,
                                    const unsigned int child) const
{
  ShapeTable table;
  table.values.resize(points.size());
  table.gradients.resize(points.size());
  for (unsigned int q = 0; q < points.size(); ++q)
  {
    dealii::Point<dim> in_parent;
    for (unsigned int d = 0; d < dim; ++d)
      in_parent[d] = 0.5 * (points[q][d] + bit(child, d));
    for (unsigned int k = 0; k < n_nodes; ++k)
    {
      table.values[q][k] = polynomials_.compute_value(k, in_parent);
      table.gradients[q][k] = 0.5 * polynomials_.compute_grad(k, in_parent);
    }
  }
  return table;
}

template <int dim>
const typename PatchInterpolation<dim>::ShapeTable &
PatchInterpolation<dim>::table(const dealii::Quadrature<dim> &quadrature, const unsigned int child)
{
  if (quadrature.get_points() == usual_points_)
    return tables_[child];
  cut_table_ = make_table(quadrature.get_points(), child);
  return cut_table_;
}

template <int dim>
void PatchInterpolation<dim>::gather(const NodalVector &U, const CellIterator &cell)
{
  const auto parent = cell->parent();
  dealii::Vector<double> values(space_.element().n_dofs_per_cell());
  for (unsigned int c = 0; c < parent->n_children(); ++c)
  {
    parent->child(c)->get_dof_values(U, values);
    for (unsigned int i = 0; i < values.size(); ++i)
    {
      const auto component_and_vertex = space_.element().system_to_component_index(i);
      unsigned int node = 0;
      for (unsigned int d = dim; d > 0; --d)
        node = 3 * node + bit(c, d - 1) + bit(component_and_vertex.second, d - 1);
      nodal_values_[node][component_and_vertex.first] = values[i];
    }
  }
}

template <int dim>
const FieldValues<dim> &PatchInterpolation<dim>::evaluate(const NodalVector &U,
                                                          const CellIterator &cell,
                                                          const dealii::FEValues<dim> &fe_values)
{
  gather(U, cell);
  const ShapeTable &shapes = table(fe_values.get_quadrature(), child_number<dim>(cell));
  const unsigned int n_points = fe_values.n_quadrature_points;
  result_.values.assign(n_points, dealii::Tensor<1, dim>());
  result_.gradients.assign(n_points, dealii::Tensor<2, dim>());
  for (unsigned int q = 0; q < n_points; ++q)
  {
    dealii::Tensor<2, dim> reference_gradient;
    for (unsigned int k = 0; k < n_nodes; ++k)
    {
      result_.values[q] += shapes.values[q][k] * nodal_values_[k];
      reference_gradient += outer_product(nodal_values_[k], shapes.gradients[q][k]);
    }
    // du_i/dx_j = sum_k du_i/dxi_k dxi_k/dx_j
    result_.gradients[q] =
      reference_gradient * dealii::Tensor<2, dim>(fe_values.inverse_jacobian(q));
  }
  return result_;
}

template class PatchInterpolation<2>;
} // namespace Signorini
